// Random setups of controls that could exist.
#pragma once

#include "fuzz/gen/choices.h"
#include "spec/language/setup.h"

namespace toolcomp::fuzz {

enum class Kinematics : std::uint8_t { maybe, always };

// Units, axes, memory with offsets, workpiece and reference points, parameters 3401, 5001, 19631 and the kinematics.
spec::Setup random_setup(Choices& choose, Kinematics kinematics);

// A decimal of `count` units of 10^-decimals.
spec::Decimal decimal(std::int64_t count, int decimals);
// Digits behind the point of the least input increment of the setup's units and increment system.
int increment_decimals(const spec::Setup& setup);

}  // namespace toolcomp::fuzz
