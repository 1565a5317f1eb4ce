// SPDX-License-Identifier: Apache-2.0
// Laws of the leading edge offset on paths made for them (what follows from fanuc.leading-edge.*): lists of movements
// with a tool direction each, written out as programs in several ways.
#include "tests/property/fanuc/tool_paths.h"

namespace toolcomp::laws {
namespace {

std::vector<Leg> path(bool turning = true) {
  std::vector<Leg> legs(*rc::gen::inRange<std::size_t>(2, 7));
  const Vector tool = *not_zero();
  for (Leg& leg : legs) leg = {*not_zero(), turning && *rc::gen::arbitrary<bool>() ? *not_zero() : tool};
  return legs;
}

spec::Case make(std::int64_t radius, const std::string& range) {
  spec::Case c;
  c.section = "fanuc/leading-edge-offset";
  c.setup.d[1].geometry = *spec::parse_decimal(decimal_of(radius));
  c.setup.parameters[{19631, -1}] = *spec::parse_decimal(range);
  return c;
}

std::string any_range() { return *rc::gen::element<std::string>("1.0", "0", "-1", "30", "45", "0.5", "7.25"); }
std::int64_t any_radius() { return *rc::gen::inRange<std::int64_t>(-30'000, 30'001); }

// The path incremental or absolute, with the tool direction in every block.
std::string program(const std::vector<Leg>& legs, bool absolute) {
  std::string text =
      fmt::format("{} G01 F1000\nG43.5 H0{}\nG41.3 D1\n", absolute ? "G90" : "G91", words("IJK", legs[0].tool));
  Vector at{};
  for (const Leg& leg : legs) {
    for (std::size_t i = 0; i < 3; ++i) at[i] += leg.movement[i];
    text += fmt::format("{}{}\n", words("XYZ", absolute ? at : leg.movement).substr(1), words("IJK", leg.tool));
  }
  return text + "G40\n";
}

// Every vector: perpendicular to the tool, as long as the offset value, in the plane of tool and movement, and leaning
// as the formula's sign says. Kept vectors are judged where they were made, so turning tools are left out.
RC_GTEST_PROP(LawsOfLeadingEdge, VectorsStandOnTheToolAndAreAsLongAsTheOffset, ()) {
  spec::Case c = make(any_radius(), any_range());
  c.program = program(path(false), false);
  const auto run = model_run(c);
  RC_ASSERT(run.has_value());
  RC_LOG() << fuzz::encode(c);
  const Real radius2 = square(Real(Rational(c.setup.d[1].geometry.digits, 1000)));
  bool on = false;
  for (const model::Event& e : run->events) {
    if (e.kind != EventKind::move) break;
    on = (on || e.cause == spec::Cause::start_up) && e.cause != spec::Cause::cancel;
    RC_ASSERT(e.tool_axis.has_value());
    Real along = 0;
    Real length2 = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      along += vector_of(e, i) * (*e.tool_axis)[i];
      length2 += square(vector_of(e, i));
    }
    RC_ASSERT(along == Real(0));
    RC_ASSERT(length2 == (on ? radius2 : Real(0)));
  }
  fast_agrees(c, *run);
}

RC_GTEST_PROP(LawsOfLeadingEdge, AbsoluteIsIncremental, ()) {
  spec::Case incremental = make(any_radius(), any_range());
  spec::Case absolute = incremental;
  const std::vector<Leg> legs = path();
  incremental.program = program(legs, false);
  absolute.program = program(legs, true);
  mapped(incremental, absolute, identity);
}

// A turn about Z whose cosine and sine are 3/5 and 4/5, all five times as long, is exact in decimals.
RC_GTEST_PROP(LawsOfLeadingEdge, TurnAboutZ, ()) {
  const std::string range = any_range();
  const std::int64_t radius = any_radius();
  spec::Case c = make(radius, range);
  spec::Case turned = make(5 * radius, range);
  const std::vector<Leg> legs = path();
  std::vector<Leg> other = legs;
  const auto turn = [](const Vector& v) { return Vector{3 * v[0] - 4 * v[1], 4 * v[0] + 3 * v[1], 5 * v[2]}; };
  for (Leg& leg : other) leg = {turn(leg.movement), turn(leg.tool)};
  c.program = program(legs, false);
  turned.program = program(other, false);
  mapped(c, turned, [](const spec::Axes&, const Table& t) {
    Table result = t;
    if (t.empty()) return result;
    result.set(0, 3 * t[0] - 4 * t[1]);
    result.set(1, 4 * t[0] + 3 * t[1]);
    result.set(2, 5 * t[2]);
    return result;
  });
}

// VC(-VM) = VC(VM): the way back along the first block starts with the same vector. Not within the 90 degree range
// after another block, so start-up alone; an exact right angle takes the first-listed case both ways.
RC_GTEST_PROP(LawsOfLeadingEdge, TheWayBackHasTheSameVector, ()) {
  const Vector tool = *not_zero();
  const Vector movement = *not_zero();
  Vector back{};
  for (std::size_t i = 0; i < 3; ++i) back[i] = -movement[i];
  std::int64_t product = 0;
  for (std::size_t i = 0; i < 3; ++i) product += tool[i] * movement[i];
  RC_PRE(product != 0);
  spec::Case c = make(any_radius(), any_range());
  spec::Case reversed = c;
  c.program = program({{movement, tool}}, false);
  reversed.program = program({{back, tool}}, false);
  const auto a = model_run(c);
  const auto b = model_run(reversed);
  RC_LOG() << fuzz::encode(c) << fuzz::encode(reversed);
  RC_ASSERT(a->events.size() == b->events.size());
  RC_ASSERT(a->events.size() > 1U);
  RC_ASSERT(a->events[1].kind == b->events[1].kind);
  if (a->events[1].kind == EventKind::alarm) {
    RC_ASSERT(a->events[1].number == b->events[1].number);
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) RC_ASSERT(vector_of(a->events[1], i) == vector_of(b->events[1], i));
  fast_agrees(reversed, *b);
}

// The opposite offset value gives the opposite vectors.
RC_GTEST_PROP(LawsOfLeadingEdge, NegativeOffsetIsTheOtherSide, ()) {
  const std::string range = any_range();
  const std::int64_t radius = any_radius();
  spec::Case c = make(radius, range);
  spec::Case other = make(-radius, range);
  c.program = other.program = program(path(), false);
  const auto a = model_run(c);
  const auto b = model_run(other);
  RC_ASSERT(a->events.size() == b->events.size());
  for (std::size_t i = 0; i < a->events.size(); ++i) {
    RC_ASSERT(a->events[i].kind == b->events[i].kind);
    if (a->events[i].kind != EventKind::move) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      RC_ASSERT(vector_of(a->events[i], axis) == -vector_of(b->events[i], axis));
  }
  fast_agrees(other, *b);
}

// A straight block run in two halves: the same events, and one more at the middle with the vector of the block's start.
RC_GTEST_PROP(LawsOfLeadingEdge, SplittingAStraightBlockAddsOneEvent, ()) {
  std::vector<Leg> legs = path(false);
  for (Leg& leg : legs)
    for (std::int64_t& x : leg.movement) x *= 2;
  const std::size_t at = *rc::gen::inRange<std::size_t>(0, legs.size());
  std::vector<Leg> halves = legs;
  for (std::int64_t& x : halves[at].movement) x /= 2;
  halves.insert(halves.begin() + static_cast<std::ptrdiff_t>(at), Leg(halves[at]));
  spec::Case whole = make(any_radius(), any_range());
  spec::Case split = whole;
  whole.program = program(legs, false);
  split.program = program(halves, false);
  const auto a = model_run(whole);
  const auto b = model_run(split);
  RC_LOG() << fuzz::encode(whole) << fuzz::encode(split);
  if (a->events.back().kind == EventKind::alarm) {
    RC_ASSERT(b->events.back().kind == EventKind::alarm);
    return;
  }
  RC_ASSERT(a->events.size() + 1 == b->events.size());
  // Events: G43.5, start-up, the legs, cancel; the middle is the first half's.
  const std::size_t middle = 2 + at;
  for (std::size_t i = 0; i < a->events.size(); ++i) {
    const std::size_t j = i < middle ? i : i + 1;
    RC_ASSERT(same(a->events[i].programmed, b->events[j].programmed));
    RC_ASSERT(same(a->events[i].point, b->events[j].point));
  }
  for (std::size_t i = 0; i < 3; ++i) RC_ASSERT(vector_of(b->events[middle], i) == vector_of(b->events[middle - 1], i));
  fast_agrees(split, *b);
}

// A head that turns C over B and a table that is turned B over C against it show the tool the same way to the work.
RC_GTEST_PROP(LawsOfLeadingEdge, HeadAndTableWithTheSameMotionAgree, ()) {
  const std::string range = any_range();
  const std::int64_t radius = any_radius();
  const auto control = [&](std::int64_t type, char first, char second, std::int64_t sense) {
    spec::Case c = make(radius, range);
    c.setup.axes = spec::Axes("XYZBC");
    const auto set = [&](std::uint32_t parameter, std::int64_t value) {
      c.setup.parameters[{parameter, -1}] = spec::decimal(value);
    };
    set(19680, type);
    set(19681, first == 'B' ? 4 : 5);
    set(19682, first - 'A' + 1);
    set(19684, sense);
    set(19686, second == 'B' ? 4 : 5);
    set(19687, second - 'A' + 1);
    set(19689, sense);
    return c;
  };
  spec::Case head = control(2, 'C', 'B', 0);
  spec::Case table = control(12, 'B', 'C', 1);
  std::string text = "G91 G01 F1000\nG41.3 D1\n";
  for (const Leg& leg : path()) {
    text += words("XYZ", leg.movement).substr(1);
    if (*rc::gen::arbitrary<bool>())
      text += fmt::format(" B{} C{}", *rc::gen::inRange(-90, 91),
                          decimal_of(*rc::gen::inRange<std::int64_t>(-180'000, 180'001)));
    text += '\n';
  }
  head.program = table.program = text + "G40\n";
  mapped(head, table, identity);
}

// After G40 nothing of the vector is left.
RC_GTEST_PROP(LawsOfLeadingEdge, CancelRestores, ()) {
  spec::Case c = make(any_radius(), any_range());
  c.program = program(path(), false) + "X10. Y20. Z30.\n";
  const auto run = model_run(c);
  const model::Event& last = run->events.back();
  if (last.kind == EventKind::move) RC_ASSERT(same(last.programmed, last.point));
  fast_agrees(c, *run);
}

}  // namespace
}  // namespace toolcomp::laws
