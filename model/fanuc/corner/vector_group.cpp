#include "model/fanuc/corner/vector_group.h"

#include <algorithm>

#include "model/basis/number.h"

namespace toolcomp::model {
namespace {

CornerVector p1(const PathEnd& former) { return {perpendicular(former), Seat::square, Seat::off}; }
CornerVector p2(const PathEnd& latter) { return {perpendicular(latter), Seat::off, Seat::square}; }

// An offset of 0 leaves one vector, zero; it stands square to everything.
VectorGroup zero(Recorder& recorder) {
  recorder.reach(Clause::fanuc_cutter_c_value_zero);
  return {{{}, Seat::square, Seat::square}};
}

VectorGroup one(const PlanePoint& meeting) { return {{meeting, Seat::on, Seat::on}}; }

}  // namespace

SpaceGroup in_space(spec::Plane plane, const VectorGroup& group) {
  SpaceGroup result;
  result.reserve(group.size());
  for (const CornerVector& v : group)
    result.push_back({in_space(plane, v.vector), v.former, v.latter, !result.empty()});
  return result;
}

VectorGroup way_round(CornerClass kind, const PathEnd& former, const PathEnd& latter, bool with_p1, bool with_p2) {
  VectorGroup group;
  group.reserve(4);
  if (with_p1) group.push_back(p1(former));
  if (kind == CornerClass::acute) {
    group.push_back({prolonged(former), Seat::off, Seat::off});
    group.push_back({begun_before(latter), Seat::off, Seat::off});
  } else {
    group.push_back({tangents_meet(former, latter), Seat::off, Seat::off});
  }
  if (with_p2) group.push_back(p2(latter));
  return group;
}

// The sweep is 180° or more where its sine is not positive; a whole turn too.
bool is_under_half_circle(Recorder& recorder, const PlanePoint& start, const PlanePoint& end, int turn,
                          const Real& radii) {
  return recorder.decide(Clause::fanuc_cutter_c_small_corner_before_half_circle, Real(turn) * cross(start, end),
                         radii) == Sign::positive;
}

CornerRules::CornerRules(const spec::Setup& setup, Recorder& recorder)
    : recorder_(recorder),
      type_b_(setup.bit(5003, 0)),
      limit_(setup.parameter(5010) ? plain(*setup.parameter(5010)) : Rational(0)) {}

VectorGroup CornerRules::square_to(const PathEnd& former) const {
  return former.offset == 0 ? zero(recorder_) : VectorGroup{p1(former)};
}

std::optional<CornerClass> CornerRules::detour(const PathEnd& former, const PathEnd& latter, bool to_line) const {
  if (!recorder_.decide(Clause::fanuc_cutter_c_start_up_type, type_b_)) return std::nullopt;
  const CornerClass kind = classify(recorder_, former, latter);
  if (kind == CornerClass::acute && to_line && is_under_one_degree(recorder_, former, latter)) return std::nullopt;
  return kind;
}

VectorGroup CornerRules::start_up(const PathEnd& former, const PathEnd& latter) const {
  const auto kind = detour(former, latter, !latter.is_arc());
  if (!kind) return {p2(latter)};
  if (*kind == CornerClass::inner || *kind == CornerClass::straight) {
    recorder_.reach(Clause::fanuc_cutter_c_start_up_inner);
    return {p2(latter)};
  }
  recorder_.reach(*kind == CornerClass::obtuse ? Clause::fanuc_cutter_c_start_up_obtuse
                                               : Clause::fanuc_cutter_c_start_up_acute);
  return way_round(*kind, former, latter, true, latter.is_arc());
}

VectorGroup CornerRules::cancel(const PathEnd& former, const PathEnd& latter) const {
  const auto kind = detour(former, latter, !former.is_arc());
  if (!kind) return {p1(former)};
  if (*kind == CornerClass::inner || *kind == CornerClass::straight) {
    recorder_.reach(Clause::fanuc_cutter_c_cancel_inner);
    return {p1(former)};
  }
  recorder_.reach(*kind == CornerClass::obtuse ? Clause::fanuc_cutter_c_cancel_obtuse
                                               : Clause::fanuc_cutter_c_cancel_acute);
  return way_round(*kind, former, latter, former.is_arc(), true);
}

std::optional<VectorGroup> CornerRules::offset_mode(const PathEnd& former, const PathEnd& latter) const {
  const CornerClass kind = classify(recorder_, former, latter);
  switch (kind) {
    case CornerClass::straight:
      recorder_.reach(Clause::fanuc_cutter_c_tangent_join);
      return VectorGroup{{perpendicular(former), Seat::square, Seat::square}};
    case CornerClass::obtuse:
      recorder_.reach(Clause::fanuc_cutter_c_outer_obtuse);
      return way_round(kind, former, latter, former.is_arc(), latter.is_arc());
    case CornerClass::acute:
      recorder_.reach(Clause::fanuc_cutter_c_outer_acute);
      return way_round(kind, former, latter, former.is_arc(), latter.is_arc());
    case CornerClass::inner:
      break;
  }
  if (!former.is_arc() && !latter.is_arc()) recorder_.reach(Clause::fanuc_cutter_c_inner_lines);
  if (!have_offset_paths(recorder_, former, latter)) return VectorGroup{p1(former)};
  const auto meeting = paths_meet(recorder_, former, latter);
  if (!meeting) return std::nullopt;
  return one(*meeting);
}

VectorGroup CornerRules::cancel_along(const PathEnd& former, const PlanePoint& direction) const {
  PathEnd line;
  line.heading = heading(direction);
  line.offset = former.offset;
  const Sign turn =
      recorder_.decide(Clause::fanuc_cutter_c_cancel_direction_parallel,
                       cross(former.heading.along, line.heading.along), former.heading.length * line.heading.length);
  if (turn != Sign::zero && have_offset_paths(recorder_, former, line))
    if (const auto meeting = paths_meet(recorder_, former, line)) return one(*meeting);
  return {p1(former)};
}

VectorGroup CornerRules::direction_change(const PathEnd& former, const PathEnd& latter) const {
  const Sign turn = recorder_.decide(Clause::fanuc_cutter_c_direction_change_parallel,
                                     cross(former.heading.along, latter.heading.along),
                                     former.heading.length * latter.heading.length);
  if (turn != Sign::zero && have_offset_paths(recorder_, former, latter)) {
    if (const auto meeting = paths_meet(recorder_, former, latter)) {
      const bool lines = !former.is_arc() && !latter.is_arc();
      recorder_.reach(lines ? Clause::fanuc_cutter_c_direction_change_lines
                            : Clause::fanuc_cutter_c_direction_change_arcs);
      return one(*meeting);
    }
  }
  recorder_.reach(Clause::fanuc_cutter_c_direction_change_without_intersection);
  return {p2(latter)};
}

// Both coordinates against the limit, from both sides. The scale is the length of the heads, not that of their
// difference: heads that nearly coincide are told apart no better than each of them is known. A head of a group is at
// most the diagonal of the square of the offset long.
bool CornerRules::is_small(const PlanePoint& movement, const Rational& offset) const {
  const Rational scale = limit_ + 4 * abs(offset);
  const auto within = [&](const Real& margin) {
    return recorder_.decide(Clause::fanuc_cutter_c_small_corner_movement, margin, scale) != Sign::negative;
  };
  return std::ranges::all_of(
      movement, [&](const Real& component) { return within(limit_ - component) && within(limit_ + component); });
}

void CornerRules::drop_small_movements(VectorGroup& group, const OffsetPath& latter) const {
  if (group.size() < 2) return;
  if (latter.is_arc()) {
    const Heading& from = latter.start.heading;
    const Heading& to = latter.end.heading;
    if (!is_under_half_circle(recorder_, from.along, to.along, latter.start.turn, from.length * to.length)) return;
  }
  if (limit_ < 0) return;
  VectorGroup kept{group.front()};
  for (std::size_t i = 1; i < group.size(); ++i)
    if (!is_small(group[i].vector - kept.back().vector, latter.start.offset)) kept.push_back(group[i]);
  group = kept;
}

}  // namespace toolcomp::model
