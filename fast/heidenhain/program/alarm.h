// SPDX-License-Identifier: Apache-2.0
// Alarms and warnings of Heidenhain 3D compensation. Names and texts of warnings are ours.
#pragma once

#include <array>
#include <cstdint>

#include "fast/basis/alarm.h"

namespace toolcomp::fast::klartext {

using fast::Alarm;
using fast::AlarmCause;

// Warnings as bits, in the order in which a block gives them (heidenhain.face.order-of-warnings).
enum Warning : std::uint8_t {
  kDigits = 1U << 0U,
  kToolVectorIgnored = 1U << 1U,
  kNormalNotNormalized = 1U << 2U,
  kToolNotNormalized = 1U << 3U,
  kNormalBelow = 1U << 4U,
  kContactJump = 1U << 5U,
  kNoLateral = 1U << 6U,
};
using Warnings = std::uint8_t;

struct NamedWarning {
  const char* name;
  const char* message;
};
inline constexpr std::array<NamedWarning, 7> kWarnings{{
    {"W_DIGITS", "more digits than the control accepts"},
    {"W_T_IGNORED", "without TCPM the tool vector is ignored"},
    {"W_NOT_NORMALIZED", "surface normal not normalized"},
    {"W_NOT_NORMALIZED", "tool vector not normalized"},
    {"W_N_BELOW", "surface normal below the horizontal of the tool"},
    {"W_CONTACT_JUMP", "the contact jumps over the flat bottom of the tool"},
    {"W_NO_LATERAL", "no lateral compensation: neither a surface normal nor RL or RR"},
}};

}  // namespace toolcomp::fast::klartext
