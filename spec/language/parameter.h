// SPDX-License-Identifier: Apache-2.0
// The parameters a setup may have: the registry spec/parameters.toml as a table.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "spec/language/setup.h"

namespace toolcomp::spec {

// A length is in setup units, an angle in degrees, an axis the number of a controlled axis from 1, 0 for none.
enum class ParameterType : std::uint8_t { bit, integer, decimal, length, angle, axis };

// A parameter as the registry states it.
struct ParameterInfo {
  ParameterId id;
  ParameterType type;
  Decimal least, greatest;               // both inside; of an axis also no more than the setup has
  std::string_view values;               // the only ones, with blanks between; empty: all in the range
  std::optional<Decimal> default_value;  // lengths in mm; nothing: see the text
  std::string_view unit;                 // empty: none
  std::string_view clauses;              // ids, with line feeds between
  std::string_view example;              // value in the example of a setup; empty: not there
  std::string_view text;                 // whole sentences
};

// Ascending.
std::span<const ParameterInfo> parameters();
// nullptr where it has no entry. Numbers of which bits are known have none of their own.
const ParameterInfo* find_parameter(ParameterId id);
// The bits of a number that are known, as that number; 0 for others.
unsigned known_bits(std::uint32_t number);
// Those of them that may be 1.
unsigned free_bits(std::uint32_t number);
// A bit that may only be 0: what 1 asks for is not supported.
bool is_not_supported(const ParameterInfo& parameter);
// It has an entry, or is a number with known bits, which as a whole gives all of them.
bool is_known(ParameterId id);
// The known parameter that is nearest to "number" or "number#bit": by the digits of the number, its value, the bit.
const ParameterInfo& nearest_parameter(ParameterId id);

// "19680" or "5001#2".
std::string to_string(ParameterId id);
// The other way, known or not; nothing where it is neither: a number up to 99999, a bit from 0 to 7.
std::optional<ParameterId> parse_parameter_id(std::string_view name);

// What a value may be, for messages: "0, 2, 12 or 21". `id` is known.
std::string expected_value(ParameterId id, const Axes& axes);
// Whether the value is of the type and in the range; never for an unknown parameter.
bool allows(ParameterId id, const Decimal& value, const Axes& axes);
// All parameters of a setup are known, with values that are allowed: the readers accept them.
bool has_allowed_parameters(const Setup& setup);

// What counts where the setup does not give the parameter. Nothing where no decimal does.
std::optional<Decimal> default_value(ParameterId id, Units units);

}  // namespace toolcomp::spec
