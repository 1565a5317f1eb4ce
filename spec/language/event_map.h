// SPDX-License-Identifier: Apache-2.0
// Converts an event to another number type.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
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

template <class To, class From, class Function>
std::array<To, 3> map_numbers(const std::array<From, 3>& vector, const Function& function) {
  return {function(vector[0]), function(vector[1]), function(vector[2])};
}

template <class To, class From, class Function>
SpaceCompensation<To> map_numbers(const SpaceCompensation<From>& space, const Function& function) {
  SpaceCompensation<To> mapped;
  mapped.tool_center = map_numbers<To>(space.tool_center, function);
  mapped.shift = map_numbers<To>(space.shift, function);
  mapped.tool_shift = map_numbers<To>(space.tool_shift, function);
  if (space.carrier) mapped.carrier = map_numbers<To>(*space.carrier, function);
  if (space.contact) {
    mapped.contact.emplace();
    mapped.contact->point = map_numbers<To>(space.contact->point, function);
    mapped.contact->normal = map_numbers<To>(space.contact->normal, function);
    mapped.contact->flat = space.contact->flat;
    if (space.contact->angle) mapped.contact->angle = function(*space.contact->angle);
  }
  return mapped;
}

// Applies `function` to every number that the event has, and copies everything else. Clauses are copied only if both
// types have them.
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
  if (event.tool_axis) mapped.tool_axis = map_numbers<To>(*event.tool_axis, function);
  if (event.arc) {
    mapped.arc.emplace();
    mapped.arc->center = map_numbers<To>(event.arc->center, function);
    mapped.arc->plane = event.arc->plane;
    mapped.arc->direction = event.arc->direction;
    mapped.arc->sweep = optional(event.arc->sweep);
    if (event.arc->radius)
      mapped.arc->radius.emplace(function(event.arc->radius->first), function(event.arc->radius->second));
  }
  if (event.space) mapped.space = map_numbers<To>(*event.space, function);
  mapped.unknown = event.unknown;
  if (event.hole)
    mapped.hole = {event.hole->axis, function(event.hole->point_r), function(event.hole->bottom),
                   function(event.hole->level)};
  mapped.feed = optional(event.feed);
  mapped.alarm = event.alarm;
  mapped.number = event.number;
  mapped.message = event.message;
  mapped.permitted = event.permitted;
  mapped.out_of_scope = event.out_of_scope;
  mapped.setting = event.setting;
  if (event.kind == EventKind::setting) mapped.value = function(event.value);
  mapped.t_numerator = event.t_numerator;
  mapped.t_denominator = event.t_denominator;
  if constexpr (std::is_same_v<decltype(mapped.clauses), decltype(event.clauses)>) mapped.clauses = event.clauses;
  return mapped;
}

}  // namespace toolcomp::spec
