// SPDX-License-Identifier: Apache-2.0
// Laws of face milling over exact numbers; the fast engine agrees on both
// sides of each.
#include "tests/property/heidenhain/space_paths.h"

namespace toolcomp::laws {
namespace {

constexpr const char* kFace = "heidenhain/face-milling";

void all_same(const Moved& a, const Moved& b) {
  RC_ASSERT(same(a.tip, b.tip));
  RC_ASSERT(same(a.center, b.center));
  RC_ASSERT(same(a.contact, b.contact));
  RC_ASSERT(same(a.shift, b.shift));
  RC_ASSERT(same(a.tool_shift, b.tool_shift));
  RC_ASSERT(same(a.axes, b.axes));
  RC_ASSERT(same(a.tool, b.tool));
  RC_ASSERT(same(a.normal, b.normal));
}

// P1: the centre of the corner moves by dR2 n and by nothing else, and both tools touch at the contact point.
RC_GTEST_PROP(LawsOfFaceMilling, TheCornerCentreMovesAlongTheNormal, ()) {
  const Cutter tool = any_cutter();
  const Point n = any_direction();
  const Point t = any_direction();
  const Moved m = moved_once(make(kFace, tool, {}, face(any_place(), n, t)));
  const Vec u = ring_direction(n, t);
  const Vec corner = m.tip + Real(Rational(tool.r2 + tool.dr2)) * m.tool - Real(tool.effective_flat()) * u;
  const Vec nominal = m.tip - m.shift + Real(tool.r2) * m.tool - Real(tool.flat()) * u;
  RC_ASSERT(same(corner - nominal, Real(tool.dr2) * m.normal));
  RC_ASSERT(same(corner - Real(Rational(tool.r2 + tool.dr2)) * m.normal, m.contact));
  RC_ASSERT(same(nominal - Real(tool.r2) * m.normal, m.contact));
}

// P2: the tangent plane is kept: D_tip.n = dR2 (1 - c) + (rho' - rho) s.
RC_GTEST_PROP(LawsOfFaceMilling, TheTangentPlaneIsKept, ()) {
  const Cutter tool = any_cutter(true);
  const Moved m = moved_once(make(kFace, tool, {}, face(any_place(), any_direction(), any_direction())));
  const Real c = dot(m.normal, m.tool);
  const Real left = dot(m.shift, m.normal) - Real(tool.dr2) * (Real(1) - c);
  const Real ring{Rational(tool.effective_flat() - tool.flat())};
  RC_ASSERT(equal(left * left, ring * ring * (Real(1) - c * c)));
  RC_ASSERT(left * ring >= Real(0));
}

// P3: an even allowance moves the real tool by it along the normal, whatever the tool and its direction.
RC_GTEST_PROP(LawsOfFaceMilling, AnEvenAllowanceIsEven, ()) {
  Cutter tool = any_cutter();
  const Rational a = std::max(count_of(-300, 300, 1000), Rational(-tool.r2));
  tool.dl = tool.dr = tool.dr2 = a;
  const Moved m = moved_once(make(kFace, tool, {}, face(any_place(), any_direction(), any_direction())));
  RC_ASSERT(same(m.tool_shift, Real(a) * m.normal));
}

// P4: the lengths of N and T mean nothing.
RC_GTEST_PROP(LawsOfFaceMilling, VectorsAreDirections, ()) {
  const Cutter tool = any_cutter(true);
  const Point p = any_place();
  const Point n = any_direction();
  const Point t = any_direction();
  const Rational k(1, *rc::gen::element(2, 4, 5, 10, 100));
  const Rational m(1, *rc::gen::element(2, 4, 5, 10, 100));
  all_same(moved_once(make(kFace, tool, {}, face(p, n, t))), moved_once(make(kFace, tool, {}, face(p, k * n, m * t))));
}

// P5: the tip at P is the centre at P + R2 t.
RC_GTEST_PROP(LawsOfFaceMilling, TipAndCentreProgramsMeanTheSame, ()) {
  const Cutter tool = any_cutter(true);
  const Point p = any_place();
  const Point n = any_direction();
  const Point t = any_rotation()(Point{0, 0, 1});  // of length 1
  const Moved tip = moved_once(make(kFace, tool, {}, face(p, n, t)));
  const Moved center = moved_once(make(kFace, tool, {.center = true}, face(sum(p, tool.r2 * t), n, t)));
  all_same(tip, center);
}

// P6: without deltas nothing moves.
RC_GTEST_PROP(LawsOfFaceMilling, NoDeltasNoCompensation, ()) {
  Cutter tool = any_cutter();
  tool.dl = tool.dr = tool.dr2 = 0;
  const bool center = *rc::gen::arbitrary<bool>();
  const Moved m =
      moved_once(make(kFace, tool, {.center = center}, face(any_place(), any_direction(), any_direction())));
  RC_ASSERT(same(center ? m.center : m.tip, m.programmed));
  RC_ASSERT(same(m.axes, m.tip));
}

// P8: space has no preferred direction.
RC_GTEST_PROP(LawsOfFaceMilling, RotationsOfSpace, ()) {
  const Cutter tool = any_cutter(true);
  const Mode mode{.center = *rc::gen::arbitrary<bool>(), .contour = *rc::gen::arbitrary<bool>()};
  const Point p = any_place();
  const Point n = any_direction();
  const Point t = any_direction();
  const Rotation turn = any_rotation();
  Moved m = moved_once(make(kFace, tool, mode, face(p, n, t)));
  for (Vec* v : {&m.tip, &m.center, &m.contact, &m.shift, &m.tool_shift, &m.axes, &m.tool, &m.normal}) *v = turn(*v);
  // A tenth of each, since turned components may be beyond 9.99999999.
  const Rational tenth(1, 10);
  all_same(m, moved_once(make(kFace, tool, mode, face(turn(p), tenth * turn(n), tenth * turn(t)))));
}

// P9: the centre of a ball does not depend on the tool direction.
RC_GTEST_PROP(LawsOfFaceMilling, TheCentreOfABallDoesNotTurn, ()) {
  Cutter tool = any_cutter();
  tool.r2 = tool.r;
  tool.dr2 = tool.dr;
  const Point p = any_place();
  const Point n = any_direction();
  const Moved a = moved_once(make(kFace, tool, {.center = true}, face(p, n, any_direction())));
  const Moved b = moved_once(make(kFace, tool, {.center = true}, face(p, n, any_direction())));
  RC_ASSERT(same(a.center, b.center));
  RC_ASSERT(same(a.contact, b.contact));
}

// P10: an end mill at right angles to the normal moves by DR along it.
RC_GTEST_PROP(LawsOfFaceMilling, TheFlankOfAnEndMill, ()) {
  Cutter tool = any_cutter();
  tool.r2 = tool.dr2 = 0;
  const Point t = any_direction();
  const Point n = t[0] == 0 && t[1] == 0 ? Point{3, -4, 0} : Point{t[1], -t[0], 0};
  const Moved m = moved_once(make(kFace, tool, {}, face(any_place(), n, t)));
  RC_ASSERT(same(m.shift, Real(tool.dr) * m.normal));
}

// P12: without TCPM the tool vector means nothing.
RC_GTEST_PROP(LawsOfFaceMilling, WithoutTcpmToolVectorsAreIgnored, ()) {
  const Cutter tool = any_cutter(true);
  const Point p = any_place();
  const Point n = any_direction();
  all_same(moved_once(make(kFace, tool, {.tcpm = false}, face(p, n))),
           moved_once(make(kFace, tool, {.tcpm = false}, face(p, n, any_direction()))));
}

// P13: a tool along the normal stands where it is programmed, whatever its radii.
RC_GTEST_PROP(LawsOfFaceMilling, AToolAlongTheNormalKeepsItsTip, ()) {
  const Cutter tool = any_cutter(true);
  const Moved m = moved_once(make(kFace, tool, {}, face(any_place(), any_direction())));
  RC_ASSERT(same(m.tip, m.programmed));
  RC_ASSERT(same(m.tool, m.normal));
  RC_ASSERT(same(m.tool_shift, Real(tool.dl) * m.normal));
}

// P14: M107 changes verdicts and no coordinate.
RC_GTEST_PROP(LawsOfFaceMilling, PermissionMovesNothing, ()) {
  Cutter tool = any_cutter();
  tool.dr = std::min(tool.dr, Rational(0));
  tool.dr2 = std::min(tool.dr2, Rational(0));
  RC_PRE(tool.r2 + tool.dr2 <= tool.r + tool.dr);
  const std::string block = face(any_place(), any_direction(), any_direction());
  all_same(moved_once(make(kFace, tool, {.permitted = true}, block)),
           moved_once(make(kFace, tool, {.permitted = false}, block)));
}

// P15: DL lowered by the corner radius, output at the tip, puts the axes where the centre as reference point does.
RC_GTEST_PROP(LawsOfFaceMilling, ANegativeLengthStandsForTheCentre, ()) {
  const Cutter tool = any_cutter(true);
  Cutter lowered = tool;
  lowered.dl -= tool.r2;
  const std::string block = face(any_place(), any_direction(), any_direction());
  RC_ASSERT(same(moved_once(make(kFace, lowered, {}, block)).axes,
                 moved_once(make(kFace, tool, {.center = true}, block)).axes));
}

}  // namespace
}  // namespace toolcomp::laws
