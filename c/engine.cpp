// SPDX-License-Identifier: Apache-2.0
// A block at a time.
#include <cstdint>
#include <memory>
#include <string_view>

#include "c/call.h"
#include "c/events.h"
#include "c/include/toolcomp.h"
#include "c/setup.h"
#include "fast/batch/dialect.h"

struct toolcomp_engine {
  toolcomp_engine(const toolcomp::spec::Setup& setup, std::uint32_t samples, toolcomp_on_event on_event, void* user)
      : sink(on_event, user), engine(toolcomp::fast::make_batch_engine(setup, sink, nullptr, samples)) {}

  toolcomp::c::CallbackSink sink;
  std::unique_ptr<toolcomp::fast::BatchEngine> engine;
  std::uint64_t lines = 0;  // of text so far
};

using toolcomp::c::guarded;
using toolcomp::c::need;

toolcomp_status toolcomp_engine_new(const toolcomp_setup* setup, uint32_t samples, toolcomp_on_event on_event,
                                    void* user, toolcomp_engine** engine, toolcomp_error* error) {
  return guarded(error, [&] {
    need(engine, "engine") = nullptr;
    need(on_event, "on_event");
    *engine = std::make_unique<toolcomp_engine>(need(setup, "setup").value, samples, on_event, user).release();
  });
}

toolcomp_status toolcomp_engine_run(toolcomp_engine* engine, const char* text, size_t length, toolcomp_error* error) {
  return guarded(
      error,
      [&] {
        toolcomp_engine& run = need(engine, "engine");
        need(text, "text");
        run.lines += run.engine->run({text, length}, run.lines);
      },
      engine == nullptr ? 0 : engine->lines);
}

toolcomp_status toolcomp_engine_end(toolcomp_engine* engine, toolcomp_error* error) {
  return guarded(error, [&] { need(engine, "engine").engine->end(); });
}

int toolcomp_engine_stopped(const toolcomp_engine* engine) { return engine->engine->stopped() ? 1 : 0; }

void toolcomp_engine_free(toolcomp_engine* engine) { delete engine; }
