// SPDX-License-Identifier: Apache-2.0
// Laws of cutter compensation C (14.5, 14.6) on paths of lines and arcs.
#include <algorithm>

#include "tests/property/fanuc/cutter_paths.h"

namespace toolcomp::laws {
namespace {

const std::string kC = "fanuc/cutter-compensation-c";

RC_GTEST_PROP(LawsOfCutterC, MirrorExchangesSides, ()) { mirror_exchanges_sides(kC); }
RC_GTEST_PROP(LawsOfCutterC, QuarterTurn, ()) { quarter_turn(kC); }
RC_GTEST_PROP(LawsOfCutterC, PythagoreanTurn, ()) { pythagorean_turn(kC); }
RC_GTEST_PROP(LawsOfCutterC, InchesAreMillimetresTimes254, ()) { inches(kC); }
RC_GTEST_PROP(LawsOfCutterC, NegativeValueExchangesSides, ()) { negative_value_exchanges_sides(kC); }
RC_GTEST_PROP(LawsOfCutterC, AbsoluteIsIncremental, ()) { absolute_is_incremental(kC); }
RC_GTEST_PROP(LawsOfCutterC, PlanesByCyclicRenaming, ()) { planes_by_cyclic_renaming(kC); }
RC_GTEST_PROP(LawsOfCutterC, ValueZeroIsTheIdentity, ()) { value_zero_is_the_identity(kC); }

// Type B of start-up and cancel, under the mirror too.
RC_GTEST_PROP(LawsOfCutterC, MirrorExchangesSidesOfTypeB, ()) {
  const Path path = any_path(1, 3);
  const Path other = changed(path, [](PlaneCounts p) { return PlaneCounts{p.x, -p.y}; }, 1, true);
  Writing right;
  right.right = true;
  spec::Case a = make(kC, path);
  spec::Case b = make(kC, other, right);
  for (spec::Case* c : {&a, &b}) c->setup.parameters[{5003, 0}] = spec::decimal(1);
  moved(a, b, {in_plane([](const Real& x, const Real& y) { return std::pair(x, -y); }), 1, true, {}});
}

// No interference check and no vectors omitted: corners see their two blocks alone.
spec::Case unchecked(const Path& path, const Writing& how = {}) {
  spec::Case c = make(kC, path, how);
  c.setup.parameters[{5008, 0}] = spec::decimal(1);
  return c;
}

// The heads between the segments i and i + 1, neighbours that coincide once.
using Heads = std::vector<std::array<Real, 2>>;
std::vector<Heads> corners(const judge::ModelRun& run, std::size_t segments) {
  std::vector<Heads> groups(segments - 1);
  for (const model::Event& e : run.events) {
    if (e.kind != EventKind::move || e.line < kFirstSegmentLine) continue;
    const std::size_t segment = e.line - kFirstSegmentLine;
    const std::size_t corner = e.cause == spec::Cause::corner ? segment - 1 : segment;
    if (corner >= groups.size()) continue;  // start-up and cancel corners
    Heads& heads = groups[corner];
    const std::array<Real, 2> head{e.point[0], e.point[1]};
    if (heads.empty() || !equal(heads.back()[0], head[0]) || !equal(heads.back()[1], head[1])) heads.push_back(head);
  }
  return groups;
}

// A closed path, its first segment once more at the end, so that every corner has offset mode on both sides.
Path closed_path() {
  Path path = any_path(2, 5);
  PlaneCounts sum{};
  for (const Segment& s : path.segments) sum = sum + s.travel;
  if (sum != PlaneCounts{}) {
    Segment back;
    back.travel = -sum;
    path.segments.push_back(back);
  }
  path.segments.push_back(Segment(path.segments.front()));
  return path;
}

Path reversed(const Path& path) {
  Path result = path;
  result.lead = -path.lead;
  std::ranges::reverse(result.segments);
  for (Segment& s : result.segments) {
    s.to_center = s.to_center - s.travel;
    s.travel = -s.travel;
    s.clockwise = !s.clockwise;
  }
  return result;
}

// Whether the tool at the left fits into every arc, at both of its ends; beside one into which it does not fit the
// group goes by the former block alone.
bool fits(const Path& path) {
  return std::ranges::all_of(path.segments, [&](const Segment& s) {
    if (s.kind == Segment::Kind::line || s.clockwise) return true;
    const PlaneCounts from_end = s.to_center - s.travel;
    const std::int64_t r2 = path.offset * path.offset;
    if (s.kind == Segment::Kind::radius_arc) return s.radius * s.radius >= r2;
    return std::min(s.to_center.x * s.to_center.x + s.to_center.y * s.to_center.y,
                    from_end.x * from_end.x + from_end.y * from_end.y) >= r2;
  });
}

// The way back under G42 has the heads of the way there under G41, in the opposite order.
RC_GTEST_PROP(LawsOfCutterC, TheWayBackOnTheOtherSideHasTheSameHeads, ()) {
  const Path path = closed_path();
  RC_PRE(fits(path));
  Writing right;
  right.right = true;
  const spec::Case there = unchecked(path);
  const spec::Case back = unchecked(reversed(path), right);
  RC_LOG() << fuzz::encode(there) << fuzz::encode(back);
  const auto a = model_run(there);
  const auto b = model_run(back);
  const auto alarm = [](const judge::ModelRun& run) { return run.events.back().kind != EventKind::move; };
  // Either way a corner without intersection ends the run; start-up and cancel can alarm on one way alone.
  if (alarm(*a) || alarm(*b)) RC_DISCARD("alarm");
  std::vector<Heads> forward = corners(*a, path.segments.size());
  std::vector<Heads> backward = corners(*b, path.segments.size());
  std::ranges::reverse(backward);
  // Both start in the same place of a closed path only up to the lead.
  PlaneCounts sum{};
  for (const Segment& s : path.segments) sum = sum + s.travel;
  const PlaneCounts shift = path.lead + path.lead + sum;  // from the reversed program's positions to the others'
  for (std::size_t i = 0; i < forward.size(); ++i) {
    std::ranges::reverse(backward[i]);
    RC_ASSERT(forward[i].size() == backward[i].size());
    for (std::size_t h = 0; h < forward[i].size(); ++h) {
      RC_ASSERT(equal(forward[i][h][0], backward[i][h][0] + Real(Rational(shift.x, kOne))));
      RC_ASSERT(equal(forward[i][h][1], backward[i][h][1] + Real(Rational(shift.y, kOne))));
    }
  }
  fast_agrees(back, *b);
}

// A line run in two halves: the same events, and one more at the middle, d along the line's normal.
RC_GTEST_PROP(LawsOfCutterC, SplittingALineAddsOneEvent, ()) {
  const Path path = changed(any_path(), [](PlaneCounts p) { return 2 * p; }, 2);
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < path.segments.size(); ++i)
    if (path.segments[i].kind == Segment::Kind::line && path.segments[i].travel != PlaneCounts{}) lines.push_back(i);
  RC_PRE(!lines.empty());
  const std::size_t at = *rc::gen::elementOf(lines);
  Path halves = path;
  halves.segments[at].travel = {path.segments[at].travel.x / 2, path.segments[at].travel.y / 2};
  halves.segments.insert(halves.segments.begin() + static_cast<std::ptrdiff_t>(at), Segment(halves.segments[at]));
  const spec::Case whole = unchecked(path);
  const spec::Case split = unchecked(halves);
  const auto a = model_run(whole);
  const auto b = model_run(split);
  RC_LOG() << fuzz::encode(whole) << fuzz::encode(split);
  const std::uint64_t line = kFirstSegmentLine + at;
  const PlaneCounts t = halves.segments[at].travel;
  std::size_t j = 0;
  for (const model::Event& e : a->events) {
    if (e.line == line && e.cause == spec::Cause::programmed && e.kind == EventKind::move) {
      const model::Event& middle = b->events.at(j++);
      RC_ASSERT(middle.line == line);
      const Real x = middle.point[0] - middle.programmed[0];
      const Real y = middle.point[1] - middle.programmed[1];
      RC_ASSERT(equal(x * Real(Rational(t.x)) + y * Real(Rational(t.y)), 0));
      RC_ASSERT(equal(square(x) + square(y), square(Real(Rational(path.offset, kOne)))));
    }
    // A line that cannot end is not run, and its corner moves neither; its first half is.
    if (e.line == line && e.kind == EventKind::alarm)
      while (b->events.at(j).kind == EventKind::move) ++j;
    const model::Event& f = b->events.at(j++);
    RC_ASSERT(f.kind == e.kind);
    RC_ASSERT(f.number == e.number);
    const bool after = e.line > line || (e.line == line && e.cause != spec::Cause::corner);
    RC_ASSERT(f.line == e.line + (after ? 1U : 0U));
    if (e.kind == EventKind::move) RC_ASSERT(same(e.point, f.point));
  }
  RC_ASSERT(j == b->events.size());
  fast_agrees(split, *b);
}

// Every head of a corner of two lines lies at the offset value from both lines, or from one of them and d past the
// corner along it (acute corners).
RC_GTEST_PROP(LawsOfCutterC, HeadsLieOnTheOffsetLines, ()) {
  const Path path = any_path();
  const spec::Case c = unchecked(path);
  const auto run = model_run(c);
  RC_LOG() << fuzz::encode(c);
  RC_ASSERT(run.has_value());
  const auto is_line = [&](std::size_t i) { return path.segments[i].kind == Segment::Kind::line; };
  const Real d = Rational(path.offset, kOne);
  // How far the head lies to the left of the line, times the length of its travel; squares of both compared.
  const auto on_offset_line = [&](const model::Event& e, PlaneCounts t) {
    const Real left =
        Real(Rational(t.x)) * (e.point[1] - e.programmed[1]) - Real(Rational(t.y)) * (e.point[0] - e.programmed[0]);
    const Real length2 = Rational(t.x * t.x + t.y * t.y);
    return left > Real(0) && equal(square(left), square(d) * length2);
  };
  for (const model::Event& e : run->events) {
    if (e.kind != EventKind::move || e.line < kFirstSegmentLine || e.cause == spec::Cause::cancel) continue;
    const std::size_t own = e.line - kFirstSegmentLine;
    const std::size_t before = e.cause == spec::Cause::corner ? own - 1 : own;
    if (own == 0 && e.cause == spec::Cause::corner) continue;  // at the start-up
    if (before + 1 >= path.segments.size() || !is_line(before) || !is_line(before + 1)) continue;
    const PlaneCounts t1 = path.segments[before].travel;
    const PlaneCounts t2 = path.segments[before + 1].travel;
    if (t1 == PlaneCounts{} || t2 == PlaneCounts{}) continue;
    RC_ASSERT(on_offset_line(e, t1) || on_offset_line(e, t2));
  }
}

}  // namespace
}  // namespace toolcomp::laws
