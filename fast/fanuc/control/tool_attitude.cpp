// SPDX-License-Identifier: Apache-2.0
// The tool direction in force: from the rotary axes, or from I J K under G43.5 without kinematics.
#include <cmath>

#include "fast/arithmetic/wide.h"
#include "fast/fanuc/control/read_words.h"
#include "fast/fanuc/control/tool_attitude.h"

namespace toolcomp::fast {
namespace {

// The square root of a sum of three squares, if it is whole.
std::optional<Int128> whole_length(const std::array<Int128, 3>& v) {
  const Wide square = Wide(v[0]) * Wide(v[0]) + Wide(v[1]) * Wide(v[1]) + Wide(v[2]) * Wide(v[2]);
  const DoubleDouble root = sqrt(square.to_double_double());
  const Int128 whole = static_cast<Int128>(root.hi) + static_cast<Int128>(std::nearbyint(root.lo));
  if ((square - Wide(whole) * Wide(whole)).sign() != 0) return std::nullopt;
  return whole;
}

}  // namespace

ToolAttitude::ToolAttitude(const spec::Setup& setup, Kinematics& kinematics, const ControlAxes& axes,
                           const WordUnits& units, const ModalState& modal, AxisPositions& positions, EventSink& sink,
                           std::uint32_t samples)
    : kinematics_(kinematics),
      axes_(axes),
      units_(units),
      modal_(modal),
      positions_(positions),
      machine_(setup, kinematics),
      posture_(setup, machine_),
      tip_(setup, machine_, sink, samples),
      machine_angles_(setup.rotary_angles == spec::RotaryAngles::machine),
      cancel_moves_(setup.tip_control_cancel == spec::TipControlCancel::moves) {
  kinematics_.see_from_table(false);
}

void ToolAttitude::take_zeros() {
  if (axes_.turning == 0 || !machine_angles_) return;
  Positions zero;
  for (std::size_t axis = 0; axis < axes_.count; ++axis) zero[axis] = positions_.machine_origin(axis);
  kinematics_.set_zeros(zero);
  machine_.set_zeros(zero);
}

void ToolAttitude::turn() { kinematics_.direct(positions_.programmed(), tool_.next()); }

// A block under G43.5: I J K, or the direction in force.
void ToolAttitude::direct(const Words& words) {
  if (words.has_any(Words::set_of("IJK"))) read_direction(words, tool_.next());
}

// Missing ones of I J K are 0.
void ToolAttitude::read_direction(const Words& words, Direction& direction) const {
  if (read_usual_direction(words, direction)) return;
  std::array<Count, 3> component;
  for (std::size_t i = 0; i < 3; ++i) {
    const char letter = static_cast<char>('I' + i);
    if (words.has(letter)) component[i] = units_.value(words[letter], true);
  }
  direction = whole_direction({component[0].units(), component[1].units(), component[2].units()});
}

// G49 after G43.5: the programmed position becomes that of the axes, P + L V. It is exact where |V| is whole and L V_i
// a multiple of the unit; elsewhere it is rounded to the unit, 8e-21, and the axis is marked.
void ToolAttitude::take_position_along_tool() {
  const Direction& tool = tool_.now();
  const Int128 length = tool_length().units();
  const std::optional<Int128> norm = tool.is_whole ? whole_length(tool.whole()) : std::nullopt;
  const FineVector unit = kinematics_.refine(tool);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t axis = axes_.xyz[i];
    if (axis == spec::Axes::kNone) continue;
    const DoubleDouble along = to_double_double(length) * unit[i];
    const Int128 units = static_cast<Int128>(along.hi) + static_cast<Int128>(std::nearbyint(along.lo));
    // Two terms within the range: the next position is checked.
    positions_.set(axis, positions_.programmed()[axis] + Count::of_units(units));
    const bool exact =
        length == 0 || (norm && (Wide(units) * Wide(*norm) - Wide(length) * Wide(tool.whole()[i])).sign() == 0);
    if (!exact) positions_.set_rounded(bit(axis));
  }
}

// Under G43.5 without kinematics the moves are complete; only their samples are made on the way out.
std::uint32_t ToolAttitude::tag_direction() {
  TipBlock& block = tip_.next();
  block.direction = DirectionMotion(kinematics_, tool_.before(), tool_.now());
  block.length = tool_length().nearest();
  block.sampled = samples_block_;
  return tip_.tag();
}

// Another G43.5 leaves the tip and the direction.
void ToolAttitude::end_by_vector_alone(bool again) {
  plans_tool_ = false;
  if (again) return;
  if (!cancel_moves_) take_position_along_tool();
  positions_.make_stale();
  if (kinematics_.defined())
    turn();
  else
    tool_.next() = Direction{};
}

// L along the tool.
void ToolAttitude::add_length(Event& event) const {
  for (std::size_t i = 0; i < 3; ++i) {
    if (axes_.xyz[i] == spec::Axes::kNone) continue;
    const double offset = along_length_ * tool_.now().unit[static_cast<Eigen::Index>(i)];
    event.axes.value[axes_.xyz[i]] += offset;
    event.machine.value[axes_.xyz[i]] += offset;
  }
}

void ToolAttitude::end(bool again) {
  if (tip_.active())
    end_tip_control(again);
  else
    end_by_vector_alone(again);
}

}  // namespace toolcomp::fast
