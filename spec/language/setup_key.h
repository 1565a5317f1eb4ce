// SPDX-License-Identifier: Apache-2.0
// What a setup says by key, to choose what else the rules leave open: the registry spec/parameters.toml as a table.
// Everything that reads, writes or compares the keys of a setup goes through it; engines read the members of Setup.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "spec/language/setup.h"

namespace toolcomp::spec {

// A key as the registry states it. Of pairs the first is of Control::fanuc, the second of Control::heidenhain.
struct KeyInfo {
  std::string_view id;                       // also the member of Setup
  std::array<bool, 2> controls;              // whose setups have it
  bool boolean;                              // its values are false and true, without quotes
  std::span<const std::string_view> values;  // in the order of the enumeration
  std::size_t default_value;                 // index of a value
  bool always;                               // written also where it has its default
  char letter;                               // of its line in a fuzzed case
  std::span<const std::string_view> words;   // there, for the values; empty: the letter alone is the other of two
  unsigned percent;  // directed cases of its clauses' sections with another value; 0: see fuzz/gen
  std::span<const std::string_view> clauses;        // ids
  std::array<std::string_view, 2> text;             // whole sentences
  std::array<std::string_view, 2> comment;          // behind the default in the example of a setup
  std::size_t (*get)(const SetupKeys& keys);        // index of the value
  void (*set)(SetupKeys& keys, std::size_t value);  // likewise

  [[nodiscard]] bool is_of(Control control) const { return controls[static_cast<std::size_t>(control)]; }
  [[nodiscard]] bool is_default(const SetupKeys& keys) const { return get(keys) == default_value; }
};

// In the order in which setups are written.
std::span<const KeyInfo> keys();

// The one that the axes stand behind, which are no key of the registry.
inline constexpr std::string_view kKeyBeforeAxes = "units";

// The value as TOML and JSON write it: true, "IS-B".
std::string value_text(const KeyInfo& key, std::size_t value);

}  // namespace toolcomp::spec
