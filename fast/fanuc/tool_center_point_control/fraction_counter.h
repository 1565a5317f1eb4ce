// SPDX-License-Identifier: Apache-2.0
// The fractions 1/n, 2/n ... (n - 1)/n in lowest terms, without a division for each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace toolcomp::fast {

class FractionCounter {
 public:
  explicit FractionCounter(std::uint32_t n);

  // Before 1/n.
  void restart() {
    k_ = 0;
    for (std::size_t i = 0; i < size_; ++i) power_[i].left = power_[i].value;
  }
  // The next one.
  void advance() {
    ++k_;
    common_ = 1;
    for (std::size_t i = 0; i < size_; ++i) {
      if (--power_[i].left != 0) continue;
      power_[i].left = power_[i].value;
      common_ *= power_[i].prime;
    }
  }
  [[nodiscard]] std::uint32_t numerator() const { return common_ == 1 ? k_ : k_ / common_; }
  [[nodiscard]] std::uint32_t denominator() const { return common_ == 1 ? n_ : n_ / common_; }

 private:
  // The powers of primes p^j that divide n: k and n have p once in common for each that divides k.
  struct Power {
    std::uint32_t prime;
    std::uint32_t value;
    std::uint32_t left;  // until it divides k again
  };
  std::uint32_t n_;
  std::uint32_t k_ = 0;
  std::uint32_t common_ = 1;       // gcd of k and n
  std::array<Power, 32> power_{};  // n < 2^32 has fewer
  std::size_t size_ = 0;
};

}  // namespace toolcomp::fast
