// SPDX-License-Identifier: Apache-2.0
// Any bytes as a FANUC program: the reader ends, the size of the pieces it gets does not matter, lines read many at a
// time are the same lines, and a block without alarm is read back from its own text.
#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/targets/by_columns.h"
#include "fuzz/targets/pieces.h"
#include "fuzz/targets/worker.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/input_error.h"
#include "spec/language/line_columns.h"

namespace {

using namespace toolcomp::spec;
using toolcomp::fuzz::require;

constexpr std::string_view kAxes = "XYZBC";

struct Outcome {
  std::vector<Block> blocks;
  std::string error;
};

bool same(const Block& a, const Block& b) { return a.n == b.n && std::ranges::equal(a.words(), b.words()); }

constexpr std::array<double, 7> kScale{1e6, 1e5, 1e4, 1e3, 1e2, 1e1, 1};
// A block again, of a line among columns. Its numbers are whole numbers of 10^-6.
bool is_line(const Block& block, const LineColumns& columns, std::size_t line) {
  const auto has_place = [&](const Word& word) {
    const auto value = static_cast<double>(word.value.digits) * (word.value.negative ? -1 : 1);
    if (word.address == 'G') return value == columns.code;
    return (columns.words & place_bit(word_place(word.address))) != 0 &&
           value * kScale[word.value.decimals] == columns.columns[word_place(word.address)][line];
  };
  return !block.alarm && block.size != 0 && block.line == columns.line + line &&
         block.n == (columns.numbered ? std::optional(columns.n[line]) : std::nullopt) &&
         block.word[0].column == columns.column[line] && std::ranges::all_of(block.words(), has_place);
}

ProgramReader reader_of(std::unique_ptr<ByteSource> source, bool block_skip) {
  return {std::move(source),
          Axes(kAxes),
          {.file = "p", .block_skip = block_skip, .called_program = {}, .most_repeated = 1000}};
}

// The same text with some of its lines read as columns.
void read_by_columns(std::string_view text, bool block_skip, std::size_t pieces) {
  ProgramReader reader = reader_of(std::make_unique<toolcomp::fuzz::Pieces>(text, pieces), block_skip);
  ProgramReader blocks = reader_of(text_source(text), block_skip);
  toolcomp::fuzz::read_by_columns<Block>(
      reader, blocks, 1 + pieces, [](const Block& a, const Block& b) { return same(a, b) && a.line == b.line; },
      is_line);
}

Outcome read(std::unique_ptr<ByteSource> source, bool block_skip) {
  ProgramReader reader = reader_of(std::move(source), block_skip);
  Outcome outcome;
  Block block;
  try {
    while (reader.next(block)) outcome.blocks.push_back(block);
  } catch (const InputError& error) {
    outcome.error = error.what();
  }
  require(!reader.next(block));
  return outcome;
}

bool same_place(const Block& a, const Block& b) {
  const bool alarms = a.alarm.has_value() == b.alarm.has_value() &&
                      (!a.alarm || (a.alarm->cause == b.alarm->cause && a.alarm->column == b.alarm->column));
  return a.line == b.line && alarms && std::ranges::equal(a.words(), b.words(), {}, &Word::column, &Word::column);
}

// M98 and M99 need the programs around them.
bool calls(const Block& block) {
  return std::ranges::any_of(block.words(), [](const Word& word) {
    return word.address == 'M' && (word.value.digits == 98 || word.value.digits == 99);
  });
}

void read_back(const Block& block) {
  if (calls(block)) return;
  const std::string text = to_string(block);
  const Outcome again = read(text_source(text), false);
  require(again.error.empty() && again.blocks.size() == 1 && !again.blocks[0].alarm && same(again.blocks[0], block));
}

// The first byte chooses block skip and the size of the pieces.
void hold(std::string_view bytes) {
  if (bytes.empty()) return;
  const auto first = static_cast<unsigned char>(bytes[0]);
  const bool block_skip = (first & 1U) != 0;
  const std::string_view text = bytes.substr(1);
  const Outcome whole = read(text_source(text), block_skip);
  const Outcome pieces = read(std::make_unique<toolcomp::fuzz::Pieces>(text, 1 + first / 2U), block_skip);
  read_by_columns(text, block_skip, 1 + first / 2U);
  require(whole.error == pieces.error && whole.blocks.size() == pieces.blocks.size());
  for (std::size_t i = 0; i < whole.blocks.size(); ++i) {
    require(same(whole.blocks[i], pieces.blocks[i]) && same_place(whole.blocks[i], pieces.blocks[i]));
    if (!whole.blocks[i].alarm) read_back(whole.blocks[i]);
  }
}

}  // namespace

TOOLCOMP_READER_TARGET("read_program", hold)
