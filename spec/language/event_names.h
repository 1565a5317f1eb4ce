// SPDX-License-Identifier: Apache-2.0
// The names of what events are made of, in both directions.
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

// The reason of an undecided event that is none of the specification's open questions.
inline constexpr std::string_view kOutOfScope = "OUT_OF_SCOPE";

// "start-up" of Cause::start_up.
template <class Enum>
constexpr std::string_view name(Enum value) {
  return kNames<Enum>[static_cast<std::size_t>(value)];
}

// Cause::start_up of "start-up"; nothing for any other text.
template <class Enum>
constexpr std::optional<Enum> from_name(std::string_view text) {
  const auto found = std::ranges::find(kNames<Enum>, text);
  if (found == kNames<Enum>.end()) return std::nullopt;
  return static_cast<Enum>(found - kNames<Enum>.begin());
}

}  // namespace toolcomp::spec
