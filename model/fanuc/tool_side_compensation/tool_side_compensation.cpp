// SPDX-License-Identifier: Apache-2.0
// Tool side compensation: G41.2 G42.2, under G43.5 G41.6 G42.6, and G40. A pass over the blocks in order, each with
// those that follow it.
//
// A block is first planned: what it is to the mode, and how it moves at each corner before it (mode.h). Its vectors are
// made as soon as the next block that moves in the plane at its end is known, or that there is none near enough. It
// goes out when the interference check of the next block that makes vectors has left them as they are.
// spec/formal/program/SidePass.v has the same functions.
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "model/basis/alarm.h"
#include "model/basis/number.h"
#include "model/fanuc/passes/corner_moves.h"
#include "model/fanuc/passes/passes.h"
#include "model/fanuc/passes/window.h"
#include "model/fanuc/tool_side_compensation/rules.h"
#include "model/fanuc/tool_side_compensation/side_check.h"

namespace toolcomp::model {
namespace {

std::optional<CutterSide> side_of(Compensation code) {
  if (code == Compensation::cancel) return CutterSide::none;
  if (!is_tool_side(code)) return std::nullopt;
  const bool left = code == Compensation::tool_side_left || code == Compensation::directed_tool_side_left;
  return left ? CutterSide::left : CutterSide::right;
}

bool is_directed(Compensation code) {
  return code == Compensation::directed_tool_side_left || code == Compensation::directed_tool_side_right;
}

// Q1, Q2, Q3; 0 for any other value.
std::optional<int> treatment(const Command& command) {
  const spec::Decimal* const word = command.words.find('Q');
  if (word == nullptr) return std::nullopt;
  const Rational value = plain(*word);
  for (const int known : {1, 2, 3})
    if (value == known) return known;
  return 0;
}

// Hands on every move with its compensation vector (Move::offset), the moves that belong to a block but are inserted
// beside its own, arcs as the tool runs them. Clauses: fanuc.tool-side.*, and those of fanuc.cutter-c.* that they name;
// on(), on_after(): fanuc.tool-side.on.
class ToolSideCompensation final : public Pass {
 public:
  // Throws spec::InputError for a parameter that makes no sense.
  explicit ToolSideCompensation(const Place& place)
      : Pass(place),
        limit_(blocks_read(place.setup) - 1),
        words_(place, side_of),
        rules_(place.setup, place.recorder),
        plane_change_(place.setup, place.recorder),
        mode_(place.setup, place.recorder) {}

  [[nodiscard]] Extent extent() const override { return Extent::space; }
  [[nodiscard]] int look_ahead() const override { return 2 * limit_; }
  [[nodiscard]] bool on() const override { return mode_.is_on_or_asked_for(); }
  [[nodiscard]] bool on_after(const Command& command) const override {
    return words_.side_after(command) != CutterSide::none && words_.number_after(command) != 0;
  }
  // Throws Alarm PS5460.
  void refuse_rotary_word(const Command& command) const override {
    // fanuc.tool-side.rotary-word: A rotary axis word in a block under G43.5 raises PS5460 if tool side compensation is
    // on before or after the block. Otherwise it raises PS5421 (fanuc.tool-center-point.rotary-word).
    if (on() || on_after(command))
      raise(recorder(), Clause::fanuc_tool_side_rotary_word, AlarmCause::rotary_word_in_compensation);
  }

  // From the first G41.2, G42.2, G41.6 or G42.6 of a program on. Throws Alarm TOOL_SIDE_MODE, PS0037,
  // FORBIDDEN_IN_3D_COMPENSATION, Q_FORMAT, TYPE_C_FORMAT, PS0034 or PS0029.
  void read(const BlockWords& now, StepWords& words) override {
    auto block = std::make_shared<ToolSideBlock>();
    if (!words_.read(now, false, now.command.codes.one_shot == OneShot::none, *block)) return;
    words.side = std::move(block);
    words.side->treatment = treatment(now.command);
    words.side->changes_workpiece_system = now.command.codes.workpiece.has_value();
    check(*words.side, now);
    words_.add_value(*words.side);
  }

  void see(const BlockWay& way, StepWords& words) const override {
    if (words.side) words.side->add_place(way);
  }
  [[nodiscard]] bool has(const StepWords& words) const override { return words.side != nullptr; }
  void take(OwnedStep step) override {
    if (step->stops_look_ahead) {
      // All blocks that wait: nothing is read beyond them before they have run.
      while (make_next(true)) continue;
      recorder().at(step->line);
    }
    SidePlan plan = mode_.next(*step->words.side, *step, waiting());
    step->clauses.add(recorder().take_clauses());
    step->warning = plan.warning;
    window_.push({std::move(step), std::move(plan)});
    SidePlan& last = window_.back().plan;
    if (last.part != SidePart::idle || !last.moves_behind()) return;
    std::size_t made = window_.size();
    while (made > 0 && window_[made - 1].plan.number == 0) --made;
    last.leaves_corner = made == 0 || look(made - 1);
  }

