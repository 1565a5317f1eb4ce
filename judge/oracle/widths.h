// SPDX-License-Identifier: Apache-2.0
// Statistics of the widths that the policy granted, over many values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace toolcomp::judge {

// In micrometres. An angle, or a component of a unit vector, counts as its effect at a distance of one metre.
class Widths {
 public:
  // `known`: in a situation in which doubles hardly determine the value (README, widths).
  void add(double um, bool known = false);
  void add(const Widths& more);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double largest() const { return largest_; }
  // Share of the values that were granted more than a nanometre, and more than a micrometre.
  [[nodiscard]] double share_above_nm() const { return share(above_nm_); }
  [[nodiscard]] double share_above_um() const { return share(above_um_); }
  // The number of values that were granted more than a micrometre and not in a known situation.
  [[nodiscard]] std::uint64_t unexpected() const { return unexpected_; }
  // The width that this share of the values does not exceed, rounded up to a power of two; 0 <= share <= 1.
  [[nodiscard]] double quantile(double share) const;

 private:
  static constexpr int kLowest = -64;  // exponent of the first bin
  static constexpr std::size_t kBins = 192;
  [[nodiscard]] double share(std::uint64_t part) const {
    return count_ == 0 ? 0 : static_cast<double>(part) / static_cast<double>(count_);
  }

  std::array<std::uint32_t, kBins> bins_{};  // by powers of two; the first one also counts smaller values, and 0
  std::uint64_t count_ = 0;
  std::uint64_t above_nm_ = 0;
  std::uint64_t above_um_ = 0;
  std::uint64_t unexpected_ = 0;
  double largest_ = 0;
};

}  // namespace toolcomp::judge
