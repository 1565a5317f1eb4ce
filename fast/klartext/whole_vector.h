// A vector of a program as whole numbers of one unit: exact, as far as directions and their ratios go.
#pragma once

#include <array>
#include <cstdint>

#include "fast/arithmetic/double_double.h"
#include "fast/arithmetic/int128.h"
#include "fast/arithmetic/wide.h"
#include "fast/klartext/vector.h"
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
    const unsigned places = v[0].decimals | v[1].decimals | v[2].decimals;
    if (places > kPower.size() - 1 || !fits(v[0]) || !fits(v[1]) || !fits(v[2])) [[unlikely]] {
      set_wide(v);
      return;
    }
    narrow = true;
    small = {scaled(v[0]), scaled(v[1]), scaled(v[2])};
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
  // By decimals; beyond kPlaces nothing is narrow.
  static constexpr std::array<std::int64_t, 16> kPower{100'000'000, 10'000'000, 1'000'000, 100'000, 10'000,
                                                       1'000,       100,        10,        1};
  static constexpr std::array<std::uint64_t, 16> kBelow{10,        100,        1'000,       10'000,       100'000,
                                                        1'000'000, 10'000'000, 100'000'000, 1'000'000'000};
  static bool fits(const spec::Decimal& value) { return value.digits < kBelow[value.decimals & 15U]; }
  static std::int64_t scaled(const spec::Decimal& value) {
    const std::int64_t magnitude = static_cast<std::int64_t>(value.digits) * kPower[value.decimals & 15U];
    const auto sign = -static_cast<std::int64_t>(value.negative);
    return (magnitude ^ sign) - sign;
  }
  void set_wide(const std::array<spec::Decimal, 3>& v) {
    narrow = false;
    for (std::size_t i = 0; i < 3; ++i) {
      auto magnitude = static_cast<Int128>(v[i].digits);
      for (int place = v[i].decimals; place < kWidePlaces; ++place) magnitude *= 10;
      wide[i] = v[i].negative ? -magnitude : magnitude;
    }
  }
};

// |v·v − 1| > 2e-4, exactly (heidenhain.face.not-normalized).
[[nodiscard]] bool not_normalized_wide(const WholeVector& v);
[[nodiscard]] inline bool not_normalized(const WholeVector& v) {
  if (!v.narrow) [[unlikely]]
    return not_normalized_wide(v);
  constexpr std::int64_t kSquare = WholeVector::kOne * WholeVector::kOne;
  constexpr std::int64_t kLimit = kSquare / 5000;
  const std::int64_t excess = v.small[0] * v.small[0] + v.small[1] * v.small[1] + v.small[2] * v.small[2] - kSquare;
  return excess > kLimit || excess < -kLimit;
}

}  // namespace toolcomp::fast::klartext
