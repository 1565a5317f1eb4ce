// SPDX-License-Identifier: Apache-2.0
// Where the tool points: the tool axis, TCPM, vectors and rotary axes.
#pragma once

#include "model/basis/recorder.h"
#include "model/heidenhain/program/position.h"
#include "model/kinematics/tool_direction.h"
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::model::klartext {

// The direction of a vector of rational components, not all zero.
Direction direction_of(const Vector& vector);

// Clauses: heidenhain.program.tcpm-on, .m128-reference, .tcpm-direction, .tcpm-off, .direction-without-tcpm,
// .direction-of-rotary-axes, .tool-axis.
class ToolDirection {
 public:
  // Both must outlive it.
  ToolDirection(const ProgrammedPosition& position, Recorder& recorder) : position_(position), recorder_(recorder) {}

  [[nodiscard]] bool tcpm() const { return tcpm_; }
  // The programmed point is the centre of the tool.
  [[nodiscard]] bool at_center() const { return tcpm_ && center_; }
  // Where the tool points now; along the tool axis without TCPM.
  [[nodiscard]] const Direction& current() const { return current_; }

  // X, Y or Z of the tool axis: 0, 1, 2.
  [[nodiscard]] std::size_t axis_index() const { return axis_index_; }

  // X, Y or Z of TOOL CALL; 0: none.
  void tool_axis(char letter);
  // M128; `center`: its reference point is the centre of the tool.
  void function_m128(bool center);
  // FUNCTION TCPM.
  void function_tcpm(spec::klartext::ReferenceWord reference);
  // M129, or FUNCTION RESET TCPM.
  void tcpm_off(bool m129);

  // An L block: rotary words turn the tool under TCPM.
  void take_rotary_words(const spec::klartext::Block& block);
  // An LN block under TCPM.
  void take_vector(const Vector& vector) {
    current_ = direction_of(vector);
    by_vector_ = true;
  }

 private:
  void switch_on(bool center);
  // Rz(C) Ry(B) Rx(A) e, of the positions programmed last.
  [[nodiscard]] Direction turned() const;

  const ProgrammedPosition& position_;
  Recorder& recorder_;
  bool tcpm_ = false;
  bool center_ = false;
  std::size_t axis_index_ = 2;  // of the tool axis
  Direction axis_;              // e of it
  Direction current_;           // under TCPM it outlives a change of the tool axis
  bool by_vector_ = false;      // a vector turned the tool, and no rotary word came after it
  Direction left_;              // where TCPM was switched off and by_vector_: where the tool stands
};

}  // namespace toolcomp::model::klartext
