// SPDX-License-Identifier: Apache-2.0
// The fields of events by name, and sets of them: the fields that an event has, or that a controller announces.
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>

namespace toolcomp::spec {

enum class Field : std::uint8_t {
  kind,
  line,
  n,
  type,
  cause,
  programmed,
  point,
  axes,
  machine,
  unknown,
  tool_axis,
  center,
  plane,
  direction,
  sweep,
  radius,
  tool_center,
  contact,
  normal,
  shift,
  tool_shift,
  carrier,
  angle,
  flat,
  feed,
  r,
  bottom,
  level,
  number,
  code,
  message,
  name,
  value,
  t,
  clause,
  permitted,
  reason,
  clauses,
};
inline constexpr std::array<std::string_view, 38> kFieldNames{
    "kind",        "line",    "n",         "type",      "cause",      "programmed", "point",   "axes",
    "machine",     "unknown", "tool_axis", "center",    "plane",      "direction",  "sweep",   "radius",
    "tool_center", "contact", "normal",    "shift",     "tool_shift", "carrier",    "angle",   "flat",
    "feed",        "r",       "bottom",    "return",    "number",     "code",       "message", "name",
    "value",       "t",       "clause",    "permitted", "reason",     "clauses"};

constexpr std::string_view field_name(Field field) { return kFieldNames[static_cast<std::size_t>(field)]; }
constexpr std::optional<Field> find_field(std::string_view name) {
  const std::span names(kFieldNames);
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Field>(found - names.begin());
}

// A set of fields.
class FieldSet {
 public:
  FieldSet() = default;
  FieldSet(std::initializer_list<Field> fields) {
    for (const Field field : fields) add(field);
  }
  [[nodiscard]] bool has(Field field) const { return set_[static_cast<std::size_t>(field)]; }
  void add(Field field) { set_.set(static_cast<std::size_t>(field)); }
  void add(const FieldSet& more) { set_ |= more.set_; }
  [[nodiscard]] bool empty() const { return set_.none(); }
  friend bool operator==(const FieldSet&, const FieldSet&) = default;

 private:
  std::bitset<kFieldNames.size()> set_;
};

}  // namespace toolcomp::spec
