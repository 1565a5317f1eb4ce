// SPDX-License-Identifier: Apache-2.0
// Judges long programs while they are read, in bounded memory.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "certify/judge.h"
#include "judge/oracle/verdict.h"
#include "model/basis/recorder.h"

namespace toolcomp::certify {

// Programs up to this size are judged, drawn and checked by laws with all events in memory.
inline constexpr std::size_t kLargestAtOnce = 1 << 20;  // bytes
inline bool is_long(const spec::Case& c) { return c.program.size() > kLargestAtOnce; }

// The same case with only the first lines of its program. This part of a long program is drawn and checked by laws.
struct Beginning {
  spec::Case c;
  std::size_t lines = 0;
  judge::ModelRun run;
};
// std::nullopt if this part cannot be run by itself.
std::optional<Beginning> beginning_of(const spec::Case& c);

struct LongProgram {
  Judgement judgement;
  std::vector<model::ClauseCount> clauses;  // as a recorder counts them
  spec::FieldSet fields;                    // fields of the model's events; only for the answer of a controller
};

// Gives what judge_answer gives if the events agree directly (judge::streamed_agreement), with the laws checked only on
// the beginning. Otherwise std::nullopt: such a case is judged with all events in memory. Without an answer, the fast
// engine in this process is judged.
std::optional<LongProgram> judge_long(const Capabilities& capabilities, const spec::Case& c, const Answer* answer,
                                      const std::optional<Beginning>& beginning);

}  // namespace toolcomp::certify
