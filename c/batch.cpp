// SPDX-License-Identifier: Apache-2.0
// By arrays.
#include "fast/batch/batch.h"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "c/call.h"
#include "c/events.h"
#include "c/include/toolcomp.h"
#include "c/setup.h"

struct toolcomp_batch {
  toolcomp_batch(const toolcomp::spec::Setup& setup, toolcomp_on_event on_event, void* user)
      : sink(on_event, user), batch(setup, &sink) {}

  toolcomp::c::CallbackSink sink;
  mutable toolcomp::fast::Batch batch;  // whose moves are looked at
};

using toolcomp::c::guarded;
using toolcomp::c::need;

toolcomp_status toolcomp_batch_new(const toolcomp_setup* setup, toolcomp_on_event on_event, void* user,
                                   toolcomp_batch** batch, toolcomp_error* error) {
  return guarded(error, [&] {
    need(batch, "batch") = nullptr;
    *batch = std::make_unique<toolcomp_batch>(need(setup, "setup").value, on_event, user).release();
  });
}

toolcomp_status toolcomp_batch_run(toolcomp_batch* batch, const char* text, size_t length, toolcomp_error* error) {
  return guarded(
      error,
      [&] {
        toolcomp_batch& run = need(batch, "batch");
        need(text, "text");
        run.batch.run({text, length});
      },
      batch == nullptr ? 0 : batch->batch.blocks());
}

toolcomp_status toolcomp_batch_lines(toolcomp_batch* batch, const toolcomp_column* columns, size_t column_count,
                                     size_t blocks, toolcomp_error* error) {
  return guarded(error, [&] {
    toolcomp_batch& run = need(batch, "batch");
    need(columns, "columns");
    std::vector<toolcomp::fast::WordColumn> words;
    words.reserve(column_count);
    for (const toolcomp_column& column : std::span(columns, column_count)) {
      need(column.word, "a word");
      if (blocks != 0) need(column.values, column.word);
      words.push_back({column.word, {column.values, blocks}, column.decimals});
    }
    run.batch.lines(words);
  });
}

toolcomp_status toolcomp_batch_end(toolcomp_batch* batch, toolcomp_error* error) {
  return guarded(error, [&] { need(batch, "batch").batch.end(); });
}

int toolcomp_batch_stopped(const toolcomp_batch* batch) { return batch->batch.stopped() ? 1 : 0; }

toolcomp_moves toolcomp_batch_moves(const toolcomp_batch* batch) {
  const toolcomp::fast::Moves& moves = batch->batch.moves();
  toolcomp_moves out{};
  out.count = moves.size();
  out.axes = moves.axes();
  for (size_t i = 0; i < moves.axes(); ++i) out.axis[i] = moves.axis(i).data();
  out.block = moves.block().data();
  return out;
}

void toolcomp_batch_clear_moves(toolcomp_batch* batch) { batch->batch.moves().clear(); }

void toolcomp_batch_free(toolcomp_batch* batch) { delete batch; }
