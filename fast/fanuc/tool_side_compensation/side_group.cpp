#include "fast/fanuc/tool_side_compensation/side_group.h"

#include <cmath>
#include <string>

#include "fast/basis/fault.h"
#include "spec/language/input_error.h"

namespace toolcomp::fast {
namespace {

bool first_is_arc(const SideCorner& corner) { return corner.first->arc; }
bool second_is_arc(const SideCorner& corner) { return corner.second != nullptr && corner.second->arc; }

bool is_straight(const SideCorner& corner) {
  return SideGeometry::cross(corner) == 0 && SideGeometry::along(corner) > 0;
}

// 180 degrees or more on the side of the workpiece; straight back is an outer corner of 0 degrees.
bool is_inner(const SideCorner& corner) {
  const int cross = SideGeometry::cross(corner);
  if (fault(Fault::side_reversal_inner) && cross == 0) return true;
  return corner.first_side * cross > 0 || is_straight(corner);
}

bool is_obtuse(const SideCorner& corner) { return SideGeometry::along(corner) >= 0; }

bool offset_circles_exist(const SideCorner& corner) {
  const Corner& c = corner.plane;
  if (offset_radius_sign(*c.first, true, c.first_side, *c.offset) < 0) return false;
  return c.second == nullptr || offset_radius_sign(*c.second, false, c.second_side, *c.offset) >= 0;
}

Count count_parameter(const spec::Setup& setup, std::uint32_t number) {
  const auto value = setup.parameter(number);
  if (!value) return {};
  if (!fits_count(*value))
    throw spec::InputError("setup", 0, 0, "parameters.\"" + std::to_string(number) + "\": too large");
  return Count::of(*value);
}

}  // namespace

SideParameters::SideParameters(const spec::Setup& setup)
    : type(setup.bit(5003, 1) ? StartType::c : (setup.bit(5003, 0) ? StartType::b : StartType::a)),
      bare_b(setup.type_b_without_perpendicular),
      no_interference(setup.bit(5008, 0)),
      no_plane_change(setup.bit(19605, 5)),
      tilt(setup),
      no_movement(count_parameter(setup, 19630)),
      small(count_parameter(setup, 5010)),
      small_value(small.nearest()),
      keeps_all(small < Count()) {}

// The intersection of the offset tangents, or the prolonged ones at an acute corner.
void SideGroups::add_outer(SideGroup& group) const {
  if (is_obtuse(group.corner)) {
    add(group, HeadKind::tangents_meet);
    return;
  }
  add(group, HeadKind::first_extended);
  add(group, HeadKind::second_extended);
}

bool SideGroups::set_meeting(SideGroup& group, HeadKind kind) {
  Vector3<double> vector;
  if (!SideGeometry::paths_meet(group.corner, kind, vector)) return false;
  group.size = 1;
  group.head[0] = {vector, kind};
  return true;
}

bool SideGroups::make_ordinary(SideGroup& group) const {
  const SideCorner& corner = group.corner;
  if (is_straight(corner)) {
    set(group, HeadKind::first_normal);
    return true;
  }
  if (is_inner(corner)) {
    if (!corner.flat) {
      set(group, HeadKind::tangents_meet);
      return true;
    }
    // An offset circle of a negative radius meets nothing; its arc is left to the interference check.
    if (!offset_circles_exist(corner)) {
      set(group, HeadKind::first_normal);
      return true;
    }
    return set_meeting(group, HeadKind::paths_meet);
  }
  group.size = 0;
  if (first_is_arc(corner)) add(group, HeadKind::first_normal);
  add_outer(group);
  if (second_is_arc(corner)) add(group, HeadKind::second_normal);
  return true;
}

void SideGroups::make_start_up(SideGroup& group) const {
  const SideCorner& corner = group.corner;
  if (parameters_.type != StartType::b || is_inner(corner) || geometry_.is_under_one_degree(corner)) {
    set(group, HeadKind::second_normal);
    return;
  }
  group.size = 0;
  if (!parameters_.bare_b) add(group, HeadKind::first_normal);
  add_outer(group);
  if (second_is_arc(corner)) add(group, HeadKind::second_normal);
}

void SideGroups::make_cancel(SideGroup& group) const {
  const SideCorner& corner = group.corner;
  if (parameters_.type != StartType::b || is_inner(corner) || geometry_.is_under_one_degree(corner)) {
    set(group, HeadKind::first_normal);
    return;
  }
  group.size = 0;
  if (first_is_arc(corner)) add(group, HeadKind::first_normal);
  add_outer(group);
  if (!parameters_.bare_b) add(group, HeadKind::second_normal);
}

// Where the paths have no point in common the perpendicular vector of the latter one.
void SideGroups::make_side_change(SideGroup& group) const {
  const SideCorner& corner = group.corner;
  if (SideGeometry::cross(corner) != 0) {
    if (!corner.flat) {
      set(group, HeadKind::paths_cross);
      return;
    }
    if (offset_circles_exist(corner) && set_meeting(group, HeadKind::paths_cross)) return;
  }
  set(group, HeadKind::second_normal);
}

// |a - b| <= limit; what double-double cannot tell is taken for equal.
bool SideGroups::is_within(const SideGroup& group, std::size_t a, std::size_t b) const {
  const Vector3<double> difference = group.head[a].vector - group.head[b].vector;
  const double distance = std::sqrt(dot(difference, difference));
  const double over = distance - parameters_.small_value;
  const double scale = 4 * group.corner.offset->nearest + parameters_.small_value;
  if (std::abs(over) > 0x1p-42 * scale) return over < 0;
  const Vector3<DoubleDouble> refined = fine(group, a) - fine(group, b);
  const DoubleDouble limit = to_double_double(parameters_.small.units()) / to_double_double(Count::kRestPerOne);
  return (sqrt(dot(refined, refined)) - limit).hi <= 0x1p-86 * scale;
}

// No. 5010: a vector near the last one kept is dropped; the first stays.
void SideGroups::drop_small_movements(SideGroup& group) const {
  if (group.size < 2 || parameters_.keeps_all) return;
  if (second_is_arc(group.corner) && group.corner.second->flat.semicircle) return;
  std::array<bool, 4> keep{true, true, true, true};
  std::size_t last = 0;
  for (std::size_t i = 1; i < group.size; ++i) {
    keep[i] = !is_within(group, i, last);
    if (keep[i]) last = i;
  }
  std::uint8_t size = 0;
  for (std::size_t i = 0; i < group.size; ++i)
    if (keep[i]) group.head[size++] = group.head[i];
  group.size = size;
}

bool SideGroups::make(SideGroup& group, CornerRule rule, Treatment treatment) const {
  const SideCorner& corner = group.corner;
  if (corner.offset->nearest == 0) {
    group.clear();
    return true;
  }
  if (treatment == Treatment::perpendicular && (rule == CornerRule::ordinary || rule == CornerRule::repeated)) {
    set(group, HeadKind::first_normal);
    return true;
  }
  if (corner.first_side != corner.second_side) {
    make_side_change(group);
    return true;
  }
  switch (rule) {
    case CornerRule::repeated:
    case CornerRule::direction:
      set(group, HeadKind::first_normal);
      return true;
    case CornerRule::start_up:
      make_start_up(group);
      break;
    case CornerRule::cancel:
      make_cancel(group);
      break;
    case CornerRule::ordinary:
      if (!make_ordinary(group)) return false;
      if (treatment == Treatment::first_only && !corner.flat && !fault(Fault::side_q2_ignored)) group.size = 1;
      break;
  }
  drop_small_movements(group);
  return true;
}

}  // namespace toolcomp::fast
