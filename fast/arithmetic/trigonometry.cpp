// SPDX-License-Identifier: Apache-2.0
#include "fast/arithmetic/trigonometry.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace toolcomp::fast {
namespace {

// degrees = 90 * quarter + remainder, |remainder| <= 45, all exact.
struct Reduced {
  unsigned quarter;  // modulo 4
  Int128 remainder;
};

constexpr Reduced reduce(Int128 angle, Int128 quarter_turn) {
  Int128 quarter = 0;
  const Int128 half = quarter_turn / 2;
  if (angle > half || angle < -half) {
    const Int128 shifted = angle + half;
    quarter = shifted / quarter_turn;
    if (shifted < 0 && quarter * quarter_turn != shifted) --quarter;
  }
  return {static_cast<unsigned>(static_cast<int>(quarter % 4) + 4) % 4U, angle - quarter * quarter_turn};
}

constexpr SineCosine<DoubleDouble> fine_turned(const SineCosine<DoubleDouble>& value, unsigned quarter) {
  switch (quarter) {
    case 1:
      return {value.cosine, -value.sine};
    case 2:
      return {-value.sine, -value.cosine};
    case 3:
      return {-value.cosine, value.sine};
    default:
      return value;
  }
}

constexpr Int128 kQuarter = 90 * Count::kRestPerOne;

// sin and cos of hi + lo, |hi| <= pi/4 (1 + 2^-20), |lo| <= ulp(hi): the polynomials of fdlibm (Sun, 1993), within
// 2^-58 of sin x / x and of cos x; the rest enters to first order.
template <class Real>
[[gnu::always_inline]] inline SineCosine<Real> near(Real hi, Real lo) {
  constexpr double s1 = -0x1.5555555555549p-3;
  constexpr double s2 = 0x1.111111110f8a6p-7;
  constexpr double s3 = -0x1.a01a019c161d5p-13;
  constexpr double s4 = 0x1.71de357b1fe7dp-19;
  constexpr double s5 = -0x1.ae5e68a2b9cebp-26;
  constexpr double s6 = 0x1.5d93a5acfd57cp-33;
  constexpr double c1 = 0x1.555555555554cp-5;
  constexpr double c2 = -0x1.6c16c16c15177p-10;
  constexpr double c3 = 0x1.a01a019cb1590p-16;
  constexpr double c4 = -0x1.27e4f809c52adp-22;
  constexpr double c5 = 0x1.1ee9ebdb4b1c4p-29;
  constexpr double c6 = -0x1.8fae9be8838d4p-37;
  const Real z = hi * hi;
  const Real w = z * z;
  const Real v = z * hi;
  const Real s = (s2 + z * s3) + w * ((s4 + z * s5) + w * s6);
  const Real sine = hi - ((z * (0.5 * lo - v * s) - lo) - v * s1);
  const Real c = z * ((c1 + z * c2) + w * ((c3 + z * c4) + w * (c5 + z * c6)));
  const Real half = 0.5 * z;
  const Real one = 1 - half;
  const Real cosine = one + (((1 - one) - half) + (z * c - hi * lo));
  return {sine, cosine};
}

// The same turned by quarters, without a branch: angles follow no pattern.
template <class Bits, class Real>
[[gnu::always_inline]] inline SineCosine<Real> turned(const SineCosine<Real>& value, Bits quarter) {
  const auto sine = std::bit_cast<Bits>(value.sine);
  const auto cosine = std::bit_cast<Bits>(value.cosine);
  const Bits swap = (sine ^ cosine) & -(quarter & 1);
  return {std::bit_cast<Real>((sine ^ swap) ^ (quarter >> 1 & 1) << 63),
          std::bit_cast<Real>((cosine ^ swap) ^ ((quarter + 1) >> 1 & 1) << 63)};
}

using BitPair [[gnu::vector_size(16)]] = std::uint64_t;

// Of whole 10^-6 degrees.
template <class Bits, class Real>
[[gnu::always_inline]] inline SineCosine<Real> of_small(Real angle) {
  // The quarter nearest to the angle, in the low bits of `shifted`; a rounding just beside a tie may take the other
  // one, which leaves a remainder above 45 by one unit at most. All products and differences are exact.
  constexpr auto kQuarterUnits = static_cast<double>(90 * Count::kSmallPerOne);
  constexpr double kShift = 0x1.8p52;
  const Real shifted = angle * (1 / kQuarterUnits) + kShift;
  const Real r = angle - (shifted - kShift) * kQuarterUnits;
  // pi / 180e6 in two parts: the first has 27 bits and |r| <= 45e6 + 1 has 26, so their product is exact.
  constexpr double kRadiansHigh = 0x1.2bd8644000000p-26;
  constexpr double kRadiansLow = 0x1.60df76ae5cc06p-53;
  const Real high = r * kRadiansHigh;
  const Real low = r * kRadiansLow;
  const Real hi = high + low;
  return turned(near(hi, low - (hi - high)), std::bit_cast<Bits>(shifted));
}

// Of degrees, |degrees| < 2^36.
template <class Bits, class Real>
[[gnu::always_inline]] inline SineCosine<Real> of_degrees(Real degrees) {
  // 90 q is whole and the difference a multiple of ulp(degrees) below 2^53 of them: both are exact.
  constexpr double kShift = 0x1.8p52;
  const Real shifted = degrees * (1.0 / 90) + kShift;
  const Real r = degrees - (shifted - kShift) * 90.0;
  // pi / 180 in two parts, the first of 25 bits, and r in two of 26: products with the first are exact.
  constexpr double kRadiansHigh = 0x1.1df46ap-6;
  constexpr double kRadiansLow = 0x1.294e9c8ae0ec6p-33;
  constexpr double kSplit = 134217729.0;  // 2^27 + 1
  const Real c = kSplit * r;
  const Real upper = c - (c - r);
  const Real high = upper * kRadiansHigh;
  const Real low = (r - upper) * kRadiansHigh + r * kRadiansLow;
  const Real hi = high + low;
  return turned(near(hi, low - (hi - high)), std::bit_cast<Bits>(shifted));
}

// 1 / n! as double-doubles, n = 2 … 16, and as doubles above, where the terms are below 2^-53 of the sum.
constexpr std::array<DoubleDouble, 17> kInverseFactorial{{
    {1, 0},
    {1, 0},
    {0x1.0000000000000p-1, 0},
    {0x1.5555555555555p-3, 0x1.5555555555555p-57},
    {0x1.5555555555555p-5, 0x1.5555555555555p-59},
    {0x1.1111111111111p-7, 0x1.1111111111111p-63},
    {0x1.6c16c16c16c17p-10, -0x1.f49f49f49f49fp-65},
    {0x1.a01a01a01a01ap-13, 0x1.a01a01a01a01ap-73},
    {0x1.a01a01a01a01ap-16, 0x1.a01a01a01a01ap-76},
    {0x1.71de3a556c734p-19, -0x1.c154f8ddc6c00p-73},
    {0x1.27e4fb7789f5cp-22, 0x1.cbbc05b4fa99ap-76},
    {0x1.ae64567f544e4p-26, -0x1.c062e06d1f209p-80},
    {0x1.1eed8eff8d898p-29, -0x1.2aec959e14c06p-83},
    {0x1.6124613a86d09p-33, 0x1.f28e0cc748ebep-87},
    {0x1.93974a8c07c9dp-37, 0x1.05d6f8a2efd1fp-92},
    {0x1.ae7f3e733b81fp-41, 0x1.1d8656b0ee8cbp-97},
    {0x1.ae7f3e733b81fp-45, 0x1.1d8656b0ee8cbp-101},
}};
constexpr std::array<double, 6> kOddTail{0x1.952c77030ad4ap-49, 0x1.2f49b46814157p-57, 0x1.71b8ef6dcf572p-66,
                                         0x1.761b41316381ap-75, 0x1.3f3ccdd165fa9p-84, 0x1.d1ab1c2dccea3p-94};
constexpr std::array<double, 6> kEvenTail{0x1.6827863b97d97p-53, 0x1.e542ba4020225p-62, 0x1.0ce396db7f853p-70,
                                          0x1.f2cf01972f578p-80, 0x1.88e85fc6a4e5ap-89, 0x1.0a18a2635085dp-98};

// sum (-1)^k y^k / (first + 2k)! by Horner, the tail in double.
DoubleDouble series(const DoubleDouble& y, std::size_t first, const std::array<double, 6>& tail) {
  double small = tail[5];
  for (std::size_t i = 5; i-- > 0;) small = tail[i] - y.hi * small;
  DoubleDouble sum{small, 0};
  for (std::size_t n = kInverseFactorial.size() + 1 - first;;) {
    n -= 2;
    sum = kInverseFactorial[n] - y * sum;
    if (n == first) return sum;
  }
}

// Degrees: 180 / pi, and a third, a fifth, a seventh, a ninth of it.
constexpr double kDegrees = 0x1.ca5dc1a63c1f8p+5;
constexpr std::array<double, 4> kDegreesPerOdd{0x1.3193d66ed2bfap+4, 0x1.6eb167b830193p+3, 0x1.05ec6ea8225b2p+3,
                                               0x1.976fc893c3aa3p+2};
// The angles of slopes 0, 1/32 ... 1 in degrees.
constexpr std::array<DoubleDouble, 33> kArctangent{{
    {0x0p+0, 0x0p+0},
    {0x1.ca3794e52e2a8p+0, -0x1.b18cf3a9c5ffp-54},
    {0x1.c9c55326164cfp+1, -0x1.88708ff33aabap-55},
    {0x1.56c5d6668a4b3p+2, -0x1.fed98a21ac307p-53},
    {0x1.c80044927fe83p+2, -0x1.2a9346eb4b87bp-53},
    {0x1.1c2e5c194d0bp+3, 0x1.6109e7ac86fa3p-51},
    {0x1.53d4374d3c2a3p+3, 0x1.c5b7fa992d71fp-52},
    {0x1.8ad9cd905cd23p+3, -0x1.aa32691274d02p-51},
    {0x1.c128e80fae02ep+3, -0x1.0fc10e257c651p-53},
    {0x1.f6ad293d8a981p+3, 0x1.8ffa0b91f5008p-51},
    {0x1.15aa15bcab87ep+4, 0x1.2f23fe5f78d35p-52},
    {0x1.2f86ca5693b95p+4, -0x1.921d12e9bd286p-51},
    {0x1.48e58fac13547p+4, 0x1.bdef92fae944fp-51},
    {0x1.61c04ce8103cap+4, 0x1.cb0f408701ac7p-51},
    {0x1.7a11ee6220071p+4, -0x1.63c539bb8dcc2p-55},
    {0x1.91d65d1b06e47p+4, 0x1.bba81c7320b23p-51},
    {0x1.a90a731a61dc4p+4, -0x1.80b27b26e182bp-51},
    {0x1.bfabed561cab5p+4, -0x1.4f228abff8141p-50},
    {0x1.d5b95bc76511p+4, 0x1.6f006acd20fc1p-52},
    {0x1.eb32104600588p+4, -0x1.cdc8f191d54cdp-50},
    {0x1.000b0659f5545p+5, 0x1.0e62435c62f2fp-49},
    {0x1.0a32f878c76f4p+5, 0x1.ef68cf8c9d5bbp-49},
    {0x1.141174800a666p+5, 0x1.e004defca5108p-50},
    {0x1.1da74dd22fa17p+5, -0x1.38573f69caa41p-51},
    {0x1.26f58ce59e23cp+5, 0x1.80b27b26e182bp-50},
    {0x1.2ffd676f5018p+5, 0x1.1391e62807a1p-50},
    {0x1.38c03916765b8p+5, 0x1.50a2d34ee705p-49},
    {0x1.413f7cbb39bbep+5, 0x1.cb329a1df12d3p-49},
    {0x1.497cc65551cf8p+5, -0x1.2dd089737cc28p-49},
    {0x1.5179bd6aca3a8p+5, 0x1.67cc66a04f573p-49},
    {0x1.5938181bde651p+5, 0x1.ea28ab192aaf3p-51},
    {0x1.60b996be388b1p+5, -0x1.c843a99069d6dp-51},
    {0x1.68p+5, 0x0p+0},
}};

// The angle of the slope in the low bits.
template <class Real>
struct Tabled {
  Real angle, rest;
};
[[gnu::always_inline]] inline Tabled<double> tabled(std::uint64_t slope) {
  const DoubleDouble& angle = kArctangent[slope % 64];
  return {angle.hi, angle.lo};
}
[[gnu::always_inline]] inline Tabled<DoublePair> tabled(BitPair slope) {
  const Tabled<double> a = tabled(slope[0]);
  const Tabled<double> b = tabled(slope[1]);
  return {DoublePair{a.angle, b.angle}, DoublePair{a.rest, b.rest}};
}

template <class Bits, class Real>
[[gnu::always_inline]] inline Real angle_of(Real sine, Real cosine) {
  const auto magnitude = [](Real value) { return std::bit_cast<Real>(std::bit_cast<Bits>(value) << 1 >> 1); };
  const Real a = magnitude(sine);
  const Real b = magnitude(cosine);
  const Real one = Real{} + 1.0;
  const Real longer = a > b ? a : b;
  const Real y = a > b ? b : a;
  const Real x = longer == 0.0 ? one : longer;
  // atan(y / x) = atan(c) + atan(r), c the nearest of 0, 1/32 ... 1, so |r| <= 1/64.
  constexpr double kShift = 0x1.8p52;
  const Real shifted = y / x * 32.0 + kShift;
  const auto [angle, angle_rest] = tabled(std::bit_cast<Bits>(shifted));
  const Real c = (shifted - kShift) * (1.0 / 32);
  const Real r = (y - c * x) / (x + c * y);
  // r - r^3/3 + ... in degrees: the next term is below 2^-60 of the first. Errors, u = 2^-53: r 3u of c or of itself,
  // the product and the constant 1u, the sum u, the difference from 90 or 180 u.
  const Real z = r * r;
  const Real rest = z * (kDegreesPerOdd[0] - z * (kDegreesPerOdd[1] - z * (kDegreesPerOdd[2] - z * kDegreesPerOdd[3])));
  const Real first = angle + (angle_rest + (r * kDegrees - r * rest));
  const Real upper = a > b ? 90.0 - first : first;
  const Real half = cosine < 0.0 ? 180.0 - upper : upper;
  return sine < 0.0 ? -half : half;
}

}  // namespace

