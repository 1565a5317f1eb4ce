// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/fanuc/beside_the_path.h"

#include <algorithm>
#include <array>

#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {
namespace {

bool is_tool_side(const FanucBlock& b) {
  return b.compensation == kG41_2 || b.compensation == kG42_2 || b.compensation == kG41_6 || b.compensation == kG42_6;
}
bool is_cutter(const FanucBlock& b) { return b.compensation == kG41 || b.compensation == kG42; }
bool is_left(const FanucBlock& b) {
  return b.compensation == kG41 || b.compensation == kG41_2 || b.compensation == kG41_6;
}

// Other vectors may stand between the programmed point and the tool: of G45 to G48, of G37.
bool shifts_the_point(const FanucScene& s) { return s.program.has_code({kG45, kG46, kG47, kG48, kG37}); }
bool leaves_the_path(const FanucScene& s) {
  return shifts_the_point(s) || s.program.has_code({kG10, kG52, kG92, kG53, kG28, kG29, kG30, kG30_1, kG31});
}

Vector normal_of(int plane) {
  if (plane == kG18) return {0, 1, 0};
  if (plane == kG19) return {1, 0, 0};
  return {0, 0, 1};
}

// T: the tool where it ends this block, or the normal of the plane.
std::optional<Vector> across(const FanucScene& s, const Stop& stop) {
  const FanucBlock& b = s.block(stop);
  if (is_tool_side(b)) return stop.own->tool_axis;
  if (!is_cutter(b)) return std::nullopt;
  return normal_of(b.plane);
}

// Offset to the left of travel: G41 and a positive value.
std::optional<exact::Rational> left_offset(const FanucScene& s, const FanucBlock& b) {
  if (!b.d || s.c.setup.bit(5001, 2)) return std::nullopt;
  const auto value = cutter_value(s.c.setup, *b.d);
  if (!value) return std::nullopt;
  return is_left(b) ? *value : exact::Rational(-*value);
}

// Whether U leads across T, by more than what counts as no movement.
bool leads_across(const FanucScene& s, const FanucBlock& b, const Vector& t, const Vector& u) {
  Real limit;
  if (is_tool_side(b))
    if (const auto p = s.c.setup.parameter(19630)) {
      if (s.c.setup.units == spec::Units::inch && !p->is_zero()) return false;
      limit = Real(rational(*p));
    }
  const Vector w = cross(t, u);
  const Real tt = dot(t, t);
  return certainly_positive(dot(w, w) - limit * limit * tt);
}

bool is_line(const FanucScene& s, const Stop& stop) {
  const FanucBlock& b = s.block(stop);
  return stop.own->type != spec::MoveType::arc && (b.motion == kG00 || b.motion == kG01);
}

bool is_type_b(const FanucScene& s, const FanucBlock& b) {
  return is_cutter(b) && s.c.setup.cutter_compensation == spec::CutterCompensationType::b;
}

// Square of the distance of `from` from the centre, seen along T.
Real square_of_radius(const Vector& t, const Vector& from, const Vector& center) {
  const Vector radius = cross(t, from - center);
  return dot(radius, radius);
}

bool is_arc(const Stop& stop) { return stop.own->type == spec::MoveType::arc && stop.own->arc; }

// At the height of `at`: a helix has no other.
Vector center_of(const FanucScene& s, const Stop& stop, const Vector& at) {
  Vector center = at;
  const auto& given = stop.own->arc->center;
  for (std::size_t i = 0; i < center.size(); ++i)
    if (const std::size_t axis = s.c.setup.axes.index("XYZ"[i]); given.has(axis)) center.at(i) = given[axis];
  return center;
}

struct Circle {
  Vector center;
  exact::Rational sense;  // σ as T sees it
};
// The arc of this stop as T sees it at one of its ends; nothing where T stands in its plane.
std::optional<Circle> circle(const FanucScene& s, const Stop& stop, const Vector& at, const Vector& t) {
  if (!is_arc(stop)) return std::nullopt;
  const FanucBlock& b = s.block(stop);
  const Real along = dot(t, normal_of(b.plane));
  const bool below = certainly_negative(along);
  if (!below && !certainly_positive(along)) return std::nullopt;
  return Circle{center_of(s, stop, at), (b.motion == kG03) != below ? 1 : -1};
}

// Whether the block of this stop makes a vector at its end: a line displaced across T, or an arc round a centre that T
// does not see in its end.
bool moves_across(const FanucScene& s, const Stop& stop, const Vector& t) {
  if (!stop.displacement) return false;
  if (is_arc(stop))
    return certainly_positive(square_of_radius(t, stop.programmed, center_of(s, stop, stop.programmed)));
  return leads_across(s, s.block(stop), t, *stop.displacement);
}

// A stop with all that a law of distances asks for.
struct Place {
  Vector t;
  exact::Rational left;  // ρ
};
std::optional<Place> place(const FanucScene& s, const Stop& stop) {
  const auto t = across(s, stop);
  if (!t || !stop.displacement) return std::nullopt;
  const FanucBlock& b = s.block(stop);
  const auto left = left_offset(s, b);
  // D0 cancels.
  if (!left || *b.d == 0) return std::nullopt;
  if (b.has('I') && b.has('J') && b.has('K') && is_cutter(b)) return std::nullopt;
  // Type B: a vector (I, J) of length zero keeps the vector before.
  if (is_type_b(s, b) && (b.has('I') || b.has('J') || b.has('K')) && is_line(s, stop)) return std::nullopt;
  if (!moves_across(s, stop, *t)) return std::nullopt;
  return Place{*t, *left};
}

bool same_sign(const exact::Rational& a, const exact::Rational& b) { return (a < 0) == (b < 0) && (a > 0) == (b > 0); }

// Whether the offset stays on one side from the block of this stop to that of the next that leads across its T, or to
// the end.
bool keeps_side(const FanucScene& s, std::size_t stop, const Place& p) {
  std::size_t last = s.program.blocks().size() - 1;
  for (std::size_t k = stop + 1; k < s.stops.size(); ++k)
    if (const auto& u = s.stops[k].displacement; u && leads_across(s, s.block(s.stops[stop]), p.t, *u)) {
      last = s.stops[k].block;
      break;
    }
  for (std::size_t i = s.stops[stop].block + 1; i <= last; ++i) {
    const FanucBlock& b = s.program.blocks()[i];
    if (!is_cutter(b) && !is_tool_side(b)) continue;
    const auto other = left_offset(s, b);
    if (!other || !same_sign(p.left, *other)) return false;
  }
  return true;
}

bool interference_unchecked(const FanucScene& s) { return s.c.setup.bit(5008, 0); }

// A corner of two lines that leads toward the tool's side: one head, which no check removes.
bool is_inner(const FanucScene& s, const Place& p, const Stop& before, const Stop& after) {
  if (!after.displacement || !is_line(s, before) || !is_line(s, after)) return false;
  const Real turn = dot(p.t, cross(*before.displacement, *after.displacement));
  return p.left > 0 ? certainly_positive(turn) : p.left < 0 && certainly_negative(turn);
}

// Nothing was removed at the end of `stop`.
bool all_heads_stand(const FanucScene& s, std::size_t stop, const Place& p) {
  if (interference_unchecked(s)) return true;
  return stop + 1 < s.stops.size() && is_inner(s, p, s.stops[stop], s.stops[stop + 1]);
}

bool in_mode_before(const FanucScene& s, std::size_t stop) {
  if (stop == 0) return false;
  const FanucBlock& b = s.block(s.stops[stop - 1]);
  return is_tool_side(b) || is_cutter(b);
}

// R - σρ of the arc through `at`.
Real parallel_radius(const Vector& at, const Place& p, const Circle& circle) {
  return sqrt(square_of_radius(p.t, at, circle.center)) - Real(exact::Rational(circle.sense * p.left));
}

// What the last head at the end of stop `i` owes to the block after it.
bool corner_is_plain(const FanucScene& s, std::size_t i, const Place& p) {
  if (i + 1 >= s.stops.size()) return false;
  const Stop& a = s.stops[i];
  const Stop& b = s.stops[i + 1];
  const FanucBlock& former = s.block(a);
  const FanucBlock& latter = s.block(b);
  if (b.block != a.block + 1 || !former.is_plain() || !latter.is_plain() || latter.says_compensation()) return false;
  if (latter.compensation != former.compensation || latter.plane != former.plane) return false;
  if (const auto limit = s.c.setup.parameter(5010); limit && !limit->is_zero()) return false;
  if (a.own->cause != spec::Cause::programmed && a.own->cause != spec::Cause::start_up) return false;
  if (b.own->cause != spec::Cause::programmed || !b.displacement) return false;
  // An offset circle smaller than nothing meets nothing; an arc that runs straight may have had one.
  if (!is_line(s, a)) {
    const auto arc = circle(s, a, a.programmed, p.t);
    if (!arc || !certainly_positive(parallel_radius(a.programmed, p, *arc))) return false;
  }
  const auto left = left_offset(s, latter);
  return left && *latter.d != 0 && same_sign(*left, p.left);
}

// V to the left of U, less ρ: zero at the distance r.
Real distance_error(const Vector& v, const Place& p, const Vector& u) {
  const Vector left = cross(p.t, u);
  return dot(v, left) / length(left) - Real(p.left);
}

// |at + v - O| = R - σρ with R = |at - O| for the arc of this stop, as squares, seen along T.
void on_the_parallel_circle(const FanucScene& s, const Stop& stop, const Vector& at, const Head& head, const Place& p,
                            Holding& holding) {
  const auto arc = circle(s, stop, at, p.t);
  if (!arc) return;
  const Real parallel = parallel_radius(at, p, *arc);
  if (!certainly_positive(parallel)) return;
  holding.zero(square_of_radius(p.t, at + head.vector, arc->center) - parallel * parallel, head.event,
               "square of the distance from the centre, less that of the parallel circle");
}

}  // namespace

