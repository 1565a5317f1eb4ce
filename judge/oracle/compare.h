// SPDX-License-Identifier: Apache-2.0
// Compares one expected event with one actual event, by the policy table.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

#include "judge/oracle/condition.h"
#include "judge/oracle/policy.h"
#include "judge/oracle/verdict.h"
#include "judge/oracle/widths.h"

namespace toolcomp::judge {

// Which fields are judged, and the tolerances of numbers. The same for every event of a case.
class Rules {
 public:
  Rules(const spec::Setup& setup, std::string_view section, const JudgeOptions& options);

  // Sets the units of the events, if those of the program differ from the setup.
  void units(spec::Units units);

  [[nodiscard]] bool judges(std::string_view field) const;
  // Whether a controller announced a field that only undecided events have. It then reports itself what is left open.
  [[nodiscard]] bool judges_undecided() const;
  // Whether the event rests on a clause that is not of the kinds in JudgeOptions::known.
  [[nodiscard]] bool leaves_out(const model::Event& event) const;
  [[nodiscard]] bool leaves_out(spec::Clause clause) const { return !known_.has(spec::info(clause).known); }
  [[nodiscard]] const policy::Budget& budget() const { return budget_; }
  [[nodiscard]] const spec::Axes& axes() const { return axes_; }
  // The resolution of lengths in the units of the events, of angles in degrees, of components of unit vectors; 0: they
  // are doubles.
  [[nodiscard]] double resolution() const { return inch_ ? resolution_.inch : resolution_.mm; }
  [[nodiscard]] double angle_resolution() const { return resolution_.degrees; }
  [[nodiscard]] double vector_resolution() const { return resolution_.vectors; }
  [[nodiscard]] Rounding rounding() const { return resolution_.rounding; }
  [[nodiscard]] bool rounds() const { return resolution_.any(); }
  // Whether the other outcomes of a decision are permitted, for this relative half width of a near tie.
  [[nodiscard]] bool is_near_tie(const model::Decision& decision, double band, const PositionErrors& positions) const;
  [[nodiscard]] double um_per_unit() const { return um_per_unit_; }
  // In micrometres. A value that is granted more than this is not judged.
  [[nodiscard]] double cap_um() const { return std::max(policy::kCap, resolution() * um_per_unit_); }

 private:
  policy::Budget budget_;
  spec::Axes axes_;
  std::vector<std::string> fields_;
  Resolution resolution_;
  spec::KnownSet known_;
  bool inch_ = false;
  double um_per_unit_ = 0;
};

// What was judged, summed over a run.
struct Tally {
  std::uint64_t values = 0;
  std::uint64_t numbers = 0;
  std::uint64_t wide = 0;
  std::uint64_t events = 0;
  OpenEvents open;
  std::uint64_t out_of_scope = 0;  // events of the model after one with the reason OUT_OF_SCOPE
  bool scope_left = false;         // there was such an event
  std::uint64_t left_out = 0;      // events of the model left out by JudgeOptions::known
  std::map<spec::Clause, std::uint64_t> left_out_for;
  double worst_ulp = 0;
  double worst_um = 0;
  Bias bias;
  Widths widths;
};

// Counts an event that is not judged because of JudgeOptions::known.
void leave_out(const Rules& rules, const model::Event& event, Tally& tally);

// Copies the counts to the verdict.
void take(Verdict& verdict, const Tally& tally);

// The first difference between the two, or std::nullopt. `Number` is double or exact::Rational.
template <class Number>
std::optional<Difference> compare(const Rules& rules, const model::Event& expected, const Scale& scale,
                                  const spec::Event<Number>& actual, Tally& tally);

// Whether an undecided event of the model means that the specification leaves the case open, and not that a tie was not
// certified.
bool left_open(const model::Event& event);

// "move (linear, programmed) of line 5": the text for a whole event in a difference.
template <class Number>
std::string describe(const spec::Event<Number>& event);

}  // namespace toolcomp::judge
