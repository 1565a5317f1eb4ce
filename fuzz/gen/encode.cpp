// The lines, one letter first:
//   u mm|inch   i A|B|C   a LETTERS   k b|c   s (block skip)   x (type B without perpendicular)   p NUMBER[#BIT] VALUE
//   m a|b|c COUNT h NUMBER GEOMETRY WEAR   d NUMBER GEOMETRY WEAR   w 54…59 AXIS VALUE   o AXIS VALUE (position) r 1…4
//   AXIS VALUE   f AXIS VALUE (floating reference)   t AXIS VALUE (measurement)   n COUNT (samples)
#include "fuzz/gen/encode.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <optional>

namespace toolcomp::fuzz {
namespace {

using spec::AxisTable;
using spec::Decimal;
using spec::Setup;

constexpr std::string_view kProgram = "%%\n";
constexpr std::string_view kDefaultAxes = "XYZ";
constexpr std::uint32_t kDefaultCount = 400;
constexpr std::uint32_t kFirstWorkpiece = 54;
constexpr std::uint32_t kMostSamples = 64;  // of a fuzzed case

// The words of a line, at most four.
struct Line {
  std::array<std::string_view, 4> word;

  explicit Line(std::string_view text) {
    for (std::string_view& w : word) {
      const std::size_t space = text.find(' ');
      w = text.substr(0, space);
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
  setup.parameters[id] = *value;
}

bool all_different_axes(std::string_view letters) {
  if (letters.empty() || letters.size() > spec::kMaxAxes) return false;
  for (std::size_t i = 0; i < letters.size(); ++i)
    if (!is_axis(letters[i]) || letters.find(letters[i], i + 1) != std::string_view::npos) return false;
  return true;
}

void apply(Setup& setup, const Line& line) {
  if (line.word[0].size() != 1) return;
  const std::string_view first = line.word[1];
  const auto letter = [&](std::string_view letters) -> std::optional<std::size_t> {
    const std::size_t at = first.size() == 1 ? letters.find(first[0]) : std::string_view::npos;
    return at == std::string_view::npos ? std::nullopt : std::optional(at);
  };
  switch (line.word[0][0]) {
    case 'u':
      setup.units = first == "inch" ? spec::Units::inch : spec::Units::mm;
      break;
    case 'i':
      if (const auto at = letter("ABC")) setup.increment = static_cast<spec::IncrementSystem>(*at);
      break;
    case 'a':
      if (all_different_axes(first)) setup.axes = spec::Axes(first);
      break;
    case 'k':
      if (const auto at = letter("bc")) setup.cutter_compensation = static_cast<spec::CutterCompensationType>(*at);
      break;
    case 's':
      setup.block_skip = true;
      break;
    case 'x':
      setup.type_b_without_perpendicular = true;
      break;
    case 'p':
      put_parameter(setup, line);
      break;
    case 'm':
      if (const auto at = letter("abc")) setup.memory = static_cast<spec::OffsetMemory>(*at);
      setup.offset_count = std::max(1U, whole(line.word[2], 999).value_or(kDefaultCount));
      break;
    case 'h':
      put(setup.h, line);
      break;
    case 'd':
      put(setup.d, line);
      break;
    case 'w':
      if (const auto n = whole(first, kFirstWorkpiece + 5); n && *n >= kFirstWorkpiece)
        put(setup.workpiece.at(*n - kFirstWorkpiece), line.word[2], line.word[3]);
      break;
    case 'o':
      put(setup.position, first, line.word[2]);
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

}  // namespace

std::string encode(const spec::Case& c) {
  const Setup& s = c.setup;
  std::string out;
  if (s.units == spec::Units::inch) out += "u inch\n";
  if (s.increment != spec::IncrementSystem::is_b) out += fmt::format("i {}\n", "ABC"[static_cast<int>(s.increment)]);
  if (s.axes.letters() != kDefaultAxes) out += fmt::format("a {}\n", s.axes.letters());
  if (s.cutter_compensation == spec::CutterCompensationType::b) out += "k b\n";
  if (s.block_skip) out += "s\n";
  if (s.type_b_without_perpendicular) out += "x\n";
  for (const auto& [id, value] : s.parameters)
    out += id.bit < 0 ? fmt::format("p {} {}\n", id.number, spec::to_string(value))
                      : fmt::format("p {}#{} {}\n", id.number, id.bit, spec::to_string(value));
  if (s.memory != spec::OffsetMemory::a || s.offset_count != kDefaultCount)
    out += fmt::format("m {} {}\n", "abc"[static_cast<int>(s.memory)], s.offset_count);
  add(out, 'h', s.h);
  add(out, 'd', s.d);
  for (std::uint32_t i = 0; i < s.workpiece.size(); ++i)
    add(out, fmt::format("w {}", kFirstWorkpiece + i), s.workpiece.at(i));
  add(out, "o", s.position);
  for (const auto& [number, table] : s.reference) add(out, fmt::format("r {}", number), table);
  add(out, "f", s.floating_reference);
  add(out, "t", s.measurement);
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
  return c;
}

}  // namespace toolcomp::fuzz
