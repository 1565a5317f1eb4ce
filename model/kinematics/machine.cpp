// SPDX-License-Identifier: Apache-2.0
#include "model/kinematics/machine.h"

#include <utility>

#include "spec/language/input_error.h"

namespace toolcomp::model {
namespace {

Vector vector_parameter(const spec::Setup& setup, std::uint32_t first) {
  return {parameter(setup, first), parameter(setup, first + 1), parameter(setup, first + 2)};
}

// The same number, as a rational where it is a multiple of 1/8: of the constants of common machines most are, such as
// those of axes inclined by 45 degrees.
Real simplified(const Real& x) {
  if (x.is_rational()) return x;
  constexpr int bits = 20;
  const Rational value = Rational(floor(x.enclosure(bits).lower * 8 + Rational(1, 2))) / 8;
  return (x - value).sign() == Sign::zero ? Real(value) : x;
}
Vector simplified(const Vector& v) { return {simplified(v.x), simplified(v.y), simplified(v.z)}; }

}  // namespace

Machine::Machine(const spec::Setup& setup)
    : mechanism_(read_mechanism(setup)),
      arms_{vector_parameter(setup, 19700), vector_parameter(setup, 19703), vector_parameter(setup, 19709),
            vector_parameter(setup, 19712)},
      programs_workpiece_(setup.bit(19696, 5)) {
  if (mechanism_.type == MachineType::none)
    throw spec::InputError("setup", 0, 0, "parameters.19680: expected a machine with rotary axes");
  find_heights();
  find_singular_postures();
}

void Machine::find_heights() {
  const Vector& axis = tool_side().line;
  const Vector& over = work_side().line;
  const Vector& reference = mechanism_.reference;
  heights_.along = simplified(dot(axis, reference) * axis);
  heights_.across = simplified(reference - heights_.along);
  heights_.ahead = simplified(cross(axis, reference));
  heights_.mean = simplified(dot(over, heights_.along));
  heights_.a = simplified(dot(over, heights_.across));
  heights_.b = simplified(dot(over, heights_.ahead));
  heights_.swing2 = simplified(square(heights_.a) + square(heights_.b));
  tilts_ = heights_.swing2.sign() != Sign::zero;
  orthogonal_ = dot(axis, over).sign() == Sign::zero && is_zero(heights_.along);
}

// A tilted direction reaches the work-side axis where the tool-side axis makes the same angle with both.
void Machine::find_singular_postures() {
  if (!is_invertible()) return;
  const Vector& axis = tool_side().line;
  const Vector& over = work_side().line;
  const Real of_reference = dot(axis, mechanism_.reference);
  const Real of_axes = dot(axis, over);
  const auto add = [this](int side, const Vector& direction, const Angle& turn) {
    singular_.push_back({side, direction, tool_side().position_at(turn).principal()});
  };
  if (of_reference == of_axes) add(1, over, Angle::of_direction(heights_.a, heights_.b));
  if (of_reference == -of_axes) add(-1, -over, Angle::of_direction(-heights_.a, -heights_.b));
}

const SingularPosture* Machine::singular(int side) const {
  for (const SingularPosture& posture : singular_)
    if (posture.side == side) return &posture;
  return nullptr;
}

Pose Machine::pose(const Position& angles) const {
  return {tool_side().position(angles), work_side().position(angles)};
}

void Machine::place(const Pose& pose, const Pose& zero, Position& position) const {
  if (const auto axis = tool_side().axis) position.at(*axis) = Coordinate(pose.tool - zero.tool);
  if (const auto axis = work_side().axis) position.at(*axis) = Coordinate(pose.work - zero.work);
}

Vector Machine::direction(const Pose& pose) const { return work_side().apply(tilted(pose.tool), pose.work); }

Vector Machine::direction_beside(const Pose& pose, const Angle& work) const {
  return work_side().carry(tilted(pose.tool), pose.work, work);
}

Vector Machine::direction_in_machine(const Pose& pose) const {
  switch (type()) {
    case MachineType::table:
      return mechanism_.reference;
    case MachineType::mixed:
      return tilted(pose.tool);
    default:
      return direction(pose);
  }
}

Vector Machine::carried(const Vector& point, const Pose& from, const Pose& to) const {
  if (type() == MachineType::head) return point;
  const Vector on_first = point - arms_.table;
  if (type() == MachineType::mixed) return arms_.table + work_side().carry(on_first, from.work, to.work);
  const Vector on_second = tool_side().apply(on_first, from.tool) - arms_.table_step;
  const Vector carried = arms_.table_step + work_side().carry(on_second, from.work, to.work);
  return arms_.table + tool_side().apply_back(carried, to.tool);
}

Vector Machine::tool_vector(const Pose& pose, const Real& length) const {
  Vector along = length * mechanism_.reference;
  switch (type()) {
    case MachineType::table:
      return along;
    case MachineType::mixed:
      return tool_side().apply(along + arms_.head, pose.tool);
    default:
      return work_side().apply(tool_side().apply(along + arms_.head, pose.tool) + arms_.head_step, pose.work);
  }
}

ProgrammingFrame::ProgrammingFrame(const Machine& machine, Pose frozen, Vector origin)
    : machine_(&machine), frozen_(std::move(frozen)), origin_(std::move(origin)) {}

Vector ProgrammingFrame::to_table_beside(const Vector& direction) const {
  return machine_->type() == MachineType::table ? machine_->tool_side().apply(direction, frozen_.tool) : direction;
}

Vector ProgrammingFrame::to_table(const Vector& direction) const {
  if (machine_->type() == MachineType::head) return direction;
  return machine_->work_side().apply(to_table_beside(direction), frozen_.work);
}

Vector ProgrammingFrame::from_table(const Vector& direction) const {
  switch (machine_->type()) {
    case MachineType::table:
      return machine_->tool_side().apply_back(machine_->work_side().apply_back(direction, frozen_.work), frozen_.tool);
    case MachineType::mixed:
      return machine_->work_side().apply_back(direction, frozen_.work);
    default:
      return direction;
  }
}

// Turns about one axis are added up, so that those that cancel do not enter it.
Vector ProgrammingFrame::direction(const Pose& pose) const {
  switch (machine_->type()) {
    case MachineType::table:
      if (known_difference(pose.work, frozen_.work) == Rational(0))
        return machine_->tool_side().carry(machine_->mechanism_.reference, pose.tool, frozen_.tool);
      return machine_->tool_side().apply_back(machine_->direction_beside(pose, frozen_.work), frozen_.tool);
    case MachineType::mixed:
      return machine_->direction_beside(pose, frozen_.work);
    default:
      return machine_->direction(pose);
  }
}

// Turns about itself leave it.
Vector ProgrammingFrame::work_axis() const {
  const Vector& axis = machine_->work_side().line;
  return machine_->type() == MachineType::table ? machine_->tool_side().apply_back(axis, frozen_.tool) : axis;
}

Vector ProgrammingFrame::control_point(const Vector& tip, const Pose& pose, const Real& length) const {
  return in_workpiece(tip, pose) + machine_->tool_vector(pose, length);
}

Vector ProgrammingFrame::in_workpiece(const Vector& tip, const Pose& pose) const {
  if (machine_->type() == MachineType::head) return tip;
  return machine_->carried(origin_ + tip, frozen_, pose) - origin_;
}

Vector ProgrammingFrame::of_workpiece(const Vector& point, const Pose& pose) const {
  if (machine_->type() == MachineType::head) return point;
  return machine_->carried(origin_ + point, pose, frozen_) - origin_;
}

}  // namespace toolcomp::model
