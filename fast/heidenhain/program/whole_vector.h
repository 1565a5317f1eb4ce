// SPDX-License-Identifier: Apache-2.0
// A vector of a program as whole numbers of one unit: exact, as far as directions and their ratios go.
#pragma once

#include <array>
#include <cstdint>

#include "fast/arithmetic/double_double.h"
#include "fast/arithmetic/int128.h"
#include "fast/arithmetic/wide.h"
#include "fast/heidenhain/program/vector.h"
#include "spec/language/decimal.h"

namespace toolcomp::fast::klartext {

using FineVector3 = Vector3<DoubleDouble>;
using WideVector3 = Vector3<Wide>;

// Components are below 10 (E_VEC_RANGE). Narrow: of at most 8 decimals, in units of 1e-8, so that products of two fit
// into 64 bits. Otherwise in units of 1e-18.
struct WholeVector {
  static constexpr int kPlaces = 8;
  static constexpr std::int64_t kOne = 100'000'000;
  static constexpr int kWidePlaces = 18;

  bool narrow = true;
  std::array<std::int64_t, 3> small{0, 0, kOne};
  std::array<Int128, 3> wide{};  // not narrow

  void set(const std::array<spec::Decimal, 3>& v) {
    // Not above it: none of the three is.
    if ((v[0].decimals | v[1].decimals | v[2].decimals) > kPlaces) [[unlikely]] {
      set_any(v);
      return;
    }
    set_narrow(v);
  }
  void set_axis(std::size_t axis, std::int64_t sign = 1) {
    narrow = true;
    small = {0, 0, 0};
    small[axis] = sign * kOne;
  }
  // Only what counts.
  void copy(const WholeVector& other) {
    narrow = other.narrow;
    small = other.small;
    if (!narrow) [[unlikely]]
      wide = other.wide;
  }

  // The components as doubles, those of a narrow vector exact.
  [[nodiscard]] Vector nearest() const {
    if (narrow) [[likely]]
      return {static_cast<double>(small[0]), static_cast<double>(small[1]), static_cast<double>(small[2])};
    return {static_cast<double>(wide[0]), static_cast<double>(wide[1]), static_cast<double>(wide[2])};
  }
  // Within 2^-106, those of a narrow vector exact.
  [[nodiscard]] FineVector3 fine() const {
    if (narrow) {
      const Vector v = nearest();
      return {{v.x(), 0}, {v.y(), 0}, {v.z, 0}};
    }
    return {to_double_double(wide[0]), to_double_double(wide[1]), to_double_double(wide[2])};
  }
  // In units of 1e-18 whatever it is, below 2^64.
  [[nodiscard]] WideVector3 exact() const {
    constexpr Int128 kFactor = 10'000'000'000;
    if (narrow) return {Wide(small[0] * kFactor), Wide(small[1] * kFactor), Wide(small[2] * kFactor)};
    return {Wide(wide[0]), Wide(wide[1]), Wide(wide[2])};
  }

 private:
  // What the last digit of a component is worth: by its decimals, from the 16th on of negative ones. Signs come in no
  // order a processor could foresee: no branch.
  static constexpr std::array<std::int64_t, 32> kWorth = [] {
    std::array<std::int64_t, 32> worth{};
    std::int64_t power = kOne;
    for (std::size_t decimals = 0; decimals <= kPlaces; ++decimals, power /= 10) {
      worth[decimals] = power;
      worth[16 + decimals] = -power;
    }
    return worth;
  }();
  static std::int64_t scaled(const spec::Decimal& value) {
    return static_cast<std::int64_t>(value.digits) * kWorth[value.decimals + 16U * value.negative];
  }
  void set_narrow(const std::array<spec::Decimal, 3>& v) {
    narrow = true;
    small[0] = scaled(v[0]);
    small[1] = scaled(v[1]);
    small[2] = scaled(v[2]);
  }
  void set_any(const std::array<spec::Decimal, 3>& v);
};

// v / |v|, each component within two ulps of 1.
struct UnitVector {
  Vector unit;
  double scale = 0;        // 1 / |v| in the units of v
  bool normalized = true;  // |v·v − 1| <= 2e-4, exactly (heidenhain.face.not-normalized)
};
[[nodiscard]] UnitVector unit_of_any(const WholeVector& v);
// Of a narrow vector: how far v·v may be from that of a normalized one, in the units of v.
inline constexpr std::int64_t kNormalizedSquare = WholeVector::kOne * WholeVector::kOne;
inline constexpr std::int64_t kMostExcess = kNormalizedSquare / 5000;
// 1 / |v| of one that is normalized, by its excess x over them: (1 + x)^(-1/2) by its series up to x^4; the next term
// is below 2^-63.
[[gnu::always_inline]] inline double inverse_length(double x) {
  constexpr double kScale = 1.0 / static_cast<double>(WholeVector::kOne);
  constexpr double kX = kScale * kScale;
  const double square = x * x;
  return (kScale - x * (kScale * kX / 2)) +
         square * ((kScale * kX * kX * 3 / 8 - x * (kScale * kX * kX * kX * 5 / 16)) +
                   square * (kScale * kX * kX * kX * kX * 35 / 128));
}
[[nodiscard]] inline UnitVector unit_of(const WholeVector& v) {
  if (!v.narrow) [[unlikely]]
    return unit_of_any(v);
  const std::int64_t excess =
      v.small[0] * v.small[0] + v.small[1] * v.small[1] + v.small[2] * v.small[2] - kNormalizedSquare;
  if (excess > kMostExcess || excess < -kMostExcess) [[unlikely]]
    return unit_of_any(v);
  const auto x = static_cast<double>(excess);
  UnitVector u;
  u.scale = inverse_length(x);
  u.unit = v.nearest() * u.scale;
  u.normalized = true;
  return u;
}

}  // namespace toolcomp::fast::klartext
