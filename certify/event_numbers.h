// SPDX-License-Identifier: Apache-2.0
// Visits every number of an event, for any number type.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "spec/language/axes.h"
#include "spec/language/event.h"

namespace toolcomp::certify {

// Calls `visit(field, letter, number)` for each: `field` is its name in docs/events.md, `letter` an axis or a
// component, 0 if the field is one number.
template <class Number, class Visit>
void for_each_number(const spec::Event<Number>& event, const spec::Axes& axes, const Visit& visit) {
  const auto axis_values = [&](std::string_view field, const spec::AxisValues<Number>& values) {
    for (std::size_t i = 0; i < axes.size(); ++i)
      if (values.has(i)) visit(field, axes.letter(i), values[i]);
  };
  const auto vector = [&](std::string_view field, const std::array<Number, 3>& v) {
    for (std::size_t i = 0; i < v.size(); ++i) visit(field, "XYZ"[i], v.at(i));
  };
  axis_values("programmed", event.programmed);
  axis_values("point", event.point);
  axis_values("axes", event.axes);
  axis_values("machine", event.machine);
  if (event.tool_axis) vector("tool_axis", *event.tool_axis);
  if (event.arc) {
    axis_values("center", event.arc->center);
    if (event.arc->sweep) visit("sweep", '\0', *event.arc->sweep);
  }
  if (event.hole) {
    visit("r", '\0', event.hole->point_r);
    visit("bottom", '\0', event.hole->bottom);
    visit("return", '\0', event.hole->level);
  }
  if (event.feed) visit("feed", '\0', *event.feed);
  if (event.kind == spec::EventKind::setting) visit("value", '\0', event.value);
  if (!event.space) return;
  vector("tool_center", event.space->tool_center);
  vector("shift", event.space->shift);
  vector("tool_shift", event.space->tool_shift);
  if (event.space->carrier) vector("carrier", *event.space->carrier);
  if (!event.space->contact) return;
  vector("contact", event.space->contact->point);
  vector("normal", event.space->contact->normal);
  if (event.space->contact->angle) visit("angle", '\0', *event.space->contact->angle);
}

}  // namespace toolcomp::certify
