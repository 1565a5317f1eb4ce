// SPDX-License-Identifier: Apache-2.0
// Programs for machines that really move, whose motion is recorded (docs/adapters.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "spec/language/case.h"

namespace toolcomp::certify {

// A program for the machine of `setup` (mm), and the setup with the offsets that it uses. The same seed gives the same
// program. With kinematics (19680): tool center point control, entered and left with the rotary axes at 0. Without:
// length offsets, and cutter compensation C at inside corners. The moves are some hundred millimetres long in total.
spec::Case machine_program(const spec::Setup& setup, std::uint64_t seed);

// The seed of program number `index` of a series. Series of two different seeds have no program in common.
std::uint64_t program_seed(std::uint64_t seed, std::uint32_t index);

struct MachineProgram {
  spec::Case c;
  std::string machine;  // name of its setup: the name of the file without its ending
};
// `count` programs for the machines of these setup files in turn. Throws spec::InputError for a file that is not a
// setup.
std::vector<MachineProgram> machine_programs(const std::vector<std::filesystem::path>& setups, std::uint32_t count,
                                             std::uint64_t seed);

}  // namespace toolcomp::certify
