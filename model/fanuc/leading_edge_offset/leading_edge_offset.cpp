// SPDX-License-Identifier: Apache-2.0
// Leading edge offset: G41.3 and G40. A pass over the blocks in order, each with those that follow it: one that moves,
// and one other. spec/formal/program/EdgePass.v has the same functions.
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "model/basis/alarm.h"
#include "model/fanuc/leading_edge_offset/rules.h"
#include "model/fanuc/passes/passes.h"
#include "model/fanuc/passes/window.h"

namespace toolcomp::model {

// What a block says to the leading edge offset, where that is on before it or from it on.
struct EdgeBlock {
  enum class Code : std::uint8_t { none, start, cancel };
  Code code = Code::none;
  Rational radius;  // offset of the D number in force at the end of the block, but for a cancel block
};

namespace {

// Gives every move its compensation vector (Move::offset). Clauses: fanuc.leading-edge.*.
class LeadingEdgeOffset : public Pass {
 public:
  // Throws spec::InputError naming parameter 19631.
  explicit LeadingEdgeOffset(const Place& place) : Pass(place), rules_(place.setup, place.recorder) {}

  [[nodiscard]] Extent extent() const override { return Extent::space; }
  [[nodiscard]] int look_ahead() const override { return 2; }
  [[nodiscard]] bool on() const override { return active_; }
  [[nodiscard]] bool on_after(const Command& command) const override {
    const Codes& codes = command.codes;
    if (codes.compensation == Compensation::leading_edge) return number(command) != 0;
    return active_ && codes.compensation != Compensation::cancel && codes.d != 0U;
  }

  // Reads G41.3, G40 and D. Throws Alarm PS5406, PS5408, PS5407, FORBIDDEN_IN_3D_COMPENSATION or PS0029.
  void read(const BlockWords& now, StepWords& words) override {
    const Command& command = now.command;
    const Codes& codes = command.codes;
    number_ = number(command);
    auto block = std::make_shared<EdgeBlock>();
    if (codes.compensation == Compensation::leading_edge) {
      // fanuc.leading-edge.start-format: An axis word (I J K under G43.5 included), or an M code that stops reading
      // ahead (fanuc.program.stops-reading-ahead), in the G41.3 block raises PS5406.
      if (now.moves() || codes.stops_look_ahead)
        raise(recorder(), Clause::fanuc_leading_edge_start_format, AlarmCause::leading_edge_format);
      // fanuc.leading-edge.start-in-arc-mode: G41.3 while G02 or G03 is in force raises PS5408.
      if (command.is_arc_motion())
        raise(recorder(), Clause::fanuc_leading_edge_start_in_arc_mode, AlarmCause::leading_edge_start);
      // fanuc.leading-edge.repeated: G41.3 while the mode is on raises PS5407.
      if (active_) raise(recorder(), Clause::fanuc_leading_edge_repeated, AlarmCause::leading_edge_command);
      // fanuc.leading-edge.start-with-d0: G41.3 with D0 in force starts nothing: the state stays cancelled, and the
      // next block may be any block. A number whose value is 0 starts the mode with vectors of length 0. The format of
      // the block is checked in both cases.
      if (!recorder().decide(Clause::fanuc_leading_edge_start_with_d0, number_ == 0)) block->code = Code::start;
    } else if (active_) {
      // fanuc.leading-edge.d0-cancels: A D0 word while the mode is on cancels it as G40 does.
      const bool by_number = recorder().decide(Clause::fanuc_leading_edge_d0_cancels, codes.d == 0U);
      if (codes.compensation == Compensation::cancel || by_number) {
        // fanuc.leading-edge.cancel-format: An axis word (I J K under G43.5 included) in the block that cancels the
        // mode raises PS5406.
        if (now.moves()) raise(recorder(), Clause::fanuc_leading_edge_cancel_format, AlarmCause::leading_edge_format);
        block->code = Code::cancel;
      }
      // fanuc.leading-edge.arc: G02 or G03 while the mode is on raises PS5407, also in the block that cancels the mode:
      // only G00 and G01 are allowed.
      if (command.is_arc_motion()) raise(recorder(), Clause::fanuc_leading_edge_arc, AlarmCause::leading_edge_command);
    }
    if (!active_ && block->code == Code::none) return;
    if (block->code != Code::cancel) {
      forbid(now);
      block->radius = memory().d(number_);
      // fanuc.leading-edge.number-changed: Another D while the mode is on counts for the vector at the end of the block
      // that has it. A vector that is kept keeps its length.
      recorder().decide(Clause::fanuc_leading_edge_number_changed, active_ && codes.d.has_value());
    }
    words.edge = std::move(block);
  }

