// SPDX-License-Identifier: Apache-2.0
// [[parameter]] of the registry as C++.
#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spec/generated_source.h"
#include "spec/parameters/registry.h"

namespace toolcomp::spec {
namespace {

constexpr std::string_view kKeys[] = {"id",      "through", "type",    "range",   "values",
                                      "default", "unit",    "clauses", "example", "text"};
constexpr std::string_view kTypes[] = {"bit", "integer", "decimal", "length", "angle", "axis"};

constexpr std::string_view kFile = R"(// Generated from the registry of parameters. Do not edit.
#pragma once

#include <array>
#include <optional>

#include "spec/language/parameter.h"

namespace toolcomp::spec {{

inline constexpr std::array<ParameterInfo, {1}> kParameters{{{{
{0}}}}};

}}  // namespace toolcomp::spec
)";

class Parameters {
 public:
  explicit Parameters(const Registry& registry) : registry_(registry) {}

  [[nodiscard]] std::string table() const {
    std::string rows;
    std::size_t count = 0;
    for (const toml::table* entry : registry_.entries("parameter"))
      for (const std::string& id : ids(*entry)) {
        rows += row(*entry, id);
        ++count;
      }
    return fmt::format(kFile, rows, count);
  }

 private:
  // A C++ Decimal from an integer or a quoted decimal.
  [[nodiscard]] std::string decimal(const toml::node& node) const {
    const std::string text = number_text(node);
    const bool negative = text.starts_with('-');
    const std::string magnitude = text.substr(negative ? 1 : 0);
    const std::size_t point = magnitude.find('.');
    std::string digits = magnitude;
    if (point != std::string::npos) digits.erase(point, 1);
    const std::size_t decimals = point == std::string::npos ? 0 : magnitude.size() - point - 1;
    if (digits.empty() || digits.size() > 18 || digits.find_first_not_of("0123456789") != std::string::npos)
      registry_.fail(node, "an integer or a quoted decimal must stand here");
    const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
    return fmt::format("Decimal{{{}U, {}, {}, {}}}", digits.substr(first), decimals, negative,
                       point != std::string::npos);
  }

  [[nodiscard]] std::string number_text(const toml::node& node) const {
    if (const auto integer = node.value<std::int64_t>(); integer && node.is_integer()) return std::to_string(*integer);
    if (const auto text = node.value<std::string>()) return *text;
    registry_.fail(node, "an integer or a quoted decimal must stand here");
  }

  // "5001#2" as "5001, 2"; a whole number has bit -1. With `through` all numbers up to that one: they differ in
  // nothing.
  [[nodiscard]] std::vector<std::string> ids(const toml::table& table) const {
    const auto* node = table.get("id");
    const std::string text = node == nullptr ? std::string() : node->value_or(std::string());
    const std::size_t mark = text.find('#');
    const std::string number = text.substr(0, mark);
    const std::string bit = mark == std::string::npos ? "-1" : text.substr(mark + 1);
    const bool is_number = !number.empty() && number.size() <= 5 && number[0] != '0' &&
                           number.find_first_not_of("0123456789") == std::string::npos;
    const bool is_bit = mark == std::string::npos || (bit.size() == 1 && bit[0] >= '0' && bit[0] <= '7');
    if (!is_number || !is_bit)
      registry_.fail(node == nullptr ? table : *node, "id: a number or number#bit must stand here");
    std::vector<std::string> list{number + ", " + bit};
    if (const toml::node* through = table.get("through")) {
      const std::int64_t last = through->value_or(std::int64_t{0});
      if (bit != "-1" || last <= std::stoll(number) || last > 99999)
        registry_.fail(*through, "through: a greater number, of parameters without bit, must stand here");
      for (std::int64_t next = std::stoll(number) + 1; next <= last; ++next)
        list.push_back(std::to_string(next) + ", -1");
    }
    return list;
  }

  [[nodiscard]] std::string row(const toml::table& table, const std::string& id) const {
    registry_.expect_keys(table, kKeys);
    const std::string type = registry_.text(table, "type");
    if (std::ranges::find(kTypes, type) == std::end(kTypes))
      registry_.fail(table, "type must be bit, integer, decimal, length, angle or axis");
    const toml::node* default_value = table.get("default");
    const toml::node* example = table.get("example");
    const toml::node* unit = own_or_of_type(table, "unit");
    return fmt::format("    ParameterInfo{{{{{}}}, ParameterType::{}, {}, {},\n      {}, {}, {},\n      {}}},\n", id,
                       type, bounds(table, type), default_value == nullptr ? "std::nullopt" : decimal(*default_value),
                       literal(unit == nullptr ? std::string() : unit->value_or(std::string())),
                       literal(fmt::format("{}", fmt::join(registry_.clauses(table), "\n"))),
                       literal(example == nullptr ? std::string() : number_text(*example)),
                       literal(registry_.text(table, "text")));
  }

  // Least, greatest, and the only values, of which an empty list admits all between.
  [[nodiscard]] std::string bounds(const toml::table& table, std::string_view type) const {
    const toml::node* range = own_or_of_type(table, "range");
    const auto* values = table["values"].as_array();
    const bool bit_or_axis = type == "bit" || type == "axis";
    if (type == "bit" && values != nullptr) {
      if (values->size() != 1 || values->get(0)->value<std::int64_t>() != 0)
        registry_.fail(*values, "of a bit values may only be [0]: 1 is not supported");
      return R"(Decimal{}, Decimal{}, "0")";
    }
    if ((range != nullptr) + (values != nullptr) + bit_or_axis != 1)
      registry_.fail(table, "range or values must stand here, for a bit or an axis neither");
    if (bit_or_axis)
      return fmt::format("Decimal{{}}, Decimal{{{}U, 0, false, false}}, \"\"", type == "bit" ? "1" : "9");
    if (values != nullptr) {
      std::string list;
      for (const toml::node& value : *values) {
        if (!value.is_integer()) registry_.fail(value, "values must be integers");
        list += (list.empty() ? "" : " ") + number_text(value);
      }
      if (list.empty()) registry_.fail(*values, "values must not be empty");
      return fmt::format("{}, {}, {}", decimal(*values->begin()), decimal(*(values->end() - 1)), literal(list));
    }
    const auto* pair = range->as_array();
    if (pair == nullptr || pair->size() != 2) registry_.fail(*range, "range must be the least and the greatest value");
    return fmt::format("{}, {}, \"\"", decimal(*pair->get(0)), decimal(*pair->get(1)));
  }

  // The key of the parameter, else that of its type.
  [[nodiscard]] const toml::node* own_or_of_type(const toml::table& table, std::string_view key) const {
    const toml::node* own = table.get(key);
    return own != nullptr ? own : registry_.of_type(registry_.text(table, "type"), key);
  }

  const Registry& registry_;
};

}  // namespace

std::string parameter_table(const Registry& registry) { return Parameters(registry).table(); }

}  // namespace toolcomp::spec
