// SPDX-License-Identifier: Apache-2.0
#include "fuzz/parallel/judge_in_pieces.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "fuzz/oracle/stream_pass.h"
#include "fuzz/parallel/in_pieces.h"
#include "fuzz/parallel/lead.h"
#include "fuzz/parallel/packed_blocks.h"

namespace toolcomp::fuzz {
namespace {

// What the fast engine gave for some blocks, block by block.
struct FastRun {
  std::vector<fast::Event> events;
  std::vector<std::size_t> ends;    // of each block, among the events
  std::size_t runs = 0;             // behind so many blocks it has stopped; more than there are: it goes on
  std::vector<fast::Event> at_end;  // of the text
};

template <class Control>
struct ProgramPiece final : Piece {
  using Block = typename Control::Block;
  std::uint64_t first = 0;  // number of its first block
  PackedBlocks<Block> blocks;
  FastRun fast;
  ProgramFacts facts;           // of the blocks before
  std::vector<Block> lead;      // by which the model may be brought here
  FastRun fast_lead;            // of the last epoch of it, and some blocks before
  std::uint64_t next_line = 0;  // of the block behind it
  bool last = false;
  std::exception_ptr unreadable;  // what stands behind its blocks
};

// The fast engine's part in a pass: what it has given.
template <class Block>
class Given {
 public:
  explicit Given(fast::EventSink& sink) : sink_(sink) {}
  void of(const FastRun& run) {
    run_ = &run;
    next_ = 0;
  }
  void block(const Block& /*block*/) {
    for (std::size_t i = next_ == 0 ? 0 : run_->ends[next_ - 1]; i < run_->ends[next_]; ++i) sink_.on(run_->events[i]);
    ++next_;
  }
  void end() {
    for (const fast::Event& event : run_->at_end) sink_.on(event);
  }
  [[nodiscard]] bool stopped() const { return next_ >= run_->runs; }

 private:
  fast::EventSink& sink_;
  const FastRun* run_ = nullptr;
  std::size_t next_ = 0;
};

struct PieceVerdict final : PieceResult {
  Verdict verdict;
  std::size_t events = 0;
  bool over = false;        // nothing behind it counts
  bool scope_left = false;  // out_of_scope counts from there
  bool near_tie = false;    // beside a difference
  std::uint64_t blocks = 0;
  std::exception_ptr unreadable;
};

template <class Control>
class PiecePass final : public PieceWork, private stream::Pass<Control, Given<typename Control::Block>> {
  using Block = typename Control::Block;
  using Base = stream::Pass<Control, Given<Block>>;

 public:
  PiecePass(const spec::Setup& setup, std::uint32_t samples, std::uint64_t epoch)
      : Base(setup, samples, kNoChoices, epoch, [](fast::EventSink& sink) { return Given<Block>(sink); }) {}

  // To the beginning of the piece, by a guess. False: not even that.
  bool begin(const ProgramPiece<Control>& piece, const std::vector<Block>& lead) {
    this->facts_ = piece.facts;
    if (this->facts_.units()) this->rules_.units(*this->facts_.units());
    const std::size_t judged = lead.size() - piece.fast_lead.ends.size();
    const std::size_t epoch = lead.size() - this->blocks_in_epoch_;
    // Events of the blocks before are not judged.
    const std::uint64_t line = lead[judged].line;
    this->fast_.of(piece.fast_lead);
    for (std::size_t i = 0; i < lead.size(); ++i) {
      if (i == epoch) {
        this->recorder_ = model::Recorder(true);
        this->starts_.second = lead[i].line;
      }
      this->model_.block(lead[i]);
      this->pass_by(line);
      if (i < judged) continue;
      this->fast_.block(lead[i]);
      std::erase_if(this->actual_.events, [line](const auto& event) { return event.line < line; });
      if (this->expected_.events.empty() || this->expected_.events.front().line >= line)
        this->compare_pairs(this->window());
      if (this->over()) return false;
    }
    if (this->model_.stopped()) return false;
    this->blocks_ = piece.first;
    this->next_epoch(piece.blocks.at(0, *block_).line);
    forget_counts();
    return true;
  }

  [[nodiscard]] std::string state() const override {
    spec::StateWriter out;
    out(this->blocks_, this->facts_.units(), this->starts_, this->expected_.positions, this->expected_.events,
        this->actual_.events, this->pairing_, this->recorder_, this->previous_, this->model_, this->undecided_);
    return out.take();
  }

