// SPDX-License-Identifier: Apache-2.0
// Numbers of a program's page: exact ones as short texts, doubles by their distance from them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "model/basis/event.h"

namespace toolcomp::certify {

// The exact value to `digits` decimals, and what it is besides, which view/numbers.js reads:
//   "1.25"                 the value itself
//   "0.333333333333333=1/3"  a fraction, the decimals rounded
//   "0.142857142857143#71"   a fraction of so many characters, too long to be shown
//   "1.414213562373095~"   no fraction that is known, rounded: half a unit of the last decimal
//   "1.5?"                 decimals that could not be certified: the middle of an enclosure
std::string number_words(const model::Real& value, int digits);

// How many doubles lie between `value` and the nearer of the two next to the exact value: 0 for either of them, below
// it negative. Nothing where it is not finite or cannot be known.
std::optional<std::int64_t> ulps_off(double value, const model::Real& exact);

}  // namespace toolcomp::certify
