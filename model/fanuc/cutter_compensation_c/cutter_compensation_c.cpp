// SPDX-License-Identifier: Apache-2.0
// Cutter compensation C: G40, G41, G42 and G39. A pass over the blocks in order, each with those that follow it.
//
// A block is first planned: what it is to the mode (mode.h). Its moves are made as soon as the next block that moves in
// the plane is known, or that there is none near enough. docs/formal.md says which functions of spec/formal they are.
#include <utility>

#include "model/basis/alarm.h"
#include "model/fanuc/cutter_compensation/cutter_compensation.h"
#include "model/fanuc/cutter_compensation_c/mode.h"
#include "model/fanuc/cutter_compensation_c/rules.h"
#include "model/fanuc/passes/corner_moves.h"
#include "model/fanuc/passes/passes.h"
#include "model/fanuc/passes/window.h"
#include "model/geometry/arc.h"

namespace toolcomp::model {
namespace {

// A block that makes a corner with the block that ends there.
bool makes_corner(CutterPart part) {
  return part == CutterPart::moving || part == CutterPart::cancel || part == CutterPart::way_to_intermediate;
}

CornerVector in_plane(spec::Plane plane, const SpaceVector& v) {
  return {in_plane_of(plane, v.vector), v.former, v.latter};
}

// Clauses: fanuc.cutter-c.*.
class CutterCompensationC final : public CutterCompensation {
 public:
  explicit CutterCompensationC(const Place& place)
      : CutterCompensation(place, true), rules_(place.setup, place.recorder), mode_(place.setup, place.recorder) {}

  [[nodiscard]] int look_ahead() const override { return mode_.idle_limit; }
  [[nodiscard]] bool on() const override { return mode_.is_on_or_asked_for(); }
  void take(OwnedStep step) override {
    CutterPlan plan = mode_.next(*step, waiting());
    step->clauses.add(recorder().take_clauses());
    window_.push({std::move(step), std::move(plan)});
  }

  void end() override { window_.end(); }
  OwnedStep next() override {
    const auto ahead = look();
    if (!ahead) return nullptr;
    Planned now = window_.pop();
    recorder().at(now.step->line);
    make_moves(now, *ahead);
    now.step->clauses.add(recorder().take_clauses());
    tool_.place = now.step->rest;
    return std::move(now.step);
  }

 private:
  struct Planned {
    OwnedStep step;
    CutterPlan plan;
  };
  using Ahead = Window<Planned>::Ahead;

  void check(const CutterBlock& words, const Command& /*command*/) const override {
    // fanuc.cutter-c.corner-arc-alarm: G39 raises PS0035 with G40 or number 0 in force, or after them while a vector
    // waits for its removal. It raises PS0035 before a moving block has made a vector: before the start-up block, after
    // a G41 or G42 of SUV = 1, and after G53, G28, G30, G30.1, G29, G52 or G92 of the plane. It raises PS0035 with G41,
    // G42, an axis word, or a word that gives the cutter another number in its block, and with letters of the plane
    // that are all 0.
    if (words.one_shot == OneShot::corner_arc &&
        (!wanted(words) || !mode_.made_by_move() || words.says_side() || words.axis_word || words.changes_number() ||
         (words.direction && is_zero(*words.direction))))
      raise(recorder(), Clause::fanuc_cutter_c_corner_arc_alarm, AlarmCause::corner_arc);
    // fanuc.cutter-c.start-or-cancel-in-arc: An arc as start-up block or as cancel block raises PS0034. The words of
    // the block tell whether it is an arc: G02 or G03 in force, no code of group 00 in the block (G45 to G48 do not
    // count here), and an axis word of the plane, R, I, J or K in the block.
    if (words.arc_words && (mode_.starts(wanted(words)) || mode_.cancels(wanted(words))))
      raise(recorder(), Clause::fanuc_cutter_c_start_or_cancel_in_arc, AlarmCause::arc_at_start_or_cancel);
  }

  [[nodiscard]] const CutterBlock& block_of(const Planned& b) const { return *b.step->words.cutter; }

  // Nothing but the block that waits, and blocks without motion after it, is here when the next one is planned.
  [[nodiscard]] std::optional<CutterMode::Waiting> waiting() const {
    if (window_.empty()) return std::nullopt;
    const CutterPart part = window_[0].plan.part;
    CutterMode::Waiting result{part == CutterPart::start_up || part == CutterPart::moving};
    for (std::size_t i = 1; i < window_.size(); ++i) result.count += window_[i].plan.count;
    return result;
  }