SineCosine<double> sine_cosine(std::int64_t small) { return of_small<std::uint64_t>(static_cast<double>(small)); }

SineCosine<DoublePair> sine_cosine(std::int64_t first, std::int64_t second) {
  return of_small<BitPair>(DoublePair{static_cast<double>(first), static_cast<double>(second)});
}

SineCosine<double> sine_cosine(const Count& degrees) {
  if (degrees.is_small()) return sine_cosine(degrees.small());
  const auto [quarter, remainder] = reduce(degrees.units(), kQuarter);
  constexpr double kRadiansPerUnit = 0x1.4c4780a1fb529p-73;  // pi / (180 * 127e18)
  const auto r = static_cast<double>(remainder);
  return turned(near(r * kRadiansPerUnit, 0.0), std::uint64_t{quarter});
}

std::array<SineCosine<double>, 2> sine_cosine(const Count& first, const Count& second) {
  if (first.is_small() && second.is_small()) [[likely]]
    return apart(sine_cosine(first.small(), second.small()));
  return {sine_cosine(first), sine_cosine(second)};
}

SineCosine<DoubleDouble> fine_sine_cosine(const Count& degrees) {
  const auto [quarter, remainder] = reduce(degrees.units(), kQuarter);
  constexpr DoubleDouble kRadiansPerUnit{0x1.4c4780a1fb529p-73, 0x1.51bc475ac6966p-130};
  const auto hi = static_cast<double>(remainder);
  const auto lo = static_cast<double>(remainder - static_cast<Int128>(hi));
  const DoubleDouble x = quick_two_sum(hi, lo) * kRadiansPerUnit;
  const DoubleDouble y = x * x;
  // sin x = x (1 - y/3! + y^2/5! - …), cos x = 1 - y/2! + …: eight or nine double-double steps and six double ones.
  return fine_turned(SineCosine<DoubleDouble>{x * series(y, 1, kOddTail), series(y, 0, kEvenTail)}, quarter);
}

