// SPDX-License-Identifier: Apache-2.0
// Laws of tool side compensation (fanuc.tool-side.*): in space on straight movements with tool directions by I J
// K, and in the plane, lines and arcs, with the tool along Z, where it is cutter compensation C.
#include <algorithm>

#include "tests/property/fanuc/cutter_paths.h"
#include "tests/property/fanuc/tool_paths.h"

namespace toolcomp::laws {
namespace {

using Legs = std::vector<Leg>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Every movement stands apart from every tool direction, so that every block moves in every plane.
bool all_move(const Legs& legs) {
  return std::ranges::all_of(legs, [&](const Leg& a) {
    return std::ranges::all_of(legs, [&](const Leg& b) { return cross(a.movement, b.tool) != Vector{}; });
  });
}

Legs any_legs(bool turning = true, std::size_t least = 3) {
  Legs legs(*rc::gen::inRange<std::size_t>(least, 7));
  const Vector tool = *not_zero();
  for (Leg& leg : legs) {
    leg.movement = *not_zero();
    const bool turns = turning && *rc::gen::arbitrary<bool>();
    leg.tool = turns ? *not_zero() : tool;
  }
  RC_PRE(all_move(legs));
  return legs;
}

std::int64_t any_radius() { return *rc::gen::inRange<std::int64_t>(-12'000, 12'001); }

struct How {
  bool absolute = false;
  bool right = false;
  std::int64_t tool_scale = 1;
};

// The first leg is the start-up block, the last but the G40 block the last compensated one.
std::string program(const Legs& legs, const How& how = {}) {
  const auto scaled = [&](Vector tool) {
    for (std::int64_t& x : tool) x *= how.tool_scale;
    return words("IJK", tool);
  };
  std::string text = fmt::format("{} G01 F1000\nG43.5 H0{}\n", how.absolute ? "G90" : "G91", scaled(legs.front().tool));
  Vector at{};
  for (std::size_t i = 0; i < legs.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) at[k] += legs[i].movement[k];
    if (i == 0) text += how.right ? "G42.6 D1" : "G41.6 D1";
    if (i + 1 == legs.size()) text += "G40";
    text += words("XYZ", how.absolute ? at : legs[i].movement) + scaled(legs[i].tool) + '\n';
  }
  return text;
}
constexpr std::uint64_t kFirstLegLine = 3;

spec::Case in_space(std::int64_t radius, const Legs& legs, const How& how = {}) {
  spec::Case c;
  c.section = kToolSide;
  c.setup.d[1].geometry = *spec::parse_decimal(decimal_of(radius));
  c.program = program(legs, how);
  return c;
}
// No check ends the run or drops vectors: corners see their two blocks alone.
spec::Case unchecked(spec::Case c) {
  c.setup.parameters[{5008, 0}] = spec::decimal(1);
  c.setup.parameters[{19605, 5}] = spec::decimal(1);
  return c;
}

// A legs' map by a matrix whose rows are orthogonal and `scale` long, applied to movements and tools.
using Matrix = std::array<Vector, 3>;
Vector times(const Matrix& m, const Vector& v) {
  Vector result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i] += m[i][j] * v[j];
  return result;
}
Legs times(const Matrix& m, Legs legs) {
  for (Leg& leg : legs) leg = {times(m, leg.movement), times(m, leg.tool)};
  return legs;
}
Map times(const Matrix& m) {
  return [m](const spec::Axes&, const Table& t) {
    Table result = t;
    if (t.empty()) return result;
    for (std::size_t i = 0; i < 3; ++i) {
      Real sum = 0;
      for (std::size_t j = 0; j < 3; ++j) sum += Real(Rational(m[i][j])) * t[j];
      result.set(i, sum);
    }
    return result;
  };
}

