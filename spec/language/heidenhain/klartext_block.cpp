// SPDX-License-Identifier: Apache-2.0
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::spec::klartext {
namespace {

// The grammar has no number that ends in a point.
std::string number_text(Decimal number) {
  number.point = number.decimals != 0;
  return to_string(number);
}

std::string parameter_text(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::none:
      break;
    case ParameterKind::q:
      return 'Q' + std::to_string(parameter.index);
    case ParameterKind::ql:
      return "QL" + std::to_string(parameter.index);
    case ParameterKind::qr:
      return "QR" + std::to_string(parameter.index);
  }
  return "";
}

std::string axis_words(const Block& block) {
  std::string text;
  for (std::size_t slot = 0; slot < kAxisLetters.size(); ++slot)
    if (block.has_axis(slot))
      text.append(block.is_incremental(slot) ? " I" : " ")
          .append(1, kAxisLetters[slot])
          .append(to_string(block.axis[slot]));
  return text;
}

std::string vector_words(char name, const std::array<Decimal, 3>& vector) {
  std::string text;
  for (std::size_t i = 0; i < vector.size(); ++i)
    text.append(1, ' ').append(1, name).append(1, kAxisLetters[i]).append(number_text(vector[i]));
  return text;
}

std::string feed_text(const Block& block) {
  switch (block.feed) {
    case FeedWord::none:
      break;
    case FeedWord::f:
      return " F" + to_string(block.feed_value);
    case FeedWord::f_max:
      return " FMAX";
    case FeedWord::f_auto:
      return " FAUTO";
    case FeedWord::f_z:
      return " FZ" + to_string(block.feed_value);
    case FeedWord::f_u:
      return " FU" + to_string(block.feed_value);
  }
  return "";
}

std::string function_words(const Block& block) {
  std::string text;
  constexpr std::uint16_t kRetraction = 140;
  for (std::size_t i = 0; i < block.functions; ++i) {
    text += " M" + std::to_string(block.function[i]);
    if (block.function[i] != kRetraction || block.retraction == Retraction::none) continue;
    text += block.retraction == Retraction::by ? " MB" + to_string(block.retraction_by) : std::string(" MB MAX");
  }
  return text;
}

std::string tail(const Block& block) {
  constexpr std::array<std::string_view, 4> kRadius{"", " R0", " RL", " RR"};
  return std::string(kRadius[static_cast<std::size_t>(block.radius)]) + feed_text(block) + function_words(block);
}

std::string tool_call(const Block& block) {
  std::string text = "TOOL CALL";
  if (block.tool == ToolWord::number) {
    text += ' ' + std::to_string(block.tool_number / 10);
    if (block.tool_number % 10 != 0) text += '.' + std::to_string(block.tool_number % 10);
  }
  if (block.tool == ToolWord::name) text.append(" \"").append(block.tool_name.view()).append(1, '"');
  if (block.tool == ToolWord::string_parameter) text += " QS0";
  if (block.tool_axis != '\0') text.append(1, ' ').append(1, block.tool_axis);
  text += feed_text(block);
  if (block.dl) text += " DL" + to_string(*block.dl);
  if (block.dr) text += " DR:" + to_string(*block.dr);  // DR2 is not DR and a 2
  if (block.dr2) text += " DR2:" + to_string(*block.dr2);
  return text;
}

std::string cycle_values(const Block& block) {
  std::string text;
  for (const Assignment& assignment : block.cycle_values)
    text += ' ' + to_string(Value{{}, assignment.target}) + '=' + to_string(assignment.value);
  return text;
}

std::string correction_text(CorrectionTable table) {
  return table == CorrectionTable::tcs ? " TCS" : table == CorrectionTable::wpl ? " WPL" : "";
}

std::string statement(const Block& block) {
  constexpr std::array<std::string_view, 3> kReferences{"TIP-TIP", "TIP-CNT", "CNT-CNT"};
  const std::string_view unit = block.unit == Units::mm ? "MM" : "INCH";
  switch (block.statement) {
    case Statement::begin_program:
      return "BEGIN PGM P " + std::string(unit);
    case Statement::end_program:
    case Statement::program_return:
      return "END PGM P " + std::string(unit);
    case Statement::block_form:
      return "BLK FORM 0.1 Z X0 Y0 Z0";
    case Statement::tool_call:
      return tool_call(block);
    case Statement::tool_definition:
      return "TOOL DEF 0";
    case Statement::line:
      return (block.departs ? "DEP LT LEN1" : "L") + axis_words(block) + tail(block);
    case Statement::line_with_vectors:
      return "LN" + axis_words(block) + (block.has_normal ? vector_words('N', block.normal) : "") +
             (block.has_tool_vector ? vector_words('T', block.tool_vector) : "") + tail(block);
    case Statement::tcpm:
      return "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT " +
             std::string(kReferences[static_cast<std::size_t>(block.reference)]);
    case Statement::reset_tcpm:
      return "FUNCTION RESET TCPM";
    case Statement::programmed_path:
      return block.contour ? "FUNCTION PROG PATH IS CONTOUR" : "FUNCTION PROG PATH OFF";
    case Statement::select_corrections:
      return "SEL CORR-TABLE" + correction_text(block.corrections) + " \"\"";
    case Statement::correction_row:
      return "FUNCTION CORRDATA" + correction_text(block.corrections) + " #" + std::to_string(block.row);
    case Statement::reset_corrections:
      return "FUNCTION CORRDATA RESET" + correction_text(block.corrections);
    case Statement::cycle:
      return "CYCL DEF " + std::to_string(block.cycle) + '.' + std::to_string(block.cycle_part) + axis_words(block) +
             cycle_values(block);
    case Statement::plane:
      return "PLANE RESET STAY";
    case Statement::label:
      return "LBL " + std::string(block.label.view());
    case Statement::call_label:
      return "CALL LBL " + std::string(block.label.view()) +
             (block.repeats == 0 ? "" : " REP " + std::to_string(block.repeats));
    case Statement::call_program:
      return "CALL PGM \"" + std::string(block.program.view()) + '"';
    case Statement::without_effect:
      return "FUNCTION MODE MILL";
    case Statement::assignment:
      return parameter_text(block.target) + " = " + to_string(block.value);
    case Statement::stop:
      return "STOP" + function_words(block);
    case Statement::miscellaneous:
      if (block.calls_cycle && !block.has_function(99)) return "CYCL CALL" + function_words(block);
      return block.functions == 0 ? "" : function_words(block).substr(1);
  }
  return "";
}

}  // namespace

std::string to_string(const Value& value) {
  if (value.parameter.kind == ParameterKind::none) return number_text(value.number);
  return (value.number.negative ? "-" : "") + parameter_text(value.parameter);
}

std::string to_string(const Block& block) {
  const std::string text = statement(block);
  return block.n ? std::to_string(*block.n) + ' ' + text : text;
}

}  // namespace toolcomp::spec::klartext
