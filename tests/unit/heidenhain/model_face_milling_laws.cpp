// SPDX-License-Identifier: Apache-2.0
// Laws of face milling that hold for every tool and direction, proven on rational and
// irrational vectors by the exact numbers themselves: every comparison here is a certified one.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "model/geometry/vector.h"
#include "tests/unit/heidenhain/klartext_run.h"

namespace {

using namespace toolcomp;
using exact::Real;
using model::Vector;
using test::last_move;
using test::tool;

const std::string kCenter = "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\n";
const std::string kCall = "TOOL CALL 1 Z\nM107\n";

// Decimal vectors, rational or not when they are normalised; some of them parallel, across or below.
const std::vector<std::string> kNormals{"NX0.6 NY0 NZ0.8 ", "NX0.3 NY-0.5 NZ0.7 ", "NX0 NY0 NZ1 ", "NX1 NY0 NZ0 ",
                                        "NX0.28 NY0.96 NZ-0.1 "};
const std::vector<std::string> kTools{"TX0 TY0 TZ1 ", "TX0 TY0.6 TZ0.8 ", "TX0.2 TY-0.1 TZ0.9 "};

struct Shape {
  std::string radii;
  std::string deltas;
  Real flat, r2, dr, dr2;  // flat: R - R2

  [[nodiscard]] std::string keys() const { return radii + deltas; }
};
std::vector<Shape> shapes() {
  const auto q = [](int n, int d) { return Real(exact::Rational(n, d)); };
  return {{"R = 3\nR2 = 3\n", "DL = \"0.1\"\nDR = \"-0.1\"\nDR2 = \"-0.1\"\n", 0, 3, q(-1, 10), q(-1, 10)},
          {"R = 6\nR2 = 1\n", "DR = \"0.3\"\nDR2 = \"-0.2\"\n", 5, 1, q(3, 10), q(-1, 5)},
          {"R = 6\n", "DR = \"-0.25\"\n", 6, 0, q(-1, 4), 0}};
}

Vector vector(const std::array<Real, 3>& v) { return {v[0], v[1], v[2]}; }
Vector point(const model::Event& event) { return {event.point[0], event.point[1], event.point[2]}; }
Vector normal(const model::Event& event) { return vector(event.space->contact->normal); }
Vector axis(const model::Event& event) { return vector(*event.tool_axis); }
Vector shift(const model::Event& event) { return vector(event.space->shift); }

template <class Law>
void for_all(const Law& law) {
  for (const Shape& shape : shapes())
    for (const std::string& n : kNormals)
      for (const std::string& t : kTools) {
        SCOPED_TRACE(shape.keys() + n + t);
        law(shape, n, t);
      }
}

model::Event run(const Shape& shape, const std::string& before, const std::string& vectors) {
  return last_move(tool(shape.keys()), kCall + before + "LN X1.5 Y-2 Z3.25 " + vectors + "\n");
}

// P1: both tools touch the same point, so the corner centre, R2 or R2' along n from it, moves by dR2 n; the ring of the
// effective tool has the radius rho'. P2: along the normal the tip moves by dR2 (1 - c) + (rho' - rho) s.
TEST(ModelFaceMillingLaws, CornerCenterAndTangency) {
  for_all([](const Shape& shape, const std::string& n, const std::string& t) {
    const model::Event event = run(shape, "M128\n", n + t);
    Shape nominal = shape;
    nominal.deltas = "";
    const Vector q = vector(event.space->contact->point);
    EXPECT_TRUE(q == vector(run(nominal, "M128\n", n + t).space->contact->point));
    const Vector ring = vector(event.space->tool_center) - q - (shape.r2 + shape.dr2) * normal(event);
    EXPECT_EQ(dot(ring, axis(event)).sign(), exact::Sign::zero);
    const Real rho = shape.flat + shape.dr - shape.dr2;
    EXPECT_TRUE(squared_norm(ring) == (event.space->contact->flat ? Real() : rho * rho));
    const Real c = dot(normal(event), axis(event));
    const Real beyond = dot(shift(event), normal(event)) - shape.dr2 * (1 - c);
    const Real change = shape.dr - shape.dr2;
    EXPECT_TRUE(beyond * beyond == change * change * (1 - c * c));
  });
}

// P5: TIP at P is CNT at P + R2 t, seen from the contact. P6: no deltas, nothing moves.
TEST(ModelFaceMillingLaws, ReferencePointAndNoDeltas) {
  for_all([](const Shape& shape, const std::string& n, const std::string& t) {
    const model::Event tip = run(shape, "M128\n", n + t);
    const model::Event center = run(shape, kCenter, n + t);
    EXPECT_TRUE(point(tip) - point(center) == shape.r2 * axis(tip));
    EXPECT_TRUE(shift(tip) == shift(center));
  });
  const model::Event event =
      last_move(tool("R = 6\nR2 = 1\n"), "TOOL CALL 1\nM128\nLN X1 Y2 Z3 NX1 NY2 NZ3 TX0 TY1 TZ3\n");
  EXPECT_TRUE(point(event) == (Vector{1, 2, 3}));
}

// P9: the centre of a ball does not depend on T under CNT-CNT. P12: without TCPM T does nothing.
TEST(ModelFaceMillingLaws, WhereTheToolVectorDoesNotCount) {
  const Shape ball = shapes().front();
  for (const std::string& n : kNormals) {
    const Vector center = vector(run(ball, kCenter, n + kTools[0]).space->tool_center);
    const Vector upright = point(run(ball, "", n));
    for (const std::string& t : kTools) {
      EXPECT_TRUE(vector(run(ball, kCenter, n + t).space->tool_center) == center) << n << t;
      EXPECT_TRUE(point(run(ball, "", n + t)) == upright) << n << t;
    }
  }
}

// P10: an end mill with the normal across the tool goes by dR n. P13: with the tool along the normal nothing moves.
TEST(ModelFaceMillingLaws, AcrossAndAlong) {
  const Shape mill = shapes().back();
  const model::Event across = run(mill, "M128\n", "NX0.3 NY-0.6 NZ0 TX0.2 TY0.1 TZ0.9 ");
  EXPECT_TRUE(shift(across) == mill.dr * normal(across));
  for (const Shape& shape : shapes())
    for (const std::string& n : kNormals) {
      EXPECT_TRUE(exact::is_zero(shift(run(shape, "M128\n", n)))) << shape.radii << n;
      // The same direction written longer.
      std::string t = n;
      for (char& letter : t)
        if (letter == 'N') letter = 'T';
      EXPECT_TRUE(exact::is_zero(shift(run(shape, "M128\n", n + t)))) << shape.radii << n;
    }
}

// P14: M107 never changes coordinates.
TEST(ModelFaceMillingLaws, OversizeSwitchChangesNoCoordinate) {
  const std::string keys = "R = 6\nR2 = 1\nDR = \"-0.3\"\nDR2 = \"-0.2\"\n";
  const std::string block = "LN X1 Y2 Z3 NX0.3 NY-0.5 NZ0.7 TX0 TY0.6 TZ0.8 ";
  EXPECT_TRUE(point(last_move(tool(keys), "TOOL CALL 1\nM128\n" + block + "\n")) ==
              point(last_move(tool(keys), "TOOL CALL 1\nM128\n" + block + "M107\n")));
}

// P8: turning N, T and P by a rational rotation about Z (3-4-5) turns the result.
TEST(ModelFaceMillingLaws, Rotation) {
  const std::string keys = "R = 6\nR2 = 1\nDR = \"0.3\"\nDR2 = \"-0.2\"\n";
  const auto at = [&](const std::string& block) { return point(last_move(tool(keys), kCall + "M128\n" + block)); };
  const Vector a = at("LN X5 Y10 Z3 NX0.5 NY0.1 NZ0.7 TX0 TY0.5 TZ0.8\n");
  const Vector b = at("LN X-5 Y10 Z3 NX0.22 NY0.46 NZ0.7 TX-0.4 TY0.3 TZ0.8\n");
  const Real c = exact::Rational(3, 5);
  const Real s = exact::Rational(4, 5);
  EXPECT_TRUE(b == (Vector{c * a.x - s * a.y, s * a.x + c * a.y, a.z}));
}

}  // namespace
