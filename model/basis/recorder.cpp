// SPDX-License-Identifier: Apache-2.0
#include "model/basis/recorder.h"

#include <utility>

namespace toolcomp::model {

Sign Recorder::decide(Clause clause, const Real& quantity, const Real& scale) {
  ClauseCount& count = applied(clause);
  const std::size_t index = next_++;
  Sign outcome{};
  if (const auto found = forced_.find(index); found != forced_.end())
    outcome = found->second;
  else
    outcome = quantity.sign();
  switch (outcome) {
    case Sign::positive:
      ++count.positive;
      break;
    case Sign::negative:
      ++count.negative;
      break;
    case Sign::zero:
      ++count.tie;
      break;
  }
  if (keep_) decisions_.push_back({clause, line_, quantity, scale, outcome});
  return outcome;
}

bool Recorder::decide(Clause clause, bool fact) {
  ClauseCount& count = counts_[static_cast<std::size_t>(clause)];
  ++count.reached;
  ++(fact ? count.positive : count.negative);
  if (fact) applied_.add(clause);
  return fact;
}

void Recorder::reach(Clause clause) { applied(clause); }

ClauseCount& Recorder::applied(Clause clause) {
  latest_ = clause;
  applied_.add(clause);
  ClauseCount& count = counts_[static_cast<std::size_t>(clause)];
  ++count.reached;
  return count;
}

spec::ClauseList Recorder::take_clauses() { return std::exchange(applied_, spec::ClauseList()); }

}  // namespace toolcomp::model
