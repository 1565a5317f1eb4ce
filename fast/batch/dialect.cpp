// SPDX-License-Identifier: Apache-2.0
#include "fast/batch/dialect.h"

#include <algorithm>
#include <utility>

#include "fast/arrays/line_road.h"
#include "fast/fanuc/engine.h"
#include "fast/heidenhain/engine.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/heidenhain/klartext_reader.h"

namespace toolcomp::fast {
namespace {

class FanucMaker final : public BlockMaker {
 public:
  explicit FanucMaker(spec::Axes axes) : axes_(std::move(axes)) {}

  // Words of a line: axes, I J K and the feed.
  [[nodiscard]] std::optional<std::size_t> place_of(std::string_view word) const override {
    if (word.size() != 1 || word[0] < 'A' || word[0] > 'Z') return std::nullopt;
    const bool known = axes_.has(word[0]) || word == "I" || word == "J" || word == "K" || word == "F";
    return known ? std::optional(word_place(word[0])) : std::nullopt;
  }
  void begin(std::uint64_t line, std::uint32_t /*words*/) override {
    made.line = line;
    made.n.reset();
    made.alarm.reset();
    made.size = 0;
  }
  void set(std::size_t place, const spec::Decimal& value) override {
    made.word[made.size++] = {static_cast<char>('A' + place), value, 0};
  }
  spec::Block made;

 private:
  const spec::Axes axes_;
};

class KlartextMaker final : public BlockMaker {
 public:
  explicit KlartextMaker(spec::Axes axes) : axes_(std::move(axes)) {}

  [[nodiscard]] std::optional<std::size_t> place_of(std::string_view word) const override {
    if (word.size() == 1 && spec::klartext::kAxisLetters.find(word[0]) != std::string_view::npos && axes_.has(word[0]))
      return word_place(word[0]);
    if (word.size() != 2 || word[1] < 'X' || word[1] > 'Z') return std::nullopt;
    const auto i = static_cast<std::size_t>(word[1] - 'X');
    if (word[0] == 'N') return kNormalPlace + i;
    if (word[0] == 'T') return kToolVectorPlace + i;
    return std::nullopt;
  }
  void begin(std::uint64_t line, std::uint32_t words) override {
    using spec::klartext::Statement;
    made = {};
    made.line = line;
    made.has_normal = (words >> kNormalPlace & 0b111U) != 0;
    made.has_tool_vector = (words >> kToolVectorPlace & 0b111U) != 0;
    made.statement = made.has_normal || made.has_tool_vector ? Statement::line_with_vectors : Statement::line;
  }
  void set(std::size_t place, const spec::Decimal& value) override {
    if (place >= kToolVectorPlace) {
      made.tool_vector[place - kToolVectorPlace] = value;
    } else if (place >= kNormalPlace) {
      made.normal[place - kNormalPlace] = value;
    } else {
      const std::size_t slot = spec::klartext::kAxisLetters.find(static_cast<char>('A' + place));
      made.axes = static_cast<std::uint16_t>(made.axes | 1U << slot);
      made.axis[slot] = {value, {}};
    }
  }
  spec::klartext::Block made;

 private:
  const spec::Axes axes_;
};

// A reader of a text that follows another one of so many lines.
template <class Reader>
struct LaterReader {
  Reader reader;
  std::uint64_t before = 0;

  template <class Block>
  bool next(Block& block) {
    if (!reader.next(block)) return false;
    block.line += before;
    return true;
  }
  void lines(spec::LineColumns& to, std::size_t most) {
    reader.lines(to, most);
    to.line += before;
  }
  void pass_lines(std::size_t count) { reader.pass_lines(count); }
};

// `Source`: the rest of what a reader is made of; `samples`: those of an engine that has them.
template <class Engine, class Reader, class Block, class Maker, class Source>
class EngineOf final : public BatchEngine {
 public:
  template <class... Samples>
  EngineOf(const spec::Setup& setup, EventSink& sink, LineSink* lines, Source source, Samples... samples)
      : maker_(setup.axes), engine_(setup, sink, samples...), source_(std::move(source)), road_(lines) {}

  std::uint64_t run(std::string_view text, std::uint64_t before) override {
    LaterReader<Reader> reader{Reader(spec::text_source(text), source_), before};
    Block block;
    road_.run(reader, engine_, block);
    return static_cast<std::uint64_t>(std::ranges::count(text, '\n')) + (text.ends_with('\n') || text.empty() ? 0 : 1);
  }
  BlockMaker& maker() override { return maker_; }
  void block() override { engine_.block(maker_.made); }
  std::size_t lines(const LineChunk& chunk) override { return engine_.lines(chunk); }
  void end() override { engine_.end(); }
  [[nodiscard]] bool stopped() const override { return engine_.stopped(); }

 private:
  Maker maker_;
  Engine engine_;
  Source source_;
  LineRoad road_;
};

using FanucEngine = EngineOf<Engine, spec::ProgramReader, spec::Block, FanucMaker, spec::Axes>;
using KlartextEngine =
    EngineOf<klartext::Engine, spec::klartext::Reader, spec::klartext::Block, KlartextMaker, spec::Setup>;

}  // namespace

std::unique_ptr<BatchEngine> make_batch_engine(const spec::Setup& setup, EventSink& sink, LineSink* lines,
                                               std::uint32_t samples) {
  if (setup.control == spec::Control::heidenhain) return std::make_unique<KlartextEngine>(setup, sink, lines, setup);
  return std::make_unique<FanucEngine>(setup, sink, lines, setup.axes, samples);
}

}  // namespace toolcomp::fast
