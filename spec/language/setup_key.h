// SPDX-License-Identifier: Apache-2.0
// The keys of a setup, which choose what the rules would otherwise leave open: the registry spec/parameters.toml as a
// table. All code that reads, writes or compares the keys of a setup uses this table. Engines read the members of
// Setup.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "spec/language/setup.h"

namespace toolcomp::spec {

// A key, as the registry gives it. The first of a pair is for Control::fanuc, the second for Control::heidenhain.
struct KeyInfo {
  std::string_view id;                       // also the member of Setup
  std::array<bool, 2> controls;              // the controls whose setups have it
  bool boolean;                              // whether its values are false and true, without quotes
  std::span<const std::string_view> values;  // in the order of the enumeration
  std::size_t default_value;                 // index of a value
  bool always;                               // whether it is also written if it has its default
  char letter;                               // letter of its line in a fuzzed case
  std::span<const std::string_view> words;   // for the values there; empty: the letter alone is the other of two
  unsigned percent;  // share of directed cases of its clauses' sections that have another value; 0: see fuzz/gen
  std::span<const std::string_view> clauses;        // ids
  std::array<std::string_view, 2> text;             // whole sentences
  std::array<std::string_view, 2> comment;          // after the default in the example of a setup
  std::size_t (*get)(const SetupKeys& keys);        // index of the value
  void (*set)(SetupKeys& keys, std::size_t value);  // likewise

  [[nodiscard]] bool is_of(Control control) const { return controls[static_cast<std::size_t>(control)]; }
  [[nodiscard]] bool is_default(const SetupKeys& keys) const { return get(keys) == default_value; }
};

// All keys, in the order in which setups are written.
std::span<const KeyInfo> keys();

// The key after which the axes are written. The axes are not a key of the registry.
inline constexpr std::string_view kKeyBeforeAxes = "units";

// The value in the form of TOML and JSON: true, "IS-B".
std::string value_text(const KeyInfo& key, std::size_t value);

}  // namespace toolcomp::spec
