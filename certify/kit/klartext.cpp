// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/klartext.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "spec/language/byte_source.h"
#include "spec/language/decimal_order.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::kit {
namespace {

using spec::klartext::Block;
using spec::klartext::Statement;

constexpr std::array<std::uint16_t, 4> kFunctions = {107, 108, 128, 129};

bool only_ends(const Block& block) {
  return block.statement == Statement::miscellaneous && block.functions == 1 &&
         (block.function[0] == 2 || block.function[0] == 30);
}

std::string refuse_functions(const Block& block) {
  const bool may_move = block.statement == Statement::line || block.statement == Statement::line_with_vectors ||
                        block.statement == Statement::stop || block.statement == Statement::miscellaneous;
  if (!may_move) return {};
  if (block.statement == Statement::stop) return "a stop inside it would look like a mark";
  for (std::size_t i = 0; i < block.functions; ++i)
    if (std::ranges::find(kFunctions, block.function.at(i)) == kFunctions.end())
      return "M functions may start something that is not safe on an empty machine";
  return {};
}

std::string refuse_feed(const Block& block) {
  using enum spec::klartext::FeedWord;
  const bool has_feed = block.statement == Statement::line || block.statement == Statement::line_with_vectors ||
                        block.statement == Statement::tool_call;
  if (!has_feed || block.feed == none || block.feed == f_max) return {};
  if (block.feed != f) return "a feed per tooth or per revolution, or the feed of the tool call";
  const spec::Decimal& value = block.feed_value.number;
  const spec::Decimal most = spec::decimal(10000);
  if (block.feed_value.parameter.kind != spec::klartext::ParameterKind::none) return "a feed given by a parameter";
  const bool fits = !value.negative && !value.is_zero() && spec::compare(value, most) != std::strong_ordering::greater;
  return fits ? "" : "a feed of 0 or below, or above 10000";
}

// The model does not say where rotary axes stand, so only words that do may go.
std::string refuse_rotary(const Machine& machine, const Block& block) {
  if (block.statement != Statement::line) return {};
  for (std::size_t slot = 0; slot < spec::klartext::kAxisLetters.size(); ++slot) {
    const char axis = spec::klartext::kAxisLetters[slot];
    if (!block.has_axis(slot) || !spec::is_rotary_axis(axis)) continue;
    const spec::klartext::Value& value = block.axis.at(slot);
    if (block.is_incremental(slot) || value.parameter.kind != spec::klartext::ParameterKind::none)
      return "a rotary axis moves by an increment or by a parameter";
    const auto travel = machine.travels.find(axis);
    const bool inside = travel != machine.travels.end() &&
                        spec::compare(value.number, travel->second.least) != std::strong_ordering::less &&
                        spec::compare(value.number, travel->second.greatest) != std::strong_ordering::greater;
    if (!inside) return "outside the travels";
  }
  return {};
}

std::string refuse(const Machine& machine, const Block& block) {
  if (block.alarm) return "a block that cannot be read, or names an axis that the machine does not have";
  switch (block.statement) {
    case Statement::begin_program:
    case Statement::end_program:
      return block.unit == machine.setup.units ? "" : "a program in units other than those of the machine";
    case Statement::tool_definition:
      return "TOOL DEF defines its own tool";
    case Statement::select_corrections:
    case Statement::correction_row:
      return "compensation tables are not part of a kit";
    case Statement::plane:
      return "PLANE tilts the working plane";
    case Statement::cycle:
      if (block.cycle != 7) return "a cycle other than the datum shift";
      break;
    case Statement::tool_call:
      if (block.tool == spec::klartext::ToolWord::string_parameter) return "a tool given by a string parameter";
      break;
    default:
      break;
  }
  if ((block.statement == Statement::line || block.statement == Statement::line_with_vectors) && block.many_digits)
    return "more digits than the control accepts";
  if (std::string why = refuse_functions(block); !why.empty()) return why;
  if (std::string why = refuse_rotary(machine, block); !why.empty()) return why;
  return refuse_feed(block);
}

// No number begins with its point.
std::string with_zeros(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '.' && (out.empty() || out.back() < '0' || out.back() > '9')) out += '0';
    out += c;
  }
  return out;
}

std::string number(const spec::Decimal& value) { return with_zeros(spec::to_string(value)); }

// The row that the call names; nullptr where the table has none.
const spec::ToolRow* called(const std::vector<spec::ToolRow>& tools, const Block& block) {
  using enum spec::klartext::ToolWord;
  if (block.statement != Statement::tool_call || block.tool == none) return nullptr;
  const auto row = std::ranges::find_if(tools, [&](const spec::ToolRow& tool) {
    return block.tool == name ? tool.name == block.tool_name.view() : tool.number == block.tool_number;
  });
  return row == tools.end() ? nullptr : &*row;
}

