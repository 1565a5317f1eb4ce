// SPDX-License-Identifier: Apache-2.0
// Programs for machines that really move: for controllers that are recorded (docs/adapters.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "spec/language/case.h"

namespace toolcomp::certify {

// A program for the machine of `setup` (mm), and the setup with the offsets it uses: the same for the same seed. With
// kinematics (19680): tool center point control, entered and left with the rotary axes at 0. Without: length offsets,
// and cutter compensation C at inside corners. Moves are some hundred millimetres in all.
spec::Case machine_program(const spec::Setup& setup, std::uint64_t seed);

// Its seed for program number `index` of those of one seed: two seeds have no program in common.
std::uint64_t program_seed(std::uint64_t seed, std::uint32_t index);

struct MachineProgram {
  spec::Case c;
  std::string machine;  // name of its setup: that of the file without its ending
};
// `count` programs for the machines of these setup files in turn. Throws spec::InputError for a file that is no setup.
std::vector<MachineProgram> machine_programs(const std::vector<std::filesystem::path>& setups, std::uint32_t count,
                                             std::uint64_t seed);

}  // namespace toolcomp::certify
