// SPDX-License-Identifier: Apache-2.0
// Cutter compensation B: G40, G41, G42 and G39.
#include <bit>
#include <utility>

#include "model/basis/alarm.h"
#include "model/fanuc/cutter_compensation/cutter_compensation.h"
#include "model/fanuc/cutter_compensation_b/rules.h"
#include "model/fanuc/passes/passes.h"
#include "model/geometry/plane_vector.h"

namespace toolcomp::model {
namespace {

// Every block by itself, without look-ahead: the tool goes from head to head. Clauses: fanuc.cutter-b.*.
class CutterCompensationB : public CutterCompensation {
 public:
  explicit CutterCompensationB(const Place& place) : CutterCompensation(place, false) {}

  [[nodiscard]] int look_ahead() const override { return 0; }
  [[nodiscard]] bool on() const override { return side_ != CutterSide::none; }
  void take(OwnedStep step) override { taken_ = std::move(step); }
  void end() override {}
  // Throws Alarm PS0038.
  OwnedStep next() override {
    OwnedStep step = std::move(taken_);
    if (!step) return step;
    run(*step);
    side_ = step->words.cutter->side;
    step->clauses.add(recorder().take_clauses());
    return step;
  }

 private:
  // Throws Alarm PS0035 or PS0034.
  void check(const CutterBlock& words, const Command& command) const override {
    const bool outside = std::popcount(command.axes) > int{words.word[0]} + int{words.word[1]};
    const bool forbidden = words.code || words.changes_number() || outside;
    // fanuc.cutter-b.corner-arc-format: G39 raises PS0035 while the mode is off or no start-up has been made; with G40,
    // G41, G42 or a word that gives the cutter another number in its block; with an axis word outside the plane; with a
    // direction that is zero or missing.
    if (words.one_shot == OneShot::corner_arc &&
        (!on() || !started_ || forbidden || !words.direction || is_zero(*words.direction)))
      raise(recorder(), Clause::fanuc_cutter_b_corner_arc_format, AlarmCause::corner_arc);
    if (words.arc_words) check_arc(words);
  }

  void check_arc(const CutterBlock& words) const {
    const bool is_on = words.side != CutterSide::none;
    // fanuc.cutter-b.arc-with-code: G41 or G42 in a block that is an arc raises PS0034, even if the code is repeated. A
    // block is an arc if G02 or G03 is in force, it has no code of group 00, and it has an axis word of the plane, I,
    // J, K or R.
    if (is_on && words.code)
      raise(recorder(), Clause::fanuc_cutter_b_arc_with_code, AlarmCause::arc_at_start_or_cancel);
    // fanuc.cutter-b.arc-with-number: In a block that is an arc while the mode is on, a word that gives the cutter
    // another number than the one in force raises PS0034.
    if (is_on && words.changes_number())
      raise(recorder(), Clause::fanuc_cutter_b_arc_with_number, AlarmCause::arc_at_start_or_cancel);
    // fanuc.cutter-b.arc-at-start-up: An arc as the first block that would make a vector (the start-up) raises PS0034.
    if (is_on && !started_)
      raise(recorder(), Clause::fanuc_cutter_b_arc_at_start_up, AlarmCause::arc_at_start_or_cancel);
    // fanuc.cutter-b.arc-at-cancel: G40 in a block that is an arc raises PS0034 while the vector is not zero; a zero
    // vector leaves the arc as programmed.
    if (!is_on && on() && recorder().decide(Clause::fanuc_cutter_b_arc_at_cancel, !is_zero(vector_)))
      throw Alarm(AlarmCause::arc_at_start_or_cancel);
  }