  void end() override { window_.end(); }
  OwnedStep next() override {
    while (made_.size() == waiting_)
      if (!make_next()) return nullptr;
    OwnedStep step = std::move(made_.front());
    made_.pop_front();
    return step;
  }

 private:
  struct Planned {
    OwnedStep step;
    SidePlan plan;
  };
  using Ahead = Window<Planned>::Ahead;

  void check(const ToolSideBlock& words, const BlockWords& now) const {
    const auto& code = now.command.codes.compensation;
    // fanuc.tool-side.code-for-the-mode: Under G43.5, where I J K give the tool direction, the codes are G41.6 and
    // G42.6; otherwise they are G41.2 and G42.2. The codes of both pairs mean the same (a program of the manual shows
    // G42.6).
    if (code && is_tool_side(*code) && is_directed(*code) != now.directed)
      raise(recorder(), Clause::fanuc_tool_side_code_for_the_mode, AlarmCause::side_mode);
    // fanuc.tool-side.plane-selected: A G17, G18 or G19 that changes the plane raises PS0037 if tool side compensation
    // is on before the block. This holds also for the block that cancels it.
    if (on() && words.plane_changed)
      raise(recorder(), Clause::fanuc_tool_side_plane_selected, AlarmCause::plane_change);
    forbid(words, now);
    // fanuc.tool-side.q-format: A Q with another value than 1, 2 or 3 in a block after which tool side compensation is
    // on raises Q_FORMAT, a name of ours, whatever else the block does. In other blocks Q is not looked at.
    if (words.wanted() && words.treatment == 0)
      raise(recorder(), Clause::fanuc_tool_side_q_format, AlarmCause::treatment);
    const bool starts = mode_.starts(words.wanted());
    const bool cancels = mode_.cancels(words.wanted());
    check_type_c(now, starts, cancels);
    // fanuc.cutter-c.start-or-cancel-in-arc: An arc as start-up block or as cancel block raises PS0034. The words of
    // the block tell whether it is an arc: G02 or G03 in force, no code of group 00 in the block (G45 to G48 do not
    // count here), and an axis word of the plane, R, I, J or K in the block. In tool side compensation I, J and K count
    // even if they are a tool direction, because the manual speaks of the mode.
    if (words.arc_words && (starts || cancels))
      raise(recorder(), Clause::fanuc_cutter_c_start_or_cancel_in_arc, AlarmCause::arc_at_start_or_cancel);
    // fanuc.tool-side.arc-on-mixed-machine: On the 30i only G00 and G01 are allowed in compensation on a mixed machine
    // (19680 = 21). There an arc in a block after which tool side compensation is on raises PS5461; the words of the
    // block tell whether it is an arc, as in fanuc.cutter-c.start-or-cancel-in-arc. The 16i runs the arc.
    if (words.arc_words && words.wanted() && parameter(setup(), 19680) == 21 &&
        recorder().decide(Clause::fanuc_tool_side_arc_on_mixed_machine, setup().series == spec::Series::series_30i))
      throw Alarm(AlarmCause::arc_in_compensation);
  }

  void forbid(const ToolSideBlock& words, const BlockWords& now) const {
    const Codes& codes = now.command.codes;
    const bool around = (on() || words.wanted()) && codes.one_shot != OneShot::none;
    const bool refused = codes.workpiece || codes.units || codes.refused_in_space;
    const bool after = words.wanted() && (refused || (codes.auxiliary && (now.moves() || words.arc_words)));
    // fanuc.tool-side.forbidden: Codes that do not go together with tool side compensation raise
    // FORBIDDEN_IN_3D_COMPENSATION (the alarm number is not known). In a block after which the compensation is on,
    // these are G54 to G59, G54.1, G20, G21, G96, G97, G160, G05 except with P10000, and an M, S or T word together
    // with an axis word (I J K under G43.5 included) or in an arc.
    if (around || after || (on() && words.other_compensation))
      raise(recorder(), Clause::fanuc_tool_side_forbidden, AlarmCause::forbidden_in_compensation);
  }

