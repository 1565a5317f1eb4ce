// SPDX-License-Identifier: Apache-2.0
// The lines, one letter first: those of the keys in spec/parameters.toml (u inch   v), which stand for what is not the
// default, and
//   a LETTERS (axes)   p NUMBER[#BIT] VALUE   m a|b|c COUNT   h NUMBER GEOMETRY WEAR   d NUMBER GEOMETRY WEAR
//   w 54…59 AXIS VALUE   o AXIS VALUE (position)   r 1…4 AXIS VALUE   f AXIS VALUE (floating reference)
//   b CAUSE NUMBER (alarms)   t AXIS VALUE (measurement)   n COUNT (samples)
// of a Heidenhain control its keys, a, o, and
//   c heidenhain (before all others)   y TENTHS R R2 DL DR DR2 [L] (a tool)   e NAME (of the tool before)   g NAME (its
//   table of deviations)   j NUMBER DL DR DR2 (a row of corrections)   q ANGLE DEVIATION NAME (a point of that table)
// The registry's generator (spec/parameters/keys.cpp) keeps these letters from the keys.
#include "fuzz/gen/encode.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <tuple>
#include "judge/oracle/number.h"
#include "spec/language/alarm.h"
#include "spec/language/parameter.h"
#include "spec/language/setup_key.h"

namespace toolcomp::fuzz {
namespace {

using spec::AxisTable;
using spec::Decimal;
using spec::Setup;

constexpr std::string_view kProgram = "%%\n";
constexpr std::string_view kDefaultAxes = "XYZ";
constexpr std::uint32_t kDefaultCount = 400;
constexpr std::uint32_t kFirstWorkpiece = 54;
constexpr std::uint32_t kExternalWorkpiece = 100;  // 101 is G54.1 P1
constexpr std::uint32_t kMostSamples = 64;         // of a fuzzed case

constexpr std::size_t kLongestName = 32;

// The words of a line, at most eight, and what stands from each of them on.
struct Line {
  std::array<std::string_view, 8> word;
  std::array<std::string_view, 8> from;

  explicit Line(std::string_view text) {
    for (std::size_t i = 0; i < word.size(); ++i) {
      const std::size_t space = text.find(' ');
      from.at(i) = text;
      word.at(i) = text.substr(0, space);
      text = space == std::string_view::npos ? std::string_view() : text.substr(space + 1);
    }
  }
};

std::optional<std::uint32_t> whole(std::string_view text, std::uint32_t most) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value > most) return std::nullopt;
  return value;
}

bool is_axis(char c) { return spec::is_linear_axis(c) || spec::is_rotary_axis(c); }

void put(AxisTable& table, std::string_view axis, std::string_view value) {
  const auto number = spec::parse_decimal(value);
  if (axis.size() == 1 && is_axis(axis[0]) && number) table[axis[0]] = *number;
}

void put(std::map<std::uint32_t, spec::OffsetEntry>& memory, const Line& line) {
  constexpr std::uint32_t most = 999;
  const auto number = whole(line.word[1], most);
  const auto geometry = spec::parse_decimal(line.word[2]);
  const auto wear = spec::parse_decimal(line.word[3]);
  if (number && *number > 0 && geometry) memory[*number] = {*geometry, wear.value_or(Decimal{})};
}

void put_parameter(Setup& setup, const Line& line) {
  constexpr std::uint32_t most = 99'999;
  const std::size_t mark = line.word[1].find('#');
  const auto number = whole(line.word[1].substr(0, mark), most);
  const auto value = spec::parse_decimal(line.word[2]);
  if (!number || !value) return;
  spec::ParameterId id{*number, -1};
  if (mark != std::string_view::npos) {
    const auto bit = whole(line.word[1].substr(mark + 1), 7);
    if (!bit) return;
    id.bit = static_cast<int>(*bit);
  }
  if (spec::is_known(id)) setup.parameters[id] = *value;
}

