// SPDX-License-Identifier: Apache-2.0
// Shorthand for generators over a choice source.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string_view>

#include "fuzz/gen/generator.h"

namespace toolcomp::fuzz {

class Choices {
 public:
  explicit Choices(ChoiceSource& source) : source_(source) {}

  // In [0, n).
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(source_.below(n)); }
  // In [low, high], both included.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(source_.below(static_cast<std::uint64_t>(high - low) + 1));
  }
  // True in `percent` of 100.
  bool chance(std::uint64_t percent) { return source_.below(100) < percent; }
  template <class T>
  T one_of(std::initializer_list<T> values) {
    return *(values.begin() + below(values.size()));
  }
  template <class T, std::size_t N>
  const T& one_of(const T (&values)[N]) {
    return values[below(N)];
  }
  // An index, with the weight given for it.
  std::size_t weighted(std::span<const int> weights) {
    std::uint64_t total = 0;
    for (const int w : weights) total += static_cast<std::uint64_t>(w);
    std::uint64_t at = source_.below(total);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (at < static_cast<std::uint64_t>(weights[i])) return i;
      at -= static_cast<std::uint64_t>(weights[i]);
    }
    return 0;
  }
  std::size_t weighted(std::initializer_list<int> weights) {
    return weighted(std::span(weights.begin(), weights.size()));
  }

  ChoiceSource& source() { return source_; }

 private:
  ChoiceSource& source_;
};

}  // namespace toolcomp::fuzz
