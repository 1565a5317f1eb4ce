// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/canned_cycle/canned_cycle.h"

#include <utility>

#include "model/basis/alarm.h"
#include "model/geometry/plane.h"

namespace toolcomp::model {

CannedCycle::CannedCycle(const spec::Setup& setup, const Numbers& numbers, Recorder& recorder)
    : numbers_(numbers), recorder_(recorder), axes_(setup.axes), by_plane_(setup.bit(5101, 0)) {}

void CannedCycle::read(Command& command) {
  const Codes& codes = command.codes;
  const bool was_on = cycle_.has_value();
  change_mode(codes);
  if (codes.to_initial_level) to_initial_level_ = *codes.to_initial_level;
  CycleBlock& block = command.cycle;
  block.on = cycle_.has_value();
  if (!block.on) return;
  const std::size_t axis = axis_of(command.plane);
  if (!was_on) {
    axis_ = axis;
    point_r_ = bottom_ = {};
    depth_of_cut_ = false;
    rise_ = {};
  }
  same_axis_ = axis == axis_ && axis != spec::Axes::kNone;
  const bool own = !codes.letters_are_data && !is_shift(codes.one_shot);
  // fanuc.canned-cycle.drills: A block in the drilling mode drills if it has an axis word or R, the block with the
  // cycle code included. It makes no move of its own. Its event is the hole. A block without these words drills
  // nothing, its Q is not kept, and its I J K R make no arc. Letters that are data of another code
  // (fanuc.program.letters-as-data), and axis words and R of a block with G52 or G92, do not count. For all other rules
  // a block that drills names no axis.
  block.drills =
      recorder_.decide(Clause::fanuc_canned_cycle_drills, own && (command.axes != 0 || command.words.has('R')));
  command.direction = false;
  if (!own) return;
  block.axes = std::exchange(command.axes, AxisMask{0});
  if (!block.drills) return;
  block.repeats = repeats(codes, command.words);
  keep(command);
}

void CannedCycle::change_mode(const Codes& codes) {
  const bool starts = codes.cycle && *codes.cycle != Cycle::cancel;
  if (codes.motion ? (cycle_ || starts) : (codes.cycle && !starts)) {
    // fanuc.canned-cycle.cancel: G80, and a code of group 01 (G00 G01 G02 G03), end the drilling mode and clear its
    // data. If a block has a cycle code and a code of group 01, in whatever order, the cycle code is cancelled and the
    // mode is off.
    recorder_.decide(Clause::fanuc_canned_cycle_cancel, codes.motion.has_value());
    cycle_.reset();
  } else if (starts) {
    // fanuc.canned-cycle.mode: G73 G74 G76 and G81 to G89 start the drilling mode, which is modal. Another of these
    // codes in the mode changes the cycle, and what the mode keeps (data, initial level) stays.
    recorder_.decide(Clause::fanuc_canned_cycle_mode, !cycle_);
    cycle_ = codes.cycle;
  }
}

std::size_t CannedCycle::axis_of(spec::Plane plane) const {
  // fanuc.canned-cycle.drilling-axis: With FXY (5101#0) = 0 the drilling axis is Z. With FXY = 1 it is the axis at
  // right angles to the plane of the block: Z in G17, Y in G18, X in G19.
  return axes_.index(recorder_.decide(Clause::fanuc_canned_cycle_drilling_axis, by_plane_) ? normal(plane) : 'Z');
}

Rational CannedCycle::repeats(const Codes& codes, const Words& words) const {
  const spec::Decimal* number = words.find('K');
  if (number == nullptr && !codes.calls) number = words.find('L');
  // fanuc.canned-cycle.repeats: K says how many holes a block drills, one after the other. Under G91 each hole is
  // further by the travel of the block, under G90 all holes are in one place. K counts in its block alone. In a block
  // without K, L counts for it, except the L of M98. Without both the block drills one hole.
  return recorder_.decide(Clause::fanuc_canned_cycle_repeats, number != nullptr) ? plain(*number) : Rational(1);
}

void CannedCycle::keep(const Command& command) {
  const Words& words = command.words;
  if (const spec::Decimal* const r = words.find('R')) point_r_ = {numbers_.length(*r), command.incremental};
  if (in(command.cycle.axes, axis_)) bottom_ = {numbers_.length(*words.find(axes_.letter(axis_))), command.incremental};
  if (const spec::Decimal* const q = words.find('Q')) depth_of_cut_ = plain(*q) != 0;
}

void CannedCycle::check(const Command& command, const Passes& passes) const {
  const Passes::InForce space = passes.in_force(Extent::space, command);
  const Passes::InForce plane = passes.in_force(Extent::plane, command);
  const CycleBlock& block = command.cycle;
  const OneShot one_shot = command.codes.one_shot;
  // fanuc.canned-cycle.reference-return: G28, G29, G30 or G30.1 in a block in the drilling mode raises PS0044.
  if (is_reference_return(one_shot) || one_shot == OneShot::from_reference)
    raise(recorder_, Clause::fanuc_canned_cycle_reference_return, AlarmCause::reference_in_cycle);
  if (space.after || plane.after) {
    // fanuc.canned-cycle.in-compensation: A block in the drilling mode raises an alarm if a compensation by radius is
    // on after it. The alarm is FORBIDDEN_IN_3D_COMPENSATION if that is one of G41.2 G42.2 G41.3 G41.6 G42.6, and
    // FORBIDDEN_IN_CUTTER_COMPENSATION under G41 or G42.
    throw Alarm(recorder_.decide(Clause::fanuc_canned_cycle_in_compensation, space.after)
                    ? AlarmCause::forbidden_in_compensation
                    : AlarmCause::forbidden_in_cutter_compensation);
  }
  const bool other_code =
      one_shot == OneShot::measure || one_shot == OneShot::corner_arc || one_shot == OneShot::machine_coordinates;
  const bool drills = block.makes_holes();
  // fanuc.canned-cycle.not-said: If the manual does not say what a block in a canned cycle does, the run ends undecided
  // at that block. In the drilling mode this holds for G37, G39 and G53; for a compensation by radius that is on before
  // the block but not after it (its vector is removed in the block, or waits for its removal), and then the blocks
  // before it are given as if this block were absent; for a drilling axis other than that of the mode, and for one that
  // the machine does not have. In a block that drills it holds for a number of repeats that is no whole number from 0
  // to 9999, and, except with K0, for G99 under G87.
  if (other_code || space.before || plane.before || !same_axis_ ||
      (block.drills && !is_whole(block.repeats, 0, 9999)) ||
      (drills && cycle_ == Cycle::back_boring && !to_initial_level_)) {
    recorder_.reach(Clause::fanuc_canned_cycle_not_said);
    leave_open_alone(recorder_, Clause::fanuc_canned_cycle_not_said,
                     "the manual does not say what this block does in a canned cycle");
  }
  // fanuc.canned-cycle.tool-offset: In a block in the drilling mode G45 to G48 only store the number.
  if (is_tool_offset(one_shot)) recorder_.reach(Clause::fanuc_canned_cycle_tool_offset);
  // fanuc.canned-cycle.depth-of-cut: A block that drills under G73 or G83, except with K0, raises PS0045 if Q is 0 or
  // none has been given since the mode began. Q of a block that drills is kept.
  if (drills && cycle_ == Cycle::pecking && recorder_.decide(Clause::fanuc_canned_cycle_depth_of_cut, !depth_of_cut_))
    throw Alarm(AlarmCause::cycle_without_depth_of_cut);
}

Position CannedCycle::place(const Command& command, const Position& from) const {
  Position end = from;
  for (const std::size_t i : axes_in(command.cycle.axes)) {
    if (i == axis_) continue;
    const char letter = axes_.letter(i);
    const Rational value = numbers_.of_axis(letter, *command.words.find(letter));
    // fanuc.canned-cycle.position: The axis words of the block, except that of the drilling axis, give the position of
    // the hole. Under G90 they are coordinates, under G91 the travel from the previous hole, or from where the axes
    // stand. An axis without a word stays.
    if (recorder_.decide(Clause::fanuc_canned_cycle_position, command.incremental))
      end.at(i) = end.at(i) + value;
    else
      end.at(i) = value;
  }
  return end;
}

std::vector<DrilledHole> CannedCycle::drill(const Command& command, const Position& from) {
  if (!command.cycle.makes_holes()) {
    // fanuc.canned-cycle.no-hole: A block with K0 keeps its data (point R, bottom, Q) and drills nothing. It moves only
    // by a change of its length offset.
    recorder_.reach(Clause::fanuc_canned_cycle_no_hole);
    return {};
  }
  // fanuc.canned-cycle.initial-level: The initial level is where the drilling axis stands when the drilling mode
  // begins. G99 does not change it. What renames the position of that axis in the mode (another workpiece system, G52,
  // G92, G10 L2, 5006#6) renames the initial level in the same way.
  recorder_.reach(Clause::fanuc_canned_cycle_initial_level);
  const Coordinate initial = from.at(axis_) + rise_;
  // fanuc.canned-cycle.point-r: Under G90 R of a block is the coordinate of point R, under G91 it is its distance from
  // the initial level.
  const Coordinate point_r = recorder_.decide(Clause::fanuc_canned_cycle_point_r, point_r_.distance)
                                 ? initial + point_r_.value
                                 : Coordinate(point_r_.value);
  // fanuc.canned-cycle.bottom: Under G90 the word of the drilling axis is the coordinate of the bottom, under G91 it is
  // its distance from point R.
  const Coordinate bottom = recorder_.decide(Clause::fanuc_canned_cycle_bottom, bottom_.distance)
                                ? point_r + bottom_.value
                                : Coordinate(bottom_.value);
  // fanuc.canned-cycle.return: Under G98 the tool returns to the initial level, under G99 to point R. G98 is in force
  // at the start. After the block the position is that of the last hole, at this level.
  const bool rises = recorder_.decide(Clause::fanuc_canned_cycle_return, to_initial_level_);
  rise_ = rises ? Coordinate() : initial - point_r;
  std::vector<DrilledHole> holes;
  Position at = from;
  for (Rational made = 0; made < command.cycle.repeats; made += 1) {
    at = place(command, at);
    at.at(axis_) = rises ? initial : point_r;
    holes.push_back({Move(), axis_, point_r, bottom});
    holes.back().move.leg.end = at;
  }
  return holes;
}

}  // namespace toolcomp::model
