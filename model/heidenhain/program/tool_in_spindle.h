// SPDX-License-Identifier: Apache-2.0
// TOOL CALL, the tool table, and the row of the compensation table.
#pragma once

#include <memory>
#include <optional>

#include "model/basis/recorder.h"
#include "model/heidenhain/program/motion.h"
#include "model/heidenhain/program/values.h"
#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/setup.h"

namespace toolcomp::model::klartext {

// Which tool is in the spindle and with what deltas. Clauses: heidenhain.program.tool-call, .tool-call-under-tcpm,
// .tool-unknown, .correction-row, .correction-row-dropped, .delta-sum.
class ToolInSpindle {
 public:
  ToolInSpindle(const spec::Setup& setup, const Values& values, Recorder& recorder);

  // Whether the TOOL CALL calls a tool. Throws Alarm.
  bool call(const spec::klartext::Block& block, bool tcpm);
  // FUNCTION CORRDATA TCS #row. Throws spec::InputError where the setup has no such row: the reader refuses it before.
  void use_correction(std::uint32_t row);
  // FUNCTION CORRDATA RESET.
  void drop_correction();

  // As it is now; it stays as it is when the tool changes.
  [[nodiscard]] std::shared_ptr<const EffectiveTool> effective();

 private:
  struct Deltas {
    Real dl, dr, dr2;
  };

  [[nodiscard]] const spec::ToolRow* find(const spec::klartext::Block& block) const;
  void take_over(const spec::ToolRow& row);

  const spec::Setup& setup_;
  const Values& values_;
  Recorder& recorder_;
  EffectiveTool table_;  // without sums
  Deltas of_table_;
  Deltas of_call_;
  Deltas of_correction_;
  bool corrected_ = false;                          // a row of the compensation table is in force
  std::shared_ptr<const EffectiveTool> effective_;  // null: to be made anew
};

}  // namespace toolcomp::model::klartext
