// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/recording.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include "spec/language/input_error.h"
#include "spec/language/printable.h"

namespace toolcomp::certify {
namespace {

// A line of nine axes is far shorter; a file without line ends must not fill the memory.
constexpr std::size_t kLongestLine = 1 << 16;
constexpr std::size_t kRead = 1 << 16;
constexpr double kInch = 25.4;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return out;
}

// Calls `each(field, column)` for every field; the column is that of its first character, from 1.
template <class Function>
void for_each_field(std::string_view line, char separator, Function each) {
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    std::size_t first = begin;
    while (first < end && is_blank(line[first])) ++first;
    each(trimmed(line.substr(begin, end - begin)), first + 1);
    if (end == line.size()) return;
    begin = end + 1;
  }
}

// A column's name, and the unit behind it: NAME, NAME_UNIT, NAME [UNIT], NAME (UNIT).
std::pair<std::string, std::string> name_and_unit(std::string_view field) {
  const std::string text = lower(field);
  const std::size_t at = text.find_first_of("_[(");
  if (at == std::string::npos) return {text, ""};
  std::string unit(trimmed(std::string_view(text).substr(at + 1)));
  if (text[at] != '_') {
    const char close = text[at] == '[' ? ']' : ')';
    if (unit.empty() || unit.back() != close) return {text, ""};
    unit = trimmed(std::string_view(unit).substr(0, unit.size() - 1));
  }
  // Behind a name without a unit no underline or bracket may stand.
  if (unit.empty()) return {text, ""};
  return {std::string(trimmed(std::string_view(text).substr(0, at))), unit};
}

struct Unit {
  std::string_view name;
  double scale;  // millimetres, degrees, seconds
};
constexpr std::array<Unit, 7> kLengths{
    {{"um", 0.001}, {"\xC2\xB5m", 0.001}, {"mm", 1}, {"m", 1000}, {"in", kInch}, {"inch", kInch}, {"inches", kInch}}};
constexpr std::array<Unit, 4> kAngles{{{"deg", 1}, {"degrees", 1}, {"\xC2\xB0", 1}, {"rad", 180 / std::numbers::pi}}};
constexpr std::array<Unit, 4> kTimes{{{"us", 0.000001}, {"\xC2\xB5s", 0.000001}, {"ms", 0.001}, {"s", 1}}};

template <std::size_t n>
std::optional<double> scale_of(const std::array<Unit, n>& units, std::string_view name) {
  const auto unit = std::ranges::find(units, name, &Unit::name);
  return unit == units.end() ? std::nullopt : std::optional(unit->scale);
}

// One of the last digit of a number: 0.001 for 1.250.
double last_digit(std::string_view text) {
  const std::size_t exponent_at = std::min(text.find_first_of("eE"), text.size());
  int exponent = 0;
  if (exponent_at < text.size()) {
    std::string_view digits = text.substr(exponent_at + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  }
  const std::size_t point = text.find('.');
  if (point < exponent_at) exponent -= static_cast<int>(exponent_at - point - 1);
  return std::pow(10.0, exponent);
}

}  // namespace

Recording::Recording(std::istream& stream, std::string file, const spec::Axes& axes, spec::Units units)
    : stream_(stream), file_(std::move(file)) {
  read_header(axes, units);
}

void Recording::fail(std::size_t column, const std::string& what) const {
  throw spec::InputError(file_, line_, column, what);
}

bool Recording::fill() {
  buffer_.resize(kRead);
  const std::streamsize size = stream_.rdbuf()->sgetn(buffer_.data(), static_cast<std::streamsize>(kRead));
  buffer_.resize(static_cast<std::size_t>(std::max<std::streamsize>(size, 0)));
  begin_ = 0;
  return !buffer_.empty();
}

bool Recording::next_line() {
  text_.clear();
  bool any = false;
  while (begin_ < buffer_.size() || fill()) {
    if (!any) ++line_;
    any = true;
    const std::size_t line_end = buffer_.find('\n', begin_);
    const std::size_t end = std::min(line_end, buffer_.size());
    text_.append(buffer_, begin_, end - begin_);
    begin_ = line_end == std::string::npos ? end : end + 1;
    if (text_.size() > kLongestLine) fail(kLongestLine + 1, "a line of more than 65536 bytes");
    if (line_end != std::string::npos) break;
  }
  if (const std::size_t nul = text_.find('\0'); nul != std::string::npos)
    fail(nul + 1, "a NUL byte: this is not a text file");
  if (!text_.empty() && text_.back() == '\r') text_.pop_back();
  return any;
}

