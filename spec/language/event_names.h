// SPDX-License-Identifier: Apache-2.0
// The names of the enumerations in events, in both directions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "spec/language/event.h"

namespace toolcomp::spec {

// The names of an enumeration in the order of its values.
template <class Enum>
inline constexpr std::array<std::string_view, 0> kNames{};
template <>
inline constexpr std::array<std::string_view, 9> kNames<EventKind>{
    "move", "sample", "alarm", "warning", "setting", "undecided", "not_supported", "not_judged", "hole"};
template <>
inline constexpr std::array<std::string_view, 3> kNames<MoveType>{"rapid", "linear", "arc"};
template <>
inline constexpr std::array<std::string_view, 8> kNames<Cause>{"programmed", "start-up",  "corner",    "cancel",
                                                               "pre-turn",   "post-turn", "reference", "measure"};
template <>
inline constexpr std::array<std::string_view, 3> kNames<Plane>{"XY", "ZX", "YZ"};
template <>
inline constexpr std::array<std::string_view, 2> kNames<ArcDirection>{"cw", "ccw"};

// The reason of an undecided event that is not an open question of the specification.
inline constexpr std::string_view kOutOfScope = "OUT_OF_SCOPE";

// The name of a value: "start-up" for Cause::start_up.
template <class Enum>
constexpr std::string_view name(Enum value) {
  return kNames<Enum>[static_cast<std::size_t>(value)];
}

// The value of a name: Cause::start_up for "start-up"; std::nullopt for an unknown name.
template <class Enum>
constexpr std::optional<Enum> from_name(std::string_view text) {
  const auto found = std::ranges::find(kNames<Enum>, text);
  if (found == kNames<Enum>.end()) return std::nullopt;
  return static_cast<Enum>(found - kNames<Enum>.begin());
}

}  // namespace toolcomp::spec
