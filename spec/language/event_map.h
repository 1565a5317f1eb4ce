// The same event over another number.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "spec/language/event.h"

namespace toolcomp::spec {

template <class To, class From, class Function>
AxisValues<To> map_numbers(const AxisValues<From>& values, const Function& function) {
  AxisValues<To> mapped;
  for (std::size_t axis = 0; axis < kMaxAxes; ++axis)
    if (values.has(axis)) mapped.set(axis, function(values[axis]));
  return mapped;
}

// Every number of the event that is there, through `function`; everything else as it is.
template <class To, class From, class Function>
Event<To> map_numbers(const Event<From>& event, const Function& function) {
  const auto optional = [&function](const std::optional<From>& value) {
    return value ? std::optional<To>(function(*value)) : std::nullopt;
  };
  Event<To> mapped;
  mapped.kind = event.kind;
  mapped.line = event.line;
  mapped.n = event.n;
  mapped.type = event.type;
  mapped.cause = event.cause;
  mapped.programmed = map_numbers<To>(event.programmed, function);
  mapped.point = map_numbers<To>(event.point, function);
  mapped.axes = map_numbers<To>(event.axes, function);
  mapped.machine = map_numbers<To>(event.machine, function);
  if (event.tool_axis) {
    const auto& [i, j, k] = *event.tool_axis;
    mapped.tool_axis = {function(i), function(j), function(k)};
  }
  if (event.arc) {
    mapped.arc.emplace();
    mapped.arc->center = map_numbers<To>(event.arc->center, function);
    mapped.arc->plane = event.arc->plane;
    mapped.arc->direction = event.arc->direction;
    mapped.arc->sweep = optional(event.arc->sweep);
    if (event.arc->radius)
      mapped.arc->radius.emplace(function(event.arc->radius->first), function(event.arc->radius->second));
  }
  mapped.feed = optional(event.feed);
  mapped.number = event.number;
  mapped.message = event.message;
  mapped.permitted = event.permitted;
  mapped.setting = event.setting;
  if (event.kind == EventKind::setting) mapped.value = function(event.value);
  mapped.t_numerator = event.t_numerator;
  mapped.t_denominator = event.t_denominator;
  mapped.clauses = event.clauses;
  return mapped;
}

}  // namespace toolcomp::spec
