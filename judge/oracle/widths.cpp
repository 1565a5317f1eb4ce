// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/widths.h"

#include <algorithm>
#include <cmath>

namespace toolcomp::judge {

void Widths::add(double um, bool known) {
  constexpr double nanometre = 1.0 / 1000;
  ++count_;
  if (um > nanometre) ++above_nm_;
  if (um > 1) ++above_um_;
  if (um > 1 && !known) ++unexpected_;
  largest_ = std::fmax(largest_, um);
  int exponent = kLowest;
  if (um > 0) std::frexp(std::fmin(um, 0x1p200), &exponent);
  const int bin = std::clamp(exponent - kLowest, 0, static_cast<int>(kBins) - 1);
  ++bins_.at(static_cast<std::size_t>(bin));
}

void Widths::add(const Widths& more) {
  for (std::size_t i = 0; i < kBins; ++i) bins_.at(i) += more.bins_.at(i);
  count_ += more.count_;
  above_nm_ += more.above_nm_;
  above_um_ += more.above_um_;
  unexpected_ += more.unexpected_;
  largest_ = std::fmax(largest_, more.largest_);
}

double Widths::quantile(double share) const {
  const double wanted = share * static_cast<double>(count_);
  double below = 0;
  for (std::size_t i = 0; i < kBins; ++i) {
    below += bins_.at(i);
    if (below >= wanted) return std::fmin(std::ldexp(1.0, static_cast<int>(i) + kLowest), largest_);
  }
  return largest_;
}

}  // namespace toolcomp::judge