bool alike(spec::ToolRow a, const spec::ToolRow& b) {
  a.number = b.number;
  a.name = b.name;
  return a == b;
}

}  // namespace

ScreenedKlartext screen_klartext(const Machine& machine, const spec::Case& vector) {
  if (std::ranges::find(vector.flags, "generated-unrestricted") != vector.flags.end())
    return {{}, "its words are random"};
  if (vector.program.find('/') != std::string::npos) return {{}, "it depends on the block skip switch of the panel"};
  const bool deviations =
      std::ranges::any_of(vector.setup.tools, [](const spec::ToolRow& tool) { return !tool.dr2_table.empty(); });
  if (deviations) return {{}, "a tool with a table of deviations"};
  ScreenedKlartext screened;
  try {
    spec::Setup setup = vector.setup;
    setup.axes = machine.setup.axes;
    spec::klartext::Reader reader(spec::text_source(vector.program), setup, {.file = vector.id});
    Block block;
    bool begins = false;
    while (reader.next(block)) {
      begins = begins || block.statement == Statement::begin_program;
      if (std::string why = only_ends(block) ? "" : refuse(machine, block); !why.empty()) return {{}, std::move(why)};
      block.n.reset();
      const bool frame = block.statement == Statement::begin_program || block.statement == Statement::end_program ||
                         block.statement == Statement::block_form;
      if (!frame) screened.statements.push_back(block);
    }
    if (!begins && vector.setup.units != machine.setup.units)
      return {{}, "a program in units other than those of the machine"};
  } catch (const spec::InputError& error) {
    return {{}, "its text cannot be read: " + error.message()};
  }
  Statements& statements = screened.statements;
  while (!statements.empty() && only_ends(statements.back())) statements.pop_back();
  if (std::ranges::any_of(statements, only_ends)) return {{}, "it ends before its last block"};
  if (statements.empty()) return {{}, "it has no block"};
  return screened;
}

bool ToolTable::take(const std::vector<spec::ToolRow>& tools, Statements& statements) {
  constexpr std::uint32_t kMostTools = 32767;
  std::map<std::uint32_t, std::uint32_t> numbers;  // of the case: of the table, in tenths
  std::set<std::uint32_t> taken;
  for (Block& block : statements) {
    const spec::ToolRow* const row = called(tools, block);
    if (row == nullptr) {
      const bool unknown = block.statement == Statement::tool_call && block.tool != spec::klartext::ToolWord::none &&
                           (block.tool == spec::klartext::ToolWord::name || block.tool_number != 0);
      if (!unknown) continue;
      block.tool = spec::klartext::ToolWord::number;
      block.tool_number = kMostTools * 10;
      continue;
    }
    if (!numbers.contains(row->number)) {
      auto entry = std::ranges::find_if(
          rows_, [&](const spec::ToolRow& other) { return alike(other, *row) && !taken.contains(other.number); });
      if (entry == rows_.end()) {
        if (first_ + rows_.size() >= kMostTools) return false;
        spec::ToolRow added = *row;
        added.name.clear();
        added.number = (first_ + static_cast<std::uint32_t>(rows_.size())) * 10;
        entry = rows_.insert(rows_.end(), added);
      }
      numbers[row->number] = entry->number;
      taken.insert(entry->number);
    }
    block.tool = spec::klartext::ToolWord::number;
    block.tool_number = numbers.at(row->number);
  }
  return true;
}

std::string klartext_of(const Block& statement) {
  std::string text;
  const std::string written = with_zeros(spec::klartext::to_string(statement));
  // DL, DR and DR2 with a sign, as a control writes them.
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (written[i] != ':') text += written[i];
    if (written[i] == ':' && (i + 1 == written.size() || written[i + 1] != '-')) text += '+';
  }
  if (statement.statement == Statement::cycle && statement.cycle_part == 0) text += " DATUM SHIFT";
  return text;
}

std::string tool_file(const std::vector<spec::ToolRow>& rows) {
  std::string text =
      "BEGIN TOOL.T MM\nT     NAME              L            R            R2           DL           DR  "
      "         DR2\n";
  for (const spec::ToolRow& row : rows)
    text += fmt::format("{:<5} {:<17} {:<12} {:<12} {:<12} {:<12} {:<12} {}\n", row.number / 10,
                        fmt::format("KIT{}", row.number / 10), row.l ? number(*row.l) : "+0", number(row.r),
                        number(row.r2), number(row.dl), number(row.dr), number(row.dr2));
  return text + "[END]\n";
}

}  // namespace toolcomp::certify::kit
