// SPDX-License-Identifier: Apache-2.0
// One program through the model and another engine of ours.
#pragma once

#include <cstdint>

#include "certify/input/program.h"
#include "certify/judge.h"
#include "fuzz/oracle/verdict.h"

namespace toolcomp::certify {

struct Comparison {
  fuzz::Verdict verdict;
  std::uint64_t questions = 0;  // that laws asked
};

// The fast engine; where it agrees, and the program can be read again and is no longer than a megabyte, the model's
// events are held against the laws. `on_block` as judge_stream() calls it. Throws spec::InputError for what is no text
// of a program.
Comparison compare_fast(const input::Program& program, void (*on_block)(std::uint64_t) = nullptr);

// The formal specification. Throws spec::InputError where this build has none, and as above.
Judgement compare_specification(const input::Program& program);

}  // namespace toolcomp::certify
