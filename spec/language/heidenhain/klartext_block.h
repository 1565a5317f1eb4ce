// SPDX-License-Identifier: Apache-2.0
// One logical block of a Klartext program: a statement with its words, with exact decimals, without their meaning.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spec/language/decimal.h"
#include "spec/language/name.h"
#include "spec/language/setup.h"
#include "spec/parameters/alarm_causes.h"

namespace toolcomp::spec::klartext {

enum class Statement : std::uint8_t {
  begin_program,       // BEGIN PGM name MM|INCH: unit
  end_program,         // END PGM name MM|INCH: unit
  block_form,          // BLK FORM 0.1, 0.2
  tool_call,           // TOOL CALL: tool, tool_axis, deltas, feed
  tool_definition,     // TOOL DEF
  line,                // L: axis words, radius, feed, M functions; M140 of any block; departures from a contour
  line_with_vectors,   // LN: X Y Z, normal, tool_vector, radius, feed, M functions
  tcpm,                // FUNCTION TCPM: reference
  reset_tcpm,          // FUNCTION RESET TCPM, FUNCTION TCPM OFF
  programmed_path,     // FUNCTION PROG PATH: contour
  select_corrections,  // SEL CORR-TABLE: corrections
  correction_row,      // FUNCTION CORRDATA TCS|WPL #n: corrections, row
  reset_corrections,   // FUNCTION CORRDATA RESET: corrections
  cycle,               // CYCL DEF: cycle, cycle_part; of cycle 7 the axis words, of drilling cycles the values
  plane,               // PLANE RESET, PLANE SPATIAL
  label,               // LBL: label, jumps
  call_label,          // CALL LBL: label, repeats, jumps
  call_program,        // CALL PGM: program
  program_return,      // END PGM of a program that was called
  assignment,          // Q1 = …, FN 0: Q1 = …: target, value
  stop,                // STOP: M functions
  miscellaneous,       // M functions alone; CYCL CALL
  without_effect,      // SEL TABLE, FUNCTION MODE MILL, PRESET SELECT, …
};

enum class ParameterKind : std::uint8_t { none, q, ql, qr };
struct Parameter {
  ParameterKind kind = ParameterKind::none;
  std::uint16_t index = 0;  // Q up to 1999, QL and QR up to 499
  friend bool operator==(const Parameter&, const Parameter&) = default;
};
inline constexpr std::uint16_t kMostQ = 1999;
inline constexpr std::uint16_t kMostLocal = 499;
// The parameters that a call of a drilling cycle uses (heidenhain.program.cycle-call).
inline constexpr Parameter kSetUpClearance{ParameterKind::q, 200};
inline constexpr Parameter kDepth{ParameterKind::q, 201};
inline constexpr Parameter kSurface{ParameterKind::q, 203};
inline constexpr Parameter kSecondClearance{ParameterKind::q, 204};

// A literal, or a parameter with its sign (number.negative; the other members of number are then 0).
struct Value {
  Decimal number;
  Parameter parameter;
  friend bool operator==(const Value&, const Value&) = default;
};

// Q200 = +2
struct Assignment {
  Parameter target;
  Value value;
  friend bool operator==(const Assignment&, const Assignment&) = default;
};

// The letters of axis words, in the order of the slots.
inline constexpr std::string_view kAxisLetters = "XYZABCUVW";

enum class RadiusWord : std::uint8_t { none, r0, rl, rr };
enum class FeedWord : std::uint8_t { none, f, f_max, f_auto, f_z, f_u };
enum class ReferenceWord : std::uint8_t { tip_tip, tip_center, center_center };
enum class CorrectionTable : std::uint8_t { tcs, wpl, both };

enum class Retraction : std::uint8_t { none, by, to_limit };  // M140 MB n, M140 MB MAX

enum class ToolWord : std::uint8_t { none, number, name, string_parameter };

// The alarm that the control raises when it reaches a block it cannot read (docs/events.md, rule 5).
struct ReadAlarm {
  AlarmCause cause = AlarmCause::none;
  std::uint64_t line = 0;  // line of the fault in the text; after a continuation it is not the line of the block
  std::uint32_t column = 0;
  const char* message = "";  // static text
};

// A member has a meaning only if the statement has it and its mask or kind says so. The reader writes nothing else, so
// other members may keep old values. A block with a read alarm is not executed; its statement is that of the initiator,
// or `miscellaneous`.
struct Block {
  static constexpr std::size_t kMostFunctions = 4;  // one more raises E_TOO_MANY_M