void perpendicular_to_the_tool(const FanucScene& s, Holding& holding) {
  if (shifts_the_point(s)) return;
  for (const Stop& stop : s.stops) {
    const auto t = across(s, stop);
    if (!t || !moves_across(s, stop, *t)) continue;
    for (const Head& head : stop.heads)
      holding.zero(dot(head.vector, *t), head.event, "component of the vector along the tool");
  }
}

void not_nearer_than_the_radius(const FanucScene& s, Holding& holding) {
  if (leaves_the_path(s)) return;
  for (const Stop& stop : s.stops) {
    const auto p = place(s, stop);
    if (!p) continue;
    for (const Head& head : stop.heads) {
      // G39's arc is of a block of its own, and of that block's value.
      if (s.events[head.event].type == spec::MoveType::arc && s.events[head.event].cause == spec::Cause::corner) break;
      holding.not_negative(dot(head.vector, head.vector) - Real(exact::Rational(p->left * p->left)), head.event,
                           "square of the distance from the corner, less that of the radius");
    }
  }
}

void beside_the_line_before(const FanucScene& s, Holding& holding) {
  if (leaves_the_path(s)) return;
  for (std::size_t i = 0; i < s.stops.size(); ++i) {
    const Stop& stop = s.stops[i];
    if (stop.own->cause != spec::Cause::programmed || !is_line(s, stop) || !in_mode_before(s, i)) continue;
    if (is_type_b(s, s.block(stop))) continue;
    const auto p = place(s, stop);
    if (!p || !all_heads_stand(s, i, *p) || !keeps_side(s, i, *p)) continue;
    holding.zero(distance_error(stop.heads.front().vector, *p, *stop.displacement), stop.event,
                 "distance from the line before, less the radius");
  }
}