  void check_type_c(const BlockWords& now, bool starts, bool cancels) const {
    if (!setup().bit(5003, 1) || !(starts || cancels)) return;
    // fanuc.tool-side.type-c-format: A block of type C that makes or removes the vector raises TYPE_C_FORMAT (a name of
    // ours, the number is not known) if it has an axis word, linear or rotary (I J K under G43.5 included), or if G02
    // or G03 is in force. A block that makes the vector also raises it with an M code that stops reading ahead
    // (fanuc.program.stops-reading-ahead), or if the block right after it does not move in the plane of VT before that
    // block (its own end does not matter), cancels, raises an alarm of its own (DIR_CHANGE_AT_STARTUP and PS0038 too),
    // leaves the run undecided or is not there.
    if (now.moves() || now.command.is_arc_motion() || (starts && now.command.codes.stops_look_ahead))
      raise(recorder(), Clause::fanuc_tool_side_type_c_format, AlarmCause::type_c_format);
  }

  // G40 or number 0 is in force.
  [[nodiscard]] static bool ends_mode(const Planned& b) { return !b.step->words.side->wanted(); }

  // The first block that waits, if what it needs is known. `stopped`: the look-ahead stops after the window.
  bool make_next(bool stopped = false) {
    if (window_.empty()) return false;
    const auto ahead = look(0, stopped);
    if (!ahead) return false;
    Planned b = window_.pop();
    recorder().at(b.step->line);
    make_moves(b, *ahead);
    b.step->clauses.add(recorder().take_clauses());
    made_.push_back(std::move(b.step));
    return true;
  }

  // fanuc.tool-side.one-block-without-movement: If one block between A and B does not move in the plane at the end of A
  // (a rotation alone, a movement along the tool), the group is made of A and B in that plane, with VT before the first
  // block between.
  // fanuc.tool-side.two-blocks-without-movement: As soon as two blocks that do not move in the plane at the end of A
  // follow block A (on the 30i N - 1, fanuc.tool-side.look-ahead), A ends with the vector perpendicular to it, and
  // there is no corner.
  // fanuc.tool-side.no-next-block: If there is no B, block A, also a start-up block, ends with the vector perpendicular
  // to it too. There is no B at the end of the program, before a block that raises an alarm when it is read or leaves
  // the run undecided, and before G40 or number 0 in a block that does not move in the plane at the end of A.
  // fanuc.tool-side.look-ahead-stopped: An M code that stops reading ahead (fanuc.program.stops-reading-ahead) stops
  // the look-ahead. The block A before it, also a start-up block, ends with the vector perpendicular to it.
  [[nodiscard]] std::optional<Ahead> look(std::size_t at, bool stopped = false) const {
    const SidePlan& a = window_[at].plan;
    if (a.number == 0) return Ahead{};
    bool repeated = false;
    int count = 0;
    for (std::size_t i = at + 1; i < window_.size(); ++i) {
      const Planned& b = window_[i];
      repeated = repeated || b.step->words.side->repeats_code();
      if (b.plan.start_at(a.number) != nullptr) return Ahead{&b, repeated, count > 0};
      if (ends_mode(b) || a.part == SidePart::lone_start) return Ahead{.why = Clause::fanuc_tool_side_no_next_block};
      if (++count >= limit_) return Ahead{.why = Clause::fanuc_tool_side_two_blocks_without_movement};
    }
    if (stopped) return Ahead{.why = Clause::fanuc_tool_side_look_ahead_stopped};
    if (!window_.ended()) return std::nullopt;
    return Ahead{.why = Clause::fanuc_tool_side_no_next_block};
  }

  // The blocks whose corners are not known.
  [[nodiscard]] std::vector<const SidePlan*> waiting() const {
    std::vector<const SidePlan*> result;
    for (std::size_t i = 0; i < window_.size(); ++i)
      if (!look(i)) result.push_back(&window_[i].plan);
    return result;
  }

  // The moves of a block, and where the tool stands after it.
  void make_moves(Planned& b, const Ahead& ahead) {
    switch (b.plan.part) {
      case SidePart::free:
        break;
      case SidePart::idle:
        idle(b);
        break;
      case SidePart::lone_start:
        lone_start(b, ahead);
        break;
      case SidePart::lone_cancel:
        lone_cancel(b);
        break;
      case SidePart::start_up:
      case SidePart::moving:
        mode_block(b, ahead);
        break;
      case SidePart::cancel:
        cancel(b);
        break;
    }
  }

