// SPDX-License-Identifier: Apache-2.0
// Blocks that move without axis words, M140 and departures from a contour, and positions that nobody knows.
#include <bit>

#include "fast/heidenhain/interpreter/interpreter.h"

namespace toolcomp::fast::klartext {

bool Interpreter::moves_without_words(const Block& block) {
  return block.retraction != spec::klartext::Retraction::none || block.departs;
}

Alarm Interpreter::place_without_words(const Block& block) {
  const unsigned before = unknown_;
  head_.rotary = 0;
  head_.more_axes = parallel_axes_;
  if (!block.departs && block.feed == spec::klartext::FeedWord::none) head_.rapid = true;
  std::array<Count, 3> way;
  double slack = 0;
  switch (block.retraction) {
    case spec::klartext::Retraction::by:
      if (const Alarm a = retract(block, way, slack)) return a;
      break;
    case spec::klartext::Retraction::to_limit:
      // How far it is nobody knows, but where to: any length directs the block that is held.
      slack = direction_->way(Count::of(spec::decimal(1000)), way);
      set_unknown(before | direction_->components());
      break;
    case spec::klartext::Retraction::none:
      set_unknown(before | (kMainSlots & ~(1U << tool_axis_)));
      break;
  }
  if (needs_unknown(block, before)) return AlarmCause::not_judged;
  if (compensates() || peripheral_.holds()) set_displacement(peripheral_.next().travel, {}, way, slack);
  return AlarmCause::none;
}

// P + n t. Sums of what is rounded are off by the sum of it.
Alarm Interpreter::retract(const Block& block, std::array<Count, 3>& way, double& slack) {
  Count length;
  if (!parameters_.read(block.retraction_by, length)) return AlarmCause::position_range;
  slack = direction_->way(length, way);
  slack_ += slack;
  for (std::size_t slot = 0; slot < 3; ++slot) {
    if (way[slot].is_zero() || (unknown_ >> slot & 1U) != 0) continue;
    const Count value = position_[slot] + way[slot];
    if (!value.in_range()) return AlarmCause::position_range;
    set_position(slot, value);
    if (slack != 0) rounded_ = static_cast<std::uint16_t>(rounded_ | 1U << slot);
  }
  return AlarmCause::none;
}

Alarm Interpreter::settle(const Block& block) {
  const unsigned before = unknown_;
  const unsigned positions = block.axes & ~static_cast<unsigned>(block.incremental);
  rounded_ = static_cast<std::uint16_t>(rounded_ & ~positions);
  if (rounded_ == 0) slack_ = 0;
  set_unknown(before & ~positions);
  return needs_unknown(block, before) ? AlarmCause::not_judged : AlarmCause::none;
}

// heidenhain.program.unknown-position; `before`: what was unknown before the block.
bool Interpreter::needs_unknown(const Block& block, unsigned before) const {
  if ((block.axes & block.incremental & before) != 0) return true;
  if (block.calls_cycle && hole_needs_unknown()) return true;
  const bool by_normal = block.statement == spec::klartext::Statement::line_with_vectors && block.has_normal;
  return compensates() && !by_normal && (before | unknown_) != 0;
}

void Interpreter::set_unknown(unsigned slots) {
  unknown_ = static_cast<std::uint16_t>(slots);
  head_.unknown = 0;
  for (unsigned rest = slots; rest != 0; rest &= rest - 1)
    head_.unknown =
        static_cast<std::uint16_t>(head_.unknown | 1U << axis_[static_cast<std::size_t>(std::countr_zero(rest))]);
}

}  // namespace toolcomp::fast::klartext
