// SPDX-License-Identifier: Apache-2.0
// Alarms and warnings of Heidenhain 3D compensation. Names and texts are ours.
#pragma once

#include <array>
#include <cstdint>

#include "fast/basis/alarm.h"

namespace toolcomp::fast::klartext {

using fast::Alarm;

namespace alarm {

inline constexpr Alarm kNone{};
inline constexpr Alarm kMachineCoordinates{"E_TCPM_M91", "M91 or M92 under TCPM"};
inline constexpr Alarm kToolCall{"E_TCPM_TOOLCALL", "tool call under TCPM"};
inline constexpr Alarm kNoTool{"E_NO_TOOL", "no tool, or none of this number or name"};
inline constexpr Alarm kRadiusWithNormal{"E_RC_WITH_N", "surface normal while RL or RR is in force"};
inline constexpr Alarm kTool{"E_TOOL", "radius below 0, or corner radius below 0 or beyond the radius"};
inline constexpr Alarm kShape{"E_3DTC_SHAPE", "a table of deviations is for ball-nose cutters"};
inline constexpr Alarm kEffectiveTool{"E_TOOL_EFF", "effective radius below 0"};
inline constexpr Alarm kAngleRange{"E_3DTC_RANGE", "contact angle outside the table of deviations"};
inline constexpr Alarm kCornerNegative{"E_R2_NEG", "effective corner radius below 0"};
inline constexpr Alarm kOversizeRadius{"E_OVERSIZE_DR", "positive radius delta without M107"};
inline constexpr Alarm kOversizeCorner{"E_OVERSIZE_DR2", "positive corner radius delta without M107"};
inline constexpr Alarm kCornerBeyondRadius{"E_R2_GT_R", "effective corner radius beyond the radius without M107"};
inline constexpr Alarm kNoDirection{"E_NO_DIRECTION", "no direction of compensation: nothing moves across the tool"};
inline constexpr Alarm kReversal{"E_REVERSAL", "opposite directions of compensation at a corner"};
inline constexpr Alarm kRange{"POSITION_RANGE", "value or position of 1e17 or more"};

}  // namespace alarm

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

inline constexpr std::array<Alarm, 7> kWarnings{{
    {"W_DIGITS", "more digits than the control takes"},
    {"W_T_IGNORED", "without TCPM the tool vector is ignored"},
    {"W_NOT_NORMALIZED", "surface normal not normalized"},
    {"W_NOT_NORMALIZED", "tool vector not normalized"},
    {"W_N_BELOW", "surface normal below the horizontal of the tool"},
    {"W_CONTACT_JUMP", "the contact jumps over the flat bottom of the tool"},
    {"W_NO_LATERAL", "no lateral compensation: neither a surface normal nor RL or RR"},
}};

}  // namespace toolcomp::fast::klartext