  // A block that makes no vector runs with the last head, and takes the corner moves that are left.
  void idle(Planned& b) {
    // fanuc.tool-side.along-the-tool-at-its-end: A block that is B of a corner but does not move in the plane at its
    // own end has no vector made there. This happens if the tool turns in the block so that the displacement is along
    // the tool there, or shorter than 19630 as seen there. The block ends with the last vector at its start, and the
    // next block that moves at its own end starts from that vector, without a corner.
    if (b.plan.moves_behind()) recorder().reach(Clause::fanuc_tool_side_along_the_tool_at_its_end);
    if (waiting_ > 0 && !b.plan.leaves_corner) {
      ++waiting_;
      return;
    }
    flush();
    run_at_last_head(*b.step);
    // The head is no longer one of the corner where the vector was made.
    if (b.plan.leaves_corner) tool_.stand({tool_.heads.front().vector});
  }

  void run_at_last_head(Step& step) {
    at_head(step, tool_.heads.back());
    if (!step.moves.empty()) insert_corner_moves(step, *step.words.side, tool_);
  }

  // A start-up block, or a block of the mode.
  void mode_block(Planned& a, const Ahead& ahead) {
    const SidePlan& plan = a.plan;
    SpaceGroup at_end = group_at_end(a, ahead);
    std::optional<ToolArcRun> run = arc_run(recorder(), plan, plane_, tool_.heads.back(), at_end.front());
    Checked checked;
    // fanuc.cutter-c.interference-check: No. 5008 bit 0, CNI, switches the interference check: 0 checks, 1 does not.
    if (plan.part == SidePart::moving &&
        recorder().decide(Clause::fanuc_cutter_c_interference_check, !setup().bit(5008, 0)))
      checked =
          check_interference(recorder(), {}, between_vectors(plan, plane_), tool_.heads, at_end, run ? &*run : nullptr);
    // fanuc.cutter-c.interference-alarm: Interference of the last pair, or of the only pair, raises PS0041 (except in
    // fanuc.cutter-c.interference-without-alarm). The alarm names the block. Neither the block nor its corner moves are
    // given; the block before it runs to the first head of its own group.
    if (checked.passage == Passage::blocked)
      raise_at(a, Clause::fanuc_cutter_c_interference_alarm, AlarmCause::interference, checked.crossing);
    flush();
    Step& step = *a.step;
    step.clauses.add(recorder().take_clauses());  // an arc that is not decided names its own clauses alone
    end_at(step.moves.front(), at_end.front(), run ? &*run : nullptr, checked.passage);
    if (plan.part == SidePart::start_up) step.moves.front().leg.cause = spec::Cause::start_up;
    insert_corner_moves(step, *step.words.side, tool_);
    tool_ = {std::move(at_end), step.rest};
    plane_ = plan.plane;
    waiting_ = tool_.heads.size() > 1 ? 1 : 0;
  }

  // The vectors at the end of a block that makes one: those of the corner, or the one perpendicular to it.
  [[nodiscard]] SpaceGroup group_at_end(const Planned& a, const Ahead& ahead) {
    if (ahead.next == nullptr) {
      recorder().reach(ahead.why);
      return rules_.in_plane(rules_.square_to(*a.plan.end));
    }
    recorder().decide(Clause::fanuc_tool_side_one_block_without_movement, ahead.between);
    const SidePlan& next = ahead.next->plan;
    SideCase given{.starts = a.plan.part == SidePart::start_up,
                   .cancels = ends_mode(*ahead.next),
                   .side_changes = a.plan.offset.side != next.offset.side,
                   .repeated = ahead.repeated,
                   .next_arc = next.arc};
    if (!given.starts && !given.cancels) given.treatment = a.step->words.side->treatment.value_or(0);
    // fanuc.cutter-c.value-at-a-corner: A new number or value counts for the vectors at the end of the moving block
    // that has it, or, if that block does not move, at the end of the next moving block.
    if (!given.cancels)
      recorder().decide(Clause::fanuc_cutter_c_value_at_a_corner, next.offset.value != a.plan.offset.value);
    auto group = rules_.group({a.plan.plane, *a.plan.end, *next.start_at(a.plan.number)}, given);
    // fanuc.cutter-c.no-intersection: An inner corner with an arc and R' >= 0 whose offset paths do not meet raises
    // PS0033. The alarm names A. Neither A nor a corner move of A is given, and the blocks before A are given as
    // computed with A present.
    if (!group) raise_at(a, Clause::fanuc_cutter_c_no_intersection, AlarmCause::no_intersection);
    const bool in_mode = !given.starts && !given.cancels && !given.side_changes && !given.repeated;
    // fanuc.tool-side.plane-change-alarm: If all three conditions of the plane change check hold, PS0041 is raised;
    // OVERCUT_PLANE_CHANGE is our name for this cause of it. The alarm list of this control has P/S0041; the text of
    // the manual has PS0272, a number of a sister control.
    if (in_mode && a.plan.end->offset != 0 && given.treatment == 0 && plane_change_.interferes(a.plan, next))
      raise_at(a, Clause::fanuc_tool_side_plane_change_alarm, AlarmCause::interference);
    return rules_.in_plane(std::move(group->vectors));
  }

