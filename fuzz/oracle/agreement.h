// SPDX-License-Identifier: Apache-2.0
// Cases too long to be held whole: what is said of them as long as everything agrees.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fuzz/oracle/verdict.h"
#include "model/basis/recorder.h"

namespace toolcomp::fuzz {

struct Agreed {
  Verdict verdict;
  std::vector<model::ClauseCount> clauses;  // as the recorder of a ModelRun counts them
};

// What judge() says of a case where the events agree as they are, in bounded memory. Nothing in every other case, which
// is to be judged with the whole run at hand: a difference (be it that of a near tie taken otherwise), a program that
// is left open or goes beyond what is supported, rounded numbers, samples that are not judged.
//
// Of the fast engine, which runs in here.
std::optional<Agreed> streamed_agreement(const spec::Case& c, const JudgeOptions& judged = {});
// Of a controller's events. `on_event` is called with every event of the model that has agreed.
std::optional<Agreed> streamed_agreement(const spec::Case& c, std::span<const spec::TextEvent> events,
                                         const JudgeOptions& judged,
                                         const std::function<void(const model::Event&)>& on_event);

}  // namespace toolcomp::fuzz
