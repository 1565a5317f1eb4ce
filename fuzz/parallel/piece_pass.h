// SPDX-License-Identifier: Apache-2.0
// The model and the judge over one piece of a long program (judge_in_pieces.h).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <vector>

#include "fuzz/oracle/reading.h"
#include "fuzz/oracle/stream_pass.h"
#include "fuzz/parallel/in_pieces.h"
#include "fuzz/parallel/judge_in_pieces.h"
#include "fuzz/parallel/packed_blocks.h"

namespace toolcomp::fuzz {

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
  std::size_t lead_judged = 0;  // blocks at its end whose events are judged: the last epoch, and some before
  FastRun fast_lead;            // of these
  std::uint64_t next_line = 0;  // of the block behind it
  bool last = false;
  bool beyond = false;            // a controller's: one of its blocks is not supported
  std::exception_ptr unreadable;  // what stands behind its blocks
};

// Of the fast engine, which has nothing but its pieces, and of a list of events.
struct EngineOrigin {};
struct ListOrigin {
  std::span<const spec::TextEvent> events;
  const spec::Axes& axes;
};

// One side of a pass: what the fast engine has given.
template <class Block>
class GivenByEngine {
 public:
  using Number = double;
  using Origin = EngineOrigin;
  GivenByEngine(const Origin& /*origin*/, const Rules& /*rules*/, const stream::Expected& /*expected*/,
                stream::Actual<double>& actual)
      : actual_(actual) {}
  void of(const FastRun& run) {
    run_ = &run;
    next_ = 0;
  }
  void begin_at(std::uint64_t /*line*/) {}
  void block(const Block& /*block*/) {
    for (std::size_t i = next_ == 0 ? 0 : run_->ends[next_ - 1]; i < run_->ends[next_]; ++i)
      actual_.on(run_->events[i]);
    ++next_;
  }
  void end() {
    for (const fast::Event& event : run_->at_end) actual_.on(event);
  }
  [[nodiscard]] bool stopped() const { return next_ >= run_->runs; }
  [[nodiscard]] bool lost() const { return false; }
  void state(spec::StateWriter& out) const { out(actual_.events); }

 private:
  stream::Actual<double>& actual_;
  const FastRun* run_ = nullptr;
  std::size_t next_ = 0;
};

// The same of a controller, whose events are there as one list: it has given as many as the model.
template <class Block>
class GivenAsList {
 public:
  using Number = exact::Rational;
  using Origin = ListOrigin;
  GivenAsList(const Origin& origin, const Rules& rules, const stream::Expected& expected,
              stream::Actual<exact::Rational>& actual)
      : list_(origin.events), reading_(origin.axes, rules), expected_(expected), actual_(actual) {}
  void of(const FastRun& /*run*/) {}
  // Before any is given: the first is that of this line, where lines rise.
  void begin_at(std::uint64_t line) {
    if (begun_) return;
    begun_ = true;
    const auto before = [line](const spec::TextEvent& event) { return event.line < line; };
    next_ = static_cast<std::size_t>(std::ranges::partition_point(list_, before) - list_.begin());
  }
  void block(const Block& /*block*/) {
    if (begun_) give(expected_.events.size());
  }
  // One too many is seen.
  void end() { give(expected_.events.size() + 1); }
  [[nodiscard]] bool stopped() const { return true; }
  // A text is no number.
  [[nodiscard]] bool lost() const { return reading_.bad().has_value(); }
  void state(spec::StateWriter& out) const { out(next_, actual_.events.size()); }

 private:
  void give(std::size_t most) {
    while (actual_.events.size() < most && next_ < list_.size()) actual_.on(reading_.event(list_[next_++]));
  }

  std::span<const spec::TextEvent> list_;
  Reading reading_;
  const stream::Expected& expected_;
  stream::Actual<exact::Rational>& actual_;
  std::size_t next_ = 0;
  bool begun_ = false;
};

struct PieceVerdict final : PieceResult {
  Verdict verdict;
  Counted counted;
  std::size_t events = 0;
  bool over = false;        // nothing behind it counts
  bool scope_left = false;  // out_of_scope counts from there
  bool near_tie = false;    // beside a difference
  std::uint64_t blocks = 0;
  std::exception_ptr unreadable;
};

// What is the same for every piece.
struct PieceRules {
  Rules rules;
  const spec::Setup& setup;
  std::uint32_t samples = 0;
  std::uint64_t epoch = 0;
  bool counts = false;  // how often clauses were reached is state
  FieldsOf fields_of = nullptr;
};

template <class Control, class Given>
class PiecePass final : public PieceWork, private stream::Pass<Control, Given, typename Given::Number> {
  using Block = typename Control::Block;
  using Base = stream::Pass<Control, Given, typename Given::Number>;

 public:
  PiecePass(const PieceRules& rules, const typename Given::Origin& origin)
      : Base(rules.rules, rules.setup, rules.samples, kNoChoices, rules.epoch,
             [&](auto& actual) { return Given(origin, this->rules_, this->expected_, actual); }),
        counts_(rules.counts) {
    if (rules.fields_of != nullptr)
      this->agreed_ = [this, fields_of = rules.fields_of](const model::Event& event) { fields_of(fields_, event); };
  }

  // To the beginning of the piece, by a guess. False: not even that.
  bool begin(const ProgramPiece<Control>& piece, const std::vector<Block>& lead) {
    this->facts_ = piece.facts;
    if (this->facts_.units()) this->rules_.units(*this->facts_.units());
    const std::size_t judged = lead.size() - piece.lead_judged;
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
      const auto& expected = this->expected_.events;
      const bool there = !expected.empty() && expected.front().line >= line;
      if (there) this->fast_.begin_at(expected.front().line);
      this->fast_.block(lead[i]);
      this->actual_.events.erase_if([line](const auto& event) { return event.line < line; });
      if (there || expected.empty()) this->compare_pairs(this->window());
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
        this->fast_, this->pairing_, this->recorder_, this->previous_, this->model_, this->undecided_);
    if (counts_ && this->previous_)
      for (const model::ClauseCount& count : this->previous_->counts())
        out(count.reached, count.positive, count.negative, count.tie);
    return out.take();
  }

  std::unique_ptr<PieceResult> run(const Piece& given, const std::atomic<bool>& stop) override {
    const auto& piece = static_cast<const ProgramPiece<Control>&>(given);
    auto result = std::make_unique<PieceVerdict>();
    this->fast_.of(piece.fast);
    if (piece.first == 0) this->fast_.begin_at(0);
    if (piece.beyond) this->undecided_ = true;
    for (std::size_t i = 0; i < piece.blocks.size() && !this->over() && !stop; ++i) {
      const Block& block = piece.blocks.at(i, *block_);
      // The epoch that begins with the piece has begun behind the one before.
      if (i != 0 && this->blocks_ % this->blocks_in_epoch_ == 0) this->next_epoch(block.line);
      this->take(block);
      ++result->blocks;
      if (this->fast_.lost()) this->undecided_ = true;
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
    result->counted = {this->clauses_, fields_};
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
    this->clauses_.assign(spec::kClauseCount, {});
    fields_ = {};
  }

  static inline const stream::Choices kNoChoices;
  std::unique_ptr<Block> block_ = std::make_unique<Block>();
  spec::FieldSet fields_;
  bool counts_;
};

}  // namespace toolcomp::fuzz
