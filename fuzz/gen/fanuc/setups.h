// SPDX-License-Identifier: Apache-2.0
// Random setups of FANUC controls that could exist.
#pragma once

#include "fuzz/gen/choices.h"
#include "spec/language/setup.h"

namespace toolcomp::fuzz {

enum class Kinematics : std::uint8_t { none, maybe, always };

// Units, axes, memory with offsets, workpiece and reference points, parameters 3401, 5001, 19631 and the kinematics.
spec::Setup random_setup(Choices& choose, Kinematics wanted);

// For cutter compensation of one type: no rotary tool, XYZ among the axes, offsets that fit contours of some ten units,
// parameters 5001, 5003, 5008, 5010, in type C the series.
spec::Setup random_cutter_setup(Choices& choose, spec::CutterCompensationType type);

// For tool side compensation: a tool that turns on most machines, the same offsets, parameters 5003, 5008, 5010, 6261,
// 19605 and 19630.
spec::Setup random_tool_side_setup(Choices& choose);

// For tool center point control and tool posture control: heads, tables and mixed machines, orthogonal and nutating,
// with the distances of their axes, ranges and limits; offsets and corner parameters as for tool side compensation.
spec::Setup random_rotary_setup(Choices& choose);

// A decimal of `count` units of 10^-decimals.
spec::Decimal decimal(std::int64_t count, int decimals);
// Digits behind the point of the least input increment of the setup's units and increment system.
int increment_decimals(const spec::Setup& setup);
// A value of the setup in least increments, rounded.
std::int64_t counts_of(const spec::Decimal& value, const spec::Setup& setup);

}  // namespace toolcomp::fuzz
