// SPDX-License-Identifier: Apache-2.0
// Any bytes as a Klartext program: the reader ends, positions lie in the text, neither the size of the pieces it gets
// nor carriage returns matter, LN blocks read many at a time are the same blocks, and a block without alarm is read
// back from its own text: the blocks of calls apart, the order of which is then that of the text.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/targets/by_columns.h"
#include "fuzz/targets/pieces.h"
#include "fuzz/targets/worker.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/input_error.h"
#include "spec/language/line_columns.h"

namespace {

using namespace toolcomp::spec;
using klartext::Block;
using toolcomp::fuzz::require;

Setup setup_of(bool block_skip) {
  Setup setup;
  setup.control = Control::heidenhain;
  setup.axes = Axes("XYZABCUV");
  setup.block_skip = block_skip;
  setup.tcs[1] = {};
  setup.tcs[42] = {};
  return setup;
}

// All that counts of a block, as text.
struct Read {
  std::string text;  // canonical; empty with an alarm
  bool many_digits = false;
  std::optional<klartext::ReadAlarm> alarm;
  klartext::Statement statement{};
  std::optional<std::uint64_t> n;
  std::uint64_t line = 0;
  std::uint32_t column = 0;
};

bool is_call(const Read& block) {
  using klartext::Statement;
  return block.statement == Statement::label || block.statement == Statement::call_label ||
         block.statement == Statement::call_program || block.statement == Statement::program_return;
}

Read kept(const Block& block) {
  const bool moves =
      block.statement == klartext::Statement::line || block.statement == klartext::Statement::line_with_vectors;
  return {block.alarm ? "" : to_string(block),
          moves && !block.alarm && block.many_digits,
          block.alarm,
          block.statement,
          block.n,
          block.line,
          block.column};
}

bool same(const Read& a, const Read& b) {
  const bool alarms = a.alarm.has_value() == b.alarm.has_value() &&
                      (!a.alarm || (a.alarm->cause == b.alarm->cause && a.alarm->line == b.alarm->line &&
                                    a.alarm->column == b.alarm->column));
  return alarms && a.text == b.text && a.many_digits == b.many_digits && a.statement == b.statement && a.n == b.n &&
         a.line == b.line && a.column == b.column;
}

struct Outcome {
  std::vector<Read> blocks;
  std::string error;
  std::uint64_t error_line = 1;
  std::uint64_t error_column = 1;
};

Outcome read(std::unique_ptr<ByteSource> source, bool block_skip) {
  klartext::Reader reader(std::move(source), setup_of(block_skip), {.file = "p", .most_repeated = 500});
  Outcome outcome;
  Block block;
  try {
    while (reader.next(block)) outcome.blocks.push_back(kept(block));
  } catch (const InputError& error) {
    outcome.error = error.what();
    outcome.error_line = error.line();
    outcome.error_column = error.column();
  }
  require(!reader.next(block));
  return outcome;
}

bool same(const Outcome& a, const Outcome& b) {
  return a.error == b.error &&
         std::ranges::equal(a.blocks, b.blocks, [](const Read& x, const Read& y) { return same(x, y); });
}

// Bytes of every line, without its line feed.
std::vector<std::size_t> line_lengths(std::string_view text) {
  std::vector<std::size_t> lengths;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    lengths.push_back(end - start);
    start = end + 1;
  }
  return lengths;
}

void check_positions(const Outcome& outcome, std::string_view text) {
  const std::vector<std::size_t> lengths = line_lengths(text);
  const auto inside = [&](std::uint64_t line, std::uint64_t column) {
    return line >= 1 && line <= lengths.size() && column >= 1 && column <= lengths[line - 1] + 1;
  };
  require(inside(outcome.error_line, outcome.error_column));
  const bool calls = std::ranges::any_of(outcome.blocks, is_call);
  std::uint64_t line = 0;
  for (const Read& block : outcome.blocks) {
    require((calls || block.line > line) && block.line <= lengths.size());
    require(!block.alarm || (block.alarm->line >= block.line && inside(block.alarm->line, block.alarm->column)));
    line = block.line;
  }
}

// BEGIN PGM without alarm is the first block and END PGM the last one, so that all texts together are a program.
void read_back(const std::vector<Read>& blocks) {
  std::string text;
  std::vector<Read> sound;
  for (const Read& block : blocks) {
    if (block.alarm || is_call(block)) continue;
    sound.push_back(block);
    text += block.text + '\n';
  }
  const Outcome again = read(text_source(text), false);
  require(again.error.empty() && std::ranges::equal(again.blocks, sound, [](const Read& a, const Read& b) {
            return !a.alarm && a.text == b.text && a.many_digits == b.many_digits && a.n == b.n &&
                   a.statement == b.statement;
          }));
}

// A block again, of a line among columns.
bool is_line(const Block& block, const LineColumns& columns, std::size_t line) {
  const auto is = [&](const Decimal& value, std::size_t place, std::size_t places) {
    double whole = static_cast<double>(value.digits) * (value.negative ? -1 : 1);
    for (std::size_t i = value.decimals; i < places; ++i) whole *= 10;
    return (columns.words & place_bit(place)) != 0 && whole == columns.columns[place][line];
  };
  bool same = block.statement == klartext::Statement::line_with_vectors && !block.alarm && !block.many_digits &&
              block.line == columns.line + line && block.column == columns.column[line] &&
              block.n == (columns.numbered ? std::optional(columns.n[line]) : std::nullopt) && block.has_normal &&
              block.has_tool_vector == ((columns.words & place_bit(kToolVectorPlace)) != 0) &&
              block.radius == klartext::RadiusWord::none && block.feed == klartext::FeedWord::none &&
              block.functions == 0;
  for (std::size_t i = 0; i < 3; ++i)
    same = same && is(block.axis[i].number, word_place('X') + i, 6) && is(block.normal[i], kNormalPlace + i, 8) &&
           (!block.has_tool_vector || is(block.tool_vector[i], kToolVectorPlace + i, 8));
  return same;
}

// The same text with some of its blocks read as columns.
void read_by_columns(std::string_view text, bool block_skip, std::size_t pieces) {
  const Setup setup = setup_of(block_skip);
  const ReaderOptions options{.file = "p", .most_repeated = 500};
  klartext::Reader reader(std::make_unique<toolcomp::fuzz::Pieces>(text, pieces), setup, options);
  klartext::Reader blocks(text_source(text), setup, options);
  toolcomp::fuzz::read_by_columns<Block>(
      reader, blocks, 1 + pieces, [](const Block& a, const Block& b) { return same(kept(a), kept(b)); }, is_line);
}

std::string with_carriage_returns(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\n') result += '\r';
    result += c;
  }
  return result;
}

// The first byte chooses block skip and the size of the pieces.
void hold(std::string_view bytes) {
  if (bytes.empty()) return;
  const auto first = static_cast<unsigned char>(bytes[0]);
  const bool block_skip = (first & 1U) != 0;
  const std::string_view text = bytes.substr(1);
  const Outcome whole = read(text_source(text), block_skip);
  require(same(whole, read(std::make_unique<toolcomp::fuzz::Pieces>(text, 1 + first / 2U), block_skip)));
  require(same(whole, read(text_source(with_carriage_returns(text)), block_skip)));
  read_by_columns(text, block_skip, 1 + first / 2U);
  check_positions(whole, text);
  read_back(whole.blocks);
}

}  // namespace

TOOLCOMP_READER_TARGET("read_klartext", hold)
