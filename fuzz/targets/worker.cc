// SPDX-License-Identifier: Apache-2.0
#include "fuzz/targets/worker.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>

#include "fuzz/gen/encode.h"

namespace toolcomp::fuzz {
namespace {

// What readers count: they judge nothing but themselves.
Counters g_reader;

}  // namespace

Diary* worker_diary(const char* target) {
  static const std::unique_ptr<Diary> diary = [target]() -> std::unique_ptr<Diary> {
    const char* const folder = std::getenv("TOOLCOMP_FUZZ_WORK");  // NOLINT(concurrency-mt-unsafe): one thread
    const char* const seed = std::getenv("TOOLCOMP_FUZZ_SEED");    // NOLINT(concurrency-mt-unsafe)
    if (folder == nullptr) return nullptr;
    try {
      return std::make_unique<Diary>(folder, target, seed == nullptr ? 0 : std::strtoull(seed, nullptr, 10));
    } catch (const std::exception& error) {
      fmt::print(stderr, "{}\n", error.what());
      std::_Exit(Diary::kCannotWrite);
    }
  }();
  return diary.get();
}

void end_if_failed(Diary& diary, const Counters& result) {
  if (!diary.failed()) return;
  diary.write(result);
  std::_Exit(Diary::kCannotWrite);
}

int run_reader(const char* target, ReaderLaw law, const std::uint8_t* data, std::size_t size) {
  const std::string_view text = as_text({data, size});
  Diary* const diary = worker_diary(target);
  if (diary != nullptr) {
    static const int at_end = std::atexit([] { worker_diary("")->write(g_reader); });
    static_cast<void>(at_end);
    diary->begin(text);
  }
  ++g_reader.executions;
  int result = 0;
  try {
    law(text);
    ++g_reader.acceptance[0];
  } catch (const Broken& broken) {
    if (diary == nullptr) {
      fmt::print(stderr, "\nBROKEN {}\n", broken.where);
      std::abort();
    }
    // Not into the corpus: it would be met again and again.
    result = -1;
    diary->hit(
        fmt::format("{}|broken|{}", target, broken.where), g_reader.executions,
        [&](const HowFound&) { return std::string(text); }, "." + broken.where + ".input");
  }
  if (diary != nullptr) {
    diary->tick(g_reader);
    end_if_failed(*diary, g_reader);
  }
  return result;
}

}  // namespace toolcomp::fuzz