  // fanuc.cutter-c.one-non-motion-block: If the count between A and B is smaller than that of
  // fanuc.cutter-c.two-non-motion-blocks (so it is one, or on the 30i more, by No. 19625), the group is made as if the
  // blocks between were not there. The blocks between run at the first head, before the corner moves.
  // fanuc.cutter-c.two-non-motion-blocks: As soon as the count after block A is two or more, A ends with P1. This holds
  // for a start-up block too. The next moving block starts from that vector, so there is no corner.
  // fanuc.cutter-c.look-ahead-stopped: Nothing is read beyond a block with G53, whatever its words, or with an M code
  // that stops reading ahead (fanuc.program.stops-reading-ahead), before that block has run.
  // fanuc.cutter-c.no-next-block: If there is no B to make a corner with, block A, also a start-up block, ends with P1
  // as well. There is no B at the end of the program, before a block that raises an alarm when it is read or leaves the
  // run undecided, and before G39, G29 with axis words, G28, G30 or G30.1 with axis words (except in
  // fanuc.cutter-c.reference-intersection), a lone G40 and a lone number 0.
  // fanuc.cutter-c.repeated: If block B, or a block between A and B, has a word G41 or G42 equal to the code in force
  // before it, the group is P1 of A, at inner and outer corners alike.
  [[nodiscard]] std::optional<Ahead> look() const {
    if (window_.empty()) return std::nullopt;
    const Planned& a = window_[0];
    const CutterPart part = a.plan.part;
    if (part != CutterPart::start_up && part != CutterPart::moving && part != CutterPart::lone_start &&
        (part != CutterPart::corner_arc || block_of(a).direction))
      return Ahead{};
    if (a.plan.stops) return Ahead{.why = Clause::fanuc_cutter_c_look_ahead_stopped};
    bool repeated = false;
    int count = 0;
    for (std::size_t i = 1; i < window_.size(); ++i) {
      const Planned& b = window_[i];
      repeated = repeated || block_of(b).repeats_code();
      if (makes_corner(b.plan.part)) return Ahead{&b, repeated, count > 0};
      // A reference return is a case of fanuc.cutter-c.no-next-block, whether reading stops there or not.
      if (b.plan.stops && block_of(b).motion != PlaneMotion::reference)
        return Ahead{.why = Clause::fanuc_cutter_c_look_ahead_stopped};
      if (b.plan.shifts) return Ahead{.why = Clause::fanuc_cutter_c_coordinate_shift};
      if (b.plan.part != CutterPart::idle && b.plan.part != CutterPart::lone_start)
        return Ahead{.why = Clause::fanuc_cutter_c_no_next_block};
      count += b.plan.count;
      if (count >= mode_.idle_limit || b.plan.part == CutterPart::lone_start)
        return Ahead{.why = Clause::fanuc_cutter_c_two_non_motion_blocks};
    }
    if (!window_.ended()) return std::nullopt;
    return Ahead{.why = Clause::fanuc_cutter_c_no_next_block};
  }

  // The moves of a block, and where the tool stands after it.
  void make_moves(Planned& now, const Ahead& ahead) {
    if (now.plan.shifts) shift(now);
    switch (now.plan.part) {
      case CutterPart::free:
        return;
      case CutterPart::idle:
        break;
      case CutterPart::outside_axes:
        // fanuc.cutter-c.outside-axes-only: A block with G53, G28, G30, G30.1 or G29 that names only axes outside the
        // plane keeps the vector. The block before ends with P1, and the next moving block starts from that vector.
        recorder().reach(Clause::fanuc_cutter_c_outside_axes_only);
        break;
      case CutterPart::lone_start:
        lone_start(now, ahead);
        break;
      case CutterPart::lone_cancel:
        lone_cancel(now);
        break;
      case CutterPart::corner_arc:
        corner_arc(now, ahead);
        break;
      case CutterPart::start_up:
      case CutterPart::moving:
        return mode_block(now, ahead);
      case CutterPart::cancel:
      case CutterPart::cancel_by_zero_travel:
        return cancel(now);
      case CutterPart::vector_goes:
      case CutterPart::way_to_intermediate:
      case CutterPart::along_to_intermediate:
        return machine_move(now);
    }
    at_head(*now.step, tool_.heads.front());
  }

