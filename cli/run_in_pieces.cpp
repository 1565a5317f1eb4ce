// SPDX-License-Identifier: Apache-2.0
#include "cli/run_in_pieces.h"

#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/event_text.h"
#include "fuzz/oracle/control.h"
#include "fuzz/parallel/in_pieces.h"
#include "fuzz/parallel/lead.h"
#include "fuzz/parallel/packed_blocks.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

constexpr std::size_t kFastBlocks = 2048;
constexpr std::size_t kModelBlocks = 8192;
constexpr std::size_t kLatest = 64;  // blocks that lead the model to a piece: look-ahead and vectors kept are shorter

// The alarm that ends a run, and where.
struct PlacedAlarm {
  RecentBlocks::LineColumn at;
  spec::Name number;
  const char* message = "";
};
template <class Number>
PlacedAlarm placed(const RecentBlocks& recent, const spec::Event<Number>& alarm) {
  return {recent.place(alarm.line), alarm.number, alarm.message};
}

struct PieceText final : fuzz::PieceResult {
  spec::TextBuffer text;
  std::optional<PlacedAlarm> alarm;
  std::exception_ptr thrown;  // behind that text
  bool undecided = false;
  bool over = false;
};

// Writes the pieces in order; the exit status.
int write_in_order(const Program& program, fuzz::InPieces& work) {
  bool undecided = false;
  work.take = [&](fuzz::PieceResult& result) {
    auto& piece = static_cast<PieceText&>(result);
    const std::string_view text = piece.text.view();
    std::cout.write(text.data(), static_cast<std::streamsize>(text.size()));
    if (piece.alarm) {
      std::cout.flush();
      const Place place = program.place(piece.alarm->at.line, piece.alarm->at.column);
      report_alarm(place.file, place.line, place.column, piece.alarm->number.view(), piece.alarm->message);
    }
    undecided = undecided || piece.undecided;
    if (piece.thrown) std::rethrow_exception(piece.thrown);
    return !piece.over;
  };
  try {
    fuzz::in_pieces(work);
  } catch (const spec::InputError& error) {
    throw program.placed(error);
  }
  return undecided ? kUndecided : kAgrees;
}

// What the fast engine gave for some blocks.
struct FastPiece final : fuzz::Piece {
  std::vector<fast::Event> events;
  std::optional<PlacedAlarm> alarm;
  std::exception_ptr thrown;
};

template <class Control>
class FastReader final : public fast::EventSink {
 public:
  explicit FastReader(const Program& program)
      : text_(program.text()),
        reader_(Control::reader(text_.open(), program.setup(), text_.name, text_.called_program)),
        engine_(Control::fast(program.setup(), *this, program.samples())) {}

  void on(const fast::Event& event) override {
    piece_->events.push_back(event);
    if (event.kind == spec::EventKind::alarm) piece_->alarm = placed(recent_, event);
  }

  std::unique_ptr<fuzz::Piece> next() {
    if (ended_) return nullptr;
    auto piece = std::make_unique<FastPiece>();
    piece_ = piece.get();
    piece->events.reserve(kFastBlocks + kFastBlocks / 4);
    try {
      for (std::size_t i = 0; i < kFastBlocks && !ended_; ++i) run();
    } catch (...) {
      piece->thrown = std::current_exception();
      ended_ = true;
    }
    return piece;
  }

 private:
  void run() {
    ended_ = engine_.stopped() || !reader_.next(*block_);
    if (ended_) return engine_.end();
    recent_.add(*block_);
    engine_.block(*block_);
  }

  fuzz::StreamedProgram text_;
  typename Control::Reader reader_;
  typename Control::Fast engine_;
  std::unique_ptr<typename Control::Block> block_ = std::make_unique<typename Control::Block>();
  RecentBlocks recent_;
  FastPiece* piece_ = nullptr;
  bool ended_ = false;
};

// Prints; no state goes from one piece to the next.
class FastPrinter final : public fuzz::PieceWork {
 public:
  FastPrinter(const spec::Setup& setup, Format format) : event_text_(setup, format) {}
  [[nodiscard]] std::string state() const override { return {}; }
  std::unique_ptr<fuzz::PieceResult> run(const fuzz::Piece& given, const std::atomic<bool>& stop) override {
    const auto& piece = static_cast<const FastPiece&>(given);
    auto result = std::make_unique<PieceText>();
    for (const fast::Event& event : piece.events) {
      if (stop) break;
      result->undecided = result->undecided || event.kind == spec::EventKind::undecided;
      event_text_.append(result->text, event, fast_number_);
    }
    result->alarm = piece.alarm;
    result->thrown = piece.thrown;
    return result;
  }

 private:
  EventText event_text_;
  FastNumber fast_number_;
};

template <class Control>
int run_fast(const Program& program, Format format, unsigned jobs) {
  FastReader<Control> reader(program);
  fuzz::InPieces work;
  work.jobs = jobs;
  work.next = [&] { return reader.next(); };
  work.begin = [&](const fuzz::Piece&, bool) { return std::make_unique<FastPrinter>(program.setup(), format); };
  return write_in_order(program, work);
}