bool all_different_axes(std::string_view letters) {
  if (letters.empty() || letters.size() > spec::kMaxAxes) return false;
  for (std::size_t i = 0; i < letters.size(); ++i)
    if (!is_axis(letters[i]) || letters.find(letters[i], i + 1) != std::string_view::npos) return false;
  return true;
}

// Numbers of the words from `first` on; nothing where one is none.
template <std::size_t N>
std::optional<std::array<Decimal, N>> decimals(const Line& line, std::size_t first) {
  std::array<Decimal, N> values{};
  for (std::size_t i = 0; i < N; ++i) {
    const auto value = spec::parse_decimal(line.word.at(first + i));
    if (!value) return std::nullopt;
    values.at(i) = *value;
  }
  return values;
}

void put_tool(Setup& setup, const Line& line) {
  constexpr std::uint32_t least = 10;
  constexpr std::uint32_t most = 327'679;
  const auto tenths = whole(line.word[1], most);
  const auto values = decimals<5>(line, 2);
  if (!tenths || *tenths < least || !values) return;
  if (std::ranges::find(setup.tools, *tenths, &spec::ToolRow::number) != setup.tools.end()) return;
  spec::ToolRow& row = setup.tools.emplace_back();
  row.number = *tenths;
  std::tie(row.r, row.r2, row.dl, row.dr, row.dr2) = std::tuple_cat(*values);
  row.l = spec::parse_decimal(line.word[7]);
}

void name_tool(Setup& setup, std::string_view name) {
  const bool fits = !setup.tools.empty() && name.size() <= kLongestName;
  if (fits && std::ranges::find(setup.tools, name, &spec::ToolRow::name) == setup.tools.end())
    setup.tools.back().name = name;
}

void put_correction(Setup& setup, const Line& line) {
  constexpr std::uint32_t most = 999'999'999;
  const auto number = whole(line.word[1], most);
  if (const auto values = decimals<3>(line, 2); number && values)
    setup.tcs[*number] = {(*values)[0], (*values)[1], (*values)[2]};
}

// Ascending from 0 to 180 degrees, with a gap that doubles see.
void put_deviation(Setup& setup, const Line& line) {
  constexpr double half_turn = 180;
  constexpr double gap = 1.0 / 1'000'000'000;
  const auto values = decimals<2>(line, 1);
  const std::string_view name = line.from[3];
  if (!values || name.empty() || judge::approximate((*values)[0]) < 0 || judge::approximate((*values)[0]) > half_turn)
    return;
  spec::DeviationTable& table = setup.dr2_tables[std::string(name)];
  if (table.empty() || judge::approximate((*values)[0]) > judge::approximate(table.back().first) + gap)
    table.emplace_back((*values)[0], (*values)[1]);
}

// What no setup of this control has is left out.
void make_possible(Setup& setup) {
  if (setup.control != spec::Control::heidenhain) return;
  for (const char letter : kDefaultAxes)
    if (!setup.axes.has(letter)) setup.axes = spec::Axes(kDefaultAxes);
  std::erase_if(setup.position, [&](const auto& entry) { return !setup.axes.has(entry.first); });
  for (spec::ToolRow& tool : setup.tools)
    if (!setup.dr2_tables.contains(tool.dr2_table)) tool.dr2_table.clear();
}

// The place of the line's letter in a list of them.
std::optional<std::size_t> place_in(std::string_view letters, const Line& line) {
  const std::string_view first = line.word[1];
  const std::size_t at = first.size() == 1 ? letters.find(first[0]) : std::string_view::npos;
  return at == std::string_view::npos ? std::nullopt : std::optional(at);
}