  Statement statement = Statement::miscellaneous;
  std::uint64_t line = 0;          // of the text, from 1: the first of the block
  std::uint32_t column = 1;        // of the statement
  std::optional<std::uint64_t> n;  // block number
  std::optional<ReadAlarm> alarm;

  // L, LN, cycle 7: by slot, see kAxisLetters
  std::uint16_t axes = 0;         // bit i: slot i has a word
  std::uint16_t incremental = 0;  // bit i: with I
  std::array<Value, kAxisLetters.size()> axis;

  // LN: NX NY NZ and TX TY TZ, plain numbers, not all 0
  bool has_normal = false;
  bool has_tool_vector = false;
  std::array<Decimal, 3> normal;
  std::array<Decimal, 3> tool_vector;
  bool many_digits = false;  // L, LN: more digits than the control accepts (W_DIGITS)

  // L, LN; the feed of TOOL CALL too
  RadiusWord radius = RadiusWord::none;
  FeedWord feed = FeedWord::none;
  Value feed_value;  // value of f, f_z, f_u

  // L, LN, STOP, M alone: M functions in the order written
  std::uint8_t functions = 0;
  std::array<std::uint16_t, kMostFunctions> function{};

  // L, M alone: M99 or CYCL CALL; it calls the drilling cycle defined last
  bool calls_cycle = false;

  // L: M140, in a block without axis words
  Retraction retraction = Retraction::none;
  Value retraction_by;
  bool departs = false;  // DEP LT, LN or CT, whose words do not give the end point

  // TOOL CALL
  ToolWord tool = ToolWord::none;
  std::uint32_t tool_number = 0;  // tenths: 51 for 5.1, 50 for 5
  Name tool_name;                 // at most 32 characters
  char tool_axis = 0;             // X Y Z, or 0
  std::optional<Value> dl, dr, dr2;

  Units unit = Units::mm;                               // BEGIN PGM, END PGM
  ReferenceWord reference = ReferenceWord::tip_tip;     // FUNCTION TCPM
  bool contour = false;                                 // FUNCTION PROG PATH
  CorrectionTable corrections = CorrectionTable::both;  // SEL CORR-TABLE, CORRDATA
  std::uint32_t row = 0;                                // CORRDATA #n
  std::uint32_t cycle = 0;                              // CYCL DEF 7.1: 7 …
  std::uint32_t cycle_part = 0;                         // … and 1
  std::vector<Assignment> cycle_values;                 // CYCL DEF of a drilling cycle, in the order written
  Parameter target;                                     // Q1 = value
  Value value;

  // LBL, CALL LBL: the digits of a number, or a name with its quotes. LBL 0 ends a subprogram.
  Name label;
  std::uint16_t repeats = 0;  // CALL LBL: the number of REP; 0: a subprogram
  bool jumps = false;         // LBL, CALL LBL: the next block is not the next one of the text
  Name program;               // CALL PGM, BEGIN PGM, END PGM: the name as written, without quotes

  [[nodiscard]] bool departs_from_contour() const { return statement == Statement::line && departs; }
  [[nodiscard]] bool has_function(std::uint16_t number) const {
    return std::find(function.begin(), function.begin() + functions, number) != function.begin() + functions;
  }
  [[nodiscard]] bool has_axis(std::size_t slot) const { return (axes >> slot & 1U) != 0; }
  [[nodiscard]] bool is_incremental(std::size_t slot) const { return (incremental >> slot & 1U) != 0; }
};

// Whether usual LN blocks (klartext_lines.h) are worth a look after this block.
inline bool lines_may_follow(const Block& block) { return block.statement == Statement::line_with_vectors; }

// A text that the reader reads back to the same block, including the block number. Parts that a block does not keep
// (the corners of BLK FORM, the text of cycles, …) are as short as the grammar permits.
std::string to_string(const Block& block);
std::string to_string(const Value& value);

}  // namespace toolcomp::spec::klartext
