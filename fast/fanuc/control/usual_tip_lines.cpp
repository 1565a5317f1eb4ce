// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/control/usual_tip_lines.h"

#include "fast/basis/short_cut.h"

namespace toolcomp::fast {

bool ToolAttitude::awaits_lines() const {
  const bool on_table = machine_.workpiece_frame() && machine_.has_table();
  return plans_tool_ && !starts_tip_ && lean_angle_.is_zero() && !on_table && tip_.takes_lines();
}

[[gnu::always_inline]] inline TipBlock& ToolAttitude::next_line() {
  TipBlock& block = tip_.next();
  block.length = along_length_;
  return block;
}

Alarm ToolAttitude::plan_line(bool turns) {
  const Pose& start = tip_.block().plan.end;
  TipBlock& block = next_line();
  if (!turns) {
    posture_.stand(start, block.plan);
    return AlarmCause::none;
  }
  pose_commanded(block.plan.end);
  posture_.plan(start, block.plan.end, posture_control_, block.plan);
  return alarm_of(block.plan.outcome);
}

Alarm ToolAttitude::plan_line(std::int64_t i, std::int64_t j, std::int64_t k) {
  const Pose& start = tip_.block().plan.end;
  TipBlock& block = next_line();
  set_small_direction(commanded_, i, j, k);
  posture_.plan(start, commanded_, posture_control_, block.plan);
  if (block.plan.changed) commanded_ = block.plan.end.tool;
  return alarm_of(block.plan.outcome);
}

bool UsualTipLines::may_come() const {
  const AxisPositions& positions = control_.positions;
  return is_open(ShortCut::tip_line) && control_.attitude.awaits_lines() && control_.modal.motion() <= kG01 &&
         !control_.modal.incremental() && usual_positions_may_come(control_) && positions.length().live() == 0;
}

void UsualTipLines::await() {
  if (!may_come()) return;
  const std::uint32_t turning = control_.modal.by_vector() ? kDirection : letters_of_further_axes(control_);
  words_.permit(kXyz | turning | UsualWords::set_of("FG"));
  handover_.take(*this);
}

BlockTaker& UsualTipLines::leave() {
  control_.attitude.leave_lines();
  return handover_.back();
}

void UsualTipLines::block(const spec::Block& block) {
  if (take(block)) [[likely]]
    return;
  leave().block(block);
}

[[gnu::always_inline]] inline Mask UsualTipLines::place(std::uint32_t letters) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if ((letters & (UsualWords::set('X') << axis)) != 0) control_.positions.place_small(axis, words_[kX + axis]);
  const unsigned named = control_.axes.letters.positions(letters >> 1U);
  for (unsigned rest = named & ~0b111U; rest != 0; rest &= rest - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(rest));
    control_.positions.place_small(axis, words_[control_.axes.letters.index[axis] + 1U]);
  }
  return static_cast<Mask>(named & control_.axes.turning);
}

void UsualTipLines::send_with_turns(const spec::Block& block) {
  control_.attitude.leave_lines();
  control_.line = block.line;
  control_.n = block.n;
  Event move;
  control_.fill(move, control_.modal.straight(), spec::Cause::programmed);
  control_.attitude.tip().on(move);
}

[[gnu::always_inline]] inline bool UsualTipLines::take(const spec::Block& block) {
  constexpr std::uint32_t kFeed = UsualWords::set('F');
  for (std::size_t i = 0; i < 3; ++i) words_[kI + i] = 0;
  std::uint32_t letters = 0;
  if (block.alarm || !words_.read(block, control_.modal.motion(), letters)) [[unlikely]]
    return false;
  if ((letters & ~(kFeed | UsualWords::set('G'))) == 0) [[unlikely]]
    return false;
  const bool directs = (letters & kDirection) != 0;
  if (directs && (words_[kI] | words_[kI + 1] | words_[kI + 2]) == 0) [[unlikely]]
    return false;

  if ((letters & kFeed) != 0) [[unlikely]]
    control_.modal.set_feed(words_.feed());
  const bool turns = place(letters) != 0;
  const Alarm alarm = directs ? control_.attitude.plan_line(words_[kI], words_[kI + 1], words_[kI + 2])
                              : control_.attitude.plan_line(turns);
  if (alarm) [[unlikely]] {
    control_.line = block.line;
    control_.n = block.n;
    control_.end(alarm.cause);
    return true;
  }
  const AxisPositions& positions = control_.positions;
  const Vector3<double> at{positions.programmed_value(0), positions.programmed_value(1), positions.programmed_value(2)};
  if (!control_.attitude.tip().send_line(block.line, block.n, control_.modal.straight(), control_.modal.feed(), at))
      [[unlikely]]
    send_with_turns(block);
  return true;
}

}  // namespace toolcomp::fast