  // A start-up block, or a block of the offset mode.
  void mode_block(Planned& a, const Ahead& ahead) {
    const spec::Plane plane = block_of(a).plane;
    const OffsetPath& path = a.plan.path;
    SpaceGroup at_end = group_at_end(a, ahead);
    std::optional<ToolArcRun> run;
    if (path.is_arc())
      run.emplace(recorder(), path, in_plane(plane, tool_.heads.back()), in_plane(plane, at_end.front()));
    Checked checked;
    // fanuc.cutter-c.interference-check: No. 5008 bit 0, CNI, switches the interference check: 0 checks, 1 does not.
    if (a.plan.part == CutterPart::moving && a.plan.to_check && ahead.why != Clause::fanuc_cutter_c_coordinate_shift &&
        recorder().decide(Clause::fanuc_cutter_c_interference_check, !setup().bit(5008, 0)))
      checked = check_interference(recorder(), &setup(), between_vectors(plane, path), tool_.heads, at_end,
                                   run ? &*run : nullptr);
    // fanuc.cutter-c.interference-alarm: Interference of the last pair, or of the only pair, raises PS0041 (except in
    // fanuc.cutter-c.interference-without-alarm). The alarm names the block. Neither the block nor its corner moves are
    // given; the block before it runs to the first head of its own group.
    if (checked.passage == Passage::blocked)
      raise_at(a, Clause::fanuc_cutter_c_interference_alarm, AlarmCause::interference, checked.crossing);
    end_at(a.step->moves.front(), at_end.front(), run ? &*run : nullptr, checked.passage);
    if (a.plan.part == CutterPart::start_up) a.step->moves.front().leg.cause = spec::Cause::start_up;
    insert_corner_moves(*a.step, block_of(a), tool_);
    tool_.heads = std::move(at_end);
    here_ = path.end.heading;
  }

  // The vectors at the end of a moving block: those of the corner, or P1.
  [[nodiscard]] SpaceGroup group_at_end(const Planned& a, const Ahead& ahead) {
    const spec::Plane plane = block_of(a).plane;
    // fanuc.cutter-c.coordinate-shift: G52 or G92 with an axis word of the plane while the mode is on takes the vector
    // away for a time. The block before, A, ends at its programmed point, without a move of its own for that. This
    // holds also if A is a start-up block, and with or without a block without motion between. The mode stays on,
    // whatever CCN is. The next moving block, also an arc, runs from there to its ordinary group, without a corner and
    // without a change of direction before it.
    if (ahead.why == Clause::fanuc_cutter_c_coordinate_shift) {
      recorder().decide(Clause::fanuc_cutter_c_coordinate_shift, true);
      return {SpaceVector{}};
    }
    if (ahead.next == nullptr) {
      recorder().reach(ahead.why);
      return in_space(plane, square_to(recorder(), a.plan.path.end));
    }
    recorder().decide(Clause::fanuc_cutter_c_one_non_motion_block, ahead.between);
    return in_space(plane, corner_group(a, ahead.next->plan, ahead.repeated));
  }

  [[nodiscard]] VectorGroup corner_group(const Planned& a, const CutterPlan& b, bool repeated) {
    // fanuc.cutter-c.value-at-a-corner: A new number or value counts for the vectors at the end of the moving block
    // that has it, or, if that block does not move, at the end of the next moving block.
    if (b.part != CutterPart::cancel)
      recorder().decide(Clause::fanuc_cutter_c_value_at_a_corner, b.offset.value != a.plan.offset.value);
    auto group = rules_.by_first_rule(a.plan, b, repeated);
    // fanuc.cutter-c.no-intersection: An inner corner with an arc and R' >= 0 whose offset paths do not meet raises
    // PS0033. The alarm names A. Neither A nor a corner move of A is given, and the blocks before A are given as
    // computed with A present.
    if (!group) raise_at(a, Clause::fanuc_cutter_c_no_intersection, AlarmCause::no_intersection, {});
    rules_.drop_small_movements(*group, b.path);
    // fanuc.cutter-c.corner-movement: Block A ends at the first head of the group, and the straight moves between the
    // heads belong to B. These moves have the cause corner. They are rapid if G00 is in force in B, otherwise linear.
    // They have B's feed; tool direction, length offset and other axes are as before B. They carry no machine
    // coordinates, not even before G28.
    recorder().decide(Clause::fanuc_cutter_c_corner_movement, group->size() > 1);
    return std::move(*group);
  }

  // The vector made or removed in a block without motion.
  void at_once(Planned& now, spec::Cause cause) {
    const CutterBlock& block = block_of(now);
    // The words of an ignored G53 are none.
    const bool ignored = block.one_shot == OneShot::machine_coordinates && block.motion == PlaneMotion::none;
    // fanuc.cutter-c.start-without-motion-move: If a block without motion in the plane makes or removes the vector and
    // has no axis word, it does so by a move of its own, of the kind of group 01 (linear under G02 and G03). If the
    // block has an axis word, its own move takes the vector along.
    recorder().decide(Clause::fanuc_cutter_c_start_without_motion_move, block.axis_word && !ignored);
    // Beside G52 and G92 the only move there can be is that of the length offset (clause
    // fanuc.cutter-c.workpiece-change).
    if (now.plan.changes && is_shift(block.one_shot)) now.step->moves.clear();
    change_alone(*now.step, cause, now.plan.changes);
  }

