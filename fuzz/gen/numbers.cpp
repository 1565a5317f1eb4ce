// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/numbers.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "fuzz/gen/change_text.h"
#include "fuzz/gen/program_text.h"
#include "spec/language/parameter.h"

namespace toolcomp::fuzz {
namespace {

using spec::Decimal;

constexpr int kFanucDecimals = 4;
constexpr int kKlartextDecimals = 7;

std::uint64_t power_of_ten(int exponent) {
  std::uint64_t power = 1;
  for (; exponent > 0; --exponent) power *= 10;
  return power;
}

bool is_measure(spec::ParameterId id) {
  const spec::ParameterInfo* const info = spec::find_parameter(id);
  return info != nullptr && (info->type == spec::ParameterType::length || info->type == spec::ParameterType::angle ||
                             info->type == spec::ParameterType::decimal);
}

// Calls visit(name, number) for every number of a setup that may vary, always in the same order.
template <class Visit>
void for_each_number(spec::Setup& setup, Visit visit) {
  const auto axes = [&](const std::string& name, spec::AxisTable& table) {
    for (auto& [axis, value] : table) visit(name + ' ' + axis, value);
  };
  for (auto& [number, entry] : setup.h) {
    visit("H" + std::to_string(number), entry.geometry);
    visit("wear of H" + std::to_string(number), entry.wear);
  }
  for (auto& [number, entry] : setup.d) {
    visit("D" + std::to_string(number), entry.geometry);
    visit("wear of D" + std::to_string(number), entry.wear);
  }
  for (auto& [id, value] : setup.parameters)
    if (is_measure(id)) visit("parameter " + spec::to_string(id), value);
  for (std::size_t i = 0; i < setup.workpiece.size(); ++i) axes("G" + std::to_string(54 + i), setup.workpiece.at(i));
  for (auto& [number, table] : setup.additional_workpiece) axes("G54.1 P" + std::to_string(number), table);
  axes("position", setup.position);
  for (auto& [number, table] : setup.reference) axes("reference " + std::to_string(number), table);
  axes("floating reference", setup.floating_reference);
  axes("measurement", setup.measurement);
  for (spec::ToolRow& tool : setup.tools) {
    const std::string of = " of tool " + std::to_string(tool.number / 10);
    visit("R" + of, tool.r);
    visit("R2" + of, tool.r2);
    visit("DL" + of, tool.dl);
    visit("DR" + of, tool.dr);
    visit("DR2" + of, tool.dr2);
    if (tool.l) visit("L" + of, *tool.l);
  }
  for (auto& [number, row] : setup.tcs) {
    const std::string of = " of correction " + std::to_string(number);
    visit("DL" + of, row.dl);
    visit("DR" + of, row.dr);
    visit("DR2" + of, row.dr2);
  }
  // Angles stay: they ascend.
  for (auto& [name, table] : setup.dr2_tables)
    for (auto& [angle, deviation] : table) visit("deviation of " + name, deviation);
}

constexpr std::array<std::string_view, 14> kFanucAddresses = {"X", "Y", "Z", "A", "B", "C", "U",
                                                              "V", "W", "I", "J", "K", "R", "Q"};
constexpr std::array<std::string_view, 22> kKlartextAddresses = {"X",  "Y",  "Z",  "A",  "B",  "C",  "U",  "V",
                                                                 "W",  "IX", "IY", "IZ", "IA", "IB", "IC", "NX",
                                                                 "NY", "NZ", "TX", "TY", "TZ", "DL"};

// Behind which letters a number is one that may vary.
bool is_address(std::string_view letters, spec::Control control) {
  if (control == spec::Control::fanuc) return std::ranges::find(kFanucAddresses, letters) != kFanucAddresses.end();
  return letters == "DR" || letters == "DR2" ||
         std::ranges::find(kKlartextAddresses, letters) != kKlartextAddresses.end();
}

// The end of the number that begins at `at`; `at` itself where none does.
std::size_t end_of_number(std::string_view text, std::size_t at) {
  std::size_t end = at;
  if (end < text.size() && (text[end] == '+' || text[end] == '-')) ++end;
  bool digit = false;
  bool point = false;
  for (; end < text.size(); ++end) {
    if (is_digit(text[end]))
      digit = true;
    else if ((text[end] == '.' || text[end] == ',') && !point)
      point = true;
    else
      break;
  }
  return digit ? end : at;
}

// Of the word that a number behind `at` would belong to: its letters, and the digit of DR2.
std::string_view address_before(std::string_view text, std::size_t at) {
  std::size_t begin = at;
  if (begin > 2 && text.substr(begin - 3, 3) == "DR2") --begin;
  while (begin > 0 && is_letter(text[begin - 1])) --begin;
  return text.substr(begin, at - begin);
}

}  // namespace

int usual_decimals(spec::Control control) {
  return control == spec::Control::fanuc ? kFanucDecimals : kKlartextDecimals;
}

Numbers::Numbers(spec::Case c) : case_(std::move(c)) {
  read_program();
  for_each_number(case_.setup, [this](std::string name, const Decimal& value) {
    names_.push_back(std::move(name));
    values_.push_back(value);
    lines_.push_back(0);
    whole_.push_back(false);
  });
}

void Numbers::read_program() {
  const std::string_view text = case_.program;
  const bool fanuc = case_.setup.control == spec::Control::fanuc;
  const bool counts = fanuc && !case_.setup.bit(3401, 0, true);
  std::size_t from = 0;
  bool comment = false;
  std::uint64_t line = 1;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '(' || text[at] == ';' || text[at] == '"') comment = true;
    if (text[at] == ')' || text[at] == '\n') comment = false;
    if (text[at] == '\n') ++line;
    if (comment || !is_letter(text[at])) continue;
    // "DR2+0.3": the digit belongs to the address.
    std::size_t begin = at + 1;
    if (text.substr(0, begin).ends_with("DR") && text.substr(begin, 1) == "2" && text.size() > begin + 1 &&
        (text[begin + 1] == '+' || text[begin + 1] == '-'))
      ++begin;
    const std::size_t end = end_of_number(text, begin);
    if (end == begin || !is_address(address_before(text, begin), case_.setup.control)) continue;
    std::string number(text.substr(begin, end - begin));
    std::ranges::replace(number, ',', '.');
    const auto value = spec::parse_decimal(number);
    if (!value) continue;
    text_.emplace_back(text.substr(from, begin - from));
    written_.emplace_back(text.substr(begin, end - begin));
    names_.emplace_back(address_before(text, begin));
    values_.push_back(*value);
    lines_.push_back(line);
    whole_.push_back(counts && !value->point);
    from = end;
    at = end - 1;
  }
  text_.emplace_back(text.substr(from));
}