template <class Control>
struct ModelPiece final : fuzz::Piece {
  fuzz::PackedBlocks<typename Control::Block> blocks;
  std::vector<typename Control::Block> lead;
  bool last = false;
  std::exception_ptr unreadable;  // what stands behind its blocks
};

template <class Control>
class BlockReader {
  using Block = typename Control::Block;

 public:
  explicit BlockReader(const Program& program)
      : text_(program.text()),
        reader_(Control::reader(text_.open(), program.setup(), text_.name, text_.called_program)) {}

  std::unique_ptr<fuzz::Piece> next() {
    if (ended_) return nullptr;
    auto piece = std::make_unique<ModelPiece<Control>>();
    piece->lead = lead_.blocks();
    try {
      while (!ended_ && piece->blocks.size() < kModelBlocks) {
        ended_ = !reader_.next(*block_);
        if (ended_) break;
        piece->blocks.add(*block_);
        lead_.add(*block_);
      }
    } catch (...) {
      piece->unreadable = std::current_exception();
      ended_ = true;
    }
    piece->last = ended_;
    return piece;
  }

 private:
  fuzz::StreamedProgram text_;
  typename Control::Reader reader_;
  std::unique_ptr<Block> block_ = std::make_unique<Block>();
  fuzz::Lead<Block> lead_{kLatest};
  bool ended_ = false;
};

template <class Control>
class ModelRunner final : public fuzz::PieceWork, private model::EventSink {
  using Block = typename Control::Block;

 public:
  ModelRunner(const Program& program, Format format, int digits)
      : event_text_(program.setup(), format),
        number_{digits},
        engine_(Control::model(program.setup(), recorder_, *this, program.samples())) {}

  // To the beginning of a piece.
  bool begin(const std::vector<Block>& lead) {
    for (const Block& block : lead) {
      recent_.add(block);
      engine_.block(block);
    }
    return !engine_.stopped();
  }

  [[nodiscard]] std::string state() const override {
    spec::StateWriter out;
    out(recorder_, engine_);
    return out.take();
  }

  std::unique_ptr<fuzz::PieceResult> run(const fuzz::Piece& given, const std::atomic<bool>& stop) override {
    const auto& piece = static_cast<const ModelPiece<Control>&>(given);
    auto result = std::make_unique<PieceText>();
    to_ = result.get();
    try {
      for (std::size_t i = 0; i < piece.blocks.size() && !engine_.stopped() && !stop; ++i) {
        const Block& block = piece.blocks.at(i, *block_);
        recent_.add(block);
        engine_.block(block);
      }
      result->over = engine_.stopped() || piece.last;
      if (piece.unreadable && !engine_.stopped())
        result->thrown = piece.unreadable;
      else if (result->over)
        engine_.end();
    } catch (...) {
      result->thrown = std::current_exception();
    }
    to_ = nullptr;
    return result;
  }

 private:
  void on(const model::Event& event) override {
    if (to_ == nullptr) return;
    event_text_.append(to_->text, event, number_);
    if (event.kind == spec::EventKind::undecided) to_->undecided = true;
    if (event.kind == spec::EventKind::alarm) to_->alarm = placed(recent_, event);
  }

  model::Recorder recorder_;
  EventText event_text_;
  ModelNumber number_;
  RecentBlocks recent_;
  std::unique_ptr<Block> block_ = std::make_unique<Block>();
  PieceText* to_ = nullptr;
  typename Control::Model engine_;
};

template <class Control>
int run_model(const Program& program, const RunOptions& options, unsigned jobs) {
  BlockReader<Control> reader(program);
  fuzz::InPieces work;
  work.jobs = jobs;
  work.next = [&] { return reader.next(); };
  work.begin = [&](const fuzz::Piece& piece, bool first) -> std::unique_ptr<fuzz::PieceWork> {
    using Work = std::unique_ptr<ModelRunner<Control>>;
    const auto at_the_beginning = [&] {
      return std::make_unique<ModelRunner<Control>>(program, options.format, options.digits);
    };
    if (first) return at_the_beginning();
    const auto& lead = static_cast<const ModelPiece<Control>&>(piece).lead;
    return fuzz::begin_by(lead, kLatest, kLatest / 2, [&](const auto& blocks) -> Work {
      Work runner = at_the_beginning();
      return runner->begin(blocks) ? std::move(runner) : nullptr;
    });
  };
  return write_in_order(program, work);
}

}  // namespace

bool runs_in_pieces(Format format) { return format == Format::jsonl || format == Format::csv; }

int run_in_pieces(const Program& program, const RunOptions& options, unsigned jobs) {
  std::string head;
  if (options.format == Format::csv) spec::append_csv_header(head, program.setup().axes, program.setup().control);
  std::cout << head;
  return fuzz::with_control(program.setup(), [&]<class Control>(Control) {
    return options.engine == EngineName::fast ? run_fast<Control>(program, options.format, jobs)
                                              : run_model<Control>(program, options, jobs);
  });
}

}  // namespace toolcomp::cli
