// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/leading_edge_offset/leading_edge_stage.h"

#include "fast/fanuc/control/xyz_travel.h"

namespace toolcomp::fast {
namespace {

constexpr std::uint32_t kDirectionLetters = Words::set_of("IJK");
constexpr std::uint32_t kAuxiliaryLetters = Words::set_of("MST");

// A code of another compensation of the same group.
bool is_other(Code code) { return code != kNone && code != kG40 && code != kG41_3; }

}  // namespace

void LeadingEdgeStage::release() {
  if (offset_.active() && offset_.release()) end_at_start(AlarmCause::leading_edge_command);
}

// Other compensations are forbidden in it and do not end it; with number 0 it ends.
void LeadingEdgeStage::read(const Words& words, const Command& /*command*/) {
  const Code code = words.code(Words::kCompensation);
  const bool active = offset_.active();
  d_read_ = words.has('D') ? whole_number(words['D'], control_.memory.count()) : d_;
  const bool after = (code == kNone || (active && is_other(code)) ? active : code == kG41_3) && d_read_ != 0;
  set_read(active || code == kG41_3, active, after);
}

// The alarms that words and state alone show (clause fanuc.program.alarm-order).
Alarm LeadingEdgeStage::check(const Words& words, const Command& command) const {
  const bool code = words.code(Words::kCompensation) == kG41_3;
  const bool moves = words.axes() != 0 || (command.vector && words.has_any(kDirectionLetters));
  // The format of a G41.3 block counts where it starts nothing too: with D0, or in the mode.
  if (code && (moves || words.suppresses_look_ahead())) return AlarmCause::leading_edge_format;
  if (on_before() && !on_after() && moves) return AlarmCause::leading_edge_format;
  if (code && command.motion > kG01) return AlarmCause::leading_edge_start;
  if (on_before() && (code || command.motion > kG01)) return AlarmCause::leading_edge_command;
  if (!on_after()) return AlarmCause::none;
  if (is_other(words.code(Words::kCompensation))) return AlarmCause::forbidden_in_compensation;
  if (words.code(Words::kOneShot) != kNone || words.code(Words::kWorkpiece) != kNone ||
      words.code(Words::kUnits) != kNone || words.refused_in_space() || (moves && words.has_any(kAuxiliaryLetters)))
    return AlarmCause::forbidden_in_compensation;
  if (!on_before() || words.has('D'))
    if (!control_.memory.fits(control_.memory.d(d_read_))) return AlarmCause::offset_value;
  return AlarmCause::none;
}

Alarm LeadingEdgeStage::take(const Words& words, Command& command) {
  d_ = d_read_;
  if (on_after() && (!on_before() || words.has('D'))) radius_ = control_.memory.d(d_).nearest();
  if (words.suppresses_look_ahead() && on_before())
    if (const Alarm a = offset_.release()) return a;
  set_takes_moves(on_before() || on_after());
  command.taken |= takes_moves();
  return AlarmCause::none;
}

Alarm LeadingEdgeStage::move(const Words& words, const OwnMove& own) {
  const bool words_move = own.one_shot == kNone;
  if (on_before() && on_after()) return follow(words, words_move, own.extra);
  if (const Alarm a = control_.place_words(words, words_move ? words.axes() : Mask{0})) return a;
  return on_after() ? start() : cancel();
}

Alarm LeadingEdgeStage::start() {
  Move& move = offset_.next();
  control_.fill(move.event, control_.modal.straight(), spec::Cause::start_up);
  move.direction = &control_.attitude.directions().now();
  move.radius = radius_;
  offset_.start();
  set_on(true);
  return AlarmCause::none;
}

Alarm LeadingEdgeStage::cancel() {
  if (const Alarm a = offset_.finish()) return a;
  control_.fill(offset_.next().event, control_.modal.straight(), spec::Cause::cancel);
  offset_.cancel();
  set_on(false);
  return AlarmCause::none;
}

Alarm LeadingEdgeStage::plain_block(const Words& words) {
  if (!words.any()) return AlarmCause::none;
  if (control_.modal.motion() > kG01) return AlarmCause::leading_edge_command;
  return follow(words, true, false);
}

Alarm LeadingEdgeStage::follow(const Words& words, bool own, bool extra) {
  const Mask axes = own ? words.axes() : Mask{0};
  const XyzTravel xyz(control_);
  if (const Alarm a = control_.place_words(words, axes)) return a;

  // As early as can be: what has just been written is waited for.
  Move& move = offset_.next();
  if (xyz.is_small()) [[likely]]
    set_displacement(move.displacement, xyz.small(0), xyz.small(1), xyz.small(2));
  else
    set_displacement(move.displacement, xyz.from(), control_.positions.programmed_xyz(), xyz.slack(axes));
  const bool event = axes != 0 || extra || (own && control_.modal.by_vector() && words.has_any(kDirectionLetters));
  if (event) control_.fill(move.event, control_.modal.straight(), spec::Cause::programmed);
  move.direction = &control_.attitude.directions().now();
  move.radius = radius_;
  // The only alarms here are those of the start-up move.
  if (const Alarm a = offset_.block(event, !move.displacement.zero)) end_at_start(a);
  return AlarmCause::none;
}

}  // namespace toolcomp::fast