void put_workpiece(Setup& setup, const Line& line) {
  const auto n = whole(line.word[1], kExternalWorkpiece + spec::kAdditionalWorkpieces);
  if (!n || *n < kFirstWorkpiece) return;
  if (*n < kFirstWorkpiece + setup.workpiece.size()) {
    put(setup.workpiece.at(*n - kFirstWorkpiece), line.word[2], line.word[3]);
  } else if (*n >= kExternalWorkpiece) {
    AxisTable& table = setup.additional_workpiece[*n - kExternalWorkpiece];
    put(table, line.word[2], line.word[3]);
    if (table.empty()) setup.additional_workpiece.erase(*n - kExternalWorkpiece);
  }
}

void apply_to_fanuc(Setup& setup, const Line& line) {
  const std::string_view first = line.word[1];
  switch (line.word[0][0]) {
    case 'p':
      put_parameter(setup, line);
      break;
    case 'm':
      if (const auto at = place_in("abc", line)) setup.memory = static_cast<spec::OffsetMemory>(*at);
      setup.offset_count = std::max(1U, whole(line.word[2], 999).value_or(kDefaultCount));
      break;
    case 'h':
      put(setup.h, line);
      break;
    case 'd':
      put(setup.d, line);
      break;
    case 'w':
      put_workpiece(setup, line);
      break;
    case 'r':
      if (const auto n = whole(first, 4); n && *n > 0) {
        AxisTable& point = setup.reference[static_cast<int>(*n)];
        put(point, line.word[2], line.word[3]);
        if (point.empty()) setup.reference.erase(static_cast<int>(*n));
      }
      break;
    case 'f':
      put(setup.floating_reference, first, line.word[2]);
      break;
    case 't':
      put(setup.measurement, first, line.word[2]);
      break;
    default:
      break;
  }
}

void apply_to_heidenhain(Setup& setup, const Line& line) {
  switch (line.word[0][0]) {
    case 'y':
      put_tool(setup, line);
      break;
    case 'e':
      name_tool(setup, line.from[1]);
      break;
    case 'g':
      if (!setup.tools.empty()) setup.tools.back().dr2_table = line.from[1];
      break;
    case 'j':
      put_correction(setup, line);
      break;
    case 'q':
      put_deviation(setup, line);
      break;
    default:
      break;
  }
}

// Of two values without words a letter means the one that is not the default.
void put_key(Setup& setup, const spec::KeyInfo& key, const Line& line) {
  const auto word = std::ranges::find(key.words, line.word[1]);
  if (key.words.empty())
    key.set(setup, 1 - key.default_value);
  else if (word != key.words.end())
    key.set(setup, static_cast<std::size_t>(word - key.words.begin()));
}

void apply(Setup& setup, const Line& line) {
  if (line.word[0].size() != 1) return;
  const auto key = std::ranges::find(spec::keys(), line.word[0][0], &spec::KeyInfo::letter);
  if (key != spec::keys().end()) {
    if (key->is_of(setup.control)) put_key(setup, *key, line);
    return;
  }
  const std::string_view first = line.word[1];
  switch (line.word[0][0]) {
    case 'a':
      if (all_different_axes(first)) setup.axes = spec::Axes(first);
      break;
    case 'b':
      if (const auto cause = spec::find_alarm(first); cause && spec::is_alarm_number(line.word[2]))
        setup.alarms[*cause] = line.word[2];
      break;
    case 'o':
      put(setup.position, first, line.word[2]);
      break;
    case 'c':
      setup = {};
      if (first == "heidenhain") setup.control = spec::Control::heidenhain;
      break;
    default:
      return setup.control == spec::Control::heidenhain ? apply_to_heidenhain(setup, line)
                                                        : apply_to_fanuc(setup, line);
  }
}

void add(std::string& out, std::string_view prefix, const AxisTable& table) {
  for (const auto& [axis, value] : table)
    fmt::format_to(std::back_inserter(out), "{} {} {}\n", prefix, axis, spec::to_string(value));
}

void add(std::string& out, char prefix, const std::map<std::uint32_t, spec::OffsetEntry>& memory) {
  for (const auto& [number, entry] : memory) {
    fmt::format_to(std::back_inserter(out), "{} {} {}", prefix, number, spec::to_string(entry.geometry));
    if (entry.wear != Decimal{}) out += " " + spec::to_string(entry.wear);
    out += '\n';
  }
}

