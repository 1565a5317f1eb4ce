// SPDX-License-Identifier: Apache-2.0
// A finishing program of real length, as a CAM system writes it: LN blocks over a free-form surface.
#pragma once

#include <cstddef>
#include <string>

namespace toolcomp::corpus {

struct FreeformOptions {
  std::size_t blocks = 500'000;  // LN blocks
  bool tool_vector = true;       // with TX TY TZ under M128; otherwise the tool stays along Z
};

struct Freeform {
  std::string program;
  std::string setup;  // TOML
  std::size_t passes = 0;
};

// Smallest and largest number of LN blocks.
inline constexpr std::size_t kLeastFreeform = 60;
inline constexpr std::size_t kMostFreeform = 10'000'000;

// The surface is z = 20 - 24 u^2 - 14 v^2 + 10 u^3 + 12 u v^2 mm over x = 60 u and y = 40 v, u and v from -1 to 1.
// Passes run along u forth and back, with v from -1 to 1. The points of a pass are evenly spaced. The tool is a ball of
// 10 mm re-worked by 0.1 mm; the program is that of the tip of the nominal tool: q + 5 (n - t) for the point q of the
// surface and its normal n. The tool leans with half the slopes of the surface, and by 1/10 and 1/20 more: t along (0.1
// - z_x / 2, 0.05
// - z_y / 2, 1). Coordinates have four decimals, components seven. The same options give the same bytes on every
// compiler: the formulas are evaluated in whole numbers, to 2^-50. Throws std::invalid_argument for too few or too many
// blocks.
Freeform make_freeform(const FreeformOptions& options);

}  // namespace toolcomp::corpus
