// SPDX-License-Identifier: Apache-2.0
// Tool directions of the fast engine against the closed forms of each machine, by hand,
// evaluated with MPFR, and their stated errors.
#include "fast/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "spec/language/setup_format.h"
#include "tests/effort.h"

namespace toolcomp::fast {
namespace {

using Big = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>>;
using Vector = std::array<Big, 3>;
// The direction for sine and cosine of the tool-side (t) and the work-piece-side axis (w).
using ClosedForm = std::function<Vector(const Big& st, const Big& ct, const Big& sw, const Big& cw)>;

std::string machine(const std::string& parameters) {
  return "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\",\"A\",\"B\",\"C\"]\n[parameters]\n" + parameters;
}

Big radians(const spec::Decimal& degrees) {
  Big value = degrees.digits;
  value /= boost::multiprecision::pow(Big(10), degrees.decimals);
  if (degrees.negative) value = -value;
  return value * boost::math::constants::pi<Big>() / 180;
}

// Compares at random angles; `t` and `w` are axis indices of X Y Z A B C.
void check(const std::string& parameters, std::size_t t, std::size_t w, const ClosedForm& form) {
  Kinematics kinematics(spec::read_setup_toml(machine(parameters), "setup"));
  ASSERT_TRUE(kinematics.defined());
  std::mt19937_64 random(7);
  for (std::uint64_t i = 0; i < test::random_cases(2000); ++i) {
    std::array<Count, spec::kMaxAxes> position;
    const auto angle = [&] {
      spec::Decimal value{random() % 720'000'000, static_cast<std::uint8_t>(6), random() % 2 == 0, true};
      if (random() % 4 == 0) value = {15 * (random() % 48), 0, random() % 2 == 0, true};
      return value;
    };
    const spec::Decimal tau = angle();
    const spec::Decimal omega = angle();
    position[t] = Count::of(tau);
    position[w] = Count::of(omega);
    Direction direction;
    kinematics.direct(position, direction);
    const Vector exact = form(sin(radians(tau)), cos(radians(tau)), sin(radians(omega)), cos(radians(omega)));
    const FineVector& fine = kinematics.refine(direction);
    for (std::size_t k = 0; k < 3; ++k) {
      const double unit = direction.unit[static_cast<Eigen::Index>(k)];
      // 1e-90: what MPFR itself rounds.
      ASSERT_LE(abs(exact[k] - Big(unit)).convert_to<double>(), direction.error + 1e-90) << parameters;
      ASSERT_LE(abs(exact[k] - Big(fine[k].hi) - Big(fine[k].lo)).convert_to<double>(), direction.refined_error());
      if ((direction.zero >> k & 1U) != 0) {
        ASSERT_LE(abs(exact[k]).convert_to<double>(), 1e-90);
      }
    }
    if (direction.is_whole) {
      ASSERT_EQ(direction.error, 0);
    }
  }
}

std::string type(int code, int first, int second, int axis1, int axis2, int sense1, int sense2) {
  const auto line = [](int number, int value) {
    return "\"" + std::to_string(number) + "\"=" + std::to_string(value) + "\n";
  };
  return line(19680, code) + line(19681, first) + line(19682, axis1) + line(19684, sense1) + line(19686, second) +
         line(19687, axis2) + line(19689, sense2);
}

constexpr int kA = 4, kB = 5, kC = 6;  // controlled axis numbers
constexpr std::size_t iA = 3, iB = 4, iC = 5;

TEST(Kinematics, OrthogonalMachines) {
  const ClosedForm b_c = [](auto& st, auto& ct, auto& sw, auto& cw) { return Vector{st * cw, st * sw, ct}; };
  const ClosedForm a_c = [](auto& st, auto& ct, auto& sw, auto& cw) { return Vector{st * sw, -st * cw, ct}; };
  const ClosedForm a_b = [](auto& st, auto& ct, auto& sw, auto& cw) { return Vector{sw * ct, -st, cw * ct}; };
  const ClosedForm b_a = [](auto& st, auto& ct, auto& sw, auto& cw) { return Vector{st, -sw * ct, cw * ct}; };
  check(type(2, kC, kB, 3, 2, 0, 0), iB, iC, b_c);   // C-B head
  check(type(12, kB, kC, 2, 3, 1, 1), iB, iC, b_c);  // B-C trunnion
  check(type(21, kB, kC, 2, 3, 0, 1), iB, iC, b_c);  // B head, C table
  check(type(2, kC, kA, 3, 1, 0, 0), iA, iC, a_c);   // C-A head
  check(type(12, kA, kC, 1, 3, 1, 1), iA, iC, a_c);  // A-C trunnion
  check(type(2, kB, kA, 2, 1, 0, 0), iA, iB, a_b);   // B-A head
  check(type(2, kA, kB, 1, 2, 0, 0), iB, iA, b_a);   // A-B head
  // A left-handed sense turns the other way.
  check(type(2, kC, kB, 3, 2, 0, 1), iB, iC,
        [](auto& st, auto& ct, auto& sw, auto& cw) { return Vector{-st * cw, -st * sw, ct}; });
}

TEST(Kinematics, NutatingAxis) {
  // u_t = (0,1,1)/sqrt 2: code 5 with 45 degrees.
  check(type(2, kC, kB, 3, 5, 0, 0) + "\"19688\"=45\n", iB, iC, [](auto& st, auto& ct, auto& sw, auto& cw) {
    const Big x = st / sqrt(Big(2));
    const Big y = (1 - ct) / 2;
    return Vector{x * cw - y * sw, x * sw + y * cw, (1 + ct) / 2};
  });
}

TEST(Kinematics, ReferenceDirection) {
  // 19697 = 1: the tool on X at zero; B about Y turns it to (cos, 0, -sin), C about Z then turns that.
  check(type(2, kC, kB, 3, 2, 0, 0) + "\"19697\"=1\n", iB, iC,
        [](auto& st, auto& ct, auto& sw, auto& cw) { return Vector{ct * cw, ct * sw, -st}; });
  // RA = 0, RB = 90: on linear axis 1 too.
  check(type(2, kC, kB, 3, 2, 0, 0) + "\"19699\"=90\n", iB, iC,
        [](auto& st, auto& ct, auto& sw, auto& cw) { return Vector{ct * cw, ct * sw, -st}; });
}

TEST(Kinematics, HypotheticalAxis) {
  // Table rotation with the first axis fixed at 30: V = R(C) (sin 30, 0, cos 30).
  check(
      "\"19680\"=12\n\"19681\"=0\n\"19682\"=2\n\"19684\"=1\n\"19685\"=30\n\"19696#0\"=1\n\"19686\"=6\n\"19687\"=3\n"
      "\"19689\"=1\n",
      iB, iC, [](auto&, auto&, auto& sw, auto& cw) { return Vector{cw / 2, sw / 2, sqrt(Big(3)) / 2}; });
}

TEST(Kinematics, OlderParameters) {
  // First group B (turns Z toward X), second group C (turns X toward Y).
  const std::string b_c = "\"19610\"=5\n\"19611\"=3\n\"19612\"=1\n\"19615\"=6\n\"19616\"=1\n\"19617\"=2\n";
  check(b_c, iB, iC, [](auto& st, auto& ct, auto& sw, auto& cw) { return Vector{st * cw, st * sw, ct}; });
  // Reference angles: B counts from 90, C from -90.
  check(b_c + "\"19620\"=90\n\"19621\"=-90\n", iB, iC,
        [](auto& st, auto& ct, auto& sw, auto& cw) { return Vector{ct * sw, -ct * cw, st}; });
  // RA = 30: v0 = (0, -1/2, sqrt 3 / 2), A alone about X (turns Y toward Z).
  check("\"19610\"=4\n\"19611\"=2\n\"19612\"=3\n\"19622\"=30\n", iA, iC, [](auto& st, auto& ct, auto&, auto&) {
    const Big c = sqrt(Big(3)) / 2;
    return Vector{Big(0), -ct / 2 - st * c, -st / 2 + ct * c};
  });
  // Inclined by 45 from linear axis 3 toward 1, axes X Y Z: (1,0,1)/sqrt 2; the tool on Z.
  check("\"19610\"=4\n\"19611\"=1\n\"19612\"=2\n\"19613\"=3\n\"19614\"=45\n", iA, iC,
        [](auto& st, auto& ct, auto&, auto&) {
          // e3 = p + q, p = (1,0,1)/2, q = (-1,0,1)/2, u x e3 = (0,-1,0)/sqrt 2
          return Vector{(1 - ct) / 2, -st / sqrt(Big(2)), (1 + ct) / 2};
        });
}

}  // namespace
}  // namespace toolcomp::fast
