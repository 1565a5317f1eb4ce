// SPDX-License-Identifier: Apache-2.0
// How well tool directions and rotary positions under tool center point control are determined.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>

#include "judge/oracle/program_facts.h"
#include "judge/oracle/rotary.h"
#include "model/basis/event.h"
#include "spec/language/setup.h"

namespace toolcomp::judge {

// The quantities of one event that the policy multiplies by k.
struct PoseScale {
  double direction = 0;                         // of a component of the tool axis, in addition to an ulp of 1
  std::array<double, spec::kMaxAxes> rotary{};  // degrees, in addition to an ulp of the value
  double tip = 0;                               // of every X Y Z
  bool hardly = false;  // doubles hardly determine the plane of the direction, or an arc by R (policy::kHardly)
};

// The angles of the tool-side and the work-side axis are the positions of events plus the machine positions of their
// zeros. These zeros come from the last event with machine coordinates, and at first from the setup. There are none if
// programmed positions are the angles.
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
// that comes out of a direction is off by e in radians, however small its value. The larger errors near singular
// postures and edges of reach do not matter here: the reported positions are judged by their effect on the tool
// (pose_fit.h). Rotary axes that do not turn the tool run evenly: positions between two ends have the roundings of the
// ends.
class PoseErrors {
 public:
  // `facts`: of the program, read at least as far as the next events. Without them there is no lean. Kept by reference.
  explicit PoseErrors(const spec::Setup& setup, const ProgramFacts* facts = nullptr);
  // Of window[0]; `window` as for Conditions::next. `turned`: the error of the travel direction of the move in addition
  // to an ulp of 1, in radians (radius_arc.h).
  PoseScale next(std::span<const model::Event> window, double turned = 0);

 private:
  // The state at the end of a move.
  struct End {
    std::optional<std::array<model::Real, 3>> exact;  // the direction of the event
    Space direction{};                                // the same; zero if the event has none
    Space point{};
    double error = 0;  // of the direction
    bool hardly = false;
  };
  // The error of a direction in addition to an ulp of 1, as a factor.
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

// From a line on, the rotary positions of a controller are off by this much, in radians, within what is permitted.
struct Deviation {
  std::uint64_t after = 0;  // the line whose move ends there
  double radians = 0;
};

// The largest error, in ulps, of the rotary positions at the ends of a line and at the end of the line before. It is
// the error of a decision on these positions.
class PositionErrors {
 public:
  explicit PositionErrors(const spec::Setup& setup) : machine_(RotaryMachine::of(setup)), zeros_(setup, machine_) {}
  // The events of one run, in order.
  void follow(const model::Event& event);
  // 1 if nothing is known.
  [[nodiscard]] double at(std::uint64_t line) const;
  // Takes the errors of a controller's positions, in order of lines.
  void deviate(std::span<const Deviation> deviations) { deviations_ = deviations; }
  // Radians, at the beginning of a line.
  [[nodiscard]] double deviation(std::uint64_t line) const;
  // Lines before this one are no longer needed.
  void forget_before(std::uint64_t line) { of_line_.erase(of_line_.begin(), of_line_.lower_bound(line)); }

 private:
  std::optional<RotaryMachine> machine_;
  RotaryZeros zeros_;
  double before_ = 1;
  std::map<std::uint64_t, double> of_line_;
  std::span<const Deviation> deviations_;
};

}  // namespace toolcomp::judge