  void lone_start(Planned& b, const Ahead& ahead) {
    // fanuc.tool-side.start-type-c: With type C, the block with which a code and a number other than 0 come into force
    // inserts a move from the uncompensated point by the vector perpendicular to the next block at its start, in the
    // plane of VT at that moment. The cause of the move is start-up, and it is of the kind of group 01.
    if (ahead.next == nullptr) raise_at(b, Clause::fanuc_tool_side_type_c_format, AlarmCause::type_c_format);
    recorder().reach(Clause::fanuc_tool_side_start_type_c);
    plane_ = b.plan.plane;
    tool_.heads = square_to_latter(*ahead.next->plan.start_at(b.plan.number));
    change_alone(*b.step, spec::Cause::start_up, b.plan.changes);
    run_at_last_head(*b.step);
  }

  // G40 or number 0.
  void cancel(Planned& b) {
    // fanuc.tool-side.cancel: With types A and B, the first block that moves in the plane at its own end with G40 or
    // number 0 in force is the cancel block. The tool goes straight from the last head of the group at its start to its
    // programmed end; the cause is cancel.
    recorder().reach(Clause::fanuc_tool_side_cancel);
    flush();
    insert_corner_moves(*b.step, *b.step->words.side, tool_);
    b.step->moves.back().leg.cause = spec::Cause::cancel;
    tool_.stand({});
  }

  // In a block that does not move in the plane at its own end.
  void lone_cancel(Planned& b) {
    // fanuc.tool-side.type-c: Start-up and cancel are of type C if No. 5003 bit 1, SUV, is 1, whatever bit 0 is. If SUV
    // is 0, bit 0 chooses between the other two types (fanuc.tool-side.type-b).
    const bool removes = recorder().decide(Clause::fanuc_tool_side_type_c, setup().bit(5003, 1));
    // fanuc.tool-side.cancel-type-c: With type C, the last compensated block ends with the vector perpendicular to it.
    // The block with G40 or number 0, which has no move of its own, inserts a move that takes the vector away. The
    // cause of this move is cancel, and it is of the kind of group 01.
    // fanuc.tool-side.cancel-without-movement: With types A and B, G40 or number 0 in a block that does not move in the
    // plane at its own end keeps the last vector at its start. The next block that moves in the plane of VT at its own
    // end removes that vector: the tool goes straight to the end of that block, the cause is cancel, and an arc raises
    // PS0034.
    recorder().reach(removes ? Clause::fanuc_tool_side_cancel_type_c : Clause::fanuc_tool_side_cancel_without_movement);
    if (b.plan.leaves_corner) recorder().reach(Clause::fanuc_tool_side_along_the_tool_at_its_end);
    flush();
    if (removes) change_alone(*b.step, spec::Cause::cancel, b.plan.changes);
    if (removes || !b.plan.changes) tool_.stand({});
    run_at_last_head(*b.step);
    if (b.plan.leaves_corner) tool_.stand({tool_.heads.front().vector});
  }

  // The vectors at which the block that waits ends are final. The corner moves up to the stop point belong to it.
  void flush() {
    if (waiting_ == 0) return;
    append_corner_moves(*made_[made_.size() - waiting_], tool_);
    while (--waiting_ > 0) run_at_last_head(*made_[made_.size() - waiting_]);
  }

  // The alarm names this block, and nothing of it is given.
  [[noreturn]] void raise_at(const Planned& b, Clause clause, AlarmCause cause, const Real& crossing = {}) {
    flush();
    recorder().reach(clause);
    window_.clear();
    throw geometry_alarm(*b.step, setup().axes, cause, crossing);
  }

  int limit_;
  CornerWords words_;
  SideRules rules_;
  PlaneChangeCheck plane_change_;

  SideMode mode_;
  Window<Planned> window_;
  Standing tool_;
  CompensationPlane plane_;     // in which the vectors were made at which the tool stands
  std::deque<OwnedStep> made_;  // in order
  std::size_t waiting_ = 0;     // how many of them wait: the block that ends there, and those without a vector after it
};

}  // namespace

std::unique_ptr<Pass> tool_side_compensation(const Pass::Place& place) {
  return std::make_unique<ToolSideCompensation>(place);
}

}  // namespace toolcomp::model
