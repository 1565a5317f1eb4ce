// SPDX-License-Identifier: Apache-2.0
// A five-axis program of real length: the ruled flank of an impeller blade, cut with the side of the tool.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace toolcomp::corpus {

// How the program gives the tool direction.
enum class FlankTool : std::uint8_t {
  rotary,  // B and C of a head, C carries B: G41.2, G42.2
  vector,  // I J K under G43.5: G41.6, G42.6
};

struct FlankOptions {
  std::size_t blocks = 20'000;  // of the flank, without approaches and retracts
  FlankTool tool = FlankTool::rotary;
};

struct Flank {
  std::string program;
  std::string setup;  // TOML
  std::size_t passes = 0;
};

// Smallest and largest number of blocks of the flank.
inline constexpr std::size_t kLeastFlank = 60;
inline constexpr std::size_t kMostFlank = 10'000'000;

// The blade stands on the hub's curve r = 80 - 50 cos 90u, z = 50 - 50 sin 90u mm, turned by 55u about Z, u from 0 to 1
// (degrees). Its ruling through that point, which the tool lies along, has B = 68 - 44u + 6 sin 360u and C = 55u + 12
// cos 180u. A pass goes along the flank at one height above the hub, from 24 mm down to 2 mm, there (tool at the left)
// and the next one back (tool at the right), each with start-up, cancel and a retract along the tool; B and C (I J K)
// change in every block of the flank. Tool radius 5 mm; coordinates and angles have four decimals, I J K six. The same
// options give the same bytes on every compiler: the formulas are evaluated in whole numbers. Throws
// std::invalid_argument for too few or too many blocks.
Flank make_flank(const FlankOptions& options);

}  // namespace toolcomp::corpus