spec::Case Numbers::with(const Point& values) const {
  spec::Case c = case_;
  c.program.clear();
  for (std::size_t i = 0; i < written_.size(); ++i) {
    c.program += text_[i];
    if (values[i] == values_[i])
      c.program += written_[i];
    else
      c.program += spec::to_string(values[i]);
  }
  c.program += text_.back();
  std::size_t i = written_.size();
  for_each_number(c.setup, [&](const std::string&, Decimal& value) { value = values[i++]; });
  return c;
}

std::optional<Decimal> moved(const Decimal& value, std::int64_t steps, int decimals) {
  const int scale = std::max<int>(decimals, value.decimals);
  const std::uint64_t most = power_of_ten(kSearchedDigits);
  if (scale >= kSearchedDigits || value.digits >= most) return std::nullopt;
  const std::uint64_t factor = power_of_ten(scale - value.decimals);
  if (value.digits >= most / factor) return std::nullopt;
  const auto magnitude = static_cast<std::int64_t>(value.digits * factor);
  const auto limit =
      static_cast<std::int64_t>(std::min(most - 1, kSearchedMagnitude * power_of_ten(std::min(scale, 11))));
  if (steps > 2 * limit || steps < -2 * limit) return std::nullopt;
  const std::int64_t sum = (value.negative ? -magnitude : magnitude) + steps;
  if (sum > limit || sum < -limit) return std::nullopt;
  Decimal result;
  result.negative = sum < 0;
  result.digits = static_cast<std::uint64_t>(sum < 0 ? -sum : sum);
  result.decimals = static_cast<std::uint8_t>(scale);
  while (result.decimals > 0 && result.digits % 10 == 0) {
    result.digits /= 10;
    --result.decimals;
  }
  result.point = value.point || result.decimals > 0;
  return result;
}

int finest(const Point& values) {
  int most = 0;
  for (const Decimal& value : values) most = std::max<int>(most, value.decimals);
  return most;
}

bool is_searched(const spec::Case& c) {
  if (static_cast<std::size_t>(std::ranges::count(c.program, '\n')) > kMostLines) return false;
  const Numbers numbers(c);
  return std::ranges::all_of(numbers.values(), [](const Decimal& value) { return moved(value, 0, 0).has_value(); });
}

}  // namespace toolcomp::fuzz
