// SPDX-License-Identifier: Apache-2.0
// Sweep and radii of an arc as they are between the heads a controller has; worked out by hand.
#include "judge/oracle/arc_fit.h"

#include <gtest/gtest.h>

#include <tuple>

namespace toolcomp::judge {
namespace {

using exact::Real;
using model::Vector;

constexpr std::array<std::size_t, 3> kIndex = {0, 1, 2};

// Of 90 degrees about the origin, from `start` to `end`, each 10 away from it.
struct Quarter {
  spec::Arc<Real> arc;
  Vector start;
  Vector end;

  Quarter(spec::Plane plane, spec::ArcDirection direction, Vector from, Vector to)
      : start(std::move(from)), end(std::move(to)) {
    for (std::size_t i = 0; i < 3; ++i) arc.center.set(i, Real(0));
    arc.plane = plane;
    arc.direction = direction;
    arc.sweep = Real(90);
    arc.radius = {Real(10), Real(10)};
  }
  [[nodiscard]] std::optional<spec::Arc<Real>> with(const Vector& off_start, const Vector& off_end) const {
    return fitted(arc, {start, off_start}, {end, off_end}, kIndex);
  }
};

Vector at(int x, int y, int z) { return {Real(x), Real(y), Real(z)}; }

void expect(const std::optional<spec::Arc<Real>>& arc, const char* sweep, const char* start, const char* end) {
  ASSERT_TRUE(arc.has_value());
  EXPECT_EQ(arc->sweep->decimal(12), sweep);
  EXPECT_EQ(arc->radius->first.decimal(12), start);
  EXPECT_EQ(arc->radius->second.decimal(12), end);
}

TEST(ArcFit, KeepsWhatIsNotOff) {
  const Quarter quarter(spec::Plane::xy, spec::ArcDirection::ccw, at(10, 0, 0), at(0, 10, 0));
  expect(quarter.with(at(0, 0, 0), at(0, 0, 0)), "90", "10", "10");
}

// A start at (10, 10) is 45 degrees further on: half the arc is left, and its start is sqrt(200) away.
TEST(ArcFit, FollowsTheHeads) {
  const Quarter ccw(spec::Plane::xy, spec::ArcDirection::ccw, at(10, 0, 0), at(0, 10, 0));
  expect(ccw.with(at(0, 10, 7), at(0, 0, 0)), "45", "14.142135623731", "10");
  expect(ccw.with(at(0, 0, 0), at(10, 0, 0)), "45", "10", "14.142135623731");
  const Quarter cw(spec::Plane::xy, spec::ArcDirection::cw, at(0, 10, 0), at(10, 0, 0));
  expect(cw.with(at(-10, 0, 0), at(0, 0, 0)), "135", "14.142135623731", "10");
}

// Z X and Y Z turn from Z to X and from Y to Z.
TEST(ArcFit, InEveryPlane) {
  const Quarter zx(spec::Plane::zx, spec::ArcDirection::ccw, at(0, 0, 10), at(10, 0, 0));
  expect(zx.with(at(10, 0, 0), at(0, 0, 0)), "45", "14.142135623731", "10");
  const Quarter yz(spec::Plane::yz, spec::ArcDirection::ccw, at(0, 10, 0), at(0, 0, 10));
  expect(yz.with(at(0, 0, 10), at(0, 0, 0)), "45", "14.142135623731", "10");
}

// The same about (3, 4, 5), in every plane.
TEST(ArcFit, AboutAnyCentre) {
  const Vector center = at(3, 4, 5);
  for (const auto& [plane, from, to, off] : {std::tuple(spec::Plane::xy, at(10, 0, 0), at(0, 10, 0), at(0, 10, 0)),
                                             std::tuple(spec::Plane::zx, at(0, 0, 10), at(10, 0, 0), at(10, 0, 0)),
                                             std::tuple(spec::Plane::yz, at(0, 10, 0), at(0, 0, 10), at(0, 0, 10))}) {
    Quarter quarter(plane, spec::ArcDirection::ccw, center + from, center + to);
    for (std::size_t i = 0; i < 3; ++i) quarter.arc.center.set(i, model::component(center, i));
    expect(quarter.with(off, at(0, 0, 0)), "45", "14.142135623731", "10");
  }
}

// After a G92 the head before the arc has other coordinates than its start.
TEST(ArcFit, NothingBehindAnotherStart) {
  Quarter shifted(spec::Plane::xy, spec::ArcDirection::ccw, at(20, 0, 0), at(0, 10, 0));
  EXPECT_FALSE(shifted.with(at(0, 0, 0), at(0, 0, 0)).has_value());
  Quarter turned(spec::Plane::xy, spec::ArcDirection::ccw, at(-10, 0, 0), at(0, 10, 0));
  EXPECT_FALSE(turned.with(at(0, 0, 0), at(0, 0, 0)).has_value());
}

TEST(ArcFit, NothingWhereAHeadIsOffByARightAngle) {
  const Quarter quarter(spec::Plane::xy, spec::ArcDirection::ccw, at(10, 0, 0), at(0, 10, 0));
  EXPECT_FALSE(quarter.with(at(-10, 10, 0), at(0, 0, 0)).has_value());
  EXPECT_FALSE(quarter.with(at(0, 0, 0), at(0, -20, 0)).has_value());
}

}  // namespace
}  // namespace toolcomp::judge
