// SPDX-License-Identifier: Apache-2.0
#include <bit>

#include "model/basis/alarm.h"
#include "model/fanuc/tool_length_offset/tool_length_offset.h"
#include "model/geometry/plane.h"

namespace toolcomp::model {
namespace {

AxisMask letter(const spec::Axes& axes, char axis) { return axes.has(axis) ? with(0, axes.index(axis)) : AxisMask{0}; }

}  // namespace

// fanuc.length-offset.direction: Under G43 the offset of the H number is added to the end position of the block, under
// G44 it is subtracted. This is so in G90 and G91 alike, and the offset counts with its sign.
// fanuc.length-offset.replaces: A new offset replaces the one in force on its axis; it is not added to it.
LengthVector LengthRules::offset(LengthVector before, AxisMask axes, LengthCode mode, const Rational& value) const {
  const bool plus = recorder_.decide(Clause::fanuc_length_offset_direction, mode == LengthCode::plus);
  for (const std::size_t i : axes_in(axes)) {
    recorder_.decide(Clause::fanuc_length_offset_replaces, before.axis.at(i) != 0);
    before.axis.at(i) = plus ? value : Rational(-value);
  }
  return before;
}

// fanuc.length-offset.type: Type A holds with TLC = 0 and TLB = 0, type B with TLC = 0 and TLB = 1, type C with TLC =
// 1.
LengthRules::LengthRules(const spec::Setup& setup, Recorder& recorder)
    : recorder_(recorder),
      axes_(setup.axes),
      type_(setup.bit(5001, 0)   ? Type::c
            : setup.bit(5001, 1) ? Type::b
                                 : Type::a),
      ofh_(setup.bit(5001, 2)),
      tal_(setup.bit(5001, 3)),
      evo_(setup.bit(5001, 6)),
      g49_sets_h0_(setup.g49_sets_h0) {}

// fanuc.length-offset.type-a: Type A offsets Z.
AxisMask LengthRules::affected(const LengthCommand& command, const LengthVector& before, AxisMask last) const {
  if (type_ == Type::a) {
    recorder_.reach(Clause::fanuc_length_offset_type_a);
    return letter(axes_, 'Z');
  }
  if (type_ == Type::b) {
    // fanuc.length-offset.type-b: Type B offsets the axis at right angles to the plane of the block: Z in G17, Y in
    // G18, X in G19. Offsets given in several blocks stay on several axes.
    recorder_.reach(Clause::fanuc_length_offset_type_b);
    return letter(axes_, normal(command.plane));
  }
  // fanuc.length-offset.type-c: Type C offsets the axis that the block with G43 or G44 names.
  recorder_.reach(Clause::fanuc_length_offset_type_c);
  if (command.sets_mode()) return named_axes(command, before);
  // fanuc.length-offset.type-c-last-axis: In type C an H without G43 or G44 acts on the axis offset last.
  recorder_.reach(Clause::fanuc_length_offset_type_c_last_axis);
  return last;
}

// fanuc.length-offset.type-c-linear-axes: Type C goes by the linear axis words of the block, and a rotary axis word
// names no axis to offset.
AxisMask LengthRules::named_axes(const LengthCommand& command, const LengthVector& before) const {
  AxisMask linear = 0;
  for (const std::size_t i : axes_in(command.axes))
    if (spec::is_linear_axis(axes_.letter(i))) linear = with(linear, i);
  // fanuc.length-offset.type-c-no-axis: G43 or G44 of type C in a block that names no axis raises PS0027.
  if (linear == 0) raise(recorder_, Clause::fanuc_length_offset_type_c_no_axis, AlarmCause::length_offset_without_axis);
  const bool several = std::popcount(linear) > 1;
  const bool another = without(before.axes(), linear) != 0;
  if (several || another) {
    // fanuc.length-offset.tal: Type C on a second axis raises PS0027 with TAL = 0, and nothing is changed; with TAL = 1
    // it is allowed. A second axis means that another axis still has an offset, or that the block names two.
    if (!recorder_.decide(Clause::fanuc_length_offset_tal, tal_)) throw Alarm(AlarmCause::length_offset_second_axis);
    // fanuc.length-offset.type-c-several-axes: With type C and TAL = 1 a block that names several axes gives the offset
    // to all of them. Together they are the axes offset last.
    if (several) recorder_.reach(Clause::fanuc_length_offset_type_c_several_axes);
  }
  return linear;
}

// fanuc.length-offset.ofh: With OFH = 0 an H counts wherever it is. With OFH = 1 it counts only in a block with G43 or
// G44.
std::optional<std::uint32_t> LengthRules::number(const LengthCommand& command, bool active) const {
  if (command.codes.h) {
    const bool ignored = recorder_.decide(Clause::fanuc_length_offset_ofh, ofh_) && !command.sets_mode();
    // fanuc.length-offset.ofh-lone-number: With OFH = 1 an H in a block without G43 and G44 is ignored. Only the number
    // on the screen changes.
    if (recorder_.decide(Clause::fanuc_length_offset_ofh_lone_number, ignored)) return std::nullopt;
    return command.codes.h;
  }
  // fanuc.length-offset.ofh-first-without-number: With OFH = 1 a G43 or G44 without H takes H0 if no length offset is
  // in force. If one is in force, it keeps its number. This is our definition, because H is modal once G43 is active.
  if (command.sets_mode() && recorder_.decide(Clause::fanuc_length_offset_ofh, ofh_) &&
      recorder_.decide(Clause::fanuc_length_offset_ofh_first_without_number, !active))
    return 0;
  // fanuc.length-offset.one-number: There is one H number and one set of axes offset last. H0 sets these axes too. G49
  // leaves the number, so that a later G43 or G44 without H takes it again. With g49_sets_h0 in the setup, a G49
  // without H makes the number 0.
  if (command.codes.length == LengthCode::cancel &&
      recorder_.decide(Clause::fanuc_length_offset_one_number, g49_sets_h0_))
    return 0;
  return std::nullopt;
}

// fanuc.length-offset.cancel: G49 cancels the offset of all axes at once. H0 cancels that of the axis on which H acts.
// fanuc.length-offset.cancel-three-axes: G49 raises PS0015 and changes nothing if three or more axes have an offset
// that is not zero. That nothing changes is our definition.
void LengthRules::cancel(const LengthVector& before) const {
  if (recorder_.decide(Clause::fanuc_length_offset_cancel_three_axes, std::popcount(before.axes()) >= 3))
    throw Alarm(AlarmCause::length_offset_axes);
  recorder_.reach(Clause::fanuc_length_offset_cancel);
}

// fanuc.length-offset.evo: EVO decides when an edited value of the memory, or a vector that G53 or a reference return
// took away, comes into force in types A and B, G43.4 and G43.5 included. With EVO = 1 this is the next block, with EVO
// = 0 the next block with H, G43 or G44. Type C always behaves as with EVO = 0. Counted in blocks without a length code
// and without an H that counts, because a block that has them acts by them alone.
bool LengthRules::next_block_counts() const {
  return recorder_.decide(Clause::fanuc_length_offset_evo, evo_ && type_ != Type::c);
}

// fanuc.length-offset.machine-position-cancels: An offset axis that G53 names loses its offset in that move. An offset
// axis that G28, G30 or G30.1 names keeps its offset up to the intermediate point and loses it on the way to the
// reference position. Axes that are not named keep theirs. The modal code stays G43 or G44.
AxisMask LengthRules::taken_away(AxisMask named, const LengthVector& before, AxisMask last) const {
  const auto taken = static_cast<AxisMask>(named & (last | before.axes()));
  recorder_.decide(Clause::fanuc_length_offset_machine_position_cancels, taken != 0);
  return taken;
}

// fanuc.length-offset.restored-in-next-block: In types A and B with EVO = 1 the vector taken away comes back in the
// next block.
// fanuc.length-offset.not-restored-with-cutter-code: A block with G40, G41 or G42 does not restore the vector. That the
// vector then comes back in the first following block without these codes is our definition.
AxisMask LengthRules::in_next_block(const LengthCommand& command, const LengthAxes& axes) const {
  AxisMask result = axes.last;
  const bool waits = command.has_cutter_code() && (result & axes.cancelled) != 0;
  if (recorder_.decide(Clause::fanuc_length_offset_not_restored_with_cutter_code, waits))
    result = without(result, axes.cancelled);
  if ((result & axes.cancelled) != 0) recorder_.reach(Clause::fanuc_length_offset_restored_in_next_block);
  return result;
}

// fanuc.length-offset.number-only-stored: In a block with G40, G41 or G42 an H, G43 or G44 that would restore a vector
// only stores number and mode. With EVO = 1 number and mode act in the next block, on the axes offset last
// (fanuc.length-offset.evo-axes), which the block with the cutter code does not change.
bool LengthRules::only_stored(const LengthCommand& command, AxisMask affected, AxisMask cancelled) const {
  const bool waits = command.has_cutter_code() && (affected & cancelled) != 0;
  return recorder_.decide(Clause::fanuc_length_offset_number_only_stored, waits);
}

}  // namespace toolcomp::model
