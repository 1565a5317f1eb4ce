// SPDX-License-Identifier: Apache-2.0
// Numbers of a program's page: exact numbers as short texts, doubles by their distance from the exact numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "model/basis/event.h"

namespace toolcomp::certify {

// The exact value to `digits` decimals, and a mark that says how exact this text is. view/numbers.js reads it:
//   "1.25"                 the value itself
//   "0.333333333333333=1/3"  a fraction, the decimals rounded
//   "0.142857142857143#71"   a fraction of so many characters, too long to be shown
//   "1.414213562373095~"   no fraction that is known, rounded: half a unit of the last decimal
//   "1.5?"                 decimals that could not be certified: the middle of an enclosure
std::string number_words(const model::Real& value, int digits);

// The number of steps from `value` to the nearer of the two doubles next to the exact value: 0 for either of these two,
// negative if `value` is below. std::nullopt if it is not finite or cannot be known.
std::optional<std::int64_t> ulps_off(double value, const model::Real& exact);

}  // namespace toolcomp::certify
