// SPDX-License-Identifier: Apache-2.0
// Judges cases that are too long to be kept in memory, as long as everything agrees.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "judge/oracle/verdict.h"
#include "model/basis/recorder.h"

namespace toolcomp::judge {

struct Agreed {
  Verdict verdict;
  std::vector<model::ClauseCount> clauses;  // as the recorder of a ModelRun counts them
};

// Gives what judge() gives if the events agree directly, in bounded memory. Otherwise std::nullopt: such a case must be
// judged with the whole run in memory. This is so for a difference (even one of a near tie with another outcome), for a
// program that is left open, not supported or not judged, for rounded numbers, and for samples that are not judged.
//
// For the fast engine, which this function runs.
std::optional<Agreed> streamed_agreement(const spec::Case& c, const JudgeOptions& judged = {});
// For a controller's events. `on_event` is called with every event of the model that agreed.
std::optional<Agreed> streamed_agreement(const spec::Case& c, std::span<const spec::TextEvent> events,
                                         const JudgeOptions& judged,
                                         const std::function<void(const model::Event&)>& on_event);

}  // namespace toolcomp::judge