  void run(Step& step) {
    const CutterBlock& block = *step.words.cutter;
    if (block.side == CutterSide::none) {
      if (on()) cancel(step);
      return;
    }
    // fanuc.cutter-b.mode: The mode is on from the block with G41 or G42 to the block with G40.
    // fanuc.cutter-b.switch: A change from G41 to G42, or from G42 to G41, needs no G40 between. The next vector that
    // is made is on the new side; it is made in the same block if that block is a straight one. A repeated code changes
    // nothing.
    if (!on())
      recorder().reach(Clause::fanuc_cutter_b_mode);
    else if (block.code)
      recorder().decide(Clause::fanuc_cutter_b_switch, block.side != block.before);
    // fanuc.cutter-b.number-changed: A new number while the mode is on counts for the next vector that is made, which
    // is in the same block if that block is a straight one. A vector that is kept keeps its length.
    if (on() && block.number_given) recorder().decide(Clause::fanuc_cutter_b_number_changed, block.changes_number());
    if (block.one_shot == OneShot::corner_arc) {
      corner_arc(step);
    } else if (is_machine_move(block.motion)) {
      machine_position(step);
    } else if (block.motion == PlaneMotion::arc) {
      arc(step);
    } else if (block.motion != PlaneMotion::none) {
      line(step);
    } else {
      // fanuc.cutter-b.kept: A block that has no axis word of the plane and is not an arc keeps the vector, whatever
      // else it moves. I, J and K in it mean nothing.
      recorder().reach(Clause::fanuc_cutter_b_kept);
    }
    for (Move& move : step.moves) move.offset = in_space(block.plane, vector_);
  }

  // G40: the vector goes at once, in the block's own move or in one back to the programmed point.
  void cancel(Step& step) {
    const CutterBlock& block = *step.words.cutter;
    const Removal removal = model::removal(recorder(), block, started_, vector_);
    // Beside G52 and G92 the only move there can be is that of the length offset.
    if (removal == Removal::alone && (step.moves.empty() || is_shift(block.one_shot))) step.moves = {step.rest};
    vector_ = {};
    started_ = false;
    // Machine and reference positions keep the causes of their moves.
    if (removal != Removal::none && !is_machine_move(block.motion))
      for (Move& move : step.moves) move.leg.cause = spec::Cause::cancel;
  }

  void line(Step& step) {
    if (const auto made = vector_of_line(recorder(), *step.words.cutter)) {
      vector_ = *made;
      if (!std::exchange(started_, true)) {
        // fanuc.cutter-b.start-up: The first vector made after the mode began, or after G28, G29, G30, G30.1 or G53
        // took the vector away, is the start-up. Its block is a straight one, and the own move of that block has the
        // cause start-up. Blocks before it have no vector.
        recorder().reach(Clause::fanuc_cutter_b_start_up);
        step.moves.front().leg.cause = spec::Cause::start_up;
      }
    }
  }

  void arc(Step& step) {
    const CutterBlock& block = *step.words.cutter;
    const PlanePoint from = block.arc->start + vector_;
    vector_ = vector_of_arc(recorder(), block);
    head_to_head(recorder(), *step.moves.front().leg.arc, from, block.arc->end + vector_);
  }

  // G39: about the programmed point, from the old vector to the new one.
  void corner_arc(Step& step) {
    const CutterBlock& block = *step.words.cutter;
    const CornerArcOfB made = corner_arc_of_b(recorder(), block, vector_);
    vector_ = made.vector;
    if (made.moves) {
      step.moves = {step.rest};
      make_corner_arc(step.moves.front().leg, block, made.arc);
    }
  }

  // G53, G28, G30, G29: the vector goes in the first move where an axis of the plane is named.
  void machine_position(Step& step) {
    // fanuc.cutter-b.machine-position: G28, G29, G30, G30.1 and G53 take the whole vector away if they name an axis of
    // the plane. The vector goes in the first of their moves, the one to the intermediate point. The mode stays on, and
    // the next vector that is made is a start-up.
    if (recorder().decide(Clause::fanuc_cutter_b_machine_position, step.words.cutter->has_plane_word())) {
      vector_ = {};
      started_ = false;
    }
  }

  OwnedStep taken_;
  CutterSide side_ = CutterSide::none;  // group 07 in force
  bool started_ = false;                // the start-up is made
  PlanePoint vector_;                   // in force
};

}  // namespace

std::unique_ptr<Pass> cutter_compensation_b(const Pass::Place& place) {
  return std::make_unique<CutterCompensationB>(place);
}

}  // namespace toolcomp::model
