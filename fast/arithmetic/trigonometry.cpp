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

}  // namespace

SineCosine<double> sine_cosine(std::int64_t small) { return of_small<std::uint64_t>(static_cast<double>(small)); }

SineCosine<Pair> sine_cosine(std::int64_t first, std::int64_t second) {
  using Bits [[gnu::vector_size(16)]] = std::uint64_t;
  return of_small<Bits>(Pair{static_cast<double>(first), static_cast<double>(second)});
}

SineCosine<double> sine_cosine(const Count& degrees) {
  if (degrees.is_small()) return sine_cosine(degrees.small());
  const auto [quarter, remainder] = reduce(degrees.units(), kQuarter);
  constexpr double kRadiansPerUnit = 0x1.4c4780a1fb529p-73;  // pi / (180 * 127e18)
  const auto r = static_cast<double>(remainder);
  return turned(near(r * kRadiansPerUnit, 0.0), std::uint64_t{quarter});
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

}  // namespace toolcomp::fast
