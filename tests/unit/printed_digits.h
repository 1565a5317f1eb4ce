// SPDX-License-Identifier: Apache-2.0
// Numbers as the worked examples have them.
#pragma once

#include <string>

#include "model/exact/real.h"

namespace toolcomp::test {

// 15 significant digits, trailing zeros removed.
inline std::string printed_digits(const exact::Real& x, int significant = 15) {
  const std::string value = x.decimal(significant);
  const std::size_t point = value.find('.');
  const std::size_t first = value.find_first_of("123456789");
  if (point == std::string::npos || first == std::string::npos) return value;
  const auto before = static_cast<int>(point) - static_cast<int>(first);  // digits, or less the zeros behind the point
  return x.decimal(significant - (before > 0 ? before : before + 1));
}

}  // namespace toolcomp::test
