// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_offset/tool_offset.h"

#include <utility>

#include "model/basis/alarm.h"

namespace toolcomp::model {

ToolOffset::ToolOffset(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder)
    : memory_(memory),
      recorder_(recorder),
      axes_(setup.axes),
      by_length_number_(setup.bit(5001, 5) && !setup.bit(5001, 2)),
      offset_(setup, memory, recorder) {}

Leg ToolOffset::shifted(Leg leg) const {
  if (nonzero(shift_) != 0) leg.shift = shift_;
  return leg;
}

void ToolOffset::take_away(AxisMask named) {
  const auto taken = static_cast<AxisMask>(named & nonzero(shift_));
  for (const std::size_t i : axes_in(taken)) shift_.at(i) = 0;
  // fanuc.tool-offset.machine-position: G53 takes away the shift of the axes that it names, in its own move. G28, G30
  // and G30.1 reach the intermediate point with the shift and take it away on the way to the reference position.
  recorder_.decide(Clause::fanuc_tool_offset_machine_position, taken != 0);
}

Rational ToolOffset::value(const LengthState& length) const {
  const OffsetNumber number = by_length_number_ ? OffsetNumber{length.number, length.number != 0} : offset_.number();
  // fanuc.tool-offset.number: OFH and TPH decide which number counts. With OFH = 0 and TPH = 0 it is the D number, with
  // OFH = 0 and TPH = 1 it is the H number, the one of the length offset. With OFH = 1 it is the number of cutter
  // compensation, which D and H both set (fanuc.cutter.number), and TPH means nothing.
  recorder_.decide(Clause::fanuc_tool_offset_number, number.of_h);
  return memory_.value(number);
}

void ToolOffset::lengthen(const Command& command, const Interpreter& interpreter, const Rational& value, Leg& leg) {
  const Rational by = lengthening(command.codes.one_shot, value);
  if (leg.arc) lengthen_arc(command, interpreter.numbers(), by, leg);
  for (const std::size_t i : axes_in(command.axes)) {
    const Real travel = (leg.end.at(i) - interpreter.position().at(i)).value();
    shift_.at(i) += shift_by(command, axes_.letter(i), travel, by);
  }
}

void ToolOffset::apply(const Command& command, const Interpreter& interpreter, const LengthState& length,
                       std::vector<Leg>& legs) {
  offset_.take(command.codes);
  const std::array<Rational, spec::kMaxAxes> before = shift_;
  if (is_tool_offset(command.codes.one_shot)) {
    // fanuc.tool-offset.number-by-h: With TPH = 1 (and OFH = 0) G45 to G48 may be used only while the length offset is
    // cancelled. If G43 or G44 is in force after the codes of the block, they raise G45_LENGTH_OFFSET, with or without
    // an axis word.
    if (by_length_number_ && length.active)
      raise(recorder_, Clause::fanuc_tool_offset_number_by_h, AlarmCause::tool_offset_length);
    if (command.axes == 0) {
      // fanuc.tool-offset.without-axis-word: In a block without an axis word G45 to G48 only store the number, unless I
      // J K make the block a full circle (G45_ARC).
      recorder_.reach(Clause::fanuc_tool_offset_without_axis_word);
      if (!legs.empty() && legs.front().arc) {
        recorder_.decide(Clause::fanuc_tool_offset_arc_form, false);
        throw Alarm(AlarmCause::tool_offset_arc);
      }
    } else {
      recorder_.reach(Clause::fanuc_tool_offset_travel);
      lengthen(command, interpreter, value(length), legs.front());
    }
  }
  if (nonzero(before) == 0 && nonzero(shift_) == 0) return;

  for (Leg& leg : legs) {
    // A reference return keeps the shift up to its intermediate point.
    if (&leg == &legs.back() && goes_by_machine_coordinates(command.codes.one_shot)) take_away(command.axes);
    leg = shifted(std::move(leg));
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const char letter = axes_.letter(i);
      if (is_space_axis(letter)) component(leg.travel, space_index(letter)) += Real(shift_.at(i) - before.at(i));
      if (leg.arc && leg.arc->center.has(i)) leg.arc->center.set(i, leg.arc->center[i] + Real(before.at(i)));
    }
  }
}

}  // namespace toolcomp::model
