// Any bytes as a FANUC program: the reader ends, the size of the pieces it gets does not matter, and a block without
// alarm is read back from its own text.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/targets/pieces.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/input_error.h"

namespace {

using namespace toolcomp::spec;

constexpr std::string_view kAxes = "XYZBC";

void require(bool holds) {
  if (!holds) std::abort();
}

struct Outcome {
  std::vector<Block> blocks;
  std::string error;
};

Outcome read(std::unique_ptr<ByteSource> source, bool block_skip) {
  ProgramReader reader(std::move(source), Axes(kAxes), {.file = "p", .block_skip = block_skip});
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
                      (!a.alarm || (a.alarm->number == b.alarm->number && a.alarm->column == b.alarm->column));
  return a.line == b.line && alarms && std::ranges::equal(a.words(), b.words(), {}, &Word::column, &Word::column);
}

void read_back(const Block& block) {
  const std::string text = to_string(block);
  const Outcome again = read(text_source(text), false);
  require(again.error.empty() && again.blocks.size() == 1 && !again.blocks[0].alarm && same(again.blocks[0], block));
}

}  // namespace

// The first byte chooses block skip and the size of the pieces.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const bool block_skip = (data[0] & 1U) != 0;
  // NOLINTNEXTLINE(*-reinterpret-cast): bytes as characters
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  const Outcome whole = read(text_source(text), block_skip);
  const Outcome pieces = read(std::make_unique<toolcomp::fuzz::Pieces>(text, 1 + data[0] / 2U), block_skip);
  require(whole.error == pieces.error && whole.blocks.size() == pieces.blocks.size());
  for (std::size_t i = 0; i < whole.blocks.size(); ++i) {
    require(same(whole.blocks[i], pieces.blocks[i]) && same_place(whole.blocks[i], pieces.blocks[i]));
    if (!whole.blocks[i].alarm) read_back(whole.blocks[i]);
  }
  return 0;
}
