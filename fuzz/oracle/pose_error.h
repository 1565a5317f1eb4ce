// How well the rotary positions under tool center point control are determined, and what hangs on them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "fuzz/oracle/program_facts.h"
#include "fuzz/oracle/rotary.h"
#include "model/engine.h"
#include "spec/language/setup.h"

namespace toolcomp::fuzz {

// Of one event, what the policy multiplies its k with.
struct PoseScale {
  double direction = 0;                         // of a component of the tool axis, beyond an ulp of 1
  std::array<double, spec::kMaxAxes> rotary{};  // degrees, beyond an ulp of the value
  double control_point = 0;                     // of X Y Z of the axes
  double tip = 0;                               // of every X Y Z
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
// A direction is good to e = ulp(1). A tool-side position that reaches it is off by e but at an edge of reach, where it
// is √(2e); the work-side position by e over the sine of the angle between tool and work-side axis, so that near a
// singular posture it means little. At a singular posture it is what it was before, or what the block next to it makes
// it. Commanded positions (type 1) are exact. A position that is kept keeps its error, and the direction of the tool
// has that error times the sine where it is used again (changed end, kept pose).
//
// Inside a block the direction of posture control carries the errors of both ends, enlarged as they come near to
// opposite ones; where both rotary positions are linear in t they carry those of the ends. Rotary axes that do not turn
// the tool run evenly: what is between two ends is rounded as these are.
//
// G91, and a code that ends the mode or begins it anew, go on from such positions.
//
// X Y Z of the axes carry the errors of the positions times the radii; on tables also those of the pose at which the
// programming coordinate system was frozen. G49 makes programmed positions of them.
class PoseErrors {
 public:
  // `facts`: of the program, read at least as far as the events that come; without them any position may have been
  // made of a direction, and none is leant. Kept by reference.
  explicit PoseErrors(const spec::Setup& setup, const ProgramFacts* facts = nullptr);
  // Of window[0]; `window` as for Conditions::next. `length` of scale: the largest linear magnitude of the event.
  PoseScale next(std::span<const model::Event> window, double length);

 private:
  // At the end of a move. Errors in radians.
  struct Pose {
    double tool = 0;  // degrees
    double work = 0;
    Space direction{};  // as the event says it
    Space point{};
    double tool_error = 0;
    double work_error = 0;
    double direction_error = 0;
  };

  [[nodiscard]] Pose read(const model::Event& event) const;
  [[nodiscard]] Pose end(std::span<const model::Event> window) const;
  [[nodiscard]] Pose inside(std::span<const model::Event> window) const;
  void evenly(std::span<const model::Event> window, PoseScale& scale) const;
  void keep(Pose& pose) const;
  void inside_of_rotary(double t, const Pose& to, Pose& pose) const;
  [[nodiscard]] double leant(const Pose& pose, std::uint64_t line) const;
  [[nodiscard]] PoseScale scale(const Pose& pose, double length) const;

  spec::Axes axes_;
  std::optional<RotaryMachine> machine_;
  RotaryZeros zeros_;
  double length_ = 0;                 // of the longest tool
  std::array<std::size_t, 3> index_;  // of X Y Z
  bool turning_frame_ = false;        // 19696#5 = 1 on a table
  const ProgramFacts* facts_;
  Pose before_;
  spec::AxisValues<model::Real> axes_before_;  // of the move before
  bool active_ = false;                        // the move before was under tool center point control
  double frozen_ = 0;                          // error of the pose of the programming coordinate system, radians
  double last_ = 0;                            // control_point of the move before
  double carried_ = 0;                         // what programmed positions have of it
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
  // Lines before this one are not asked for any more.
  void forget_before(std::uint64_t line) { of_line_.erase(of_line_.begin(), of_line_.lower_bound(line)); }

 private:
  std::optional<RotaryMachine> machine_;
  RotaryZeros zeros_;
  double before_ = 1;
  std::map<std::uint64_t, double> of_line_;
};

}  // namespace toolcomp::fuzz
