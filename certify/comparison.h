// SPDX-License-Identifier: Apache-2.0
// Compares the model with another engine of toolcomp on one program.
#pragma once

#include <cstdint>

#include "certify/input/program.h"
#include "certify/judge.h"
#include "judge/oracle/verdict.h"

namespace toolcomp::certify {

struct Comparison {
  judge::Verdict verdict;
  std::uint64_t questions = 0;  // number of law checks
};

// Compares the fast engine. If it agrees, and if the program can be read again and is not longer than a megabyte, the
// laws are checked on the model's events. `on_block` is called as judge_stream() does. Throws spec::InputError if the
// text is not the text of a program.
Comparison compare_fast(const input::Program& program, void (*on_block)(std::uint64_t) = nullptr);

// Compares the formal specification. Throws spec::InputError if this build does not have it, and as above.
Judgement compare_specification(const input::Program& program);

}  // namespace toolcomp::certify
