// SPDX-License-Identifier: Apache-2.0
// Programs of real length: closed contours of short lines and arcs, made from splines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace toolcomp::corpus {

enum class ContourVariant : std::uint8_t {
  pocket,  // counter-clockwise, the tool inside (G41)
  island,  // counter-clockwise, the tool outside (G42)
  tight,   // the pocket with places too small for the tool: some at which the interference check drops
           // vectors, and one that must end the run in PS0041
};

// The place of the variant tight that ends the run.
enum class TightPlace : std::uint8_t {
  arc,     // an arc of a fifth of the tool's radius
  groove,  // three lines, a groove as narrow as one block is long
};

struct ContourOptions {
  std::size_t blocks = 100'000;  // lines and arcs; tight: up to two more for the groove
  ContourVariant variant = ContourVariant::pocket;
  std::uint64_t seed = 1;
  unsigned arcs = 40;  // number of arcs in 100 blocks, if the contour is curved enough
  std::optional<std::size_t> at =
      std::nullopt;  // tight: the place, the first flat one from this block on (default: the middle)
  TightPlace place = TightPlace::arc;
};

struct Contour {
  std::string program;
  std::string setup;  // TOML
  std::size_t lines = 0;
  std::size_t arcs = 0;
  std::size_t dropped = 0;  // tight: arcs between half the tool's radius and all of it, before the alarm
  std::optional<std::uint64_t> alarm_line;  // tight: the line of PS0041, found by elementary geometry only
};

// Smallest number of blocks.
inline constexpr std::size_t kLeastContour = 60;

// The same options give the same bytes on every compiler: the splines are evaluated in whole numbers. Every coordinate
// is a decimal of four places, every centre one of six, at the same distance from both ends. The tool radius is 3 mm.
// Elsewhere the curvature of the contour is at most 1/6 per mm. Throws std::invalid_argument for too few blocks.
Contour make_contour(const ContourOptions& options);

}  // namespace toolcomp::corpus
