// SPDX-License-Identifier: Apache-2.0
// Where the tool of a setup roughly points: generators aim their movements by it. In double, and no part of a verdict.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include "spec/language/setup.h"

namespace toolcomp::fuzz {

using Direction = std::array<double, 3>;

// Rotary positions in degrees by axis letter.
using Pose = std::map<char, double>;

// The unit direction from tip to holder at `pose`, by parameters 19680–19699 or 19610–19623; nothing where the setup
// states no kinematics.
std::optional<Direction> tool_direction(const spec::Setup& setup, const Pose& pose);

// A vector of X Y Z in counts of the least increment, or a direction in whole numbers.
using SpaceCounts = std::array<std::int64_t, 3>;

// A component in billionths, in which generators tell zeros and whole numbers.
std::int64_t billionths(double x);

double dot(const Direction& a, const Direction& b);
Direction cross(const Direction& a, const Direction& b);
// The unit vector along `v`; `v` must not be zero.
Direction unit(const Direction& v);
// `v` turned about the unit vector `axis` by `degrees`, right-handed.
Direction turned(const Direction& v, const Direction& axis, double degrees);
// The first coordinate axis, or the second where `d` is near the first.
Direction axis_off(const Direction& d);
// A unit direction at right angles to the unit direction `d`.
Direction beside(const Direction& d);
Direction as_direction(const SpaceCounts& whole);
// The small whole vector along the unit direction `d`, no component above `most`, if there is one.
std::optional<SpaceCounts> whole_along(const Direction& d, double most);

}  // namespace toolcomp::fuzz