void beside_the_line_after(const FanucScene& s, Holding& holding) {
  if (leaves_the_path(s)) return;
  for (std::size_t i = 0; i + 1 < s.stops.size(); ++i) {
    const Stop& stop = s.stops[i];
    const Stop& next = s.stops[i + 1];
    if (!is_line(s, next) || is_type_b(s, s.block(stop))) continue;
    const auto p = place(s, stop);
    if (!p || !corner_is_plain(s, i, *p) || !all_heads_stand(s, i, *p) ||
        !leads_across(s, s.block(stop), p->t, *next.displacement))
      continue;
    holding.zero(distance_error(stop.heads.back().vector, *p, *next.displacement), stop.heads.back().event,
                 "distance from the line after, less the radius");
    // Inside a corner one point is at the radius from both lines; another head would be beyond one of them.
    if (is_inner(s, *p, stop, next) && stop.own->cause == spec::Cause::programmed)
      holding.zero(distance_error(stop.heads.front().vector, *p, *next.displacement), stop.event,
                   "distance of the first head from the line after an inner corner, less the radius");
  }
}

void beside_the_arc(const FanucScene& s, Holding& holding) {
  if (leaves_the_path(s)) return;
  for (std::size_t i = 0; i < s.stops.size(); ++i) {
    const Stop& stop = s.stops[i];
    if (!is_arc(stop) || stop.own->cause != spec::Cause::programmed) continue;
    if (const auto at_end = place(s, stop); at_end && keeps_side(s, i, *at_end))
      on_the_parallel_circle(s, stop, stop.programmed, stop.heads.front(), *at_end, holding);
    if (i == 0 || is_type_b(s, s.block(stop))) continue;
    // An arc that has lost a vector to the interference check is none.
    const Stop& before = s.stops[i - 1];
    if (const auto at_start = place(s, before); at_start && corner_is_plain(s, i - 1, *at_start))
      on_the_parallel_circle(s, stop, before.programmed, before.heads.back(), *at_start, holding);
  }
}