  void lone_start(Planned& now, const Ahead& ahead) {
    // fanuc.cutter-c.start-without-motion: If SUV = 1, the mode is off, and a block that does not move in the plane has
    // the word G41 or G42 and a number other than 0 in force at its end, the tool moves by P2 of the next moving block
    // B. P2 has the value in force at the end of the G41 or G42 block; the cause is start-up.
    // fanuc.cutter-c.start-without-next-block: If no B follows the G41 or G42 of SUV = 1, no vector is made. The mode
    // is then off, and the next moving block is a start-up block if G41 or G42 is still in force. No B follows if one
    // of these comes first: a count of fanuc.cutter-c.two-non-motion-blocks; a case of fanuc.cutter-c.no-next-block,
    // G28 included; a block that stops reading ahead; G52 or G92 of the plane; or a block in which the mode is no
    // longer asked for, also the cancel block.
    if (ahead.next == nullptr) return recorder().reach(Clause::fanuc_cutter_c_start_without_next_block);
    recorder().reach(Clause::fanuc_cutter_c_start_without_motion);
    at_once(now, spec::Cause::start_up);
    tool_.heads = in_space(block_of(now).plane, {square_to_latter(ahead.next->plan.path.start)});
  }

  // G40 or number 0.
  void cancel(Planned& now) {
    // fanuc.cutter-c.cancel: The first moving block with G40 or number 0 in force while the mode is on is the cancel
    // block. The tool goes straight from the last head of the group at its start to its programmed end; the cause is
    // cancel.
    // fanuc.cutter-c.cancel-by-zero-travel: After a lone G40 or number 0 with SUV = 0, a block with an axis word of the
    // plane but no travel there is a move command, and it is the cancel block. The vector is removed, and the tool ends
    // at the programmed point; the cause is cancel.
    recorder().reach(now.plan.part == CutterPart::cancel ? Clause::fanuc_cutter_c_cancel
                                                         : Clause::fanuc_cutter_c_cancel_by_zero_travel);
    now.step->moves.front().leg.cause = spec::Cause::cancel;
    insert_corner_moves(*now.step, block_of(now), tool_);
    tool_.stand({});
  }

  void lone_cancel(Planned& now) {
    // fanuc.cutter-c.cancel-without-motion: A G40 or number 0 in a block that does not move in the plane while the mode
    // is on is called lone; its I, J and K mean nothing. Block A ends with P1.
    recorder().reach(Clause::fanuc_cutter_c_cancel_without_motion);
    // fanuc.cutter-c.suv: With No. 5003 bit 1, SUV, at 1 (type C), a G41 or G42 that starts the mode, and a G40 or
    // number 0 that ends it, act at once in a block that does not move in the plane. With SUV = 0 such a block makes
    // and removes nothing.
    const bool removes = recorder().decide(Clause::fanuc_cutter_c_suv, setup().bit(5003, 1));
    if (removes) at_once(now, spec::Cause::cancel);
    if (removes || !now.plan.changes) tool_.stand({});
  }

  // G39: an arc about the corner.
  void corner_arc(Planned& now, const Ahead& ahead) {
    const auto& direction = block_of(now).direction;
    // fanuc.cutter-c.corner-arc-direction: The direction u of G39 is that of the letters of the plane among I J K. A
    // missing letter is 0, and the letter outside the plane means nothing. Without letters of the plane, u is the start
    // tangent of the next moving block. That block may also be the cancel block (its own line, whatever its I J K) or,
    // with CCN = 1, the way to the intermediate point.
    if (recorder().decide(Clause::fanuc_cutter_c_corner_arc_direction, direction.has_value())) {
      turn(now, heading(*direction), false);
    } else if (ahead.next != nullptr) {
      turn(now, ahead.next->plan.path.start.heading, ahead.next->plan.offset.side == now.plan.offset.side);
    } else {
      const bool too_far = ahead.why == Clause::fanuc_cutter_c_two_non_motion_blocks;
      // fanuc.cutter-c.corner-arc-without-next-block: If a case of fanuc.cutter-c.no-next-block comes before the next
      // moving block, a G39 without letters makes no arc and keeps the vector. If a count of
      // fanuc.cutter-c.two-non-motion-blocks comes after the G39, the run is undecided at the G39 block, and the blocks
      // before it are given as if it were absent.
      if (recorder().decide(Clause::fanuc_cutter_c_corner_arc_without_next_block, too_far)) {
        window_.clear();
        LeftOpen open(Clause::fanuc_cutter_c_corner_arc_without_next_block,
                      "two blocks without motion after a G39 without direction");
        open.line = now.step->line;
        open.n = now.step->n;
        throw LeftOpen(open);
      }
    }
  }

