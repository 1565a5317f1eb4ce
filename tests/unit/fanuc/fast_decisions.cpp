// SPDX-License-Identifier: Apache-2.0
// Decisions and vectors of leading edge offset: against whole numbers of GMP where the tool direction is rational,
// against identities of special angles where it comes from rotary axes.
#include <gtest/gtest.h>

#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <random>

#include "fast/arithmetic/wide.h"
#include "fast/fanuc/leading_edge_offset/compensation_vector.h"
#include "spec/language/setup_format.h"
#include "tests/effort.h"

namespace toolcomp::fast {
namespace {

using boost::multiprecision::mpz_int;
using Big = boost::multiprecision::number<boost::multiprecision::gmp_float<120>>;
using Exact = std::array<mpz_int, 3>;

const Kinematics& no_kinematics() {
  static const Kinematics kinematics(spec::read_setup_toml("control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\"]\n", ""));
  return kinematics;
}

constexpr const char* kHead =
    "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\",\"B\",\"C\"]\n[parameters]\n\"19680\"=2\n\"19681\"=5\n"
    "\"19682\"=3\n\"19686\"=4\n\"19687\"=2\n";

Displacement displacement(const std::array<std::int64_t, 3>& m) {
  Displacement d;
  set_displacement(d, m[0], m[1], m[2]);
  return d;
}

mpz_int dot(const Exact& a, const Exact& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The class by the rules of 3.4, for a limit whose squared sine is quarters / 4.
AngleClass exact_class(const Exact& m, const Exact& v, int quarters) {
  const mpz_int d = dot(m, v);
  const mpz_int all = dot(m, m) * dot(v, v);
  if (4 * d * d >= (4 - quarters) * all && d > 0) return AngleClass::near_0;
  if (4 * d * d >= (4 - quarters) * all && d < 0) return AngleClass::near_180;
  if (4 * d * d <= quarters * all) return AngleClass::near_90;
  return d > 0 ? AngleClass::below_90 : AngleClass::above_90;
}

// Pairs at and one unit beside exact ties: rotations of (a, b, 0) against (c, d, 0) with small whole numbers, scaled.
TEST(Decisions, RationalDirectionsAreDecidedExactly) {
  std::mt19937_64 random(1);
  const struct {
    int degrees, quarters;
  } limits[] = {{0, 0}, {30, 1}, {45, 2}, {60, 3}, {90, 4}};
  std::array<int, 5> seen{};
  for (const auto& limit : limits) {
    const CompensationVector compensation(spec::decimal(limit.degrees));
    for (std::uint64_t i = 0; i < test::random_cases(40'000); ++i) {
      const auto small = [&] { return static_cast<std::int64_t>(random() % 9) - 4; };
      const std::int64_t scale = random() % 2 == 0 ? 1 : static_cast<std::int64_t>(random() % 100'000'000);
      std::array<std::int64_t, 3> m{small() * scale, small() * scale, small() * scale};
      std::array<std::int64_t, 3> v{small(), small(), small()};
      if (random() % 3 == 0) m[random() % 3] += random() % 2 == 0 ? 1 : -1;
      if (m == std::array<std::int64_t, 3>{} || v == std::array<std::int64_t, 3>{}) continue;
      const Direction direction = whole_direction({v[0], v[1], v[2]});
      const Lean lean = compensation.lean(no_kinematics(), displacement(m), direction);
      const AngleClass expected = exact_class({m[0], m[1], m[2]}, {v[0], v[1], v[2]}, limit.quarters);
      ASSERT_EQ(lean.angle, expected) << limit.degrees << ": " << m[0] << ' ' << m[1] << ' ' << m[2] << " / " << v[0]
                                      << ' ' << v[1] << ' ' << v[2];
      ++seen[static_cast<std::size_t>(expected)];
    }
  }
  for (const int n : seen) EXPECT_GT(n, 100);
}

TEST(Decisions, LargeNumbersNearTies) {
  // m.v = +1, 0, -1 with components of 50 bits: doubles see 0 in all three.
  const CompensationVector compensation(spec::decimal(0));
  const std::int64_t a = 1'000'000'000'000'003;
  for (const std::int64_t off : {-1, 0, 1}) {
    const std::array<std::int64_t, 3> m{a + 1, -a, off};
    const Direction direction = whole_direction({a, a + 1, 1});
    const int sign = CompensationVector::dot_sign(no_kinematics(), displacement(m), direction);
    EXPECT_EQ(sign, off);
    const AngleClass expected =
        off == 0 ? AngleClass::near_90 : (off > 0 ? AngleClass::below_90 : AngleClass::above_90);
    EXPECT_EQ(compensation.lean(no_kinematics(), displacement(m), direction).angle, expected);
  }
}

// The vector is accurate to a few units in the last place however near to the tool the movement is.
TEST(Decisions, VectorsNearTheToolAreAccurate) {
  std::mt19937_64 random(2);
  double worst = 0;
  const CompensationVector compensation(spec::decimal(0));
  for (std::uint64_t i = 0; i < test::random_cases(20'000); ++i) {
    std::array<std::int64_t, 3> v{};
    for (auto& component : v) component = static_cast<std::int64_t>(random() % 2'000'001) - 1'000'000;
    std::array<std::int64_t, 3> m{};
    const auto spread = static_cast<std::int64_t>(1) << (random() % 30);
    for (std::size_t k = 0; k < 3; ++k)
      m[k] = v[k] * 1000 + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * spread)) - spread;
    if (v == std::array<std::int64_t, 3>{}) continue;
    const Exact em{m[0], m[1], m[2]};
    const Exact ev{v[0], v[1], v[2]};
    // (m x v) x v = (m.v) v - (v.v) m
    Exact w;
    for (std::size_t k = 0; k < 3; ++k) w[k] = dot(em, ev) * ev[k] - dot(ev, ev) * em[k];
    if (dot(w, w) == 0) continue;
    const Lean lean = compensation.lean(no_kinematics(), displacement(m), whole_direction({v[0], v[1], v[2]}));
    if (lean.angle == AngleClass::near_0 || lean.angle == AngleClass::near_180) continue;
    const Big norm = boost::multiprecision::sqrt(Big(dot(w, w)));
    for (std::size_t k = 0; k < 3; ++k) {
      const double unit = lean.backward[k] * (1 / lean.norm);
      const Big error = abs(Big(w[k]) / norm - Big(unit));
      worst = std::max(worst, error.convert_to<double>() * 0x1p52);  // in ulp of 1
    }
  }
  RecordProperty("worst_ulp", std::to_string(worst));
  EXPECT_LE(worst, 8);
}

// The same where the tool stands by rotary axes, held against the direction in double-double: 2^-98 of it, over a sine
// of 2^-7 at least here, is nothing beside a double.
TEST(Decisions, VectorsNearAToolOfRotaryAxesAreAccurate) {
  std::mt19937_64 random(6);
  Kinematics kinematics(spec::read_setup_toml(kHead, ""));
  const CompensationVector compensation(spec::decimal(0));
  double worst = 0;
  int near = 0;
  for (std::uint64_t i = 0; i < test::random_cases(20'000); ++i) {
    std::array<Count, spec::kMaxAxes> position;
    for (const std::size_t axis : {3U, 4U})
      position[axis].set_small(static_cast<std::int64_t>(random() % 720'000'001) - 360'000'000);
    Direction tool;
    kinematics.direct(position, tool);
    const FineVector fine = kinematics.refine(tool);
    std::array<std::int64_t, 3> m{};
    const auto spread = static_cast<std::int64_t>(1) << (random() % 27);
    for (std::size_t k = 0; k < 3; ++k)
      m[k] = std::llround(tool.unit[static_cast<Eigen::Index>(k)] * 1e8) +
             static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * spread)) - spread;
    std::array<Big, 3> v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = Big(fine[k].hi) + Big(fine[k].lo);
    const Big d = m[0] * v[0] + m[1] * v[1] + m[2] * v[2];
    const Big square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    std::array<Big, 3> w;
    for (std::size_t k = 0; k < 3; ++k) w[k] = d * v[k] - square * m[k];
    const Big norm = boost::multiprecision::sqrt(Big(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]));
    const Lean lean = compensation.lean(kinematics, displacement(m), tool);
    if (lean.angle == AngleClass::near_0 || lean.angle == AngleClass::near_180) continue;
    if (norm * 2 < d) ++near;
    for (std::size_t k = 0; k < 3; ++k) {
      const Big error = abs(w[k] / norm - Big(lean.backward[k] * (1 / lean.norm)));
      worst = std::max(worst, error.convert_to<double>() * 0x1p52);  // in ulp of 1
    }
  }
  RecordProperty("worst_ulp", std::to_string(worst));
  EXPECT_GE(near, static_cast<int>(test::random_cases(10'000)));
  EXPECT_LE(worst, 16);
}

// Rotary axes: multiples of 15 degrees make exact ties that no rational arithmetic sees. VT = (sin b, 0, cos b);
// movements along (cos b', 0, -sin b') of decimal angles cannot be programmed, but those with rational tangents can.
TEST(Decisions, TrigonometricTies) {
  Kinematics kinematics(spec::read_setup_toml(kHead, ""));
  const auto direction = [&](int b, int c) {
    std::array<Count, spec::kMaxAxes> position;
    position[3] = Count::of(spec::decimal(b));
    position[4] = Count::of(spec::decimal(c));
    Direction result;
    kinematics.direct(position, result);
    return result;
  };
  const auto sign = [&](const std::array<std::int64_t, 3>& m, int b, int c) {
    return CompensationVector::dot_sign(kinematics, displacement(m), direction(b, c));
  };
  EXPECT_EQ(sign({1000, 0, -1000}, 45, 0), 0);
  EXPECT_EQ(sign({1'000'000'001, 0, -1'000'000'000}, 45, 0), 1);
  EXPECT_EQ(sign({-1000, 0, 1000}, 135, 180), 0);
  EXPECT_EQ(sign({-1000, 0, -1000}, 135, 180), 1);
  EXPECT_EQ(sign({1000, -1000, 0}, 30, 45), 0);
  EXPECT_EQ(sign({1000, 1000, 0}, 30, 135), 0);
  EXPECT_EQ(sign({0, 1000, 0}, 30, 0), 0);
  EXPECT_EQ(sign({0, 1000, 0}, 30, 180), 0);
  EXPECT_EQ(sign({0, 1000, 0}, -60, 360), 0);
  // 15-digit approximations of tan 30: the best of them are 1e-15 off and must not be taken for ties.
  EXPECT_EQ(sign({1'000'000'000'000'000, 0, -577'350'269'189'625}, 30, 0), 1);
  EXPECT_EQ(sign({1'000'000'000'000'000, 0, -577'350'269'189'626}, 30, 0), -1);
  // The range of 30 degrees about B30: movement along Z lies exactly at its end, in it.
  const CompensationVector thirty(spec::decimal(30));
  EXPECT_EQ(thirty.lean(kinematics, displacement({0, 0, 5}), direction(30, 17)).angle, AngleClass::near_0);
  EXPECT_EQ(thirty.lean(kinematics, displacement({0, 0, -5}), direction(30, 17)).angle, AngleClass::near_180);
  EXPECT_EQ(thirty.lean(kinematics, displacement({0, 0, 5}), direction(60, 17)).angle, AngleClass::near_90);
  const CompensationVector seventeen(spec::decimal(17));
  EXPECT_EQ(seventeen.lean(kinematics, displacement({0, 0, 5}), direction(17, 33)).angle, AngleClass::near_0);
  EXPECT_EQ(seventeen.lean(kinematics, displacement({0, 0, 5}), direction(73, 33)).angle, AngleClass::near_90);
  const CompensationVector eighty(spec::decimal(80));
  EXPECT_EQ(eighty.lean(kinematics, displacement({0, 0, 5}), direction(80, 33)).angle, AngleClass::near_0);
  const CompensationVector below({79'999'999'999'999, 12, false, true});
  EXPECT_EQ(below.lean(kinematics, displacement({0, 0, 5}), direction(80, 33)).angle, AngleClass::near_90);
}

// "If a cheaper level answers, every dearer level agrees": with a limit that is a hair off a rational one the answer
// comes from doubles or double-double, with the rational one from whole numbers; away from ties they are the same.
TEST(Decisions, LevelsAgree) {
  std::mt19937_64 random(3);
  const CompensationVector rational(spec::decimal(30));
  const CompensationVector decimal({300'000'000'000'001, 13, false, true});
  int compared = 0;
  for (std::uint64_t i = 0; i < test::random_cases(20'000); ++i) {
    std::array<std::int64_t, 3> m{};
    std::array<std::int64_t, 3> v{};
    for (auto& component : m) component = static_cast<std::int64_t>(random() % 2001) - 1000;
    for (auto& component : v) component = static_cast<std::int64_t>(random() % 2001) - 1000;
    const Exact em{m[0], m[1], m[2]};
    const Exact ev{v[0], v[1], v[2]};
    if (dot(em, em) == 0 || dot(ev, ev) == 0) continue;
    const mpz_int d = dot(em, ev);
    const mpz_int all = dot(em, em) * dot(ev, ev);
    if (4 * d * d == 3 * all || 4 * d * d == all) continue;
    const Direction direction = whole_direction({v[0], v[1], v[2]});
    ASSERT_EQ(rational.lean(no_kinematics(), displacement(m), direction).angle,
              decimal.lean(no_kinematics(), displacement(m), direction).angle);
    ++compared;
  }
  EXPECT_GT(compared, test::random_cases(15'000));
}

}  // namespace
}  // namespace toolcomp::fast
