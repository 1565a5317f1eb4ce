// SPDX-License-Identifier: Apache-2.0
// Clause marks: every decision of the model passes through here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "model/exact/real.h"
#include "spec/clauses/clauses.h"
#include "spec/language/event.h"

namespace toolcomp::model {

using exact::Real;
using exact::Sign;
using spec::Clause;

// How often a clause was reached and with which outcomes. A decision by the sign of a real quantity counts true for
// positive, false for negative, tie for zero; a decision by a fact (a parameter, a word) true or false.
struct ClauseCount {
  std::uint64_t reached = 0;
  std::uint64_t positive = 0;
  std::uint64_t negative = 0;
  std::uint64_t tie = 0;
};

// One decision by sign: `quantity` compared with zero. |quantity| <= scale, so that |quantity| / scale is the relative
// margin.
struct Decision {
  Clause clause{};
  std::uint64_t line = 0;  // of the block being interpreted
  Real quantity;
  Real scale;
  Sign outcome{};  // as taken, forced or not
};

// Records clauses and decisions of one run and can force outcomes (verdicts: "what if this near tie went the other
// way"). One run, one recorder.
class Recorder {
 public:
  // Keeps every decision by sign if `keep_decisions` is true; otherwise only counts.
  explicit Recorder(bool keep_decisions = false) : counts_(spec::kClauseCount), keep_(keep_decisions) {}

  // Takes `outcome` at the decision with this index (from 0, in the order of the run).
  void force(std::size_t decision, Sign outcome) { forced_[decision] = outcome; }

  // The certified sign of `quantity`, recorded under `clause`; or the forced outcome. Throws exact::Undecided.
  Sign decide(Clause clause, const Real& quantity, const Real& scale);
  // A decision by a fact; returns `fact`. The clause belongs to the event if the fact is true.
  bool decide(Clause clause, bool fact);
  // A clause without alternatives was applied.
  void reach(Clause clause);

  // Sets the line of the decisions, and of the clauses applied, from now on.
  void at(std::uint64_t line) { line_ = line; }

  // Adds a clause on which the next event rests, although its condition is not true.
  void list(Clause clause) { applied_.add(clause); }

  // The clauses applied since the last call, for the event they produced.
  spec::ClauseList take_clauses();
  // Gives back the clauses of an event that is continued. Other clauses must have been taken before.
  void resume(spec::ClauseList clauses) { applied_ = std::move(clauses); }

  // The line given last.
  [[nodiscard]] std::uint64_t line() const { return line_; }
  // The clause applied last; after exact::Undecided, the one that could not be decided.
  [[nodiscard]] Clause latest() const { return latest_; }

  [[nodiscard]] const std::vector<ClauseCount>& counts() const { return counts_; }
  [[nodiscard]] const std::vector<Decision>& decisions() const { return decisions_; }
  [[nodiscard]] std::size_t decision_count() const { return next_; }

 private:
  ClauseCount& applied(Clause clause);

  std::vector<ClauseCount> counts_;
  std::vector<Decision> decisions_;
  std::map<std::size_t, Sign> forced_;
  spec::ClauseList applied_;
  Clause latest_{};
  std::uint64_t line_ = 0;
  std::size_t next_ = 0;
  bool keep_;
};

}  // namespace toolcomp::model
