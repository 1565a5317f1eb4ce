// SPDX-License-Identifier: Apache-2.0
// Draws nominal and actual tool at the contact with the wall: a block with a surface normal, cut by the plane of normal
// and tool.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "certify/path.h"
#include "spec/language/event.h"

namespace toolcomp::certify {

// The shape of a cutter: the radius of its flat bottom and that of its corner.
struct CutterShape {
  double flat = 0;
  double corner = 0;
};

// One contact, and what its picture needs.
struct ContactPicture {
  std::size_t event = 0;  // the move at whose end the contact is
  Point3 contact{};
  Point3 normal{};  // unit, from the workpiece into the tool
  Point3 tool{};    // unit, from the tip to the holder
  Point3 across{};  // unit, at right angles to the tool in the plane of the picture, on the side of the normal
  Point3 nominal_tip{};
  Point3 effective_tip{};
  Point3 table_tip{};  // tip of a tool exactly as in the table, moved by the lengthwise delta
  bool lengthened = false;
  Point3 programmed{};
  CutterShape nominal;
  CutterShape effective;
};

// The first contacts that differ from each other, at most `most`; that of the move `marked` among them. The shapes of
// both tools follow from the events. If the tool is along the normal, the events do not give the shape, and `table`
// does.
std::vector<ContactPicture> contact_pictures(const spec::Axes& axes, std::span<const spec::Event<double>> events,
                                             const std::optional<CutterShape>& table, std::size_t most,
                                             std::optional<std::size_t> marked);

// The square panel of `side` at (left, top): the tool upright, the wall below it. `label` names the place.
std::string contact_svg(const ContactPicture& picture, double left, double top, double side, std::string_view label,
                        std::string_view unit);

}  // namespace toolcomp::certify
