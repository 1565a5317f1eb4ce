// SPDX-License-Identifier: Apache-2.0
// The statements that do not move: everything but L and LN.
#include <algorithm>
#include <array>
#include <optional>

#include "spec/language/alarm.h"
#include "spec/language/heidenhain/klartext_parser.h"
#include "spec/language/input_error.h"

namespace toolcomp::spec::klartext {
namespace {

constexpr std::uint64_t kMostTool = 32767;
constexpr std::uint64_t kMostRow = 999'999'999;
constexpr std::size_t kLongestName = 32;

bool is_zero(const Value& value) { return value.parameter.kind == ParameterKind::none && value.number.digits == 0; }

constexpr std::uint32_t kCentering = 240;
constexpr Parameter kByDiameter{ParameterKind::q, 343};  // 1: Q344 says how deep it goes, and the angle of the tool

// Cycles that drill one hole where the axes stand (heidenhain.program.drilling-cycle).
bool is_drilling_cycle(std::uint32_t cycle) {
  constexpr auto kDrilling = std::to_array<std::uint32_t>({200, 201, 202, 203, 205, 206, 207, 209, kCentering, 241});
  return std::ranges::find(kDrilling, cycle) != kDrilling.end();
}

// Cycles that nobody calls.
bool acts_where_defined(std::uint32_t cycle) {
  constexpr auto kAct =
      std::to_array<std::uint32_t>({7, 8, 9, 10, 11, 13, 14, 19, 20, 26, 32, 220, 221, 247, 270, 271});
  return std::ranges::find(kAct, cycle) != kAct.end();
}

// X, Y or Z alone.
char axis_letter(const char* at) {
  const char letter = upper(*at);
  return letter >= 'X' && letter <= 'Z' && at_word_end(at + 1) ? letter : '\0';
}

}  // namespace

const char* BlockParser::words(const char* at, std::string_view first, std::string_view second) {
  const char* end = read_word(at, first);
  if (end == nullptr) return nullptr;
  const char* const next = gap(end);
  if (second.empty()) return next;
  end = read_word(next, second);
  return end == nullptr ? nullptr : gap(end);
}

const char* BlockParser::free_text() {
  passed_over_ = true;
  return text_.stop;
}

// From the quote to the one behind it in the same line.
const char* BlockParser::quoted(Block& block, const char* at, std::string_view& text) {
  if (*at != '"') return bad_word(block, at);
  passed_over_ = true;
  const char* end = at + 1;
  while (*end != '"' && *end != '\n') ++end;
  if (*end == '\n' || !at_word_end(end + 1)) return bad_word(block, at);
  text = {at + 1, static_cast<std::size_t>(end - at - 1)};
  return gap(end + 1);
}

const char* BlockParser::rare_statement(Block& block, const char* at) {
  block.statement = Statement::miscellaneous;
  switch (upper(*at)) {
    case 'M':
      block.functions = 0;
      if (at_word_end(at + 1)) return bad_word(block, at);
      at = functions(block, at);
      break;
    case 'T':
      at = tool(block, at);
      break;
    case 'F':
      at = function(block, at);
      break;
    case 'Q':
      at = assignment(block, at, '=');
      break;
    case 'C':
      if (const char* const called = words(at, "CALL"))
        at = call(block, called);
      else
        at = cycle(block, at);
      break;
    case 'L':
      at = label(block, at);
      break;
    case 'P':
      if (const char* const selected = words(at, "PRESET", "SELECT"))
        at = preset(block, selected);
      else
        at = plane(block, at);
      break;
    case 'B':
      at = read_word(at, "BEGIN") != nullptr ? program(block, at) : block_form(block, at);
      break;
    case 'E':
      at = program(block, at);
      break;
    case 'S':
      if (const char* const stop = words(at, "STOP")) {
        block.statement = Statement::stop;
        block.functions = 0;
        at = functions(block, stop);
      } else {
        at = select_corrections(block, at);
      }
      break;
    default:
      return refuse_by_name(block, at);
  }
  if (at == nullptr || finish(block, at) == nullptr) return nullptr;
  ended_ = block.statement == Statement::end_program;
  return at;
}

const char* BlockParser::program(Block& block, const char* at) {
  const char* const initiator = at;
  const char* const begun = words(initiator, "BEGIN", "PGM");
  at = begun != nullptr ? begun : words(initiator, "END", "PGM");
  if (at == nullptr) return bad_word(block, initiator);
  block.statement = begun != nullptr ? Statement::begin_program : Statement::end_program;
  if (block.statement == Statement::begin_program && !first_)
    return raise(block, initiator, AlarmCause::syntax, "BEGIN PGM is allowed only in the first block");
  passed_over_ = true;
  if (at == text_.stop) return bad_word(block, at);
  const char* const name = at;
  while (!is_blank(*at) && *at != ';' && *at != '\n') ++at;
  block.program = std::string_view(name, static_cast<std::size_t>(at - name));
  at = gap(at);
  const char* behind = words(at, "MM");
  block.unit = behind != nullptr ? Units::mm : Units::inch;
  if (behind == nullptr) behind = words(at, "INCH");
  if (behind == nullptr) return bad_word(block, at);
  if (block.statement == Statement::begin_program && behind == text_.stop) {
    program_name_ = block.program;
    units_ = block.unit;
  }
  return behind;
}

const char* BlockParser::block_form(Block& block, const char* at) {
  const char* const initiator = at;
  at = words(at, "BLK", "FORM");
  if (at == nullptr) return bad_word(block, initiator);
  block.statement = Statement::block_form;
  for (const std::string_view form : {"CYLINDER", "ROTATION", "FILE"})
    if (read_word(at, form) != nullptr) return free_text();
  const bool second = read_word(at, "0.2") != nullptr;
  if (!second && read_word(at, "0.1") == nullptr) return bad_word(block, at);
  at = gap(at + 3);
  if (!second) {
    if (axis_letter(at) == '\0') return bad_word(block, at);
    at = gap(at + 1);
  }
  for (const char letter : {'X', 'Y', 'Z'}) {
    const bool increment = second && upper(*at) == 'I';
    if (upper(at[increment ? 1 : 0]) != letter) return bad_word(block, at);
    Value ignored;
    at = keyed_value(block, at, increment ? 2 : 1, ignored);
    if (at == nullptr) return nullptr;
  }
  return at;
}

const char* BlockParser::tool(Block& block, const char* at) {
  if (const char* const call = words(at, "TOOL", "CALL")) return tool_call(block, call);
  if (const char* const definition = words(at, "TOOL", "DEF")) return tool_definition(block, definition);
  if (const char* const datum = words(at, "TRANS", "DATUM")) return transformation(block, datum);
  return refuse_by_name(block, at);
}

// A number, a name, a string parameter, or none of them.
const char* BlockParser::tool_name(Block& block, const char* at) {
  block.tool = ToolWord::none;
  const char* const word = at;
  if (is_digit(*at)) {
    std::uint64_t number = 0;
    at = read_integer(at, kMostTool, number);
    if (at == nullptr) return bad_word(block, word);
    block.tool = ToolWord::number;
    block.tool_number = static_cast<std::uint32_t>(number * 10);
    if (*at == '.' && at[1] >= '1' && at[1] <= '9') {
      block.tool_number += static_cast<std::uint32_t>(at[1] - '0');
      at += 2;
    }
    return at_word_end(at) ? gap(at) : bad_word(block, word);
  }
  if (*at == '"') {
    std::string_view name;
    at = quoted(block, at, name);
    if (at == nullptr) return nullptr;
    if (name.empty() || name.size() > kLongestName)
      return raise(block, word, AlarmCause::syntax, "a tool name must have 1 to 32 characters");
    block.tool = ToolWord::name;
    block.tool_name = name;
    return at;
  }
  if (upper(*at) == 'Q' && upper(at[1]) == 'S') {
    std::uint64_t index = 0;
    at = read_integer(at + 2, kMostQ, index);
    if (at == nullptr || !at_word_end(at)) return bad_word(block, word);
    block.tool = ToolWord::string_parameter;
    return gap(at);
  }
  return at;
}

const char* BlockParser::tool_call(Block& block, const char* at) {
  block.statement = Statement::tool_call;
  block.feed = FeedWord::none;
  block.dl.reset();
  block.dr.reset();
  block.dr2.reset();
  bool speed = false;
  at = tool_name(block, at);
  if (at == nullptr) return nullptr;
  if (block.tool != ToolWord::none) beside_ = false;
  block.tool_axis = axis_letter(at);
  if (block.tool_axis != '\0') at = gap(at + 1);
  while (at != nullptr && at != text_.stop) {
    const char key = upper(*at);
    if (key == 'S' && !speed) {
      speed = true;
      Value ignored;
      at = keyed_value(block, at, 1, ignored);
    } else if (key == 'F' && block.feed == FeedWord::none) {
      at = feed(block, at);
    } else if (key == 'D') {
      const char which = upper(at[1]);
      const bool corner = which == 'R' && at[2] == '2';
      if (which != 'L' && which != 'R') return bad_word(block, at);
      std::optional<Value>& delta = which == 'L' ? block.dl : corner ? block.dr2 : block.dr;
      if (delta) return bad_word(block, at);
      const std::size_t letters = corner ? 3 : 2;
      at = keyed_value(block, at, letters + (at[letters] == ':' ? 1 : 0), delta.emplace());
    } else {
      return bad_word(block, at);
    }
  }
  return at;
}

const char* BlockParser::tool_definition(Block& block, const char* at) {
  block.statement = Statement::tool_definition;
  const char* const word = at;
  if (*at == '"') {
    std::string_view name;
    at = quoted(block, at, name);
    if (at == nullptr) return nullptr;
  } else {
    std::uint64_t number = 0;
    at = read_integer(at, kMostTool, number);
    if (at == nullptr || !at_word_end(at)) return bad_word(block, word);
    at = gap(at);
  }
  bool length = false;
  bool radius = false;
  while (at != nullptr && at != text_.stop) {
    const char key = upper(*at);
    bool& given = key == 'L' ? length : radius;
    if ((key != 'L' && key != 'R') || given) return bad_word(block, at);
    given = true;
    Value ignored;
    at = keyed_value(block, at, 1, ignored);
  }
  return at;
}

const char* BlockParser::function(Block& block, const char* at) {
  if (upper(at[1]) == 'N') return numbered_function(block, at);
  const char* const named = words(at, "FUNCTION");
  if (named == nullptr) return bad_word(block, at);
  const char* off = words(named, "RESET", "TCPM");
  if (off == nullptr) off = words(named, "TCPM", "OFF");
  if (off != nullptr) {
    block.statement = Statement::reset_tcpm;
    tcpm_ = false;
    return off;
  }
  if (const char* const on = words(named, "TCPM")) return tcpm(block, on);
  if (const char* const path = words(named, "PROG", "PATH")) {
    block.statement = Statement::programmed_path;
    const char* const on = words(path, "IS", "CONTOUR");
    block.contour = on != nullptr;
    if (block.contour) return on;
    off = words(path, "OFF");
    return off == nullptr ? bad_word(block, path) : off;
  }
  if (const char* const data = words(named, "CORRDATA")) return correction_data(block, data);
  if (words(named, "MODE", "MILL") != nullptr) return without_effect(block);
  for (const std::string_view word : {"COUNT", "DCM", "DWELL", "FEED", "LIFTOFF", "S-PULSE"})
    if (read_word(named, word) != nullptr) return without_effect(block);
  refuse_by_name(block, at);
  return is_beyond(block.alarm->cause) ? nullptr : bad_word(block, named);
}

const char* BlockParser::tcpm(Block& block, const char* at) {
  block.statement = Statement::tcpm;
  tcpm_ = true;
  lateral_ = lateral_ || beside_;
  block.reference = ReferenceWord::tip_tip;
  const auto one_of = [&](std::string_view word, std::string_view one, std::string_view other) {
    const char* behind = words(at, word, one);
    if (behind == nullptr) behind = words(at, word, other);
    if (behind == nullptr) bad_word(block, at);
    at = behind;
    return behind != nullptr;
  };
  if (!one_of("F", "TCP", "CONT") || !one_of("AXIS", "POS", "SPAT") || !one_of("PATHCTRL", "AXIS", "VECTOR"))
    return nullptr;
  if (const char* const point = words(at, "REFPNT")) {
    at = reference(block, point);
    if (at == nullptr) return nullptr;
  }
  if (upper(*at) != 'F') return at;
  Value ignored;
  return keyed_value(block, at, 1, ignored);
}

const char* BlockParser::reference(Block& block, const char* at) {
  struct Choice {
    std::string_view word;
    ReferenceWord reference;
  };
  constexpr std::array<Choice, 5> kChoices{{{"TIP-TIP", ReferenceWord::tip_tip},
                                            {"TIP-CNT", ReferenceWord::tip_center},
                                            {"CNT-CNT", ReferenceWord::center_center},
                                            {"TIP-CENTER", ReferenceWord::tip_center},
                                            {"CENTER-CENTER", ReferenceWord::center_center}}};
  for (const auto& [word, reference] : kChoices)
    if (const char* const end = read_word(at, word)) {
      block.reference = reference;
      return gap(end);
    }
  return bad_word(block, at);
}

const char* BlockParser::table_word(Block& block, const char* at) {
  const char* const tcs = words(at, "TCS");
  block.corrections = tcs != nullptr ? CorrectionTable::tcs : CorrectionTable::wpl;
  const char* const behind = tcs != nullptr ? tcs : words(at, "WPL");
  return behind == nullptr ? bad_word(block, at) : behind;
}

const char* BlockParser::select_corrections(Block& block, const char* at) {
  const char* const table = words(at, "SEL", "CORR-TABLE");
  if (table == nullptr) {
    // Tables and contours are named here and used elsewhere.
    for (const std::string_view kind : {"TABLE", "PATTERN", "CONTOUR"})
      if (words(at, "SEL", kind) != nullptr) return without_effect(block);
    return refuse_by_name(block, at);
  }
  block.statement = Statement::select_corrections;
  at = table_word(block, table);
  std::string_view name;
  return at == nullptr ? nullptr : quoted(block, at, name);
}

const char* BlockParser::correction_data(Block& block, const char* at) {
  if (const char* const reset = words(at, "RESET")) {
    block.statement = Statement::reset_corrections;
    block.corrections = CorrectionTable::both;
    return reset == text_.stop ? reset : table_word(block, reset);
  }
  block.statement = Statement::correction_row;
  at = table_word(block, at);
  return at == nullptr ? nullptr : correction_row(block, at);
}

const char* BlockParser::correction_row(Block& block, const char* at) {
  const char* const word = at;
  std::uint64_t row = 0;
  at = *at == '#' ? read_integer(at + 1, kMostRow, row) : nullptr;
  if (at == nullptr || !at_word_end(at)) return bad_word(block, word);
  at = gap(at);
  block.row = static_cast<std::uint32_t>(row);
  if (at != text_.stop || block.corrections != CorrectionTable::tcs || setup_.tcs.contains(block.row)) return at;
  const Place fault = place(word);
  throw InputError(file_, fault.line, fault.column,
                   "the setup has no [[correction.tcs]] with number = " + std::to_string(row));
}

const char* BlockParser::cycle(Block& block, const char* at) {
  if (const char* const call = words(at, "CYCL", "CALL")) {
    call_at_ = at;
    return cycle_call(block, call);
  }
  const char* const definition = words(at, "CYCL", "DEF");
  if (definition == nullptr) return refuse_by_name(block, at);
  block.statement = Statement::cycle;
  block.axes = block.incremental = 0;
  block.cycle_values.clear();
  std::uint64_t number = 0;
  std::uint64_t part = 0;
  at = read_integer(definition, kMostRow, number);
  if (at != nullptr && *at == '.') at = read_integer(at + 1, kMostRow, part);
  if (at == nullptr || !at_word_end(at)) return bad_word(block, definition);
  block.cycle = static_cast<std::uint32_t>(number);
  block.cycle_part = static_cast<std::uint32_t>(part);
  if (is_drilling_cycle(block.cycle)) return drilling_cycle(block, gap(at));
  if (!acts_where_defined(block.cycle)) to_call_ = block.cycle;
  return number == 7 && part != 0 ? datum_shift(block, gap(at)) : path_cycle(block, gap(at));
}

// Q200=+2 …: its parameters have these values from here on.
const char* BlockParser::drilling_cycle(Block& block, const char* at) {
  to_call_ = block.cycle;
  while (at != text_.stop && (upper(*at) != 'Q' || !is_digit(at[1]))) at = gap(word_end(at));  // its name
  while (at != text_.stop) {
    const char* const word = at;
    Assignment& assignment = block.cycle_values.emplace_back();
    at = read_parameter(at, assignment.target);
    if (at == nullptr || *at != '=' || assignment.target.kind != ParameterKind::q) return bad_word(block, word);
    at = keyed_value(block, word, static_cast<std::size_t>(at + 1 - word), assignment.value);
    if (at == nullptr) return nullptr;
    parameters_.set(assignment.target, parameters_.value(assignment.value));
  }
  return at;
}

const char* BlockParser::cycle_call(Block& block, const char* at) {
  for (const std::string_view form : {"POS", "PAT"})
    if (read_word(at, form) != nullptr) return refuse(block, at, "CYCL CALL (POS, PAT) is not supported");
  block.functions = 0;
  block.calls_cycle = true;
  return functions(block, at);
}

const char* BlockParser::call_beyond(const Block& block) const {
  const bool by_function = block.has_function(99);
  const auto either = [by_function](const char* function, const char* statement) {
    return by_function ? function : statement;
  };
  const bool plain = block.statement == Statement::miscellaneous ||
                     (block.statement == Statement::line && !block.departs && block.retraction == Retraction::none);
  if (!plain) return "M99 (cycle call, in a block other than L and M functions) is not supported";
  if (!is_drilling_cycle(to_call_))
    return either("M99 (cycle call, of a cycle other than a drilling cycle) is not supported",
                  "CYCL CALL (of a cycle other than a drilling cycle) is not supported");
  if (beside_ || tcpm_ || begins_in_tcpm_)
    return either("M99 (cycle call, under RL, RR or TCPM) is not supported",
                  "CYCL CALL (under RL, RR or TCPM) is not supported");
  const std::optional<Decimal> by_diameter = parameters_.value(kByDiameter);
  if (to_call_ == kCentering && (!by_diameter || !by_diameter->is_zero()))
    return either("M99 (cycle call, of cycle 240 by diameter) is not supported",
                  "CYCL CALL (of cycle 240 by diameter) is not supported");
  for (const Parameter& parameter : {kDepth, kSetUpClearance, kSurface, kSecondClearance})
    if (!parameters_.value(parameter)) return "Q (set by FN 18) is not supported";
  const std::optional<Decimal> depth = parameters_.value(kDepth);
  if (!depth->negative && !depth->is_zero())
    return either("M99 (cycle call, with a depth above the surface) is not supported",
                  "CYCL CALL (with a depth above the surface) is not supported");
  return nullptr;
}

const char* BlockParser::datum_shift(Block& block, const char* at) {
  constexpr std::string_view kLinear = "XYZUVW";
  if (*at == '#') return refuse(block, at, "CYCL DEF 7 # (a datum table) is not supported");
  while (at != text_.stop) {
    const char* const word = at;
    const bool increment = upper(*at) == 'I';
    if (increment) ++at;
    const unsigned slot = slot_[static_cast<unsigned char>(*at)];
    if (slot == kNoSlot || kLinear.find(upper(*at)) == std::string_view::npos || block.has_axis(slot))
      return bad_word(block, word);
    at = keyed_value(block, word, increment ? 2 : 1, block.axis[slot]);
    if (at == nullptr) return nullptr;
    block.axes = static_cast<std::uint16_t>(block.axes | 1U << slot);
    if (increment) block.incremental = static_cast<std::uint16_t>(block.incremental | 1U << slot);
  }
  return at;
}

const char* BlockParser::plane(Block& block, const char* at) {
  const char* const initiator = at;
  // Rotary axes that stand at 0 need no turn.
  const auto turns = [&](const char* word) {
    return turned_ && (read_word(word, "MOVE") != nullptr || read_word(word, "TURN") != nullptr);
  };
  at = words(at, "PLANE");
  if (at == nullptr) return refuse_by_name(block, initiator);
  block.statement = Statement::plane;
  if (const char* const reset = words(at, "RESET")) {
    if (turns(reset))
      return raise(block, initiator, AlarmCause::not_judged, "PLANE RESET (with MOVE or TURN) is not judged");
    return free_text();
  }
  const char* const spatial = words(at, "SPATIAL");
  if (spatial == nullptr) {
    refuse_by_name(block, initiator);
    return is_beyond(block.alarm->cause) ? nullptr : bad_word(block, at);
  }
  at = spatial;
  bool tilts = false;
  for (const char letter : {'A', 'B', 'C'}) {
    if (upper(at[0]) != 'S' || upper(at[1]) != 'P' || upper(at[2]) != letter) return bad_word(block, at);
    Value angle;
    at = keyed_value(block, at, 3, angle);
    if (at == nullptr) return nullptr;
    tilts = tilts || !is_zero(angle);
  }
  if (read_word(at, "MOVE") == nullptr && read_word(at, "TURN") == nullptr && read_word(at, "STAY") == nullptr)
    return bad_word(block, at);
  if (tilts || turns(at))
    return raise(block, initiator, AlarmCause::not_judged, "PLANE SPATIAL (tilted working plane) is not judged");
  return free_text();
}

// FN 18 reads what only a control knows: its parameter has no value here.
const char* BlockParser::system_data(Block& block, const char* at) {
  const char* const word = at;
  at = words(at, "SYSREAD");
  if (at == nullptr) return bad_word(block, word);
  Parameter target;
  const char* const end = read_parameter(at, target);
  if (end == nullptr) return bad_word(block, at);
  parameters_.set(target, std::nullopt);
  unknown_ = true;
  return without_effect(block);
}

// Q = formula, FN 0 to FN 4 (`operation`: = 0 + - * /).
const char* BlockParser::assignment(Block& block, const char* at, char operation) {
  block.statement = Statement::assignment;
  const bool formula = operation == '=';
  const char* const word = at;
  if (formula && upper(at[1]) == 'S' && is_digit(at[2]))
    return refuse(block, word, "QS (string parameters) is not supported");
  at = read_parameter(at, block.target);
  if (at == nullptr || (block.target.kind != ParameterKind::q && !formula)) return bad_word(block, word);
  if (*at != '=') {
    if (!at_word_end(at)) return bad_word(block, word);
    at = gap(at);
    if (*at != '=') return bad_word(block, at);
  }
  at = gap(at + 1);
  const char* const behind = read_value(at, block.value);
  if (behind != nullptr && at_word_end(behind) && (operation == '0' || (formula && gap(behind) == text_.stop))) {
    // A value alone stays as it is written.
    parameters_.set(block.target, parameters_.value(block.value));
    return gap(behind);
  }
  if (operation == '0') return bad_word(block, at);
  const Formula found = formula ? read_formula(at, parameters_) : read_operation(at, operation, parameters_);
  if (found.end == nullptr) return bad_word(block, at);
  if (!found.value) return refuse(block, found.beyond_at, found.beyond);
  parameters_.set(block.target, found.value);
  block.value = {*found.value, {}};
  return gap(found.end);
}

// A word whose value nobody knows here.
bool BlockParser::takes_unknown(const Block& block) const {
  const auto unknown = [this](const Value& value) { return !parameters_.value(value); };
  const bool line = block.statement == Statement::line || block.statement == Statement::line_with_vectors;
  const bool call = block.statement == Statement::tool_call;
  if (line || block.statement == Statement::cycle)
    for (std::size_t slot = 0; slot < block.axis.size(); ++slot)
      if (block.has_axis(slot) && unknown(block.axis.at(slot))) return true;
  if (line && block.retraction == Retraction::by && unknown(block.retraction_by)) return true;
  if ((line || call) && block.feed == FeedWord::f && unknown(block.feed_value)) return true;
  if (call)
    for (const auto* delta : {&block.dl, &block.dr, &block.dr2})
      if (*delta && unknown(**delta)) return true;
  return false;
}

}  // namespace toolcomp::spec::klartext