void normal_of_the_block(const FanucScene& s, Holding& holding) {
  if (leaves_the_path(s)) return;
  for (const Stop& stop : s.stops) {
    const FanucBlock& b = s.block(stop);
    if (!is_type_b(s, b) || !is_line(s, stop) || b.has('I') || b.has('J') || b.has('K') || b.has_code(kG39)) continue;
    const auto p = place(s, stop);
    if (!p) continue;
    const Vector& u = *stop.displacement;
    const Vector left = cross(p->t, u);
    holding.zero(length(left) * stop.heads.front().vector - Real(p->left) * left, stop.event,
                 "vector, less the radius times the normal of the block");
  }
}

void on_the_path_without_a_mode(const FanucScene& s, Holding& holding) {
  if (shifts_the_point(s)) return;
  if (s.names_other_points()) return;
  bool on_path = true;
  for (const Stop& stop : s.stops) {
    const FanucBlock& b = s.block(stop);
    const bool off = b.compensation == kG40;
    for (const Head& head : stop.heads) {
      const bool cancels = s.events[head.event].cause == spec::Cause::cancel;
      if ((off && on_path) || cancels) holding.zero(head.vector, head.event, "vector without a mode");
      on_path = off && (on_path || cancels);
    }
  }
}

void where_the_tool_is_said_to_be(const FanucScene& s, Holding& holding) {
  if (s.c.setup.cutter_compensation != spec::CutterCompensationType::c || s.program.calls() || shifts_the_point(s) ||
      s.program.has_code({kG41_2, kG41_3, kG41_6, kG42_2, kG42_6, kG43_4, kG43_5}))
    return;
  const std::vector<FanucBlock>& blocks = s.program.blocks();
  // Of two codes that act in their block alone one does not.
  const auto names_place = [](const FanucBlock& b) {
    const auto has = [&b](int code) { return b.has_code(code); };
    return has(920) && std::ranges::none_of(std::array{40, 100, 280, 290, 300, 301, 310, 390, 520, 530}, has);
  };
  for (std::size_t i = 1; i < s.stops.size(); ++i) {
    const Head& head = s.stops[i - 1].heads.back();
    // A start-up that the block of G92 makes itself (type C) comes after the place was named.
    const bool starts_up = s.events[head.event].cause == spec::Cause::start_up;
    for (std::size_t k = s.stops[i - 1].block + (starts_up ? 1 : 0); k < s.stops[i].block && !blocks[k].drills; ++k)
      for (std::size_t axis = 0; names_place(blocks[k]) && axis < head.vector.size(); ++axis)
        if (blocks[k].has("XYZ"[axis]))
          holding.zero(head.vector.at(axis), head.event, "vector at the place that G92 gives to the tool");
  }
}

}  // namespace toolcomp::judge::laws
