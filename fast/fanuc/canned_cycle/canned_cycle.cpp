// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/canned_cycle/canned_cycle.h"

namespace toolcomp::fast {
namespace {

// Of a block that drills. L counts where there is no K, and no M98 to which it belongs.
std::uint32_t repeats_of(const Words& words) {
  if (words.has('K')) return whole_number(words['K'], CycleCommand::kMostRepeats);
  if (words.has('L') && !words.calls_by_l()) return whole_number(words['L'], CycleCommand::kMostRepeats);
  return 1;
}

}  // namespace

CannedCycle::CannedCycle(const spec::Setup& setup) : by_plane_(setup.bit(5101, 0)), z_(setup.axes.index('Z')) {}

CycleCommand CannedCycle::read(const Words& words, std::size_t normal) const {
  CycleCommand command;
  const Code back = words.code(Words::kReturn);
  command.to_point_r = back == kNone ? to_point_r_ : back == kG99;
  // Of any code of group 01, before that of a cycle or behind it.
  if (words.code(Words::kMotion) != kNone) return command;
  const Code code = words.code(Words::kCycle);
  if (code == kG80) return command;
  command.cycle = code == kNone ? cycle_ : code;
  if (!command.on()) return command;

  command.begins = !on();
  command.axis = by_plane_ ? normal : z_;
  const bool own = !words.shifts_coordinates() && !words.letters_are_data();
  command.named = own ? words.axes() : Mask{0};
  command.drills = command.named != 0 || (own && words.has('R'));
  if (command.drills) command.repeats = repeats_of(words);
  return command;
}

bool CannedCycle::is_said(const Words& words, const CycleCommand& command) const {
  const Code one_shot = words.code(Words::kOneShot);
  if (one_shot == kG37 || one_shot == kG39 || one_shot == kG53) return false;
  if (command.axis == spec::Axes::kNone || (!command.begins && command.axis != axis_)) return false;
  if (!command.drills) return true;
  return command.repeats <= CycleCommand::kMostRepeats &&
         !(command.cycle == kG87 && command.to_point_r && command.makes_holes());
}

bool CannedCycle::lacks_depth_of_cut(const Words& words, const CycleCommand& command) const {
  if ((command.cycle != kG73 && command.cycle != kG83) || !command.makes_holes()) return false;
  return words.has('Q') ? words['Q'].is_zero() : command.begins || !has_depth_of_cut_;
}

void CannedCycle::take(const Words& words, const CycleCommand& command, const WordUnits& units, bool incremental) {
  to_point_r_ = command.to_point_r;
  cycle_ = command.cycle;
  if (!on()) return;
  if (command.begins) {
    axis_ = command.axis;
    point_r_.reset();
    bottom_.reset();
    has_depth_of_cut_ = false;
    rise_ = Count();
    rise_rounded_ = false;
  }
  if (!command.drills) return;
  if (words.has('R')) point_r_ = Given{units.value(words['R'], true), incremental};
  if ((command.named & bit(axis_)) != 0) bottom_ = Given{units.value(words.axis(axis_), true), incremental};
  if (words.has('Q')) has_depth_of_cut_ = !words['Q'].is_zero();
}

Count CannedCycle::along(const Count& from, const std::optional<Given>& given) {
  if (!given) return from;
  return given->distance ? from + given->value : given->value;
}

// Each is looked at before the next is counted from it: sums of more terms could be too large.
Alarm CannedCycle::find_levels(const Count& position, bool rounded, HoleLevels& levels) const {
  levels.initial = position + rise_;
  if (!levels.initial.in_range()) return AlarmCause::position_range;
  levels.point_r = along(levels.initial, point_r_);
  if (!levels.point_r.in_range()) return AlarmCause::position_range;
  levels.bottom = along(levels.point_r, bottom_);
  if (!levels.bottom.in_range()) return AlarmCause::position_range;
  levels.level = to_point_r_ ? levels.point_r : levels.initial;
  levels.initial_rounded = rounded || rise_rounded_;
  levels.level_rounded = levels.initial_rounded && !(to_point_r_ && point_r_ && !point_r_->distance);
  return AlarmCause::none;
}

void CannedCycle::stand_at(const HoleLevels& levels) {
  rise_ = levels.initial - levels.level;
  rise_rounded_ = levels.initial_rounded && !levels.level_rounded;
}

}  // namespace toolcomp::fast
