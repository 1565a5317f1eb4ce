#include "model/fanuc/tool_length_offset/tool_length_offset.h"

#include <algorithm>
#include <bit>

#include "model/basis/alarm.h"

namespace toolcomp::model {
namespace {

bool in(AxisMask mask, std::size_t axis) { return (mask >> axis & 1U) != 0; }
AxisMask without(AxisMask mask, AxisMask removed) { return static_cast<AxisMask>(mask & ~removed); }

}  // namespace

ToolLengthOffset::ToolLengthOffset(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder)
    : memory_(memory),
      recorder_(recorder),
      axes_(setup.axes),
      type_(setup.bit(5001, 0)   ? Type::c
            : setup.bit(5001, 1) ? Type::b
                                 : Type::a),
      ofh_(setup.bit(5001, 2)),
      tal_(setup.bit(5001, 3)),
      evo_(setup.bit(5001, 6)) {}

AxisMask ToolLengthOffset::letter(char axis) const {
  return axes_.has(axis) ? static_cast<AxisMask>(1U << axes_.index(axis)) : AxisMask{0};
}

bool ToolLengthOffset::axis_offset() const {
  return std::ranges::any_of(vector_.axis, [](const Rational& offset) { return offset != 0; });
}

bool ToolLengthOffset::take_number(const LengthCommand& command, bool sets_mode) {
  if (command.h) {
    const bool ignored = recorder_.decide(Clause::fanuc_length_offset_ofh, ofh_) && !sets_mode;
    if (recorder_.decide(Clause::fanuc_length_offset_ofh_lone_number, ignored)) return false;
    number_ = *command.h;
    return true;
  }
  if (sets_mode && recorder_.decide(Clause::fanuc_length_offset_ofh, ofh_)) {
    if (recorder_.decide(Clause::fanuc_length_offset_ofh_first_without_number, !active())) number_ = 0;
  }
  return false;
}

// Type C names its axis; a length goes on linear axes.
AxisMask ToolLengthOffset::named_axes(const LengthCommand& command) const {
  AxisMask linear = 0;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (in(command.axes, i) && spec::is_linear_axis(axes_.letter(i))) linear = static_cast<AxisMask>(linear | 1U << i);
  if (linear == 0)
    raise(recorder_, Clause::fanuc_length_offset_type_c_no_axis, "PS0027", "tool length offset type C without an axis");
  AxisMask offset = 0;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (vector_.axis.at(i) != 0) offset = static_cast<AxisMask>(offset | 1U << i);
  const bool several = std::popcount(linear) > 1;
  const bool another = without(offset, linear) != 0;
  if (several || another) {
    if (!recorder_.decide(Clause::fanuc_length_offset_tal, tal_))
      throw Alarm("PS0027", "tool length offset type C on a second axis");
    if (several) recorder_.reach(Clause::fanuc_length_offset_type_c_several_axes);
  }
  return linear;
}

AxisMask ToolLengthOffset::affected(const LengthCommand& command, bool sets_mode) const {
  switch (type_) {
    case Type::a:
      recorder_.reach(Clause::fanuc_length_offset_type_a);
      return letter('Z');
    case Type::b:
      recorder_.reach(Clause::fanuc_length_offset_type_b);
      return letter(command.plane == spec::Plane::xy ? 'Z' : command.plane == spec::Plane::zx ? 'Y' : 'X');
    case Type::c:
      break;
  }
  recorder_.reach(Clause::fanuc_length_offset_type_c);
  if (sets_mode) return named_axes(command);
  recorder_.reach(Clause::fanuc_length_offset_type_c_last_axis);
  return last_;
}

// The offset of the number in force on these axes, with the sign of the mode; it replaces what was there.
void ToolLengthOffset::apply(AxisMask axes) {
  if (axes == 0) return;
  const Rational offset = memory_.h(number_);
  const bool plus = recorder_.decide(Clause::fanuc_length_offset_direction, mode_ == LengthCode::plus);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (!in(axes, i)) continue;
    recorder_.decide(Clause::fanuc_length_offset_replaces, vector_.axis.at(i) != 0);
    vector_.axis.at(i) = plus ? offset : Rational(-offset);
  }
  cancelled_ = without(cancelled_, axes);
}

void ToolLengthOffset::cancel() {
  mode_ = LengthCode::cancel;
  vector_ = {};
  last_ = 0;
  cancelled_ = 0;
}

// A block that commands no length offset: an edited value, or the vector taken away last, comes into force (EVO).
void ToolLengthOffset::next_block(const LengthCommand& command) {
  if (!recorder_.decide(Clause::fanuc_length_offset_evo, evo_ && type_ != Type::c)) return;
  if (tip_control()) {
    vector_.along_tool = memory_.h(number_);
    return;
  }
  AxisMask axes = last_;
  const bool waits = command.cutter_code && (axes & cancelled_) != 0;
  if (recorder_.decide(Clause::fanuc_length_offset_not_restored_with_cutter_code, waits))
    axes = without(axes, cancelled_);
  if ((axes & cancelled_) != 0) recorder_.reach(Clause::fanuc_length_offset_restored_in_next_block);
  apply(axes);
}

LengthPlan ToolLengthOffset::plan(const LengthCommand& command) {
  const LengthVector before = vector_;
  const bool sets_mode = command.code && *command.code != LengthCode::cancel;
  const bool number_counts = take_number(command, sets_mode);

  if (command.code == LengthCode::cancel) {
    const auto offset_axes = std::ranges::count_if(vector_.axis, [](const Rational& offset) { return offset != 0; });
    if (recorder_.decide(Clause::fanuc_length_offset_cancel_three_axes, offset_axes >= 3))
      throw Alarm("PS0015", "G49 with three or more axes offset");
    recorder_.reach(Clause::fanuc_length_offset_cancel);
    cancel();
  } else if (sets_mode || number_counts) {
    const bool starts = !active();
    if (sets_mode) mode_ = *command.code;
    if (tip_control()) {
      last_ = cancelled_ = 0;
      vector_.along_tool = memory_.h(number_);
    } else if (!recorder_.decide(Clause::fanuc_length_offset_number_while_cancelled, !active())) {
      const AxisMask axes = affected(command, sets_mode);
      const bool waits = command.cutter_code && (axes & cancelled_) != 0;
      if (!recorder_.decide(Clause::fanuc_length_offset_number_only_stored, waits)) {
        if (!starts && (axes & cancelled_) != 0) recorder_.reach(Clause::fanuc_length_offset_restored_by_number);
        last_ = axes;
        apply(axes);
      }
    }
  } else if (active() && command.has_word) {
    next_block(command);
  }

  LengthPlan plan;
  plan.on_way = vector_;
  if (command.cancelled != 0 && active()) take_away(command.cancelled);
  plan.at_end = vector_;
  plan.changed = plan.at_end != before;
  return plan;
}

// G53 and the reference returns: the axes they name lose their offset; the mode stays.
void ToolLengthOffset::take_away(AxisMask axes) {
  AxisMask taken = 0;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (!in(axes, i) || (!in(last_, i) && vector_.axis.at(i) == 0)) continue;
    vector_.axis.at(i) = 0;
    taken = static_cast<AxisMask>(taken | 1U << i);
  }
  recorder_.decide(Clause::fanuc_length_offset_machine_position_cancels, taken != 0);
  cancelled_ = static_cast<AxisMask>(cancelled_ | taken);
}

}  // namespace toolcomp::model
