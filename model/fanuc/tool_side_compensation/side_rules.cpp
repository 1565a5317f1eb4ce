#include "model/fanuc/tool_side_compensation/side_rules.h"

#include "model/basis/number.h"
#include "model/fanuc/tool_side_compensation/line_corner.h"

namespace toolcomp::model {
namespace {

bool is_known_zero(const Vector& v) {
  const auto zero = [](const Real& x) { return x.is_rational() && x.sign() == Sign::zero; };
  return zero(v.x) && zero(v.y) && zero(v.z);
}

// Both ends of a corner with an arc in a frame of the plane.
struct Framed {
  explicit Framed(const SideCorner& corner) {
    const Vector v1 = direction_of(corner.former);
    const Vector v2 = direction_of(corner.latter);
    if (is_known_zero(cross(v1, v2)) && !corner.plane.has_rational_tool()) {
      set_parallel(corner, v1, v2);
      return;
    }
    frame = corner.plane.frame();
    former = seen(corner.plane, frame, corner.former);
    latter = seen(corner.plane, frame, corner.latter);
  }

  PlaneFrame frame;
  PathEnd former;
  PathEnd latter;

 private:
  // A line along a radius, or both arcs with theirs in one line, make corners of exactly 0, 90 or 180 degrees under any
  // tool: in a frame along them this is no matter of proof.
  void set_parallel(const SideCorner& corner, const Vector& v1, const Vector& v2) {
    frame = corner.plane.frame_along(v2);
    const Real length = sqrt(squared_norm(corner.plane.left(v2)) / corner.plane.tool().norm2);
    const Real ratio = dot(v1, v2) / squared_norm(v2);
    former = seen(corner.plane, PlanePoint{ratio * length, 0}, corner.former);
    latter = seen(corner.plane, PlanePoint{length, 0}, corner.latter);
  }
};

// The stop point is the head of the intersection or of the first vector of an acute corner: the first head, or the one
// behind the vector that stands square to the former block.
void mark_stop(SpaceGroup& group) {
  const std::size_t stop = group.front().former == Seat::square ? 1 : 0;
  for (std::size_t i = stop + 1; i < group.size(); ++i) group[i].after_stop = true;
}

// Vectors square to a block have a simpler form than that in the frame.
SpaceGroup lifted(const SideCorner& corner, const PlaneFrame& frame, const VectorGroup& group) {
  SpaceGroup result;
  result.reserve(group.size());
  for (const CornerVector& v : group) {
    const Vector vector = v.former == Seat::square   ? perpendicular(corner.plane, corner.former)
                          : v.latter == Seat::square ? perpendicular(corner.plane, corner.latter)
                                                     : lift(frame, v.vector);
    result.push_back({vector, v.former, v.latter, false});
  }
  mark_stop(result);
  return result;
}

// The way round an outer corner, with the vectors square to the former and to the latter block where they are asked
// for.
SpaceGroup way_round(CornerClass kind, const LineCorner& lines, const SideCorner& corner, bool with_former,
                     bool with_latter) {
  SpaceGroup group;
  group.reserve(3);
  if (with_former) group.push_back({perpendicular(corner.plane, corner.former), Seat::square, Seat::off, false});
  if (kind == CornerClass::acute) {
    group.push_back({lines.prolonged(), Seat::off, Seat::off, false});
    group.push_back({lines.begun_before(), Seat::off, Seat::off, false});
  } else {
    group.push_back({lines.meeting(), Seat::off, Seat::off, false});
  }
  if (with_latter) group.push_back({perpendicular(corner.plane, corner.latter), Seat::off, Seat::square, false});
  mark_stop(group);
  return group;
}

SpaceGroup one(const Vector& vector) { return {{vector, Seat::on, Seat::on, false}}; }

}  // namespace

SideRules::SideRules(const spec::Setup& setup, Recorder& recorder)
    : recorder_(recorder),
      plane_rules_(setup, recorder),
      type_b_(setup.bit(5003, 0)),
      with_perpendicular_(!setup.type_b_without_perpendicular),
      limit_(setup.parameter(5010) ? plain(*setup.parameter(5010)) : Rational(0)) {}

SpaceGroup SideRules::square_to(const CompensationPlane& plane, const SideEnd& former) const {
  if (former.offset == 0) {
    recorder_.reach(Clause::fanuc_cutter_c_value_zero);
    return {{{}, Seat::square, Seat::square, false}};
  }
  return {{perpendicular(plane, former), Seat::square, Seat::off, false}};
}

SpaceGroup SideRules::square_to_latter(const CompensationPlane& plane, const SideEnd& latter) const {
  return {{perpendicular(plane, latter), Seat::off, Seat::square, false}};
}

// Of type B, by the clauses of start-up or cancel; nothing where the corner has one vector as in type A.
std::optional<SpaceGroup> SideRules::detour(const SideCorner& corner, bool cancels) const {
  if (!recorder_.decide(Clause::fanuc_tool_side_type_b, type_b_)) return std::nullopt;
  std::optional<Framed> framed;
  std::optional<LineCorner> lines;
  CornerClass kind{};
  if (corner.of_lines()) {
    kind = lines.emplace(recorder_, corner.plane, corner.former, corner.latter).classify();
    if (kind == CornerClass::acute && lines->is_under_one_degree()) return std::nullopt;
  } else {
    framed.emplace(corner);
    kind = classify(recorder_, framed->former, framed->latter);
  }
  if (kind == CornerClass::inner || kind == CornerClass::straight) {
    recorder_.reach(cancels ? Clause::fanuc_tool_side_cancel_inner : Clause::fanuc_tool_side_start_up_inner);
    return std::nullopt;
  }
  if (kind == CornerClass::obtuse)
    recorder_.reach(cancels ? Clause::fanuc_tool_side_cancel_obtuse : Clause::fanuc_tool_side_start_up_obtuse);
  else
    recorder_.reach(cancels ? Clause::fanuc_tool_side_cancel_acute : Clause::fanuc_tool_side_start_up_acute);
  const bool own = recorder_.decide(Clause::fanuc_tool_side_type_b_perpendicular, with_perpendicular_);
  const bool with_former = cancels ? corner.former.arc.has_value() : own;
  const bool with_latter = cancels ? own : corner.latter.arc.has_value();
  if (lines) return way_round(kind, *lines, corner, with_former, with_latter);
  return lifted(corner, framed->frame,
                model::way_round(kind, framed->former, framed->latter, with_former, with_latter));
}

SpaceGroup SideRules::start_up(const SideCorner& corner) const {
  const auto group = detour(corner, false);
  return group ? *group : square_to_latter(corner.plane, corner.latter);
}

SpaceGroup SideRules::cancel(const SideCorner& corner) const {
  const auto group = detour(corner, true);
  return group ? *group : square_to(corner.plane, corner.former);
}

std::optional<SpaceGroup> SideRules::in_mode(const SideCorner& corner) const {
  if (!corner.of_lines()) {
    const Framed framed(corner);
    const auto group = plane_rules_.offset_mode(framed.former, framed.latter);
    if (!group) return std::nullopt;
    return lifted(corner, framed.frame, *group);
  }
  const LineCorner lines(recorder_, corner.plane, corner.former, corner.latter);
  const CornerClass kind = lines.classify();
  switch (kind) {
    case CornerClass::inner:
      recorder_.reach(Clause::fanuc_tool_side_inner);
      return one(lines.meeting());
    case CornerClass::straight:
      recorder_.reach(Clause::fanuc_tool_side_inner);
      return one(perpendicular(corner.plane, corner.former));  // Vi, in a simpler form
    case CornerClass::obtuse:
      recorder_.reach(Clause::fanuc_tool_side_outer_obtuse);
      break;
    case CornerClass::acute:
      recorder_.reach(Clause::fanuc_tool_side_outer_acute);
      break;
  }
  return way_round(kind, lines, corner, false, false);
}

SpaceGroup SideRules::side_change(const SideCorner& corner) const {
  if (!corner.of_lines()) {
    const Framed framed(corner);
    return lifted(corner, framed.frame, plane_rules_.direction_change(framed.former, framed.latter));
  }
  const LineCorner lines(recorder_, corner.plane, corner.former, corner.latter);
  if (lines.is_parallel()) {
    recorder_.reach(Clause::fanuc_cutter_c_direction_change_without_intersection);
    return square_to_latter(corner.plane, corner.latter);
  }
  recorder_.reach(Clause::fanuc_cutter_c_direction_change_lines);
  return one(lines.meeting_across());
}

void SideRules::drop_small_differences(SpaceGroup& group, const Rational& distance) const {
  if (group.size() < 2 || limit_ < 0) return;
  const Rational limit2 = limit_ * limit_;
  const Rational scale = limit2 + 8 * distance * distance;
  SpaceGroup kept{group.front()};
  for (std::size_t i = 1; i < group.size(); ++i) {
    const Real difference2 = squared_norm(group[i].vector - kept.back().vector);
    if (recorder_.decide(Clause::fanuc_tool_side_small_difference, limit2 - difference2, scale) == Sign::negative)
      kept.push_back(group[i]);
  }
  group = kept;
}

}  // namespace toolcomp::model
