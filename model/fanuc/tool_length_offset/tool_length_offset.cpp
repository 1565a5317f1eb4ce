// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_length_offset/tool_length_offset.h"

namespace toolcomp::model {

ToolLengthOffset::ToolLengthOffset(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder)
    : memory_(memory), recorder_(recorder), rules_(setup, recorder) {}

LengthPlan ToolLengthOffset::plan(const LengthCommand& command) {
  const LengthVector before = vector_;
  const std::optional<std::uint32_t> number = rules_.number(command, active());
  if (number) number_ = *number;

  if (command.codes.length == LengthCode::cancel) {
    rules_.cancel(vector_);
    mode_ = LengthCode::cancel;
    vector_ = {};
    axes_ = {};
  } else if (command.sets_mode() || number) {
    take(command);
  } else if (active() && command.codes.any) {
    next_block(command);
  }

  LengthPlan plan;
  plan.on_way = vector_;
  if (command.cancelled != 0 && active()) {
    // The mode stays.
    const AxisMask taken = rules_.taken_away(command.cancelled, vector_, axes_.last);
    for (const std::size_t i : axes_in(taken)) vector_.axis.at(i) = 0;
    axes_.cancelled = static_cast<AxisMask>(axes_.cancelled | taken);
  }
  plan.at_end = vector_;
  plan.changed = plan.at_end != before;
  return plan;
}

void ToolLengthOffset::take(const LengthCommand& command) {
  const bool starts = !active();
  if (command.sets_mode()) mode_ = *command.codes.length;
  if (tip_control()) {
    axes_ = {};
    vector_.along_tool = memory_.h(number_);
    return;
  }
  // fanuc.length-offset.number-while-cancelled: While no length offset is in force, an H stores its number and moves
  // nothing.
  if (recorder_.decide(Clause::fanuc_length_offset_number_while_cancelled, !active())) return;
  const AxisMask axes = rules_.affected(command, vector_, axes_.last);
  if (rules_.only_stored(command, axes, axes_.cancelled)) return;
  // fanuc.length-offset.restored-by-number: A block with G43, G44 or an H that counts restores the vector on the axis
  // on which it acts (types A and B with EVO = 0, and type C). Nothing else comes back with it.
  if (!starts && (axes & axes_.cancelled) != 0) recorder_.reach(Clause::fanuc_length_offset_restored_by_number);
  axes_.last = axes;
  apply(axes);
}

void ToolLengthOffset::next_block(const LengthCommand& command) {
  if (!rules_.next_block_counts()) return;
  if (tip_control())
    vector_.along_tool = memory_.h(number_);
  else
    apply(rules_.in_next_block(command, axes_));
}

void ToolLengthOffset::apply(AxisMask axes) {
  if (axes == 0) return;
  vector_ = rules_.offset(vector_, axes, mode_, memory_.h(number_));
  axes_.cancelled = without(axes_.cancelled, axes);
}

}  // namespace toolcomp::model
