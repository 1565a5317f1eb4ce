// SPDX-License-Identifier: Apache-2.0
// Tool center point control G43.4 G43.5: the last stage, which makes axis positions of tips and postures.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fast/basis/event.h"
#include "fast/fanuc/tool_center_point_control/fraction_counter.h"
#include "fast/fanuc/tool_center_point_control/tip_path.h"
#include "fast/fanuc/tool_posture_control/great_circle.h"
#include "fast/fanuc/tool_posture_control/posture.h"
#include "fast/geometry/vector3.h"
#include "fast/kinematics/machine.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// What this stage must know of a block besides its events: they wait in compensation meanwhile.
struct TipBlock {
  PosturePlan plan;
  DirectionMotion direction;  // instead, without kinematics
  double length_before = 0;   // along the tool (fanuc.tool-center-point.length), setup units
  double length = 0;
  bool sampled = false;  // its own move is run under tool center point control
};

// On a machine with kinematics: takes moves whose `point` is the compensated tip and whose t_numerator is tag() of
// their block, and sends them on with `axes` and `machine`, after the warning, the turn and the samples that belong
// before them. Without kinematics, where the moves are complete, it only makes their samples. Everything else passes.
class ToolCenterPointControl final : public EventSink {
 public:
  // `samples`: parts of a block.
  ToolCenterPointControl(const spec::Setup& setup, const Machine& machine, EventSink& out, std::uint32_t samples);

  // While the mode is on, on a machine with kinematics. Elsewhere blocks pass without this stage, but for samples.
  [[nodiscard]] bool active() const { return active_; }
  [[nodiscard]] bool samples() const { return samples_ > 1; }
  void start() { active_ = true; }
  void end() { active_ = false; }
  // Machine positions of the workpiece origin, by axis index. They do not change in the mode.
  void set_origin(const std::array<double, spec::kMaxAxes>& origin);

  // The next block to fill in. Eight blocks are kept: compensation holds at most five.
  [[nodiscard]] TipBlock& next();
  [[nodiscard]] TipBlock& block() { return blocks_[current_]; }
  [[nodiscard]] std::uint32_t tag() const { return current_; }
  // Where the block before next() ended.
  [[nodiscard]] const TipBlock& before() const { return blocks_[(current_ + blocks_.size() - 1) % blocks_.size()]; }

  void on(const Event& event) override;

 private:
  [[nodiscard]] Vector3<double> point_of(const Event& event) const;
  // X Y Z of the axes of an event; not in loops, which would look up each of them.
  void put(std::array<double, spec::kMaxAxes>& value, const Vector3<double>& point) const {
    if (xyz_first_) [[likely]] {
      value[0] = point.x;
      value[1] = point.y;
      value[2] = point.z;
      return;
    }
    for (std::size_t i = 0; i < 3; ++i)
      if (xyz_[i] != spec::Axes::kNone) value[xyz_[i]] = point[i];
  }
  // Of the programming coordinate system, fixed to the table.
  [[nodiscard]] Vector3<double> on_table(const Vector3<double>& point, const Turns<double>& turns) const {
    return moves_on_table_ ? machine_.to_table(point, turns, origin_xyz_) : point;
  }
  void warn(const Event& event);
  // Turns `event_`, the last one sent, to a pose, and sends it as a move of `owner`.
  void turn(const Event& owner, const Pose& pose, double length, spec::Cause cause);
  void send_beside_name(const Pose& pose);
  void send_samples(const Event& event, TipBlock& block);
  void send_direction_samples(const Event& event, TipBlock& block);
  void begin_samples(const Event& event);
  // The axes that go evenly from `event_` to `event`.
  void set_even(const Event& event, double t);
  void send_sample();
  // event_ becomes this move but for what the posture makes: tool axis and axes that depend on it.
  void take(const Event& move);
  // The axes of an event by its control point and rotary positions; by its tip on the table and its pose.
  void set_axes(Event& event, const Vector3<double>& point, double first, double second) const;
  void set_axes(Event& event, const Vector3<double>& tip, const Pose& pose, double length) const;
  void set_machine(Event& event) const;
  void finish(const Pose& pose, const Pose& end, double length);
  static void set_tool_axis(Event& event, const Vector3<double>& tool);

  const Machine& machine_;
  EventSink& out_;
  std::uint32_t samples_;
  std::array<std::size_t, 3> xyz_;
  bool xyz_first_;  // X Y Z are axes 0 1 2
  std::size_t count_;
  std::uint16_t all_ = 0;
  std::uint16_t linear_ = 0;
  std::uint16_t even_ = 0;  // neither X, Y, Z nor an axis that turns the tool

  bool active_ = false;
  bool moves_on_table_ = false;  // WKP = 1 on a machine with a table
  std::array<double, spec::kMaxAxes> origin_{};
  Vector3<double> origin_xyz_;

  std::array<TipBlock, 8> blocks_;
  std::uint32_t current_ = 0;

  Event event_;          // sent last
  Vector3<double> tip_;  // its tip, on the table
  Event sample_;
  FractionCounter fraction_;  // of the samples
  Event notice_;
};

}  // namespace toolcomp::fast