  // From the vector in force, which is square to its heading, to the one square to another.
  void turn(Planned& now, const Heading& to, bool next_is_square) {
    const Rational offset = now.plan.offset.left();
    // fanuc.cutter-c.value-zero: If r = 0, the group is the zero vector alone, whatever the corner and No. 5010. There
    // are then no corner moves, not even before an arc of 180 degrees or more. A start-up and a cancel with r = 0 keep
    // their causes.
    if (offset == 0) return recorder().reach(Clause::fanuc_cutter_c_value_zero);
    const bool clockwise = offset > 0;
    const Real left_turn = cross(here_.along, to.along);
    const Real cosine = dot(here_.along, to.along);
    const Real sine = clockwise ? -left_turn : left_turn;
    // fanuc.cutter-c.corner-arc: With G39 while the mode is on, the block before ends with P1, and the tool runs an arc
    // about the corner from the vector V in force to V' = rho N(u). r and side are those of the moving block before,
    // whatever has changed since.
    const Sign side = recorder().decide(Clause::fanuc_cutter_c_corner_arc, sine, here_.length * to.length);
    const CutterBlock& block = block_of(now);
    if (side != Sign::zero || cosine.sign() != Sign::positive) {
      if (now.step->moves.empty()) now.step->moves.push_back(now.step->rest);
      spec::Arc<Real> arc;
      arc.direction = clockwise ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
      arc.sweep = swept_angle(sine, cosine, side);
      make_corner_arc(now.step->moves.front().leg, block, std::move(arc));
    }
    here_ = to;
    const PlanePoint vector = perpendicular(PathEnd{to, 0, offset});
    tool_.heads = in_space(block.plane, {{vector, Seat::off, next_is_square ? Seat::square : Seat::off}});
  }

  // G52 or G92 of the plane: there is no vector from here on.
  void shift(const Planned& now) {
    if (!now.plan.after_leg) recorder().decide(Clause::fanuc_cutter_c_coordinate_shift, false);
    tool_.stand({});
  }

  // G53, G28, G30, G30.1 and G29 of the plane: the vector goes in the first move, or after the intermediate point.
  void machine_move(Planned& now) {
    const CutterBlock& block = block_of(now);
    std::vector<Move>& moves = now.step->moves;
    if (now.plan.part == CutterPart::vector_goes) {
      // fanuc.cutter-c.reference-return: If CCN = 0, if G40 or number 0 is in force, or after a lone G40, the block
      // before a G28, G30 or G30.1 of the plane ends with P1, and the vector is removed on the way to the intermediate
      // point.
      // fanuc.cutter-c.machine-position: With G53 and an axis word of the plane under G90 while the mode is on, the
      // vector vanishes in the G53 move (cause programmed). With G29 it vanishes likewise, at the intermediate point.
      recorder().reach(block.motion == PlaneMotion::reference ? Clause::fanuc_cutter_c_reference_return
                                                              : Clause::fanuc_cutter_c_machine_position);
    } else if (now.plan.part == CutterPart::way_to_intermediate) {
      moves.front().offset = in_space(block.plane, perpendicular(now.plan.path.end));
      insert_corner_moves(*now.step, block, tool_);
    } else {
      moves.front().offset = tool_.heads.front().vector;
    }
    // fanuc.cutter-c.one-plane-axis: If a block with G53, G28, G30, G30.1 or G29 names only one axis of the plane, both
    // components of the vector are cleared all the same, with CCN = 0 and with CCN = 1.
    recorder().decide(Clause::fanuc_cutter_c_one_plane_axis, block.word[0] != block.word[1]);
    tool_.stand({});
  }

  // The alarm names this block, and nothing of it is given.
  [[noreturn]] void raise_at(const Planned& now, Clause clause, AlarmCause cause, const Real& crossing) {
    recorder().reach(clause);
    window_.clear();
    throw geometry_alarm(*now.step, setup().axes, cause, crossing);
  }

  CutterRules rules_;
  CutterMode mode_;
  Window<Planned> window_;
  Standing tool_;
  Heading here_;  // the vector is square to this, where it can be that of G39
};

}  // namespace

std::unique_ptr<Pass> cutter_compensation_c(const Pass::Place& place) {
  return std::make_unique<CutterCompensationC>(place);
}

}  // namespace toolcomp::model
