// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/program/tool_direction.h"

namespace toolcomp::model::klartext {

using spec::klartext::ReferenceWord;

Direction direction_of(const Vector& vector) {
  const Real norm2 = squared_norm(vector);
  // The factor is a rational times one root, and so are the components: they stay as short as that.
  return {vector, norm2, (sqrt(norm2) / norm2) * vector, true};
}

void ToolDirection::tool_axis(char letter) {
  // heidenhain.program.tool-axis: X, Y or Z of TOOL CALL is the tool axis, the direction of the tool if nothing turns
  // it. Without the letter the tool axis stays.
  if (!recorder_.decide(Clause::heidenhain_program_tool_axis, letter != 0)) return;
  axis_index_ = space_index(letter);
  Vector e;
  component(e, axis_index_) = 1;
  axis_ = {e, 1, e, true};
  if (!tcpm_) current_ = axis_;
}

void ToolDirection::function_m128(bool center) {
  // heidenhain.program.tcpm-on: M128 switches TCPM on at the start of its block. FUNCTION TCPM switches it on in a
  // block of its own.
  recorder_.decide(Clause::heidenhain_program_tcpm_on, true);
  // heidenhain.program.m128-reference: A machine parameter sets the reference point of M128, even if FUNCTION TCPM had
  // set another one. The setup key m128_reference says which: the tip, or the centre as under CNT-CNT.
  switch_on(recorder_.decide(Clause::heidenhain_program_m128_reference, center));
}

void ToolDirection::function_tcpm(ReferenceWord reference) {
  recorder_.decide(Clause::heidenhain_program_tcpm_on, false);
  switch_on(reference == ReferenceWord::center_center);
}

void ToolDirection::switch_on(bool center) {
  center_ = center;
  if (tcpm_) return;
  tcpm_ = true;
  // heidenhain.program.tcpm-direction: When TCPM is switched on, nothing turns, and the tool has the direction that the
  // rotary axes give it. The rotary axes are at the values programmed last, including those of blocks without TCPM. If
  // a tool vector or a normal turned the tool and no rotary word came after it, the tool has the direction of that
  // vector instead.
  current_ = recorder_.decide(Clause::heidenhain_program_tcpm_direction, by_vector_) ? left_ : turned();
}

void ToolDirection::tcpm_off(bool m129) {
  // heidenhain.program.tcpm-off: M129 switches TCPM off at the end of its block. FUNCTION RESET TCPM switches it off in
  // a block of its own. The tool is then along the tool axis.
  recorder_.decide(Clause::heidenhain_program_tcpm_off, m129);
  if (tcpm_ && by_vector_) left_ = current_;
  tcpm_ = false;
  current_ = axis_;
}

void ToolDirection::take_rotary_words(const spec::klartext::Block& block) {
  bool rotary_word = false;
  for (std::size_t slot = kFirstRotarySlot; slot < kFirstParallelSlot; ++slot) rotary_word |= block.has_axis(slot);
  by_vector_ = by_vector_ && !rotary_word;
  if (!tcpm_) {
    // heidenhain.program.direction-without-tcpm: Without TCPM the tool is along the tool axis, whatever rotary words
    // and tool vectors say. The values of rotary words are remembered.
    recorder_.reach(Clause::heidenhain_program_direction_without_tcpm);
    return;
  }
  // heidenhain.program.direction-of-rotary-axes: Under TCPM an L block with a rotary word turns the tool by A, B, C, in
  // this order, about the fixed axes X, Y, Z. Rotary axes without a word keep the value programmed last.
  if (!recorder_.decide(Clause::heidenhain_program_direction_of_rotary_axes, rotary_word)) return;
  current_ = turned();
}

Direction ToolDirection::turned() const {
  Vector v = axis_.vector;
  const auto turn = [this](Real& x, Real& y, std::size_t slot) {
    const Rational degrees = position_.at(slot).rational();
    const Real cosine = exact::cos_degrees(degrees);
    const Real sine = exact::sin_degrees(degrees);
    const Real before = x;
    x = cosine * x - sine * y;
    y = sine * before + cosine * y;
  };
  turn(v.y, v.z, kFirstRotarySlot);
  turn(v.z, v.x, kFirstRotarySlot + 1);
  turn(v.x, v.y, kFirstRotarySlot + 2);
  return {v, 1, v, true};  // turns keep its length 1
}

}  // namespace toolcomp::model::klartext
