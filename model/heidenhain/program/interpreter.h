// SPDX-License-Identifier: Apache-2.0
// The state of a Klartext program: what a block changes in it, and the motion it makes.
#pragma once

#include <optional>

#include "model/basis/recorder.h"
#include "model/heidenhain/program/feed.h"
#include "model/heidenhain/program/functions.h"
#include "model/heidenhain/program/motion.h"
#include "model/heidenhain/program/position.h"
#include "model/heidenhain/program/tool_direction.h"
#include "model/heidenhain/program/tool_in_spindle.h"
#include "model/heidenhain/program/values.h"
#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/setup.h"

namespace toolcomp::model::klartext {

// Clauses: heidenhain.program.*, but those of moves.
class Interpreter {
 public:
  // The setup must outlive it.
  Interpreter(const spec::Setup& setup, Recorder& recorder);
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  // Executes the block; its motion, if it makes one. Throws Alarm.
  std::optional<Motion> read(const spec::klartext::Block& block);
  // The hole of the block read last, which it drills after its motion.
  [[nodiscard]] const std::optional<DrilledHole>& hole() const { return hole_; }
  // The program ends with the block read last.
  [[nodiscard]] bool ends() const { return ends_; }
  // A tool was called in the block read last, or its values changed.
  [[nodiscard]] bool tool_call() const { return tool_call_; }

 private:
  void begin(const spec::klartext::Block& block);
  void act_at_start(const Functions& functions);
  void act_at_end(const Functions& functions);
  std::optional<Motion> execute(const spec::klartext::Block& block, const Functions& functions);
  void call_tool(const spec::klartext::Block& block);
  void correct(const spec::klartext::Block& block);
  // CYCL DEF of a drilling cycle.
  void define_cycle(const spec::klartext::Block& block);

  // L and LN.
  std::optional<Motion> line(const spec::klartext::Block& block, const Functions& functions);
  // Where the linear axes stand.
  void add_position(Motion& motion) const;
  // CYCL CALL and M99: hole_. Throws Alarm.
  void call_cycle(const spec::klartext::Block& block);
  // Positions are unknown. Throws Alarm not_judged where one of them is needed.
  void require_positions(bool needs);
  // Where the block ends. Throws Alarm not_judged where it needs a position that nobody knows.
  void move_to_end(const spec::klartext::Block& block, const Functions& functions);
  void direct(Motion& motion, const spec::klartext::Block& block);
  void take_vectors(Motion& motion, const spec::klartext::Block& block);
  void check_length(Motion& motion, const Vector& vector, const char* message);

  const spec::Setup& setup_;
  Recorder& recorder_;
  Values values_;
  ProgrammedPosition position_;
  ToolInSpindle tool_;
  ToolDirection direction_;
  Feed feed_;
  Side side_ = Side::none;
  std::optional<DrilledHole> hole_;
  bool contour_ = false;
  bool oversize_allowed_ = false;
  bool begun_ = false;
  bool ends_ = false;
  bool tool_call_ = false;
};

}  // namespace toolcomp::model::klartext