  [[nodiscard]] bool has(const StepWords& words) const override { return words.edge != nullptr; }
  void take(OwnedStep step) override {
    // A block with N or O alone is no block and makes nothing. It is not kept while another waits.
    if (!step->has_word && !window_.empty()) return;
    Planned b{std::move(step)};
    if (b.code() != Code::none) active_ = b.code() == Code::start;
    // fanuc.leading-edge.no-movement: A block counts as one without movement if its travel in X Y Z is exactly zero:
    // rotary axes alone, a tool direction alone, M S T F H alone, a travel of zero. A block with N or O alone is no
    // block.
    if (b.code() == Code::none)
      b.travels = !recorder().decide(Clause::fanuc_leading_edge_no_movement,
                                     b.step->moves.empty() || is_zero(b.step->moves.front().leg.travel));
    b.step->clauses.add(recorder().take_clauses());
    window_.push(std::move(b));
  }

  void end() override { window_.end(); }
  // Throws Alarm PS5407 or PS5408 of a G41.3 block.
  OwnedStep next() override {
    if (window_.empty()) return nullptr;
    const auto ahead = look();
    if (!ahead) return nullptr;
    Planned b = window_.pop();
    recorder().at(b.step->line);
    make_moves(b, *ahead);
    return std::move(b.step);
  }

 private:
  using Code = EdgeBlock::Code;
  struct Planned {
    OwnedStep step;
    bool travels = false;  // it has a linear movement, X Y Z

    [[nodiscard]] Code code() const { return step->words.edge->code; }
    [[nodiscard]] const Vector& movement() const { return step->moves.front().leg.travel; }
  };
  // The next block is one with a linear movement, or the one that cancels the mode.
  using Ahead = Window<Planned>::Ahead;

  [[nodiscard]] std::uint32_t number(const Command& command) const { return command.codes.d.value_or(number_); }

  void forbid(const BlockWords& now) const {
    const Codes& codes = now.command.codes;
    const bool other = codes.compensation && (is_cutter_side(*codes.compensation) || is_tool_side(*codes.compensation));
    const bool code =
        codes.one_shot != OneShot::none || codes.workpiece || codes.units || codes.refused_in_space || other;
    // fanuc.leading-edge.forbidden: Codes that do not go together with the leading edge offset raise
    // FORBIDDEN_IN_3D_COMPENSATION (the alarm number is not known) in a block after which the mode is on. These are G04
    // G10 G28 G29 G30 G30.1 G37 G39 G41 G42 G41.2 G42.2 G41.6 G42.6 G45 to G48 G52 G53 G92 G54 to G59 G54.1 G20 G21 G96
    // G97 G160, G05 except with P10000, and an M, S or T word together with an axis word.
    if (code || (codes.auxiliary && now.moves()))
      raise(recorder(), Clause::fanuc_leading_edge_forbidden, AlarmCause::forbidden_in_compensation);
  }

