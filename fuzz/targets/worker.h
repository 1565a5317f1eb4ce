// SPDX-License-Identifier: Apache-2.0
// What every target does as a worker of a campaign: where TOOLCOMP_FUZZ_WORK names a folder, it keeps a diary there and
// a difference does not end it; elsewhere it has none and aborts at the first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/campaign/diary.h"

namespace toolcomp::fuzz {

// The diary of this process; none: it is no worker. TOOLCOMP_FUZZ_SEED is what libFuzzer was given.
Diary* worker_diary(const char* target);

// Behind an execution: ends the process, without those of libFuzzer, where its folder cannot be written.
void end_if_failed(Diary& diary, const Counters& result);

// What a reader must hold of any text; it asks by require().
using ReaderLaw = void (*)(std::string_view text);
struct Broken {
  std::string where;  // "read_case.cpp-31"
};
// `path` and `line`: of the caller. AFL++'s compiler is clang 14, which has no std::source_location.
inline void require(bool holds, std::string_view path = __builtin_FILE(), unsigned line = __builtin_LINE()) {
  if (!holds) throw Broken{std::string(path.substr(path.rfind('/') + 1)) + "-" + std::to_string(line)};
}
// One execution of a reader.
int run_reader(const char* target, ReaderLaw law, const std::uint8_t* data, std::size_t size);

}  // namespace toolcomp::fuzz

// NOLINTBEGIN(cppcoreguidelines-macro-usage,readability-identifier-naming)
#define TOOLCOMP_READER_TARGET(target, law)                                           \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { \
    return toolcomp::fuzz::run_reader(target, law, data, size);                       \
  }
// NOLINTEND(cppcoreguidelines-macro-usage,readability-identifier-naming)
