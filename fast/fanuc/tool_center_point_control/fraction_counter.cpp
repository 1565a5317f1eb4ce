// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_center_point_control/fraction_counter.h"

namespace toolcomp::fast {

FractionCounter::FractionCounter(std::uint32_t n) : n_(n) {
  std::uint32_t rest = n;
  for (std::uint32_t prime = 2; rest > 1; ++prime) {
    if (prime > rest / prime) prime = rest;  // no smaller divisor is left
    for (std::uint32_t value = prime; rest % prime == 0; value *= prime) {
      power_[size_++] = {prime, value, value};
      rest /= prime;
    }
  }
}

}  // namespace toolcomp::fast