  std::unique_ptr<PieceResult> run(const Piece& given, const std::atomic<bool>& stop) override {
    const auto& piece = static_cast<const ProgramPiece<Control>&>(given);
    auto result = std::make_unique<PieceVerdict>();
    this->fast_.of(piece.fast);
    for (std::size_t i = 0; i < piece.blocks.size() && !this->over() && !stop; ++i) {
      const Block& block = piece.blocks.at(i, *block_);
      // The epoch that begins with the piece has begun behind the one before.
      if (i != 0 && this->blocks_ % this->blocks_in_epoch_ == 0) this->next_epoch(block.line);
      this->take(block);
      ++result->blocks;
    }
    result->over = this->over() || piece.last;
    if (piece.unreadable && !this->over()) {
      result->unreadable = piece.unreadable;
    } else if (result->over) {
      result->verdict = this->end();
      result->near_tie = result->verdict.outcome == Outcome::differs && !this->near_ties().empty();
    } else {
      this->next_epoch(piece.next_line);
      result->verdict = this->verdict();
    }
    result->events = this->compared_;
    result->scope_left = this->tally_.scope_left;
    forget_counts();
    return result;
  }

 private:
  // What is summed over the pieces.
  void forget_counts() {
    this->tally_ = {};
    this->compared_ = 0;
    this->verdict_ = {};
  }

  static inline const stream::Choices kNoChoices;
  std::unique_ptr<Block> block_ = std::make_unique<Block>();
};

// Reads, and runs the fast engine.
template <class Control>
class PieceReader {
  using Block = typename Control::Block;

 public:
  PieceReader(const StreamedProgram& program, const spec::Setup& setup, std::uint32_t samples,
              const JudgeInPieces& options)
      : reader_(Control::reader(program.open(), setup, program.name, program.called_program)),
        fast_(Control::fast(setup, sink_, samples)),
        epoch_(options.epoch),
        size_(options.epoch * options.epochs_in_piece),
        lead_blocks_(options.lead),
        lead_(options.epoch + options.lead) {
    advance();
  }

  std::unique_ptr<Piece> next() {
    if (ended_) return nullptr;
    auto piece = std::make_unique<ProgramPiece<Control>>();
    piece->first = count_;
    piece->facts = facts_;
    if (count_ != 0) {
      piece->lead = lead_.blocks();
      piece->fast_lead = std::move(latest_);
    }
    piece->fast.runs = size_ + 1;
    piece->fast.events.reserve(size_ + size_ / 8);
    piece->fast.ends.reserve(size_);
    piece->blocks.reserve(size_);
    while (there_ && piece->blocks.size() < size_) run(*piece);
    piece->last = !there_;
    if (there_) {
      piece->next_line = block_->line;
      keep_latest(piece->fast);
    } else {
      ended_ = true;
      piece->unreadable = unreadable_;
      sink_.to = &piece->fast.at_end;
      if (!unreadable_) fast_.end();
    }
    return piece;
  }

 private:
  struct Sink final : fast::EventSink {
    void on(const fast::Event& event) override { to->push_back(event); }
    std::vector<fast::Event>* to = nullptr;
  };

  void advance() {
    try {
      there_ = reader_.next(*block_);
    } catch (...) {
      unreadable_ = std::current_exception();
      there_ = false;
    }
  }

  // The block at hand.
  void run(ProgramPiece<Control>& piece) {
    if (fast_.stopped()) piece.fast.runs = std::min(piece.fast.runs, piece.blocks.size());
    sink_.to = &piece.fast.events;
    piece.blocks.add(*block_);
    facts_.read(*block_);
    fast_.block(*block_);
    piece.fast.ends.push_back(piece.fast.events.size());
    if (fast_.stopped()) piece.fast.runs = std::min(piece.fast.runs, piece.blocks.size());
    lead_.add(*block_);
    ++count_;
    advance();
  }

  // What the fast engine gave for the last epoch, and for some blocks before: the judge has looked at numbers that
  // decisions of the epoch are made of.
  void keep_latest(const FastRun& run) {
    const std::size_t kept = std::min<std::size_t>(run.ends.size(), epoch_ + lead_blocks_ / 2);
    const std::size_t from = run.ends.size() - kept;
    const std::size_t begin = from == 0 ? 0 : run.ends[from - 1];
    latest_.events.assign(run.events.begin() + static_cast<std::ptrdiff_t>(begin), run.events.end());
    latest_.ends.clear();
    for (std::size_t i = from; i < run.ends.size(); ++i) latest_.ends.push_back(run.ends[i] - begin);
    latest_.runs = run.runs > run.ends.size() ? kept + 1 : run.runs < from ? 0 : run.runs - from;
  }