// Turns of space, three and five times as long: exact in decimals.
RC_GTEST_PROP(LawsOfToolSide, TurnsOfSpace, ()) {
  const auto& [matrix, scale] = *rc::gen::elementOf(std::vector<std::pair<Matrix, std::int64_t>>{
      {{{{2, -1, 2}, {2, 2, -1}, {-1, 2, 2}}}, 3}, {{{{3, -4, 0}, {4, 3, 0}, {0, 0, 5}}}, 5}});
  const std::int64_t radius = any_radius();
  const Legs legs = any_legs();
  mapped(in_space(radius, legs), in_space(scale * radius, times(matrix, legs)), times(matrix));
}

RC_GTEST_PROP(LawsOfToolSide, MirrorExchangesSidesInSpace, ()) {
  constexpr Matrix mirror{{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::int64_t radius = any_radius();
  const Legs legs = any_legs();
  How right;
  right.right = true;
  spec::Case a = in_space(radius, legs);
  spec::Case b = in_space(radius, times(mirror, legs), right);
  const bool type_b = *rc::gen::arbitrary<bool>();
  for (spec::Case* c : {&a, &b}) c->setup.parameters[{5003, 0}] = spec::decimal(type_b ? 1 : 0);
  mapped(a, b, times(mirror));
}

RC_GTEST_PROP(LawsOfToolSide, InchesInSpace, ()) {
  const Legs legs = any_legs();
  const spec::Case c = in_space(any_radius(), legs);
  spec::Case inch = c;
  spec::Decimal& value = inch.setup.d[1].geometry;
  value.digits *= 254;
  ++value.decimals;
  inch.program = "G20\n" + c.program;
  mapped(
      c, inch,
      [](const spec::Axes&, const Table& t) {
        Table result = t;
        for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
          if (t.has(i)) result.set(i, t[i] * Real(Rational(127, 5)));
        return result;
      },
      1);
}

RC_GTEST_PROP(LawsOfToolSide, NegativeValueExchangesSidesInSpace, ()) {
  const std::int64_t radius = any_radius();
  const Legs legs = any_legs();
  How right;
  right.right = true;
  mapped(in_space(radius, legs), in_space(-radius, legs, right), identity);
}

RC_GTEST_PROP(LawsOfToolSide, AbsoluteIsIncrementalInSpace, ()) {
  const std::int64_t radius = any_radius();
  const Legs legs = any_legs();
  How absolute;
  absolute.absolute = true;
  mapped(in_space(radius, legs), in_space(radius, legs, absolute), identity);
}

// I J K is a direction of any length.
RC_GTEST_PROP(LawsOfToolSide, LengthOfIJKDoesNotMatter, ()) {
  const std::int64_t radius = any_radius();
  const Legs legs = any_legs();
  How longer;
  longer.tool_scale = *rc::gen::inRange<std::int64_t>(2, 10);
  mapped(in_space(radius, legs), in_space(radius, legs, longer), identity);
}

RC_GTEST_PROP(LawsOfToolSide, ValueZeroIsTheIdentityInSpace, ()) {
  const spec::Case c = in_space(0, any_legs());
  const auto run = model_run(c);
  RC_LOG() << fuzz::encode(c);
  for (const model::Event& e : run->events)
    if (e.kind == EventKind::move) RC_ASSERT(same(e.programmed, e.point));
  fast_agrees(c, *run);
}

// Every vector lies in the plane of the tool, and the head of every block's end lies at the tool's radius from the line
// the block is programmed on, on the side of the code: V . VT = 0, V . (VT x U) = r |VT x U|.
void heads_lie_in_the_plane_at_the_radius(const Legs& legs) {
  const std::int64_t radius = any_radius();
  RC_PRE(radius != 0);
  const spec::Case c = unchecked(in_space(radius, legs));
  const auto run = model_run(c);
  RC_LOG() << fuzz::encode(c);
  for (const model::Event& e : run->events) {
    if (e.kind != EventKind::move || e.line < kFirstLegLine) continue;
    RC_ASSERT(e.tool_axis.has_value());
    Real along = 0;
    for (std::size_t i = 0; i < 3; ++i) along += vector_of(e, i) * (*e.tool_axis)[i];
    RC_ASSERT(equal(along, 0));
    // Own moves in the mode end at a head on their offset line; a start-up block ends beside the next one.
    if (e.cause != spec::Cause::programmed || e.line == kFirstLegLine) continue;
    const Leg& leg = legs[e.line - kFirstLegLine];
    const Vector normal = cross(leg.tool, leg.movement);
    Real across = 0;
    Real length2 = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Real n = Rational(normal[i], 1'000'000);
      across += n * vector_of(e, i);
      length2 += square(n);
    }
    RC_ASSERT((across.sign() == exact::Sign::positive) == (radius > 0));
    RC_ASSERT(equal(square(across), square(Real(Rational(radius, 1000))) * length2));
  }
}

RC_GTEST_PROP(LawsOfToolSide, HeadsLieInThePlaneAtTheRadius, ()) { heads_lie_in_the_plane_at_the_radius(any_legs()); }

// Whether a block moves is asked at each corner by itself: so too where blocks go along the tool of the one before.
RC_GTEST_PROP(LawsOfToolSide, HeadsOfBlocksAlongTheToolBefore, ()) {
  Legs legs(*rc::gen::inRange<std::size_t>(4, 8));
  for (std::size_t i = 0; i < legs.size(); ++i) {
    legs[i] = {*not_zero(), *not_zero()};
    if (i == 0 || *rc::gen::arbitrary<bool>()) continue;
    const std::int64_t times = *rc::gen::elementOf(std::vector<std::int64_t>{-3, -1, 1, 2});
    for (std::size_t k = 0; k < 3; ++k) legs[i].movement[k] = times * legs[i - 1].tool[k];
  }
  RC_PRE(std::ranges::all_of(legs, [](const Leg& leg) { return cross(leg.movement, leg.tool) != Vector{}; }));
  heads_lie_in_the_plane_at_the_radius(legs);
}

// The heads at the end of each block, in order.
using HeadsInSpace = std::vector<std::array<Real, 3>>;
std::vector<HeadsInSpace> groups(const judge::ModelRun& run) {
  std::vector<HeadsInSpace> result;
  for (const model::Event& e : run.events) {
    if (e.kind != EventKind::move) continue;
    if (e.cause != spec::Cause::corner) result.emplace_back();
    result.back().push_back({e.point[0], e.point[1], e.point[2]});
  }
  return result;
}

// The manual's own way: the system C2 by Gram and Schmidt from arbitrary auxiliary vectors, right-handed;
// start, end and next end turned into it, the plane problem solved there, the vectors turned back.
using RealVector = std::array<Real, 3>;
Real dot(const RealVector& a, const RealVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
RealVector minus(const RealVector& a, const Real& k, const RealVector& b) {
  return {a[0] - k * b[0], a[1] - k * b[1], a[2] - k * b[2]};
}
RealVector unit(const RealVector& a) {
  const Real length = sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}
RealVector real(const Vector& v) {
  return {Real(Rational(v[0], 1000)), Real(Rational(v[1], 1000)), Real(Rational(v[2], 1000))};
}

HeadsInSpace by_the_matrix(const Leg& a, const Leg& b, const Vector& a2, const Vector& a3, const Real& r, int side) {
  const RealVector e1 = unit(real(a.tool));
  const RealVector e2 = unit(minus(real(a2), dot(real(a2), e1), e1));
  const RealVector b3 = minus(minus(real(a3), dot(real(a3), e1), e1), dot(real(a3), e2), e2);
  RealVector e3 = unit(b3);
  // Right-handed: a2, a3 and the tool turn the right way round.
  std::int64_t turn = 0;
  const Vector normal = cross(a2, a3);
  for (std::size_t i = 0; i < 3; ++i) turn += normal[i] * a.tool[i];
  if (turn < 0) e3 = minus({0, 0, 0}, 1, e3);
  struct Plane {
    Real x;
    Real y;
  };
  const auto direction = [&](const Vector& movement) {
    const Plane u{dot(real(movement), e2), dot(real(movement), e3)};
    const Real length = sqrt(u.x * u.x + u.y * u.y);
    return Plane{u.x / length, u.y / length};
  };
  const Plane d1 = direction(a.movement);
  const Plane d2 = direction(b.movement);
  const Real s = Real(side);
  const Plane n1{-s * d1.y, s * d1.x};
  const Plane n2{-s * d2.y, s * d2.x};
  const Real c = d1.x * d2.x + d1.y * d2.y;
  const exact::Sign turns = (s * (d1.x * d2.y - d1.y * d2.x)).sign();
  const auto back = [&](const Real& x, const Real& y) {
    return std::array<Real, 3>{r * (x * e2[0] + y * e3[0]), r * (x * e2[1] + y * e3[1]), r * (x * e2[2] + y * e3[2])};
  };
  const bool acute = turns != exact::Sign::positive && c.sign() == exact::Sign::negative;
  if (acute) return {back(n1.x + d1.x, n1.y + d1.y), back(n2.x - d2.x, n2.y - d2.y)};
  return {back((n1.x + n2.x) / (1 + c), (n1.y + n2.y) / (1 + c))};
}

RC_GTEST_PROP(LawsOfToolSide, TheMatrixGivesTheSameVectorsForAnyAuxiliaryVectors, ()) {
  const std::int64_t radius = any_radius();
  RC_PRE(radius != 0);
  const Legs legs = any_legs(true, 4);
  const spec::Case c = unchecked(in_space(radius, legs));
  RC_LOG() << fuzz::encode(c);
  const auto run = model_run(c);
  const std::vector<HeadsInSpace> heads = groups(*run);
  Vector corner{};
  for (std::size_t k = 0; k < 3; ++k) corner[k] = legs[0].movement[k];
  for (std::size_t i = 1; i + 2 < legs.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) corner[k] += legs[i].movement[k];
    const Vector a2 = *not_zero();
    const Vector a3 = *not_zero();
    std::int64_t independent = 0;
    const Vector normal = cross(a2, a3);
    for (std::size_t k = 0; k < 3; ++k) independent += normal[k] * legs[i].tool[k];
    if (independent == 0) continue;
    HeadsInSpace expected;
    try {
      expected = by_the_matrix(legs[i], legs[i + 1], a2, a3, Real(Rational(radius < 0 ? -radius : radius, 1000)),
                               radius < 0 ? -1 : 1);
    } catch (const exact::Undecided&) {
      RC_DISCARD("roots over roots");
    }
    RC_ASSERT(heads[i + 1].size() == expected.size());
    for (std::size_t h = 0; h < expected.size(); ++h)
      for (std::size_t k = 0; k < 3; ++k)
        RC_ASSERT(equal(heads[i + 1][h][k], expected[h][k] + Real(Rational(corner[k], 1000))));
  }
}

// The orientation at the start of a block is irrelevant for the vectors at its end: another tool direction in one block
// changes the vectors there alone.
RC_GTEST_PROP(LawsOfToolSide, TheToolAtTheStartDoesNotMatter, ()) {
  const std::int64_t radius = any_radius();
  const Legs legs = any_legs();
  Legs other = legs;
  const std::size_t at = *rc::gen::inRange<std::size_t>(0, legs.size() - 1);
  other[at].tool = *not_zero();
  RC_PRE(all_move(other));
  const spec::Case a = unchecked(in_space(radius, legs));
  const spec::Case b = unchecked(in_space(radius, other));
  RC_LOG() << fuzz::encode(a) << "---\n" << fuzz::encode(b);
  const auto run_a = model_run(a);
  const auto run_b = model_run(b);
  const std::vector<HeadsInSpace> before = groups(*run_a);
  const std::vector<HeadsInSpace> after = groups(*run_b);
  RC_ASSERT(before.size() == legs.size() + 1);  // the G43.5 block is the first
  RC_ASSERT(after.size() == before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (i == at + 1) continue;
    RC_ASSERT(before[i].size() == after[i].size());
    for (std::size_t h = 0; h < before[i].size(); ++h)
      for (std::size_t k = 0; k < 3; ++k) RC_ASSERT(equal(before[i][h][k], after[i][h][k]));
  }
  fast_agrees(b, *run_b);
}

// A straight block run in two halves has one event more: the middle, with the perpendicular.
RC_GTEST_PROP(LawsOfToolSide, SplittingALineAddsOneEvent, ()) {
  Legs legs = any_legs(false);
  for (Leg& leg : legs)
    for (std::int64_t& x : leg.movement) x *= 2;
  const std::size_t at = *rc::gen::inRange<std::size_t>(1, legs.size() - 1);
  Legs halves = legs;
  for (std::int64_t& x : halves[at].movement) x /= 2;
  halves.insert(halves.begin() + static_cast<std::ptrdiff_t>(at), Leg(halves[at]));
  const std::int64_t radius = any_radius();
  const spec::Case whole = unchecked(in_space(radius, legs));
  const spec::Case split = unchecked(in_space(radius, halves));
  RC_LOG() << fuzz::encode(whole) << "---\n" << fuzz::encode(split);
  const auto run = model_run(whole);
  const auto run_split = model_run(split);
  const std::vector<HeadsInSpace> a = groups(*run);
  std::vector<HeadsInSpace> b = groups(*run_split);
  RC_ASSERT(b.size() == a.size() + 1);
  const HeadsInSpace middle = b[at + 1];
  RC_ASSERT(middle.size() == 1U);
  b.erase(b.begin() + static_cast<std::ptrdiff_t>(at) + 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    RC_ASSERT(a[i].size() == b[i].size());
    for (std::size_t h = 0; h < a[i].size(); ++h)
      for (std::size_t k = 0; k < 3; ++k) RC_ASSERT(equal(a[i][h][k], b[i][h][k]));
  }
  fast_agrees(split, *run_split);
}

// A turn of 360 degrees more of either rotary axis shows the tool the same way.
RC_GTEST_PROP(LawsOfToolSide, AFullTurnOfARotaryAxisChangesNothing, ()) {
  spec::Case c;
  c.section = kToolSide;
  c.setup.axes = spec::Axes("XYZBC");
  const auto set = [&](std::uint32_t parameter, std::int64_t value) {
    c.setup.parameters[{parameter, -1}] = spec::decimal(value);
  };
  set(19680, 2);
  set(19681, 5);
  set(19682, 3);
  set(19686, 4);
  set(19687, 2);
  c.setup.d[1].geometry = *spec::parse_decimal(decimal_of(any_radius()));
  spec::Case turned = c;
  const std::int64_t b_turns = *rc::gen::inRange<std::int64_t>(-2, 3);
  const std::int64_t c_turns = *rc::gen::inRange<std::int64_t>(-2, 3);
  const std::size_t count = *rc::gen::inRange<std::size_t>(2, 6);
  c.program = turned.program = "G01 F1000\n";
  for (std::size_t i = 0; i < count; ++i) {
    const std::string block = (i == 0 ? "G41.2 D1" : i + 1 == count ? "G40" : "") + words("XYZ", *not_zero());
    const std::int64_t b_angle = *rc::gen::inRange<std::int64_t>(-120'000, 120'001);
    const std::int64_t c_angle = *rc::gen::inRange<std::int64_t>(-180'000, 180'001);
    c.program += fmt::format("{} B{} C{}\n", block, decimal_of(b_angle), decimal_of(c_angle));
    turned.program += fmt::format("{} B{} C{}\n", block, decimal_of(b_angle + 360'000 * b_turns),
                                  decimal_of(c_angle + 360'000 * c_turns));
  }
  mapped(c, turned, [&](const spec::Axes&, const Table& t) {
    Table result = t;
    if (t.has(3)) result.set(3, t[3] + Real(Rational(360 * b_turns)));
    if (t.has(4)) result.set(4, t[4] + Real(Rational(360 * c_turns)));
    return result;
  });
}

// In the plane with the tool along Z.
RC_GTEST_PROP(LawsOfToolSide, MirrorExchangesSides, ()) { mirror_exchanges_sides(kToolSide); }
RC_GTEST_PROP(LawsOfToolSide, QuarterTurn, ()) { quarter_turn(kToolSide); }
RC_GTEST_PROP(LawsOfToolSide, PythagoreanTurn, ()) { pythagorean_turn(kToolSide); }
RC_GTEST_PROP(LawsOfToolSide, InchesAreMillimetresTimes254, ()) { inches(kToolSide); }
RC_GTEST_PROP(LawsOfToolSide, NegativeValueExchangesSides, ()) { negative_value_exchanges_sides(kToolSide); }
RC_GTEST_PROP(LawsOfToolSide, AbsoluteIsIncremental, ()) { absolute_is_incremental(kToolSide); }
RC_GTEST_PROP(LawsOfToolSide, ValueZeroIsTheIdentity, ()) { value_zero_is_the_identity(kToolSide); }

// The same path under G41.2 with the tool along Z and under G41 of cutter compensation C: the same heads one after the
// other, the same arcs, the same alarm. Whose a corner move is differs (the stop point), and a travel of zero counts
// otherwise, so there is none here.
RC_GTEST_PROP(LawsOfToolSide, WithTheToolAlongZItIsCutterCompensationC, ()) {
  const Path path = any_path();
  RC_PRE(std::ranges::all_of(path.segments, [](const Segment& s) { return s.travel != PlaneCounts{}; }));
  const bool type_b = *rc::gen::arbitrary<bool>();
  spec::Case a = make("fanuc/cutter-compensation-c", path);
  spec::Case b = make(kToolSide, path);
  for (spec::Case* c : {&a, &b}) c->setup.parameters[{5003, 0}] = spec::decimal(type_b ? 1 : 0);
  RC_LOG() << fuzz::encode(a) << "---\n" << fuzz::encode(b);
  const auto in_c = model_run(a);
  const auto on_side = model_run(b);
  RC_ASSERT(in_c->events.back().kind == on_side->events.back().kind);
  RC_ASSERT(in_c->events.back().number == on_side->events.back().number);
  RC_ASSERT(in_c->events.back().line == on_side->events.back().line);
  const bool alarm = in_c->events.back().kind != EventKind::move;
  // Before an alarm the one may have given a corner move that the other has with the block at fault.
  const std::size_t common = std::min(in_c->events.size(), on_side->events.size()) - (alarm ? 1 : 0);
  if (!alarm) RC_ASSERT(in_c->events.size() == on_side->events.size());
  for (std::size_t i = 0; i < common; ++i) {
    const model::Event& e = in_c->events[i];
    const model::Event& f = on_side->events[i];
    RC_LOG() << "event " << i << '\n';
    RC_ASSERT(e.kind == EventKind::move);
    RC_ASSERT(f.kind == EventKind::move);
    RC_ASSERT(same(e.programmed, f.programmed));
    RC_ASSERT(same(e.point, f.point));
    RC_ASSERT(e.arc.has_value() == f.arc.has_value());
    if (e.arc) same_arc(a.setup.axes, *e.arc, *f.arc, {unchanged, 1, false, {}});
  }
  fast_agrees(b, *on_side);
}

}  // namespace
}  // namespace toolcomp::laws
