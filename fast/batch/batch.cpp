// SPDX-License-Identifier: Apache-2.0
#include "fast/batch/batch.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "fast/arrays/line_chunk.h"
#include "fast/arrays/line_moves.h"
#include "fast/arrays/words.h"
#include "fast/batch/dialect.h"

namespace toolcomp::fast {
namespace {

// The moves of blocks that go one by one, into the arrays.
class Collector final : public EventSink, public LineSink {
 public:
  Collector(std::size_t axes, EventSink* others) : moves(axes), others_(others) {}

  void on(const Event& event) override {
    if (event.kind != spec::EventKind::move) {
      if (others_ != nullptr) others_->on(event);
      return;
    }
    moves.reserve(1);
    for (std::size_t i = 0; i < moves.axes(); ++i)
      *moves.next_of(i) = event.axes.has(i) ? event.axes.value[i] : std::numeric_limits<double>::quiet_NaN();
    *moves.next_block() = event.line;
    moves.append(1);
  }
  void lines(LineMoves& made) override {
    moves.reserve(made.size);
    for (std::size_t i = 0; i < moves.axes(); ++i) {
      if ((made.moving >> i & 1U) != 0)
        std::copy_n(made.sent[i], made.size, moves.next_of(i));
      else
        moves.set_axis(i, made.size,
                       made.event.axes.has(i) ? made.event.axes.value[i] : std::numeric_limits<double>::quiet_NaN());
    }
    for (std::size_t i = 0; i < made.size; ++i) moves.next_block()[i] = made.line(i);
    moves.append(made.size);
  }
  Moves moves;

 private:
  EventSink* others_;
};

// Columns, judged.
struct Columns {
  std::size_t size = 0;
  std::uint32_t words = 0;
  std::array<const WordColumn*, kWordPlaces> at{};
};

[[noreturn]] void refuse(std::string_view what, const std::string& why) {
  throw std::invalid_argument(std::string(what) + ": " + why);
}

// LN blocks have X, Y, Z and whole vectors, none of them zero.
void judge_vectors(const Columns& all, Instructions by) {
  for (const std::size_t place : {kNormalPlace, kToolVectorPlace}) {
    const std::uint32_t named = all.words >> place & 0b111U;
    if (named == 0) continue;
    if (named != 0b111U || (all.words >> word_place('X') & 0b111U) != 0b111U)
      refuse("vectors", "X, Y, Z and all three components of the vector are needed");
    const WordColumn& x = *all.at[place];
    const WordColumn& y = *all.at[place + 1];
    const WordColumn& z = *all.at[place + 2];
    if (y.decimals != x.decimals || z.decimals != x.decimals)
      refuse(std::string(x.word) + ", " + std::string(y.word) + ", " + std::string(z.word),
             "these words must have the same number of decimals");
    const std::size_t zero =
        find_zero_vector(by, {x.values.data(), y.values.data(), z.values.data()}, all.size, x.decimals);
    if (zero < all.size) refuse(x.word, "the vector of value " + std::to_string(zero) + " is 0");
  }
}

std::string shortest(double value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

void judge_values(const WordColumn& column, std::size_t place, Instructions by) {
  const bool vector = place >= kNormalPlace;
  const double most = vector ? most_component(column.decimals) : kMostWord;
  if (are_within(by, column.values.data(), column.values.size(), most)) return;
  const auto bad = std::ranges::find_if_not(column.values, [&](double value) { return std::abs(value) <= most; });
  refuse(column.word, "value " + std::to_string(bad - column.values.begin()) + " is " + shortest(*bad) +
                          "; expected a number up to " + shortest(most));
}

Columns judged(std::span<const WordColumn> columns, const BlockMaker& maker, Instructions by) {
  Columns all;
  for (const WordColumn& column : columns) {
    const std::optional<std::size_t> place = maker.place_of(column.word);
    if (!place) refuse(column.word, "not a word of a line of this control");
    if (all.at[*place] != nullptr) refuse(column.word, "named twice");
    if (column.decimals > kMostPlaces) refuse(column.word, "more than " + std::to_string(kMostPlaces) + " decimals");
    if (column.values.size() != columns.front().values.size())
      refuse(column.word, std::to_string(column.values.size()) + " values, and " + std::string(columns.front().word) +
                              " has " + std::to_string(columns.front().values.size()));
    judge_values(column, *place, by);
    all.at[*place] = &column;
    all.words |= place_bit(*place);
  }
  if (!columns.empty()) all.size = columns.front().values.size();
  judge_vectors(all, by);
  return all;
}

}  // namespace

class Batch::Run {
 public:
  Run(const spec::Setup& setup, EventSink* others, Instructions instructions)
      : instructions_(instructions),
        collector_(setup.axes.size(), others),
        engine_(make_batch_engine(setup, collector_, &collector_)) {}

