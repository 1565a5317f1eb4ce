// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/program/tool_in_spindle.h"

#include <algorithm>
#include <string>

#include "model/basis/alarm.h"
#include "model/basis/number.h"
#include "spec/language/input_error.h"

namespace toolcomp::model::klartext {

using spec::klartext::Block;
using spec::klartext::ToolWord;

ToolInSpindle::ToolInSpindle(const spec::Setup& setup, const Values& values, Recorder& recorder)
    : setup_(setup), values_(values), recorder_(recorder) {}

bool ToolInSpindle::call(const Block& block, bool tcpm) {
  // heidenhain.program.tool-call: TOOL CALL with a tool takes over the row of the tool, sets R0 and replaces the deltas
  // of the previous call by its own. A delta that it does not name is 0. TOOL CALL 0 calls a tool of zeros.
  const bool calls = recorder_.decide(Clause::heidenhain_program_tool_call, block.tool != ToolWord::none);
  if (calls) {
    // heidenhain.program.tool-call-under-tcpm: M128 must be off before a tool is called, so the call of a tool under
    // TCPM raises E_TCPM_TOOLCALL, even if the tool is unknown.
    if (tcpm) raise(recorder_, Clause::heidenhain_program_tool_call_under_tcpm, AlarmCause::tool_call_under_tcpm);
    table_ = EffectiveTool();
    table_.called = true;
    of_table_ = of_call_ = Deltas();
    const bool null_tool = block.tool == ToolWord::number && block.tool_number == 0;
    if (!null_tool) {
      const spec::ToolRow* const row = find(block);
      // heidenhain.program.tool-unknown: TOOL CALL raises E_NO_TOOL if its number or name has no row in the tool table,
      // or if it names the tool by a string parameter.
      if (row == nullptr) raise(recorder_, Clause::heidenhain_program_tool_unknown, AlarmCause::no_tool);
      take_over(*row);
    }
    // heidenhain.program.correction-row-dropped: After a call of a tool the row of the compensation table is no longer
    // in force.
    if (recorder_.decide(Clause::heidenhain_program_correction_row_dropped, corrected_)) {
      corrected_ = false;
      of_correction_ = Deltas();
    }
  }
  if (block.dl) of_call_.dl = values_.word(*block.dl);
  if (block.dr) of_call_.dr = values_.word(*block.dr);
  if (block.dr2) of_call_.dr2 = values_.word(*block.dr2);
  effective_.reset();
  return calls;
}

const spec::ToolRow* ToolInSpindle::find(const Block& block) const {
  const auto row = std::ranges::find_if(setup_.tools, [&block](const spec::ToolRow& tool) {
    if (block.tool == ToolWord::number) return tool.number == block.tool_number;
    return block.tool == ToolWord::name && !tool.name.empty() && tool.name == block.tool_name.view();
  });
  return row == setup_.tools.end() ? nullptr : &*row;
}

void ToolInSpindle::take_over(const spec::ToolRow& row) {
  table_.r = values_.of_table(row.r);
  table_.r2 = values_.of_table(row.r2);
  if (row.l) table_.l = values_.of_table(*row.l);
  of_table_ = {values_.of_table(row.dl), values_.of_table(row.dr), values_.of_table(row.dr2)};
  if (row.dr2_table.empty()) return;
  for (const auto& [angle, deviation] : setup_.dr2_tables.at(row.dr2_table)) {
    const Rational degrees = plain(angle);
    table_.deviations.push_back({degrees, exact::cos_degrees(degrees), values_.of_table(deviation)});
  }
}

void ToolInSpindle::use_correction(std::uint32_t row) {
  const auto found = setup_.tcs.find(row);
  if (found == setup_.tcs.end()) throw spec::InputError("setup", 0, 0, "correction.tcs: no row " + std::to_string(row));
  // heidenhain.program.correction-row: FUNCTION CORRDATA TCS #n puts a row of the compensation table in force. After
  // FUNCTION CORRDATA RESET no row is in force. SEL CORR-TABLE only names the file.
  corrected_ = recorder_.decide(Clause::heidenhain_program_correction_row, true);
  const spec::CorrectionRow& values = found->second;
  of_correction_ = {values_.of_table(values.dl), values_.of_table(values.dr), values_.of_table(values.dr2)};
  effective_.reset();
}

void ToolInSpindle::drop_correction() {
  corrected_ = recorder_.decide(Clause::heidenhain_program_correction_row, false);
  of_correction_ = Deltas();
  effective_.reset();
}

std::shared_ptr<const EffectiveTool> ToolInSpindle::effective() {
  // heidenhain.program.delta-sum: A delta is the total of the values of tool management, of the tool call and of the
  // compensation table. A positive delta means that the tool is larger than the table says.
  recorder_.reach(Clause::heidenhain_program_delta_sum);
  if (!effective_) {
    EffectiveTool sum = table_;
    sum.dl = of_table_.dl + of_call_.dl + of_correction_.dl;
    sum.dr = of_table_.dr + of_call_.dr + of_correction_.dr;
    sum.dr2_of_program = of_call_.dr2 + of_correction_.dr2;
    sum.dr2 = of_table_.dr2 + sum.dr2_of_program;
    effective_ = std::make_shared<const EffectiveTool>(std::move(sum));
  }
  return effective_;
}

}  // namespace toolcomp::model::klartext
