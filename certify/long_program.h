// SPDX-License-Identifier: Apache-2.0
// Long programs judged while they are read, in bounded memory.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "certify/judge.h"
#include "fuzz/oracle/verdict.h"
#include "model/basis/recorder.h"

namespace toolcomp::certify {

// Programs up to this size are judged, drawn and held against laws with all events at hand.
inline constexpr std::size_t kLargestAtOnce = 1 << 20;  // bytes
inline bool is_long(const spec::Case& c) { return c.program.size() > kLargestAtOnce; }

// The same case with the first lines of its program alone: what is drawn of a long one, and held against laws.
struct Beginning {
  spec::Case c;
  std::size_t lines = 0;
  fuzz::ModelRun run;
};
// Nothing where it cannot be run by itself.
std::optional<Beginning> beginning_of(const spec::Case& c);

struct LongProgram {
  Judgement judgement;
  std::vector<model::ClauseCount> clauses;  // as a recorder counts them
  spec::FieldSet fields;                    // of the model's events; of a controller's answer alone
};

// What judge_answer says where the events agree as they are (fuzz::streamed_agreement), with the laws asked of the
// beginning alone. Nothing in every other case: that is judged with all events at hand. Without an answer the fast
// engine is judged, which runs in this process.
std::optional<LongProgram> judge_long(const Capabilities& capabilities, const spec::Case& c, const Answer* answer,
                                      const std::optional<Beginning>& beginning);

}  // namespace toolcomp::certify
