// SPDX-License-Identifier: Apache-2.0
#include "fast/arrays/words.h"

#include <cmath>

#include "fast/arithmetic/trigonometry.h"

namespace toolcomp::fast {
namespace {

constexpr std::array<double, 10> kPower{1, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

struct Scale {
  [[gnu::always_inline]] static std::int64_t run(const double* value, std::size_t size, double power, double worth,
                                                 double most, double* whole) {
    std::int64_t any = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const double word = nearest_whole(value[i] * power) * worth + 0.0;  // never -0
      whole[i] = word;
      any |= std::abs(word) <= most ? 0 : 1;
    }
    return any;
  }
};

struct Within {
  [[gnu::always_inline]] static std::int64_t run(const double* value, std::size_t size, double most) {
    std::int64_t any = 0;
    for (std::size_t i = 0; i < size; ++i) any |= std::abs(value[i]) <= most ? 0 : 1;
    return any;
  }
};

struct NearZero {
  [[gnu::always_inline]] static std::int64_t run(const double* x, const double* y, const double* z, std::size_t size,
                                                 double most) {
    std::int64_t any = 0;
    for (std::size_t i = 0; i < size; ++i) any |= std::abs(x[i]) + std::abs(y[i]) + std::abs(z[i]) <= most ? 1 : 0;
    return any;
  }
};

}  // namespace

double most_component(unsigned decimals) { return 10 - 1 / kPower[decimals]; }

std::size_t find_zero_vector(Instructions by, const std::array<const double*, 3>& component, std::size_t size,
                             unsigned decimals) {
  const auto& [x, y, z] = component;
  if (run_by<NearZero>(by, x, y, z, size, 2 / kPower[decimals]) == 0) return size;
  std::size_t i = 0;
  while (i < size &&
         !(word_of(x[i], decimals).is_zero() && word_of(y[i], decimals).is_zero() && word_of(z[i], decimals).is_zero()))
    ++i;
  return i;
}

bool are_within(Instructions by, const double* value, std::size_t size, double most) {
  return run_by<Within>(by, value, size, most) == 0;
}

bool scale_words(Instructions by, const double* value, std::size_t size, unsigned decimals, unsigned places,
                 double most, double* whole) {
  return run_by<Scale>(by, value, size, kPower[decimals], kPower[places - decimals], most, whole) == 0;
}

spec::Decimal word_of(double value, unsigned decimals) {
  const double rounded = std::nearbyint(value * kPower[decimals]);
  spec::Decimal word;
  word.digits = static_cast<std::uint64_t>(std::abs(rounded));
  word.decimals = static_cast<std::uint8_t>(decimals);
  word.negative = rounded < 0;
  word.point = true;
  return word;
}

}  // namespace toolcomp::fast
