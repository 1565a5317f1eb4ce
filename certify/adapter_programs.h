// Programs for machines that really move: for controllers that are recorded (docs/adapters.md).
#pragma once

#include <cstdint>

#include "spec/language/case.h"

namespace toolcomp::certify {

// A program for the machine of `setup` (mm), and the setup with the offsets it uses: the same for the same seed. With
// kinematics (19680): tool center point control, entered and left with the rotary axes at 0. Without: length offsets,
// and cutter compensation C at inside corners. Moves are some hundred millimetres in all.
spec::Case machine_program(const spec::Setup& setup, std::uint64_t seed);

}  // namespace toolcomp::certify
