// SPDX-License-Identifier: Apache-2.0
// Any bytes as a FANUC program: the reader ends, the size of the pieces it gets does not matter, and a block without
// alarm is read back from its own text.
#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/targets/pieces.h"
#include "fuzz/targets/worker.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/input_error.h"

namespace {

using namespace toolcomp::spec;
using toolcomp::fuzz::require;

constexpr std::string_view kAxes = "XYZBC";

struct Outcome {
  std::vector<Block> blocks;
  std::string error;
};

Outcome read(std::unique_ptr<ByteSource> source, bool block_skip) {
  ProgramReader reader(std::move(source), Axes(kAxes),
                       {.file = "p", .block_skip = block_skip, .called_program = {}, .most_repeated = 1000});
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

bool same(const Block& a, const Block& b) { return a.n == b.n && std::ranges::equal(a.words(), b.words()); }

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
  require(whole.error == pieces.error && whole.blocks.size() == pieces.blocks.size());
  for (std::size_t i = 0; i < whole.blocks.size(); ++i) {
    require(same(whole.blocks[i], pieces.blocks[i]) && same_place(whole.blocks[i], pieces.blocks[i]));
    if (!whole.blocks[i].alarm) read_back(whole.blocks[i]);
  }
}

}  // namespace

TOOLCOMP_READER_TARGET("read_program", hold)
