#include "fast/fanuc/cutter_compensation_c/corner_group.h"

#include <cmath>

#include "fast/basis/fault.h"
#include "spec/language/input_error.h"

namespace toolcomp::fast {
namespace {

bool first_is_arc(const Corner& corner) { return corner.first->arc; }
bool second_is_arc(const Corner& corner) { return corner.second != nullptr && corner.second->arc; }

bool is_straight(const Corner& corner) { return corner.turn.c == 0 && corner.turn.k > 0; }

// 180 degrees or more on the side of the workpiece; straight back is an outer corner of 0 degrees.
bool is_inner(const Corner& corner) {
  if (fault(Fault::c_reversal_inner) && corner.turn.c == 0) return true;
  return corner.first_side * corner.turn.c > 0 || is_straight(corner);
}

bool is_obtuse(const Corner& corner) { return corner.turn.k >= 0; }

// An acute corner of two lines under 1 degree: (tan 1 k)^2 > c^2.
bool is_under_one_degree(const Corner& corner) {
  if (first_is_arc(corner) || second_is_arc(corner) || corner.turn.k >= 0 || fault(Fault::c_no_one_degree_rule))
    return false;
  // 0.0174550649282175857651288952197, to 31 digits.
  constexpr DoubleDouble kTangent{0x1.1dfbd9410a422p-6, 0x1.8c721220dd4afp-62};
  const double left = kTangent.hi * corner.turn.k;
  const double difference = left * left - corner.turn.c * corner.turn.c;
  if (std::abs(difference) > 0x1p-48 * left * left) return difference > 0;
  const Vector2<DoubleDouble> t1 = fine_unit(*corner.last);
  const Vector2<DoubleDouble> t2 = fine_unit(*corner.next);
  const DoubleDouble tangent = kTangent * dot(t1, t2);
  const DoubleDouble sine = cross(t1, t2);
  return (tangent * tangent - sine * sine).hi > 0;
}

// The intersection of the offset tangents, or the prolonged ones at an acute corner.
void add_outer(CornerGroup& group) {
  if (is_obtuse(group.corner)) {
    group.add(fault(Fault::c_perpendicular_for_intersection) ? HeadKind::first_normal : HeadKind::tangents_meet);
    return;
  }
  group.add(HeadKind::first_extended);
  group.add(HeadKind::second_extended);
}

bool offset_circles_exist(const Corner& corner) {
  if (offset_radius_sign(*corner.first, true, corner.first_side, *corner.offset) < 0) return false;
  return corner.second == nullptr || offset_radius_sign(*corner.second, false, corner.second_side, *corner.offset) >= 0;
}

// False where there is no intersection.
bool make_ordinary(CornerGroup& group) {
  const Corner& corner = group.corner;
  if (is_straight(corner)) {
    group.set(HeadKind::first_normal);
    return true;
  }
  if (is_inner(corner)) {
    if (!first_is_arc(corner) && !second_is_arc(corner)) {
      group.set(HeadKind::tangents_meet);
      return true;
    }
    // An offset circle of a negative radius meets nothing; its arc is left to the interference check.
    if (!offset_circles_exist(corner)) {
      group.set(HeadKind::first_normal);
      return true;
    }
    Vector2<double> meeting;
    if (!offset_paths_meet(corner, HeadKind::paths_meet, meeting)) return false;
    group.set(HeadKind::paths_meet, meeting);
    return true;
  }
  group.size = 0;
  group.cleared = 0;
  if (first_is_arc(corner)) group.add(HeadKind::first_normal);
  add_outer(group);
  if (second_is_arc(corner)) group.add(HeadKind::second_normal);
  return true;
}

void make_start_up(CornerGroup& group, const CornerParameters& parameters) {
  const Corner& corner = group.corner;
  if (!parameters.type_b || is_inner(corner) || is_under_one_degree(corner)) {
    group.set(fault(Fault::c_start_from_own_block) ? HeadKind::first_normal : HeadKind::second_normal);
    return;
  }
  group.set(HeadKind::first_normal);
  add_outer(group);
  if (second_is_arc(corner)) group.add(HeadKind::second_normal);
}

void make_cancel(CornerGroup& group, const CornerParameters& parameters) {
  const Corner& corner = group.corner;
  if (!parameters.type_b || is_inner(corner) || is_under_one_degree(corner)) {
    group.set(HeadKind::first_normal);
    return;
  }
  group.size = 0;
  group.cleared = 0;
  if (first_is_arc(corner)) group.add(HeadKind::first_normal);
  add_outer(group);
  if (!fault(Fault::c_cancel_without_perpendicular)) group.add(HeadKind::second_normal);
}

// Where the paths have no point in common the first (change of direction: second) perpendicular vector.
void make_meeting(CornerGroup& group, HeadKind meeting, HeadKind otherwise) {
  const Corner& corner = group.corner;
  Vector2<double> vector;
  if (corner.turn.c != 0 && offset_circles_exist(corner) && offset_paths_meet(corner, meeting, vector))
    group.set(meeting, vector);
  else
    group.set(otherwise);
}

// Two heads of a group in one axis: |a - b| against the limit of No. 5010.
struct Distance {
  const CornerGroup& group;
  std::size_t a;
  std::size_t b;
  const CornerParameters& parameters;

