// SPDX-License-Identifier: Apache-2.0
// Tool center point control G43.4 G43.5: the state of the mode, what a block does with the rotary axes.
#include <bit>
#include <cmath>

#include "fast/fanuc/control/read_words.h"
#include "fast/fanuc/control/tool_attitude.h"
#include "fast/fanuc/program/arc.h"

namespace toolcomp::fast {
namespace {

constexpr std::uint32_t kDirectionLetters = Words::set_of("IJK");
const DoubleDouble kUnitsPerOne = to_double_double(Count::kRestPerOne);

DoubleDouble fine(const Count& value) { return to_double_double(value.units()) / kUnitsPerOne; }
Vector3<DoubleDouble> fine(const std::array<Count, 3>& v) { return {fine(v[0]), fine(v[1]), fine(v[2])}; }

// The nearest whole number of units.
Count nearest_count(const DoubleDouble& value) {
  const DoubleDouble units = value * kUnitsPerOne;
  const double whole = std::nearbyint(units.hi);
  return Count::of_units(static_cast<Int128>(whole) +
                         static_cast<Int128>(std::nearbyint((units.hi - whole) + units.lo)));
}

// The sweep of an arc by radius, `center` from its start; units alike. Half of it is seen from the middle of the chord.
DoubleDouble radians_of(const std::array<DoubleDouble, 2>& center, const std::array<Count, 2>& start,
                        const std::array<Count, 2>& end, bool larger) {
  std::array<DoubleDouble, 2> half_chord;
  std::array<DoubleDouble, 2> height;
  for (std::size_t i = 0; i < 2; ++i) {
    half_chord[i] = to_double_double((end[i] - start[i]).units()) * 0.5;
    height[i] = center[i] - half_chord[i];
  }
  const auto length = [](const std::array<DoubleDouble, 2>& v) { return sqrt(v[0] * v[0] + v[1] * v[1]); };
  const DoubleDouble across = length(height);
  const Count half = fine_arctangent(length(half_chord), larger ? -across : across);
  constexpr DoubleDouble kTwiceRadians{0x1.1df46a2529d39p-5, 0x1.5c1d8becdd291p-61};  // pi / 90
  return fine(half) * kTwiceRadians;
}

bool is_quarter(const SineCosine<double>& turn) { return turn.sine == 0 || turn.cosine == 0; }

}  // namespace

Vector3<DoubleDouble> ToolAttitude::fine_origin() const {
  std::array<Count, 3> origin;
  for (std::size_t i = 0; i < 3; ++i)
    if (axes_.xyz[i] != spec::Axes::kNone) origin[i] = positions_.machine_origin(axes_.xyz[i]);
  return fine(origin);
}

// What the stages and the events see of a pose. The exact positions of the rotary axes are made when the mode ends.
void ToolAttitude::take_posture(const Pose& pose) {
  tool_.next() = pose.tool;
  if (!modal_.by_vector()) return;
  for (std::size_t i = 0; i < 2; ++i)
    if (const std::size_t axis = machine_.rotary_axis(i); axis != spec::kMaxAxes)
      positions_.show(axis, machine_.programmed_degrees(pose, i));
}

Alarm ToolAttitude::place(const Words& words, Mask axes) {
  // Where the block starts counts for a lean and on a table.
  std::array<Count, 3> from;
  RotaryPositions before;
  if (!lean_angle_.is_zero() || machine_.workpiece_frame()) [[unlikely]] {
    from = positions_.programmed_xyz();
    for (std::size_t i = 0; i < 2; ++i)
      if (machine_.rotary_axis(i) != spec::kMaxAxes) before[i] = positions_.programmed()[machine_.rotary_axis(i)];
  }
  if (const Alarm a = positions_.place_words(words, axes, units_, modal_.incremental())) [[unlikely]]
    return a;
  if (tip_.active()) {
    TipBlock& block = tip_.next();
    block.length = along_length_;
    block.sampled = samples_block_;
    if (const Alarm a = starts_tip_ ? start(words) : plan_posture(words, axes, from, before)) [[unlikely]]
      return a;
  } else if (starts_tip_) {
    commanded_ = tool_.now();
  } else if (asks_direction(words, from)) {
    tool_.next() = leaned(words, from);
  }
  starts_tip_ = false;
  return positions_.stale() == 0 ? AlarmCause::none : positions_.refresh();
}

Alarm ToolAttitude::plan_posture(const Words& words, Mask axes, const std::array<Count, 3>& from,
                                 const RotaryPositions& before) {
  TipBlock& block = tip_.block();
  if (modal_.by_vector()) return plan_direction(words, from, block);
  const Pose& start = tip_.before().plan.end;
  if (machine_.workpiece_frame() && modal_.is_arc(words) &&
      modal_.runs_arc(words, modal_.in_selected_plane(from), modal_.in_selected_plane(positions_.programmed_xyz())))
    if (const Alarm a = check_workpiece_arc(before, start)) return a;
  if ((axes & axes_.turning) == 0) {
    posture_.stand(start, block.plan);
  } else {
    pose_commanded(block.plan.end);
    posture_.plan(start, block.plan.end, posture_control_, block.plan);
    if (const Alarm a = alarm_of(block.plan.outcome)) return a;
    take_posture(block.plan.end);
  }
  if (machine_.workpiece_frame() && machine_.has_table()) keep_tip_on_table(axes, start, block.plan.end, from);
  return AlarmCause::none;
}

// Type 2: the direction commanded or kept, leaned, and what it makes of the rotary axes.
Alarm ToolAttitude::plan_direction(const Words& words, const std::array<Count, 3>& from, TipBlock& block) {
  const Pose& start = tip_.before().plan.end;
  if (!asks_direction(words, from)) {
    posture_.stand(start, block.plan);
    return AlarmCause::none;
  }
  posture_.plan(start, leaned(words, from), posture_control_, block.plan);
  if (const Alarm a = alarm_of(block.plan.outcome)) return a;
  if (block.plan.changed) commanded_ = block.plan.end.tool;
  take_posture(block.plan.end);
  return AlarmCause::none;
}

// I J K, or a travel under Q.
bool ToolAttitude::asks_direction(const Words& words, const std::array<Count, 3>& from) {
  if (words.has_any(kDirectionLetters)) {
    if (!read_usual_direction(words, commanded_)) [[unlikely]]
      read_direction(words, commanded_);
    return true;
  }
  return !lean_angle_.is_zero() && !(from == positions_.programmed_xyz());
}

const Direction& ToolAttitude::leaned(const Words& words, const std::array<Count, 3>& from) {
  if (lean_angle_.is_zero()) return commanded_;
  return lean(words, from, leaned_) ? leaned_ : commanded_;
}

// By Q, toward the travel; in an arc toward its tangent at the end.
bool ToolAttitude::lean(const Words& words, const std::array<Count, 3>& from, Direction& to_direction) const {
  const std::array<Count, 3> to = positions_.programmed_xyz();
  const std::array<std::size_t, 2> in{in_plane(modal_.plane(), 0), in_plane(modal_.plane(), 1)};
  const std::array<Count, 2> start = modal_.in_selected_plane(from);
  const std::array<Count, 2> end = modal_.in_selected_plane(to);
  if (!modal_.is_arc(words) || !modal_.runs_arc(words, start, end)) {
    std::array<Int128, 3> travel{};
    for (std::size_t i = 0; i < 3; ++i) travel[i] = to[i].units() - from[i].units();
    return fast::lean(kinematics_, commanded_, travel, lean_angle_, to_direction);
  }
  ArcWords arc;
  modal_.read_arc(words, units_, arc);
  const std::array<DoubleDouble, 2> center = fine_center(start, end, arc);
  std::array<DoubleDouble, 2> radius;
  for (std::size_t i = 0; i < 2; ++i) radius[i] = to_double_double((end[i] - start[i]).units()) - center[i];
  FineVector tangent{};
  tangent[in[0]] = arc.clockwise ? radius[1] : -radius[1];
  tangent[in[1]] = arc.clockwise ? -radius[0] : radius[0];
  // A helix climbs. Arcs are by radius here: R tells which of the two sweeps it is.
  const std::size_t normal = 3 - in[0] - in[1];
  if (const Count climb = to[normal] - from[normal]; !climb.is_zero())
    tangent[normal] = to_double_double(climb.units()) / radians_of(center, start, end, arc.radius < Count());
  return fast::lean(kinematics_, commanded_, tangent, lean_angle_, to_direction);
}

// WKP = 1: the table must stand as it did when the mode began.
Alarm ToolAttitude::check_workpiece_arc(const RotaryPositions& before, const Pose& start) const {
  constexpr double kNothing = 0x1p-80;  // of a unit vector in double-double
  bool turned = false;
  for (std::size_t i = machine_.type() == 12 ? 0 : 1; machine_.has_table() && i < 2; ++i) {
    const std::size_t axis = machine_.rotary_axis(i);
    if (axis == spec::kMaxAxes || (before[i] == frozen_[axis] && positions_.programmed()[axis] == frozen_[axis]))
      continue;
    const FineVector& line = (i == 0 ? kinematics_.inner() : kinematics_.outer()).axis;
    Vector3<DoubleDouble> standing{line[0], line[1], line[2]};
    // The first axis of a table carries the second.
    if (i == 1) standing = machine_.in_machine(standing, machine_.fine_turns(start));
    for (std::size_t k = 0; k < 2; ++k)
      if (std::fabs(standing[in_plane(modal_.plane(), k)].hi) > kNothing) return AlarmCause::table_turned_in_arc;
    turned = true;
  }
  return turned ? AlarmCause::arc_with_table_turned : AlarmCause::none;
}

// WKP = 1: without X Y Z the tip keeps its place on the table, and the programmed position follows it.
void ToolAttitude::keep_tip_on_table(Mask axes, const Pose& start, const Pose& end, const std::array<Count, 3>& from) {
  bool named = false;
  for (const std::size_t axis : axes_.xyz) named |= axis != spec::Axes::kNone && (axes & bit(axis)) != 0;
  if (named) {
    has_table_tip_ = false;
    return;
  }
  if ((axes & axes_.turning) == 0) return;
  const Vector3<DoubleDouble> origin = fine_origin();
  const Vector3<DoubleDouble> shift = fine(positions_.shift_xyz());
  if (!has_table_tip_) table_tip_ = machine_.to_table(fine(from) + shift, machine_.fine_turns(start), origin);
  has_table_tip_ = true;
  const Vector3<DoubleDouble> tip = machine_.from_table(table_tip_, machine_.fine_turns(end), origin);
  for (std::size_t i = 0; i < 3; ++i)
    if (axes_.xyz[i] != spec::Axes::kNone) {
      positions_.set(axes_.xyz[i], nearest_count(tip[i] - shift[i]));
      positions_.set_rounded(bit(axes_.xyz[i]));
    }
  positions_.make_stale();
}

// P and Q, where they are no data of another code.
void ToolAttitude::begin(const Words& words) {
  const bool data = words.code(Words::kOneShot) != kNone || words.letters_are_data();
  posture_control_ = words.has('P') && !data ? whole_number(words['P'], 1) == 1 : posture_.by_default();
  lean_angle_ = modal_.by_vector() && words.has('Q') && !data ? Count::of(words['Q']) : Count();
  starts_tip_ = plans_tool_ = machine_.defined() || !lean_angle_.is_zero();
  if (machine_.defined()) tip_.start();
}

// The block of G43.4 or G43.5 has gone to its positions: the length is applied, the frame is that of the pose here.
Alarm ToolAttitude::start(const Words& words) {
  TipBlock& block = tip_.block();
  has_table_tip_ = false;
  kinematics_.see_from_table(true);
  Pose pose;
  machine_.pose(positions_.programmed(), rounded_angles(), pose);
  if (stands_as_before()) {
    // A table begins a new system; what a position does not tell is the branch, hardly out of a singular posture.
    if (machine_.has_table())
      machine_.set_branch(pose, standing_->branch);
    else
      pose = *standing_;
  }
  standing_.reset();
  if (modal_.by_vector() && words.has_any(kDirectionLetters)) {
    Direction direction;
    read_direction(words, direction);
    Pose turned;
    if (!machine_.choose(direction, pose, turned)) return AlarmCause::unreachable;
    pose = turned;
  }
  machine_.freeze(pose);
  posture_.stand(pose, block.plan);
  commanded_ = pose.tool;
  frozen_ = positions_.programmed();
  take_posture(pose);
  std::array<double, spec::kMaxAxes> origin{};
  for (std::size_t axis = 0; axis < axes_.count; ++axis) origin[axis] = positions_.machine_origin(axis).nearest();
  tip_.set_origin(origin);
  return AlarmCause::none;
}

// Whether another G43.4 or G43.5 finds the head as the one before left it: its tool is better known than by the
// positions made of it.
bool ToolAttitude::stands_as_before() const {
  for (std::size_t i = 0; standing_ && i < 2; ++i)
    if (const std::size_t axis = machine_.rotary_axis(i); axis != spec::kMaxAxes)
      if (positions_.programmed()[axis] != standing_at_[i]) return false;
  return standing_.has_value();
}

void ToolAttitude::end_tip_control(bool again) {
  const Pose& pose = tip_.block().plan.end;
  const Turns<DoubleDouble> turns = machine_.fine_turns(pose);
  const Vector3<DoubleDouble> origin = fine_origin();
  const bool on_table = machine_.has_table();
  // A shift of G45 to G48 from before goes on.
  const std::array<Count, 3> shift = positions_.shift_xyz();
  Vector3<DoubleDouble> tip = fine(positions_.programmed_xyz()) + fine(shift);
  if (on_table && machine_.workpiece_frame()) tip = has_table_tip_ ? table_tip_ : machine_.to_table(tip, turns, origin);
  // That of the tip stays the programmed one.
  const bool keeps = again || cancel_moves_;
  if (!keeps || (on_table && !machine_.workpiece_frame())) {
    const Vector3<DoubleDouble> position = keeps ? machine_.from_table(tip, turns, origin)
                                                 : machine_.control_point(tip, turns, fine(tool_length()), origin);
    // Turned by quarters, along the axes of the machine, the position is exact.
    const bool exact = machine_.polar().along_axes() && kinematics_.frame().along_axes &&
                       is_quarter(pose.axis[0].turn) && is_quarter(pose.axis[1].turn) &&
                       std::popcount(pose.tool.zero) == 2;
    for (std::size_t i = 0; i < 3; ++i) {
      if (axes_.xyz[i] == spec::Axes::kNone) continue;
      positions_.set(axes_.xyz[i], nearest_count(position[i] - fine(shift[i])));
      if (!exact) positions_.set_rounded(bit(axes_.xyz[i]));
    }
  }
  if (modal_.by_vector())
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t axis = machine_.rotary_axis(i);
      if (axis == spec::kMaxAxes) continue;
      positions_.set(axis, machine_.programmed(pose, i));
      const bool exact = pose.axis[i].kind == RotaryPosition::Kind::exact;
      if (exact)
        positions_.clear_rounded(bit(axis));
      else
        positions_.set_rounded(bit(axis));
      standing_at_[i] = positions_.programmed()[axis];
    }
  standing_.reset();
  if (again && modal_.by_vector()) standing_ = pose;
  positions_.make_stale();
  machine_.release();
  kinematics_.see_from_table(false);
  turn();
  tip_.end();
  plans_tool_ = false;
}

}  // namespace toolcomp::fast