  // fanuc.leading-edge.one-block-without-movement: If one block without movement comes between two moving blocks, the
  // vector is made of the tool direction before that block and the movement after it. The vector is kept through that
  // block, whatever the tool does there.
  // fanuc.leading-edge.two-blocks-without-movement: If two or more blocks without movement come in a row, the vector
  // made before is kept: the moving block before them ends with the vector it started with. What exactly is kept is our
  // reading.
  // fanuc.leading-edge.kept-without-look-ahead: Before a block that stops the look-ahead (an M code of
  // fanuc.program.stops-reading-ahead), the vector made before is kept. This holds also if that block is the cancel
  // block.
  // fanuc.leading-edge.kept-at-the-end: At the end of the program, and before a block that ends the run by an alarm,
  // the vector made before is kept.
  [[nodiscard]] std::optional<Ahead> look() const {
    const bool starts = window_[0].code() == Code::start;
    if (!starts && !window_[0].travels) return Ahead{};
    int still = 0;
    for (std::size_t i = 1; i < window_.size(); ++i) {
      const Planned& b = window_[i];
      if (b.travels) return Ahead{.next = &b, .between = i > 1};
      if (starts) return Ahead{};
      if (b.step->stops_look_ahead) return Ahead{.why = Clause::fanuc_leading_edge_kept_without_look_ahead};
      if (b.code() == Code::cancel) return Ahead{&b};
      if (++still == 2) return Ahead{.why = Clause::fanuc_leading_edge_two_blocks_without_movement};
    }
    if (!window_.ended()) return std::nullopt;
    return Ahead{.why = Clause::fanuc_leading_edge_kept_at_the_end};
  }

  // The moves of a block, and the vector at its end.
  void make_moves(Planned& b, const Ahead& ahead) {
    const bool starts = b.code() == Code::start;
    if (starts) {
      vector_ = vector_at_start(b, ahead);
    } else if (b.code() == Code::cancel) {
      // fanuc.leading-edge.cancel: At G40 the tool returns by the vector to the programmed point, in rapid traverse
      // under G00, otherwise straight with the feed. G40 while nothing is on does nothing.
      recorder().reach(Clause::fanuc_leading_edge_cancel);
      vector_ = {};
    } else if (b.travels) {
      vector_ = vector_at_end(b, ahead);
    }
    if (b.code() != Code::none) insert_move(*b.step, starts ? spec::Cause::start_up : spec::Cause::cancel);
    b.step->clauses.add(recorder().take_clauses());
    for (Move& move : b.step->moves) move.offset = vector_.vector;
  }

  [[nodiscard]] EdgeVector vector_at_end(const Planned& b, const Ahead& ahead) const {
    if (ahead.next == nullptr) {
      recorder().reach(ahead.why);
      return vector_;
    }
    const bool moves = ahead.next->travels;
    // fanuc.leading-edge.before-cancel: The block before G40 makes its vector from its own movement and the tool
    // direction at its end. That the ranges near 0, 90 and 180 degrees hold here too, and that one block without
    // movement may come between, is our definition.
    if (moves)
      recorder().decide(Clause::fanuc_leading_edge_one_block_without_movement, ahead.between);
    else
      recorder().reach(Clause::fanuc_leading_edge_before_cancel);
    return rules_.next(vector_, (moves ? *ahead.next : b).movement(), b.step->rest.tool, b.step->words.edge->radius);
  }

  [[nodiscard]] EdgeVector vector_at_start(const Planned& b, const Ahead& ahead) {
    try {
      // fanuc.leading-edge.no-movement-after-start: The G41.3 block raises PS5407 if the block right after it has no
      // linear movement: no travel in X Y Z, G40, the end of the program, or a block that raises an alarm of its own.
      if (ahead.next == nullptr)
        raise(recorder(), Clause::fanuc_leading_edge_no_movement_after_start, AlarmCause::leading_edge_command);
      return rules_.first(ahead.next->movement(), b.step->rest.tool, b.step->words.edge->radius);
    } catch (Alarm& alarm) {
      alarm.line = b.step->line;
      alarm.n = b.step->n;
      window_.clear();
      throw;
    }
  }

  // One move, made where the block ends.
  void insert_move(Step& b, spec::Cause cause) {
    b.moves = {b.rest};
    b.moves.front().leg.cause = cause;
  }

  EdgeRules rules_;
  std::uint32_t number_ = 0;  // D in force
  bool active_ = false;       // after the block read last

  Window<Planned> window_;
  EdgeVector vector_;  // where the tool stands
};

}  // namespace

std::unique_ptr<Pass> leading_edge_offset(const Pass::Place& place) {
  return std::make_unique<LeadingEdgeOffset>(place);
}

}  // namespace toolcomp::model