  void run(std::string_view text) { blocks_ += engine_->run(text, blocks_); }
  void lines(std::span<const WordColumn> given);
  void end() { engine_->end(); }
  [[nodiscard]] bool stopped() const { return engine_->stopped(); }
  [[nodiscard]] Moves& moves() { return collector_.moves; }
  [[nodiscard]] std::uint64_t blocks() const { return blocks_; }
  [[nodiscard]] std::uint64_t blocks_as_arrays() const { return as_arrays_; }

 private:
  // The words of some lines, scaled. False: one of them is too large for arrays.
  [[nodiscard]] bool scale(const Columns& columns, std::size_t from, std::size_t size);
  // One by one and as arrays.
  void take(const Columns& columns, std::size_t from, const LineChunk& chunk, bool usual);

  Instructions instructions_;
  Collector collector_;
  std::unique_ptr<BatchEngine> engine_;
  std::uint64_t blocks_ = 0;
  std::uint64_t as_arrays_ = 0;
  LineChunk::Columns whole_;
};

bool Batch::Run::scale(const Columns& columns, std::size_t from, std::size_t size) {
  bool usual = true;
  for (std::size_t place = 0; place < kWordPlaces; ++place) {
    if (columns.at[place] == nullptr) continue;
    const WordColumn& column = *columns.at[place];
    const bool vector = place >= kNormalPlace;
    const unsigned places = vector ? kVectorPlaces : kLengthPlaces;
    usual = usual && column.decimals <= places &&
            scale_words(instructions_, column.values.data() + from, size, column.decimals, places,
                        vector ? kMostVector : kMostLength, whole_[place].data());
  }
  return usual;
}

void Batch::Run::lines(std::span<const WordColumn> given) {
  const Columns columns = judged(given, engine_->maker(), instructions_);
  collector_.moves.reserve(columns.size + 1);
  for (std::size_t from = 0; from < columns.size && !stopped(); from += LineChunk::kMost) {
    LineChunk chunk;
    chunk.size = std::min(LineChunk::kMost, columns.size - from);
    chunk.words = columns.words;
    chunk.columns = &whole_;
    chunk.line = blocks_ + 1;
    chunk.instructions = instructions_;
    chunk.moves = &collector_.moves;
    take(columns, from, chunk, scale(columns, from, chunk.size));
    blocks_ += chunk.size;
  }
}

void Batch::Run::take(const Columns& columns, std::size_t from, const LineChunk& chunk, bool usual) {
  // Where lines are taken, more of them are tried at once.
  constexpr std::size_t kFewest = 8;
  std::size_t most = LineChunk::kMost;
  for (std::size_t i = 0; i < chunk.size && !stopped();) {
    if (usual) {
      const std::size_t tried = std::min(most, chunk.size - i);
      collector_.moves.reserve(tried);
      const std::size_t taken = engine_->lines(chunk.part(i, tried));
      as_arrays_ += taken;
      i += taken;
      most = taken == tried ? std::min(2 * most, LineChunk::kMost) : kFewest;
      if (taken == tried) continue;
    }
    BlockMaker& maker = engine_->maker();
    maker.begin(chunk.line + i, columns.words);
    for (std::size_t place = 0; place < kWordPlaces; ++place)
      if (const WordColumn* const column = columns.at[place])
        maker.set(place, word_of(column->values[from + i], column->decimals));
    engine_->block();
    ++i;
  }
}

Batch::Batch(const spec::Setup& setup, EventSink* others, Instructions instructions)
    : run_(std::make_unique<Run>(setup, others, instructions)) {}
Batch::~Batch() = default;
void Batch::run(std::string_view text) { run_->run(text); }
void Batch::lines(std::span<const WordColumn> columns) { run_->lines(columns); }
void Batch::end() { run_->end(); }
bool Batch::stopped() const { return run_->stopped(); }
Moves& Batch::moves() { return run_->moves(); }
std::uint64_t Batch::blocks() const { return run_->blocks(); }
std::uint64_t Batch::blocks_as_arrays() const { return run_->blocks_as_arrays(); }

}  // namespace toolcomp::fast
