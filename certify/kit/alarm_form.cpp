// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/alarm_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "spec/language/input_error.h"

namespace toolcomp::certify::kit {
namespace {

constexpr std::string_view kHeader = "program,alarm,block,note";
constexpr std::size_t kFields = 4;

std::optional<unsigned> whole_number(std::string_view text) {
  unsigned value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

// The number of "41", "PS41" and "PS0041".
std::optional<unsigned> alarm_number(std::string_view alarm) {
  if (alarm.starts_with("PS")) alarm.remove_prefix(2);
  return whole_number(alarm);
}

struct Field {
  std::string text;  // without blanks at its ends
  std::uint64_t column = 1;
};

// The first three commas divide; a note may hold more.
std::vector<Field> fields_on(std::string_view line) {
  std::vector<Field> fields;
  std::size_t begin = 0;
  while (true) {
    const std::size_t comma = fields.size() + 1 < kFields ? line.find(',', begin) : std::string_view::npos;
    std::size_t end = std::min(comma, line.size());
    std::size_t first = begin;
    while (first < end && line[first] == ' ') ++first;
    while (end > first && line[end - 1] == ' ') --end;
    fields.push_back({std::string(line.substr(first, end - first)), first + 1});
    if (comma == std::string_view::npos) return fields;
    begin = comma + 1;
  }
}

class FormReader {
 public:
  FormReader(std::string file, const Kit& kit) : file_(std::move(file)), kit_(kit) {}

  void take(std::string_view line) {
    ++line_;
    if (line_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line_ == 1) {
      if (line != kHeader) fail(1, fmt::format("the first line must be {}", kHeader));
      return;
    }
    if (line.find_first_not_of(" ,") == std::string_view::npos) return;
    const std::vector<Field> fields = fields_on(line);
    if (fields.size() != kFields) fail(line.size() + 1, "expected program, alarm, block and note");
    entry(fields);
  }

  std::vector<NotedAlarm> end() {
    if (line_ == 0) fail(1, fmt::format("the first line must be {}", kHeader));
    return std::move(noted_);
  }

 private:
  [[noreturn]] void fail(std::uint64_t column, const std::string& what) const {
    throw spec::InputError(file_, std::max<std::uint64_t>(line_, 1), column, what);
  }

  void entry(const std::vector<Field>& fields) {
    NotedAlarm noted;
    noted.line = line_;
    const std::string& program = fields[0].text;
    const auto number = whole_number(std::string_view(program).substr(program.starts_with('O') ? 1 : 0));
    const bool known = number && std::ranges::any_of(kit_.programs, [&](const KitProgram& p) {
                         return p.number == *number && !p.alarm.empty();
                       });
    if (!known) fail(fields[0].column, "\"" + program + "\" is not a program of this kit that ends in an alarm");
    noted.number = *number;
    if (std::ranges::find(noted_, noted.number, &NotedAlarm::number) != noted_.end())
      fail(fields[0].column, program + " is listed twice");
    noted.alarm = fields[1].text;
    std::ranges::transform(noted.alarm, noted.alarm.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    const bool is_name = noted.alarm.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789-") == std::string::npos;
    if (!is_name) fail(fields[1].column, "expected an alarm: a number, PS and a number, a name, or NONE");
    noted.block = fields[2].text;
    if (noted.block.starts_with('N')) noted.block.erase(0, 1);
    if (!noted.block.empty() && !whole_number(noted.block))
      fail(fields[2].column, "expected the sequence number of the block");
    noted_.push_back(std::move(noted));
  }

  std::string file_;
  const Kit& kit_;
  std::uint64_t line_ = 0;
  std::vector<NotedAlarm> noted_;
};

}  // namespace

std::string write_alarm_form(const Kit& kit) {
  std::string text(kHeader);
  text += '\n';
  for (const KitProgram& program : kit.programs)
    if (!program.alarm.empty()) text += program_name(kit.machine.setup.control, program.number) + ",,,\n";
  return text;
}

std::vector<NotedAlarm> read_alarm_form(std::string_view text, const std::string& file, const Kit& kit) {
  FormReader reader(file, kit);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    reader.take(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return reader.end();
}

AlarmVerdict judge_alarm(const KitProgram& program, const NotedAlarm& noted) {
  if (noted.alarm.empty()) return AlarmVerdict::not_noted;
  if (noted.alarm == "NONE") return AlarmVerdict::none_came;
  const auto expected = alarm_number(program.alarm);
  if (expected && alarm_number(noted.alarm) != expected) return AlarmVerdict::other_alarm;
  if (!noted.block.empty() && noted.block != std::to_string(program.alarm_n)) return AlarmVerdict::other_alarm;
  return AlarmVerdict::as_expected;
}

}  // namespace toolcomp::certify::kit