  Sink sink_;
  typename Control::Reader reader_;
  typename Control::Fast fast_;
  std::uint64_t epoch_;
  std::uint64_t size_;
  std::uint64_t lead_blocks_;
  Lead<Block> lead_;
  FastRun latest_;
  ProgramFacts facts_;
  std::unique_ptr<Block> block_ = std::make_unique<Block>();
  bool there_ = false;
  bool ended_ = false;
  std::exception_ptr unreadable_;
  std::uint64_t count_ = 0;
};

// Adds what a later piece was judged to be; the outcome is that of the latest.
void add(Verdict& all, bool scope_left, const PieceVerdict& piece) {
  const Verdict& v = piece.verdict;
  all.values += v.values;
  all.numbers += v.numbers;
  all.wide += v.wide;
  all.widths.add(v.widths);
  all.out_of_scope += scope_left ? v.events : v.out_of_scope;
  all.events += v.events;
  all.decisions += v.decisions;
  all.near_ties += v.near_ties;
  all.worst_ulp = std::max(all.worst_ulp, v.worst_ulp);
  all.worst_um = std::max(all.worst_um, v.worst_um);
  all.bias.add(v.bias);
  all.outcome = v.outcome;
  all.difference = v.difference;
  all.undecided = v.undecided;
  if (all.outcome == Outcome::nothing_judged && all.values > 0) all.outcome = Outcome::agrees;
}

template <class Control>
std::optional<Verdict> judge(const StreamedProgram& program, const spec::Setup& setup, std::uint32_t samples,
                             const JudgeInPieces& options, void (*on_block)(std::uint64_t)) {
  // A setup that both engines refuse is refused by the model, as in one thread.
  static_cast<void>(PiecePass<Control>(setup, samples, options.epoch));
  PieceReader<Control> reader(program, setup, samples, options);
  Verdict all;
  std::size_t events = 0;
  std::uint64_t blocks = 0;
  bool scope_left = false;
  bool near_tie = false;
  InPieces work;
  work.jobs = options.jobs;
  work.same = options.same;
  work.next = [&] { return reader.next(); };
  work.begin = [&](const Piece& piece, bool first) -> std::unique_ptr<PieceWork> {
    const auto& here = static_cast<const ProgramPiece<Control>&>(piece);
    using Work = std::unique_ptr<PiecePass<Control>>;
    const auto at_the_beginning = [&] { return std::make_unique<PiecePass<Control>>(setup, samples, options.epoch); };
    if (first) return at_the_beginning();
    return begin_by(here.lead, options.epoch + options.lead, options.lead / 2, [&](const auto& lead) -> Work {
      Work pass = at_the_beginning();
      return pass->begin(here, lead) ? std::move(pass) : nullptr;
    });
  };
  work.take = [&](PieceResult& result) {
    auto& piece = static_cast<PieceVerdict&>(result);
    if (piece.unreadable) std::rethrow_exception(piece.unreadable);
    add(all, scope_left, piece);
    if (all.difference) all.difference->event += events;
    events += piece.events;
    blocks += piece.blocks;
    scope_left = scope_left || piece.scope_left;
    near_tie = piece.near_tie;
    if (on_block != nullptr) on_block(blocks);
    return !piece.over;
  };
  const std::size_t wrong = in_pieces(work);
  if (options.wrong != nullptr) *options.wrong = wrong;
  if (near_tie) return std::nullopt;
  return all;
}

}  // namespace

Verdict judge_in_pieces(const StreamedProgram& program, const spec::Setup& setup, std::uint32_t samples,
                        const JudgeInPieces& options, void (*on_block)(std::uint64_t)) {
  if (options.jobs > 1 && !program.once) {
    const auto verdict = with_control(
        setup, [&]<class Control>(Control) { return judge<Control>(program, setup, samples, options, on_block); });
    if (verdict) return *verdict;
  }
  return judge_stream(program, setup, samples, on_block);
}

}  // namespace toolcomp::fuzz
