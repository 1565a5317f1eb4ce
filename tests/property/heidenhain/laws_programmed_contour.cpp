// SPDX-License-Identifier: Apache-2.0
// Laws of FUNCTION PROG PATH IS CONTOUR over exact numbers.
#include "tests/property/heidenhain/space_paths.h"

namespace toolcomp::laws {
namespace {

constexpr const char* kContour = "heidenhain/programmed-contour";

// P7: a contour point is the tip, or the centre, of the nominal tool that touches there. Normal, tool and the direction
// across it are turned 3-4-5 triangles: every point is a decimal.
RC_GTEST_PROP(LawsOfProgrammedContour, AContourIsTheNominalToolThatTouchesIt, ()) {
  const Cutter tool = any_cutter(true);
  const Rotation turn = any_rotation();
  const bool steep = *rc::gen::arbitrary<bool>();
  const Rational s(steep ? 4 : 3, 5);
  const Rational c(steep ? 3 : 4, 5);
  const Point t = turn(Point{0, 0, 1});
  const Point u = turn(Point{1, 0, 0});
  const Point n = sum(s * u, c * t);
  const Point q = any_place();
  const Point center = sum(q, sum(tool.r2 * n, tool.flat() * u));
  const Point tip = sum(center, Rational(-tool.r2) * t);
  const bool reference = *rc::gen::arbitrary<bool>();
  const Moved contour = moved_once(make(kContour, tool, {.center = reference, .contour = true}, face(q, n, t)));
  const Moved by_tip = moved_once(make(kContour, tool, {}, face(tip, n, t)));
  const Moved by_center = moved_once(make(kContour, tool, {.center = true}, face(center, n, t)));
  for (const Moved* m : {&by_tip, &by_center}) {
    RC_ASSERT(same(contour.tip, m->tip));
    RC_ASSERT(same(contour.contact, m->contact));
    RC_ASSERT(same(contour.axes, m->axes));
    RC_ASSERT(same(contour.shift, m->shift));
  }
}

// The programmed point is the contact point, whatever the tool.
RC_GTEST_PROP(LawsOfProgrammedContour, TheProgrammedPointIsTouched, ()) {
  const Mode mode{.center = *rc::gen::arbitrary<bool>(), .contour = true};
  const Moved m =
      moved_once(make(kContour, any_cutter(true), mode, face(any_place(), any_direction(), any_direction())));
  RC_ASSERT(same(m.contact, m.programmed));
}

// Beside the path the full radius counts as a delta of that size does without the contour.
RC_GTEST_PROP(LawsOfProgrammedContour, BesideThePathTheRadiusIsADelta, ()) {
  const Cutter tool = any_cutter();
  Cutter all_delta = tool;
  all_delta.dr = tool.r + tool.dr;
  std::string path = "L X+0 Y+0 Z+0 R0\n";
  const Point t = any_direction();
  for (int i = 0; i < 3; ++i) path += "LN" + words("", any_place()) + words("T", t) + (i == 0 ? " RL\n" : "\n");
  const spec::Case contour = make(kContour, tool, {.contour = true}, path);
  const spec::Case off = make(kContour, all_delta, {}, path);
  // A corner that cannot be is left to the laws of peripheral milling.
  RC_PRE(judge::run_model(contour).events.back().kind == EventKind::move);
  const std::vector<Moved> a = moved(contour);
  const std::vector<Moved> b = moved(off);
  RC_ASSERT(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) RC_ASSERT(same(a[i].tip, b[i].tip));
}

}  // namespace
}  // namespace toolcomp::laws