void add_tools(std::string& out, const Setup& s) {
  const auto line = [&out](std::initializer_list<std::string> words) {
    for (const std::string& word : words) out += (out.empty() || out.back() == '\n' ? "" : " ") + word;
    out += '\n';
  };
  using spec::to_string;
  for (const spec::ToolRow& tool : s.tools) {
    line({"y", std::to_string(tool.number), to_string(tool.r), to_string(tool.r2), to_string(tool.dl),
          to_string(tool.dr), to_string(tool.dr2), tool.l ? to_string(*tool.l) : std::string("-")});
    if (!tool.name.empty()) line({"e", tool.name});
    if (!tool.dr2_table.empty()) line({"g", tool.dr2_table});
  }
  for (const auto& [number, row] : s.tcs)
    line({"j", std::to_string(number), to_string(row.dl), to_string(row.dr), to_string(row.dr2)});
  for (const auto& [name, points] : s.dr2_tables)
    for (const auto& [angle, deviation] : points) line({"q", to_string(angle), to_string(deviation), name});
}

}  // namespace

std::string encode(const spec::Case& c) {
  const Setup& s = c.setup;
  std::string out;
  if (s.control == spec::Control::heidenhain) out += "c heidenhain\n";
  if (s.axes.letters() != kDefaultAxes) out += fmt::format("a {}\n", s.axes.letters());
  for (const spec::KeyInfo& key : spec::keys())
    if (!key.is_default(s))
      out += key.words.empty() ? fmt::format("{}\n", key.letter)
                               : fmt::format("{} {}\n", key.letter, key.words[key.get(s)]);
  for (const auto& [id, value] : s.parameters)
    out += id.bit < 0 ? fmt::format("p {} {}\n", id.number, spec::to_string(value))
                      : fmt::format("p {}#{} {}\n", id.number, id.bit, spec::to_string(value));
  for (const auto& [cause, shown] : s.alarms) out += fmt::format("b {} {}\n", info(cause).name, shown);
  if (s.memory != spec::OffsetMemory::a || s.offset_count != kDefaultCount)
    out += fmt::format("m {} {}\n", "abc"[static_cast<int>(s.memory)], s.offset_count);
  add(out, 'h', s.h);
  add(out, 'd', s.d);
  for (std::uint32_t i = 0; i < s.workpiece.size(); ++i)
    add(out, fmt::format("w {}", kFirstWorkpiece + i), s.workpiece.at(i));
  for (const auto& [number, table] : s.additional_workpiece)
    add(out, fmt::format("w {}", kExternalWorkpiece + number), table);
  add(out, "o", s.position);
  for (const auto& [number, table] : s.reference) add(out, fmt::format("r {}", number), table);
  add(out, "f", s.floating_reference);
  add(out, "t", s.measurement);
  add_tools(out, s);
  if (c.samples != 0) out += fmt::format("n {}\n", c.samples);
  out += kProgram;
  out += c.program;
  return out;
}

spec::Case decode(std::string_view section, std::string_view bytes) {
  spec::Case c;
  c.section = section;
  while (!bytes.empty() && !bytes.starts_with(kProgram)) {
    const std::size_t end = bytes.find('\n');
    const Line line(bytes.substr(0, end));
    if (line.word[0] == "n")
      c.samples = whole(line.word[1], kMostSamples).value_or(0);
    else
      apply(c.setup, line);
    bytes = end == std::string_view::npos ? std::string_view() : bytes.substr(end + 1);
  }
  if (!bytes.empty()) c.program = bytes.substr(kProgram.size());
  make_possible(c.setup);
  if (c.setup.control == spec::Control::heidenhain) {
    c.dialect = "klartext";
    c.samples = 0;
  }
  return c;
}

}  // namespace toolcomp::fuzz