  [[nodiscard]] double scale(double va, double vb) const {
    return std::abs(va) + std::abs(vb) + group.corner.offset->nearest + parameters.limit_value;
  }
  // > 0 beyond it, < 0 within it; 0 where doubles cannot tell.
  [[nodiscard]] double over(double Vector2<double>::* axis) const {
    const double va = group.head[a].vector.*axis;
    const double vb = group.head[b].vector.*axis;
    const double over = std::abs(va - vb) - parameters.limit_value;
    return std::abs(over) > 0x1p-46 * scale(va, vb) ? over : 0;
  }
  // What double-double cannot tell is taken for equal.
  [[nodiscard]] bool is_finely_within(DoubleDouble Vector2<DoubleDouble>::* axis) const {
    const DoubleDouble va = group.fine(a).*axis;
    const DoubleDouble vb = group.fine(b).*axis;
    const DoubleDouble difference = va - vb;
    const DoubleDouble limit = to_double_double(parameters.limit.units()) / to_double_double(Count::kRestPerOne);
    const DoubleDouble over = (difference.hi < 0 ? -difference : difference) - limit;
    return over.hi <= 0x1p-88 * scale(va.hi, vb.hi);
  }
};

// Within the limit in both axes.
bool is_small_movement(const Distance& distance) {
  const double x = distance.over(&Vector2<double>::x);
  const double y = fault(Fault::c_small_movement_one_axis) ? -1 : distance.over(&Vector2<double>::y);
  if (x > 0 || y > 0) return false;
  return (x < 0 || distance.is_finely_within(&Vector2<DoubleDouble>::x)) &&
         (y < 0 || distance.is_finely_within(&Vector2<DoubleDouble>::y));
}

// No. 5010: a vector near the last one kept is dropped; the first stays.
void drop_small_movements(CornerGroup& group, const CornerParameters& parameters) {
  if (group.size < 2 || parameters.negative_limit) return;
  if (second_is_arc(group.corner) && group.corner.second->semicircle) return;
  std::array<bool, 4> keep{true, true, true, true};
  std::size_t last = 0;
  for (std::size_t i = 1; i < group.size; ++i) {
    keep[i] = !is_small_movement({group, i, last, parameters});
    if (keep[i]) last = i;
  }
  std::uint8_t size = 0;
  for (std::size_t i = 0; i < group.size; ++i)
    if (keep[i]) group.head[size++] = group.head[i];
  group.size = size;
}

}  // namespace

CornerParameters::CornerParameters(const spec::Setup& setup)
    : type_b(setup.bit(5003, 0)),
      acts_alone(setup.bit(5003, 1)),
      keeps_mode(setup.bit(5003, 2)),
      no_interference(setup.bit(5008, 0)) {
  if (const auto value = setup.parameter(5010)) {
    if (!fits_count(*value)) throw spec::InputError("setup", 0, 0, "parameters.\"5010\": too large");
    limit = Count::of(*value);
    limit_value = limit.nearest();
    negative_limit = limit < Count();
  }
}

bool make_group(CornerGroup& group, CornerRule rule, const CornerParameters& parameters) {
  const Corner& corner = group.corner;
  if (corner.offset->nearest == 0) {
    group.clear();
    return true;
  }
  if (corner.first_side != corner.second_side) {
    make_meeting(group, HeadKind::paths_cross, HeadKind::second_normal);
    return true;
  }
  switch (rule) {
    case CornerRule::repeated:
      group.set(HeadKind::first_normal);
      return true;
    case CornerRule::direction:
      make_meeting(group, HeadKind::paths_meet, HeadKind::first_normal);
      return true;
    case CornerRule::start_up:
      make_start_up(group, parameters);
      break;
    case CornerRule::cancel:
      make_cancel(group, parameters);
      break;
    case CornerRule::ordinary:
      if (!make_ordinary(group)) return false;
      break;
  }
  drop_small_movements(group, parameters);
  return true;
}

}  // namespace toolcomp::fast
