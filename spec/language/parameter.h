// SPDX-License-Identifier: Apache-2.0
// The parameters that a setup may have: the registry spec/parameters.toml as a table.
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

// A parameter, as the registry gives it.
struct ParameterInfo {
  ParameterId id;
  ParameterType type;
  Decimal least, greatest;  // both inclusive; an axis number is also at most the number of axes of the setup
  std::string_view values;  // the only values, separated by blanks; empty: all values in the range
  std::optional<Decimal> default_value;  // lengths in mm; std::nullopt: see the text
  std::string_view unit;                 // empty: none
  std::string_view clauses;              // ids, separated by line feeds
  std::string_view example;              // value in the example of a setup; empty: not in the example
  std::string_view text;                 // whole sentences
};

// In ascending order.
std::span<const ParameterInfo> parameters();
// nullptr if there is no entry. A number whose bits are known has no entry of its own.
const ParameterInfo* find_parameter(ParameterId id);
// The known bits of a number, as a bit mask; 0 for other numbers.
unsigned known_bits(std::uint32_t number);
// The known bits that may be 1.
unsigned free_bits(std::uint32_t number);
// Whether it is a bit that may only be 0, because its function is not supported.
bool is_not_supported(const ParameterInfo& parameter);
// Whether it has an entry, or is a number with known bits, which may be given as a whole.
bool is_known(ParameterId id);
// The known parameter that is nearest to "number" or "number#bit": by the digits of the number, its value, the bit.
const ParameterInfo& nearest_parameter(ParameterId id);

// "19680" or "5001#2".
std::string to_string(ParameterId id);
// Reads such a text, whether the parameter is known or not; std::nullopt if it is not a number up to 99999 or has no
// bit from 0 to 7.
std::optional<ParameterId> parse_parameter_id(std::string_view name);

// What a value may be, for messages: "0, 2, 12 or 21". `id` is known.
std::string expected_value(ParameterId id, const Axes& axes);
// Whether the value is of the type and in the range; never for an unknown parameter.
bool allows(ParameterId id, const Decimal& value, const Axes& axes);
// Whether all parameters of a setup are known and have permitted values, so that the readers accept them.
bool has_allowed_parameters(const Setup& setup);

// The value that counts if the setup does not give the parameter. std::nullopt if this is not a decimal.
std::optional<Decimal> default_value(ParameterId id, Units units);

}  // namespace toolcomp::spec