SineCosine<double> sine_cosine(double degrees) { return of_degrees<std::uint64_t>(degrees); }
SineCosine<DoublePair> sine_cosine(DoublePair degrees) { return of_degrees<BitPair>(degrees); }

double arctangent(double sine, double cosine) { return angle_of<std::uint64_t>(sine, cosine); }
DoublePair arctangent(DoublePair sine, DoublePair cosine) { return angle_of<BitPair>(sine, cosine); }

Count fine_arctangent(const DoubleDouble& sine, const DoubleDouble& cosine) {
  // One Newton step from the double: the rest r is below 2^-50, so the sine of it is r, less r^3 / 6 below 2^-150.
  const double first = arctangent(sine.hi, cosine.hi);
  if (sine.hi == 0 || cosine.hi == 0) return Count::of_units(static_cast<Int128>(first) * Count::kRestPerOne);
  // In (-180, 180] with 127 10^18 units a degree: below 2^75, of which the double holds the first 53 bits.
  const auto units = static_cast<Int128>(first * static_cast<double>(Count::kRestPerOne));
  const auto at = fine_sine_cosine(Count::of_units(units));
  const DoubleDouble across = sine * at.cosine - cosine * at.sine;
  const DoubleDouble along = cosine * at.cosine + sine * at.sine;
  constexpr double kUnitsPerRadian = 57.295779513082320877 * static_cast<double>(Count::kRestPerOne);
  // The rest is below 2^25 units.
  return Count::of_units(units + static_cast<Int128>(std::nearbyint(across.hi / along.hi * kUnitsPerRadian)));
}

}  // namespace toolcomp::fast
