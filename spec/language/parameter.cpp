// SPDX-License-Identifier: Apache-2.0
#include "spec/language/parameter.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <tuple>
#include <vector>

#include "spec/language/decimal_order.h"
#include "spec/language/edit_distance.h"
#include "spec/language/split.h"
#include "spec/parameters/table.h"

namespace toolcomp::spec {
namespace {

// "0, 2, 12 or 21"
std::string any_of(const std::vector<std::string_view>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    text.append(i == 0 ? "" : i + 1 == items.size() ? " or " : ", ").append(items[i]);
  return text;
}

bool is_one_of(const Decimal& value, std::string_view values) {
  return std::ranges::any_of(split(values, ' '), [&](std::string_view item) {
    const std::optional<Decimal> allowed = parse_decimal(item);
    return allowed && compare(*allowed, value) == 0;
  });
}

// Of a bit that may only be 0: what is not supported.
std::string not_supported(const ParameterInfo& p) {
  return " (" + std::string(p.text.substr(0, p.text.find(". "))) + ")";
}

std::string_view kind(ParameterType type) {
  switch (type) {
    case ParameterType::length:
      return "a length";
    case ParameterType::angle:
      return "an angle";
    default:
      return "a number";
  }
}

}  // namespace

std::span<const ParameterInfo> parameters() { return kParameters; }

const ParameterInfo* find_parameter(ParameterId id) {
  const auto* const found = std::ranges::lower_bound(parameters().data(), parameters().data() + parameters().size(), id,
                                                     {}, &ParameterInfo::id);
  return found != parameters().data() + parameters().size() && found->id == id ? found : nullptr;
}

unsigned known_bits(std::uint32_t number) {
  unsigned bits = 0;
  for (const ParameterInfo& p : parameters())
    if (p.id.number == number && p.id.bit >= 0) bits |= 1U << static_cast<unsigned>(p.id.bit);
  return bits;
}

unsigned free_bits(std::uint32_t number) {
  unsigned bits = known_bits(number);
  for (const ParameterInfo& p : parameters())
    if (p.id.number == number && is_not_supported(p)) bits &= ~(1U << static_cast<unsigned>(p.id.bit));
  return bits;
}

bool is_not_supported(const ParameterInfo& p) { return p.type == ParameterType::bit && !p.values.empty(); }

bool is_known(ParameterId id) { return find_parameter(id) != nullptr || (id.bit < 0 && known_bits(id.number) != 0); }

const ParameterInfo& nearest_parameter(ParameterId id) {
  const std::string digits = std::to_string(id.number);
  return *std::ranges::min_element(parameters(), {}, [&](const ParameterInfo& p) {
    const auto number = static_cast<std::int64_t>(p.id.number);
    return std::tuple{edit_distance(digits, std::to_string(number)),
                      std::abs(number - static_cast<std::int64_t>(id.number)), std::abs(p.id.bit - id.bit)};
  });
}

std::string to_string(ParameterId id) {
  return std::to_string(id.number) + (id.bit < 0 ? std::string() : '#' + std::to_string(id.bit));
}

std::optional<ParameterId> parse_parameter_id(std::string_view name) {
  constexpr std::uint64_t kGreatest = 99999;
  const std::size_t mark = name.find('#');
  const std::optional<std::uint32_t> number = parse_small_number(name.substr(0, mark), kGreatest);
  if (!number) return std::nullopt;
  if (mark == std::string_view::npos) return ParameterId{*number, -1};
  const std::string_view bit = name.substr(mark + 1);
  if (bit.size() != 1 || bit[0] < '0' || bit[0] > '7') return std::nullopt;
  return ParameterId{*number, bit[0] - '0'};
}

std::string expected_value(ParameterId id, const Axes& axes) {
  const ParameterInfo* const p = find_parameter(id);
  if (p == nullptr) {
    std::string bits;
    std::string others;
    for (const ParameterInfo& other : parameters()) {
      if (other.id.number != id.number) continue;
      if (is_not_supported(other))
        others += not_supported(other);
      else
        bits += (bits.empty() ? "" : " ") + std::to_string(other.id.bit);
    }
    return (bits.empty() ? "0" : "a whole number that sets no bits except " + any_of(split(bits, ' '))) + others;
  }
  if (is_not_supported(*p)) return "0" + not_supported(*p);
  if (!p->values.empty()) return any_of(split(p->values, ' '));
  if (p->type == ParameterType::bit) return "0 or 1";
  if (p->type == ParameterType::axis)
    return "the number of an axis, 0 to " + std::to_string(axes.size()) + " (axes " + axes.letters() + ")";
  std::string text(kind(p->type));
  if (!p->unit.empty()) text.append(" (").append(p->unit).append(")");
  return text + " from " + to_string(p->least) + " to " + to_string(p->greatest);
}

bool allows(ParameterId id, const Decimal& value, const Axes& axes) {
  const ParameterInfo* const p = find_parameter(id);
  if (p == nullptr) {
    const std::uint64_t other_bits = ~std::uint64_t{free_bits(id.number)};
    return is_known(id) && value.is_integer() && !value.negative && (value.digits & other_bits) == 0;
  }
  if (!p->values.empty()) return is_one_of(value, p->values);
  if (compare(value, p->least) < 0 || compare(value, p->greatest) > 0) return false;
  if (p->type == ParameterType::bit) return value == decimal(0) || value == decimal(1);
  if (p->type != ParameterType::axis) return true;
  for (std::size_t axis = 0; axis <= axes.size(); ++axis)
    if (compare(value, decimal(static_cast<std::int64_t>(axis))) == 0) return true;
  return false;
}

bool has_allowed_parameters(const Setup& setup) {
  return std::ranges::all_of(setup.parameters,
                             [&](const auto& entry) { return allows(entry.first, entry.second, setup.axes); });
}

std::optional<Decimal> default_value(ParameterId id, Units units) {
  const ParameterInfo* const p = find_parameter(id);
  if (p == nullptr || !p->default_value) return std::nullopt;
  // 20 mm are no decimal of inches.
  const bool converted = p->type == ParameterType::length && units == Units::inch && !p->default_value->is_zero();
  return converted ? std::nullopt : p->default_value;
}

}  // namespace toolcomp::spec
