// SPDX-License-Identifier: Apache-2.0
// Laws of cutter compensation B (14.4) on paths of lines and arcs.
#include "tests/property/fanuc/cutter_paths.h"

namespace toolcomp::laws {
namespace {

const std::string kB = "fanuc/cutter-compensation-b";

RC_GTEST_PROP(LawsOfCutterB, MirrorExchangesSides, ()) { mirror_exchanges_sides(kB); }
RC_GTEST_PROP(LawsOfCutterB, QuarterTurn, ()) { quarter_turn(kB); }
RC_GTEST_PROP(LawsOfCutterB, PythagoreanTurn, ()) { pythagorean_turn(kB); }
RC_GTEST_PROP(LawsOfCutterB, InchesAreMillimetresTimes254, ()) { inches(kB); }
RC_GTEST_PROP(LawsOfCutterB, NegativeValueExchangesSides, ()) { negative_value_exchanges_sides(kB); }
RC_GTEST_PROP(LawsOfCutterB, AbsoluteIsIncremental, ()) { absolute_is_incremental(kB); }
RC_GTEST_PROP(LawsOfCutterB, PlanesByCyclicRenaming, ()) { planes_by_cyclic_renaming(kB); }
RC_GTEST_PROP(LawsOfCutterB, ValueZeroIsTheIdentity, ()) { value_zero_is_the_identity(kB); }

// The vector at the end of a line is as long as the value and perpendicular to the line, on the left under G41.
RC_GTEST_PROP(LawsOfCutterB, VectorsStandOnTheirLines, ()) {
  const Path path = any_path();
  const spec::Case c = make(kB, path);
  const auto run = model_run(c);
  RC_LOG() << fuzz::encode(c);
  RC_ASSERT(run.has_value());
  for (const model::Event& e : run->events) {
    if (e.kind != EventKind::move || e.cause == spec::Cause::cancel || e.line < kFirstSegmentLine - 1) continue;
    const PlaneCounts t = e.line < kFirstSegmentLine ? path.lead : path.segments[e.line - kFirstSegmentLine].travel;
    if (e.arc || (t.x == 0 && t.y == 0)) continue;
    const Real x = e.point[0] - e.programmed[0];
    const Real y = e.point[1] - e.programmed[1];
    const Real tx = Rational(t.x);
    const Real ty = Rational(t.y);
    RC_ASSERT(equal(x * tx + y * ty, 0));
    RC_ASSERT(equal(square(x) + square(y), square(Real(Rational(path.offset, kOne)))));
    RC_ASSERT(tx * y - ty * x > Real(0));
  }
}

// A line run in two halves: the same events, and one more at the middle with the vector of the line.
RC_GTEST_PROP(LawsOfCutterB, SplittingALineAddsOneEvent, ()) {
  const Path path = changed(any_path(), [](PlaneCounts p) { return 2 * p; }, 2);
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < path.segments.size(); ++i)
    if (path.segments[i].kind == Segment::Kind::line && path.segments[i].travel != PlaneCounts{}) lines.push_back(i);
  RC_PRE(!lines.empty());
  const std::size_t at = *rc::gen::elementOf(lines);
  Path halves = path;
  halves.segments[at].travel = {path.segments[at].travel.x / 2, path.segments[at].travel.y / 2};
  halves.segments.insert(halves.segments.begin() + static_cast<std::ptrdiff_t>(at), Segment(halves.segments[at]));
  const spec::Case whole = make(kB, path);
  const spec::Case split = make(kB, halves);
  const auto a = model_run(whole);
  const auto b = model_run(split);
  RC_LOG() << fuzz::encode(whole) << fuzz::encode(split);
  const std::uint64_t line = kFirstSegmentLine + at;
  std::size_t j = 0;
  for (const model::Event& e : a->events) {
    if (e.line == line) {
      const model::Event& middle = b->events.at(j++);
      const model::Event& end = b->events.at(j);
      RC_ASSERT(middle.line == line);
      for (const std::size_t axis : {0U, 1U})
        RC_ASSERT(equal(middle.point[axis] - middle.programmed[axis], end.point[axis] - end.programmed[axis]));
    }
    const model::Event& f = b->events.at(j++);
    RC_ASSERT(f.kind == e.kind);
    RC_ASSERT(f.number == e.number);
    RC_ASSERT(f.line == e.line + (e.line >= line ? 1U : 0U));
    RC_ASSERT(same(e.point, f.point));
  }
  RC_ASSERT(j == b->events.size());
  fast_agrees(split, *b);
}

}  // namespace
}  // namespace toolcomp::laws
