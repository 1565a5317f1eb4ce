// SPDX-License-Identifier: Apache-2.0
// Compares one run of the model with one list of events, pair by pair.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "judge/oracle/arc_fit.h"
#include "judge/oracle/compare.h"
#include "judge/oracle/condition.h"
#include "judge/oracle/pose_fit.h"

namespace toolcomp::judge {

// Every event is compared directly. If that fails, it is compared as seen from what the controller has: its rotary
// positions (pose_fit.h), and inside a block the heads of both ends if two conditions place them (head.h); for an arc
// with such an end, sweep and radii between these heads (arc_fit.h). `Number` is double or exact::Rational.
template <class Number>
class Pairing {
 public:
  // Both are kept by reference, and so are `facts`.
  Pairing(const Rules& rules, const spec::Setup& setup, const ProgramFacts* facts)
      : rules_(rules),
        conditions_(setup, facts, rules.budget().coordinate),
        fit_(rules, setup, facts),
        index_{setup.axes.index('X'), setup.axes.index('Y'), setup.axes.index('Z')} {}

  // The first difference between window[0] and `actual`, or std::nullopt; `window` as for Conditions::next. Pairs must
  // be given in order, and none after a difference.
  std::optional<Difference> next(std::span<const model::Event> window, const spec::Event<Number>& actual, Tally& tally);

  // Goes on after window[0] without comparing the controller's event.
  void pass(std::span<const model::Event> window);

  // The deviations of the controller's rotary positions.
  [[nodiscard]] const std::vector<Deviation>& deviations() const { return fit_.deviations(); }

 private:
  [[nodiscard]] std::optional<model::Vector> shift(const model::Event& sample, const Scale& scale) const;
  // X Y Z of a move.
  void move_by(model::Event& event, const model::Vector& by) const;
  void follow(const model::Event& expected, const spec::Event<Number>& actual);
  std::optional<Difference> compared(const model::Event& expected, const Scale& scale,
                                     const spec::Event<Number>& actual, Tally& tally) const;
  // X Y Z of the points of both; std::nullopt if the controller does not give them.
  struct Heads {
    model::Vector expected;
    std::array<Number, 3> actual{};

    [[nodiscard]] ArcEnd end() const;
  };
  [[nodiscard]] std::optional<Heads> heads(const model::Event& expected, const spec::Event<Number>& actual) const;

  const Rules& rules_;
  Conditions conditions_;
  PoseFit<Number> fit_;
  std::array<std::size_t, 3> index_;  // of X Y Z
  std::optional<Heads> head_;         // of the move before
  bool placed_ = false;               // whether two conditions placed it
};

}  // namespace toolcomp::judge
