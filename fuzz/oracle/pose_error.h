// SPDX-License-Identifier: Apache-2.0
// How well tool directions and rotary positions under tool center point control are determined.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>

#include "fuzz/oracle/program_facts.h"
#include "fuzz/oracle/rotary.h"
#include "model/basis/event.h"
#include "spec/language/setup.h"

namespace toolcomp::fuzz {

// Of one event, what the policy multiplies its k with.
struct PoseScale {
  double direction = 0;                         // of a component of the tool axis, beyond an ulp of 1
  std::array<double, spec::kMaxAxes> rotary{};  // degrees, beyond an ulp of the value
  double tip = 0;                               // of every X Y Z
  bool hardly = false;  // doubles hardly know the plane of the direction, or an arc by R (policy::kHardly)
};

// The angles of the tool-side and the work-side axis: positions of events plus the machine positions of their zeros, as
// the last event says them that has machine coordinates, at first those of the setup; none where programmed positions
// are the angles.
class RotaryZeros {
 public:
  RotaryZeros(const spec::Setup& setup, const std::optional<RotaryMachine>& machine);
  void follow(const model::Event& event);
  [[nodiscard]] double tool() const { return zero_[0]; }
  [[nodiscard]] double work() const { return zero_[1]; }

 private:
  bool counts_;
  std::array<std::size_t, 2> axis_{spec::Axes::kNone, spec::Axes::kNone};
  std::array<double, 2> zero_{};
};

// Follows the events of one run, in order.
//
// A direction is good to e = ulp(1); one that a Q word leans towards the travel is worse as the plane of the two is
// ill-determined, and so is one inside a block of posture control whose ends are nearly opposite. A rotary position
// that comes out of a direction is off by e in radians, however small its value. How much more it is off near singular
// postures and edges of reach is not asked here: what a controller reports there is judged by what it does to the tool
// (pose_fit.h). Rotary axes that do not turn the tool run evenly: what is between two ends is rounded as these are.
class PoseErrors {
 public:
  // `facts`: of the program, read at least as far as the events that come; without them nothing is leant. Kept by
  // reference.
  explicit PoseErrors(const spec::Setup& setup, const ProgramFacts* facts = nullptr);
  // Of window[0]; `window` as for Conditions::next. `turned`: what the travel of the move is off by beyond an ulp of 1,
  // in radians (radius_arc.h).
  PoseScale next(std::span<const model::Event> window, double turned = 0);

 private:
  // At the end of a move.
  struct End {
    std::optional<std::array<model::Real, 3>> exact;  // the direction as the event says it
    Space direction{};                                // the same; zero where it says none
    Space point{};
    double error = 0;  // of the direction
    bool hardly = false;
  };
  // What a direction carries beyond an ulp of 1, as a factor.
  struct Lean {
    double factor = 1;
    bool hardly = false;
  };

  [[nodiscard]] End end(const model::Event& event, double turned) const;
  void inside(std::span<const model::Event> window, double turned, PoseScale& scale) const;
  [[nodiscard]] Lean leant(const Space& direction, const Space& travel, const model::Event& event) const;
  [[nodiscard]] Space travel(const model::Event& event, const Space& point) const;
  void rotary(std::span<const model::Event> window, PoseScale& scale) const;

  spec::Axes axes_;
  std::optional<RotaryMachine> machine_;
  RotaryZeros zeros_;
  std::array<std::size_t, 3> index_;  // of X Y Z
  const ProgramFacts* facts_;
  End before_;
  spec::AxisValues<model::Real> axes_before_;  // of the move before
};

// From a line on, the rotary positions of a controller lie that far off, in radians, where they may lie.
struct Deviation {
  std::uint64_t after = 0;  // the line whose move ends there
  double radians = 0;
};

// How many ulps the rotary positions at the ends of a line are off at most, and at the end of the line before: what a
// decision on them is off by.
class PositionErrors {
 public:
  explicit PositionErrors(const spec::Setup& setup) : machine_(RotaryMachine::of(setup)), zeros_(setup, machine_) {}
  // The events of one run, in order.
  void follow(const model::Event& event);
  // 1 where nothing is known.
  [[nodiscard]] double at(std::uint64_t line) const;
  // What a controller's positions are off by, in order of lines.
  void deviate(std::span<const Deviation> deviations) { deviations_ = deviations; }
  // Radians, where a line begins.
  [[nodiscard]] double deviation(std::uint64_t line) const;
  // Lines before this one are not asked for any more.
  void forget_before(std::uint64_t line) { of_line_.erase(of_line_.begin(), of_line_.lower_bound(line)); }

 private:
  std::optional<RotaryMachine> machine_;
  RotaryZeros zeros_;
  double before_ = 1;
  std::map<std::uint64_t, double> of_line_;
  std::span<const Deviation> deviations_;
};

}  // namespace toolcomp::fuzz
