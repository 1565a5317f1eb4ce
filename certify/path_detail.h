// SPDX-License-Identifier: Apache-2.0
// Draws one place of a compensated path, seen along the tool, large enough to measure in the picture.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "certify/path.h"
#include "spec/language/event.h"

namespace toolcomp::certify {

// A place in the middle of a compensated path, and what its picture needs.
struct Detail {
  std::size_t event = 0;  // the move at whose end the place is
  Point3 programmed{};    // the end
  Point3 point{};         // the compensated end
  Point3 along{};         // unit: from the programmed point towards the holder
  Point3 travel{};        // unit: the move's direction in the plane of the tool
  double distance = 0;    // distance of the compensated end from the programmed line in that plane: the tool radius
};

// The place to show: the end of the move `marked`, or else of the middle one, among the moves that have a tool
// direction and run next to their programmed line. std::nullopt if there is none.
std::optional<Detail> detail_of(std::span<const spec::Event<double>> events, const Path& programmed, const Path& point,
                                std::optional<std::size_t> marked);

// The square panel of `side` at (left, top): the travel goes to the right, and its left side is up. It shows the
// programmed and the compensated path next to the place, the tool's circle and the vector. `label` names the place.
std::string detail_svg(const Detail& detail, const Path& programmed, const Path& point, double left, double top,
                       double side, std::string_view label, std::string_view unit);

}  // namespace toolcomp::certify