char Recording::separator() const {
  const std::size_t first = text_.find_first_of(",;\t");
  if (first == std::string::npos) return ',';
  // A tab beside another separator is a blank.
  if (text_[first] == '\t') {
    const std::size_t other = text_.find_first_of(",;");
    if (other == std::string::npos) return '\t';
    return text_[other];
  }
  if (const std::size_t second = text_.find(text_[first] == ',' ? ';' : ','); second != std::string::npos)
    fail(second + 1, "columns must be separated by one of comma, semicolon and tab");
  return text_[first];
}

Recording::Column Recording::column(std::string_view field, std::size_t at, const spec::Axes& axes,
                                    spec::Units units) const {
  const auto [name, unit] = name_and_unit(field);
  if (name == "time" || name == "t") {
    const auto scale = unit.empty() ? 1.0 : scale_of(kTimes, unit);
    if (!scale) fail(at, "expected time in us, ms or s, found \"" + unit + "\"");
    return {kTime, *scale};
  }
  const char letter = name.size() == 1 && name[0] >= 'a' && name[0] <= 'z' ? static_cast<char>(name[0] - 32) : '\0';
  const std::size_t index = letter == '\0' ? spec::Axes::kNone : axes.index(letter);
  if (index == spec::Axes::kNone)
    fail(at, "expected time or an axis of the setup (" + axes.letters() + "), found \"" + std::string(field) + "\"");
  if (unit.empty()) return {index, 1};
  const bool rotary = spec::is_rotary_axis(letter);
  const auto scale = rotary ? scale_of(kAngles, unit) : scale_of(kLengths, unit);
  if (!scale)
    fail(at, std::string(1, letter) + " is in " + (rotary ? "deg or rad" : "um, mm, m or in") + ", not in \"" + unit +
                 "\"");
  return {index, !rotary && units == spec::Units::inch ? *scale / kInch : *scale};
}

void Recording::read_header(const spec::Axes& axes, spec::Units units) {
  do {
    if (!next_line()) {
      line_ = std::max<std::uint64_t>(line_, 1);
      fail(1, "no header: the first line must name the columns, as in time,X,Y,Z");
    }
    if (line_ == 1 && text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
  } while (trimmed(text_).empty() || trimmed(text_).front() == '#');
  separator_ = separator();
  for_each_field(text_, separator_, [&](std::string_view field, std::size_t at) {
    const Column read = column(field, at, axes, units);
    if (std::ranges::find(columns_, read.index, &Column::index) != columns_.end())
      fail(at, read.index == kTime ? "time occurs twice"
                                   : "axis " + std::string(1, axes.letter(read.index)) + " occurs twice");
    columns_.push_back(read);
    if (read.index == kTime)
      has_time_ = true;
    else
      recorded_.push_back(read.index);
  });
  if (recorded_.empty()) fail(1, "no axis is recorded");
}

double Recording::number(std::string_view text, std::size_t column) const {
  double value = 0;
  std::string_view digits = text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  const auto [rest, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || rest != digits.data() + digits.size() || !std::isfinite(value))
    fail(column, text.empty() ? std::string("a number is missing") : "\"" + std::string(text) + "\" is not a number");
  return value;
}

void Recording::take_time(RecordedSample& sample, double seconds, double scale, std::string_view text,
                          std::size_t column) {
  if (time_ && seconds < *time_) fail(column, "time runs backwards");
  time_ = seconds;
  sample.time = seconds;
  sample.resolution = last_digit(text) * scale;
}

bool Recording::next(RecordedSample& sample) {
  do {
    if (!next_line()) return false;
  } while (trimmed(text_).empty() || trimmed(text_).front() == '#');
  sample.line = line_;
  std::size_t index = 0;
  for_each_field(text_, separator_, [&](std::string_view field, std::size_t at) {
    if (index == columns_.size()) fail(at, "more values than columns");
    const Column& column = columns_[index++];
    const double value = number(field, at) * column.scale;
    if (!(std::fabs(value) <= (column.index == kTime ? kLatest : kFarthest)))
      fail(at, spec::printable(field) +
                   (column.index == kTime ? " is more than 1e12 s" : " is beyond 1e9, the limit of a position"));
    if (column.index == kTime)
      take_time(sample, value, column.scale, field, at);
    else
      sample.at[column.index] = value;
  });
  if (index < columns_.size()) fail(text_.size() + 1, "fewer values than columns");
  return true;
}

}  // namespace toolcomp::certify
