// SPDX-License-Identifier: Apache-2.0
#include "spec/language/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

#include "spec/language/json_text.h"

namespace toolcomp::spec {
namespace {

constexpr std::size_t kLongestDouble = 400;  // 5e-324 without exponent needs 326 characters

void append(std::string& out, double value, std::chars_format format) {
  if (value == 0) {
    out += '0';
    return;
  }
  if (!std::isfinite(value)) {
    out += std::isnan(value) ? "\"nan\"" : value > 0 ? "\"inf\"" : "\"-inf\"";
    return;
  }
  std::array<char, kLongestDouble> text;
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value, format);
  out.append(text.data(), result.ptr);
}

std::size_t count_digits(std::string_view& text) {
  const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
  text.remove_prefix(count);
  return count;
}

bool take(std::string_view& text, std::string_view any_of) {
  if (text.empty() || any_of.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

// JSON admits no +, no leading zeros and no bare point.
bool is_json_number(std::string_view text) {
  if (!is_number_text(text) || text.front() == '+') return false;
  take(text, "-");
  const bool leading_zero = text.size() > 1 && text[0] == '0' && text[1] >= '0' && text[1] <= '9';
  const std::size_t point = text.find('.');
  const bool bare = point != std::string_view::npos &&
                    (point == 0 || point + 1 == text.size() || text[point + 1] < '0' || text[point + 1] > '9');
  return !leading_zero && !bare;
}

}  // namespace

void append_shortest(std::string& out, double value) {
  std::array<char, 32> text;
  if (value == 0 || !std::isfinite(value)) {
    append(out, value, std::chars_format::general);
    return;
  }
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  out.append(text.data(), result.ptr);
}

void append_shortest_fixed(std::string& out, double value) { append(out, value, std::chars_format::fixed); }

bool is_number_text(std::string_view text, bool exponent) {
  take(text, "+-");
  std::size_t digits = count_digits(text);
  if (take(text, ".")) digits += count_digits(text);
  if (digits == 0) return false;
  if (exponent && take(text, "eE")) {
    take(text, "+-");
    if (count_digits(text) == 0) return false;
  }
  return text.empty();
}

void append_number_text(std::string& out, const NumberText& value) {
  const bool alone = value.r.empty() && value.q.empty();
  if (alone && is_json_number(value.v)) {
    out += value.v;
    return;
  }
  if (!alone) out += "{\"v\":";
  append_json_string(out, value.v);
  if (!value.r.empty()) {
    out += ",\"r\":";
    append_json_string(out, value.r);
  }
  if (!value.q.empty()) {
    out += ",\"q\":";
    append_json_string(out, value.q);
  }
  if (!alone) out += '}';
}

}  // namespace toolcomp::spec
