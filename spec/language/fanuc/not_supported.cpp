// SPDX-License-Identifier: Apache-2.0
#include "spec/language/fanuc/not_supported.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace toolcomp::spec {
namespace {

struct Code {
  std::uint64_t tenths;
  const char* text;
};

// Machining centre system, ascending.
constexpr std::array kCodes{
    Code{22, "G02.2 (involute interpolation) is not supported"},
    Code{23, "G02.3 (exponential interpolation) is not supported"},
    Code{24, "G02.4 (three-dimensional circular interpolation) is not supported"},
    Code{32, "G03.2 (involute interpolation) is not supported"},
    Code{33, "G03.3 (exponential interpolation) is not supported"},
    Code{34, "G03.4 (three-dimensional circular interpolation) is not supported"},
    Code{54, "G05.4 (hold of high precision control) is not supported"},
    Code{62, "G06.2 (NURBS interpolation) is not supported"},
    Code{70, "G07 (hypothetical axis interpolation) is not supported"},
    Code{71, "G07.1 (cylindrical interpolation) is not supported"},
    Code{106, "G10.6 (tool retract and recover) is not supported"},
    Code{120, "G12 (a code of machine builders) is not supported"},
    Code{121, "G12.1 (polar coordinate interpolation) is not supported"},
    Code{130, "G13 (a code of machine builders) is not supported"},
    Code{160, "G16 (polar coordinate command) is not supported"},
    Code{270, "G27 (reference position return check) is not supported"},
    Code{310, "G31 (skip) is not supported"},
    Code{318, "G31.8 (EGB skip) is not supported"},
    Code{330, "G33 (threading) is not supported"},
    Code{340, "G34 (a code of machine builders) is not supported"},
    Code{350, "G35 (a code of machine builders) is not supported"},
    Code{360, "G36 (a code of machine builders) is not supported"},
    Code{380, "G38 (cutter compensation vector retention) is not supported"},
    Code{411, "G41.1 (normal direction control) is not supported"},
    Code{414, "G41.4 (three-dimensional cutter compensation) is not supported"},
    Code{415, "G41.5 (three-dimensional cutter compensation) is not supported"},
    Code{421, "G42.1 (normal direction control) is not supported"},
    Code{424, "G42.4 (three-dimensional cutter compensation) is not supported"},
    Code{425, "G42.5 (three-dimensional cutter compensation) is not supported"},
    Code{431, "G43.1 (tool length compensation in tool axis direction) is not supported"},
    Code{433, "G43.3 (nutating rotary head tool length compensation) is not supported"},
    Code{437, "G43.7 (tool offset) is not supported"},
    Code{438, "G43.8 (cutting point command) is not supported"},
    Code{439, "G43.9 (cutting point command) is not supported"},
    Code{441, "G44.1 (torch turning control) is not supported"},
    Code{510, "G51 (scaling) is not supported"},
    Code{511, "G51.1 (programmable mirror image) is not supported"},
    Code{512, "G51.2 (polygon turning) is not supported"},
    Code{531, "G53.1 (tool axis direction control) is not supported"},
    Code{536, "G53.6 (tool center point retention type tool axis direction control) is not supported"},
    Code{542, "G54.2 (rotary table dynamic fixture offset) is not supported"},
    Code{544, "G54.4 (workpiece setting error compensation) is not supported"},
    Code{600, "G60 (single direction positioning) is not supported"},
    Code{650, kMacroOfNoProgram},
    Code{660, "G66 (modal macro call) is not supported"},
    Code{661, "G66.1 (modal macro call) is not supported"},
    Code{680, "G68 (coordinate system rotation) is not supported"},
    Code{682, "G68.2 (tilted working plane) is not supported"},
    Code{683, "G68.3 (tilted working plane) is not supported"},
    Code{684, "G68.4 (tilted working plane) is not supported"},
    Code{700, "G70 (a code of machine builders) is not supported"},
    Code{710, "G71 (a code of machine builders) is not supported"},
    Code{720, "G72 (a code of machine builders) is not supported"},
    Code{721, "G72.1 (figure copy) is not supported"},
    Code{722, "G72.2 (figure copy) is not supported"},
    Code{750, "G75 (grinding cycle) is not supported"},
    Code{770, "G77 (grinding cycle) is not supported"},
    Code{780, "G78 (grinding cycle) is not supported"},
    Code{790, "G79 (grinding cycle) is not supported"},
    Code{811, "G81.1 (chopping) is not supported"},
    Code{842, "G84.2 (rigid tapping, a canned cycle) is not supported"},
    Code{843, "G84.3 (left-handed rigid tapping, a canned cycle) is not supported"},
    Code{921, "G92.1 (workpiece coordinate system preset) is not supported"},
    Code{1070, "G107 (cylindrical interpolation) is not supported"},
    Code{1120, "G112 (polar coordinate interpolation) is not supported"},
    Code{1510, "G151 (normal direction control) is not supported"},
    Code{1520, "G152 (normal direction control) is not supported"},
    Code{1610, "G161 (in-feed control) is not supported"},
    Code{1870, "G187 (a code of machine builders) is not supported"},
    Code{2340, "G234 (a code of machine builders) is not supported"},
    Code{2540, "G254 (a code of machine builders) is not supported"},
    Code{2550, "G255 (a code of machine builders) is not supported"},
};
static_assert(std::ranges::is_sorted(kCodes, {}, &Code::tenths));

struct Statement {
  std::string_view begins;
  const char* text;
};

// In this order: GOTO before what begins alike.
constexpr std::array kMacros{
    Statement{"IF", "IF (a macro statement) is not supported"},
    Statement{"WHILE", "WHILE (a macro statement) is not supported"},
    Statement{"GOTO", "GOTO (a macro statement) is not supported"},
    Statement{"THEN", "THEN (a macro statement) is not supported"},
    Statement{"END", "END (a macro statement) is not supported"},
    Statement{"DO", "DO (a macro statement) is not supported"},
    Statement{"SETVN", "SETVN (a macro statement) is not supported"},
    Statement{"POPEN", "POPEN (a macro statement) is not supported"},
    Statement{"PCLOS", "PCLOS (a macro statement) is not supported"},
    Statement{"DPRNT", "DPRNT (a macro statement) is not supported"},
    Statement{"BPRNT", "BPRNT (a macro statement) is not supported"},
    Statement{",R", ",R (corner rounding) is not supported"},
    Statement{",C", ",C (chamfering) is not supported"},
};

}  // namespace

const char* code_not_supported(const Decimal& number) {
  std::uint64_t tenths = number.digits;
  unsigned decimals = number.decimals;
  for (; decimals > 1; --decimals, tenths /= 10)
    if (tenths % 10 != 0) return nullptr;
  if (tenths > kCodes.back().tenths) return nullptr;
  if (decimals == 0) tenths *= 10;
  const std::span codes(kCodes);
  const auto found = std::ranges::lower_bound(codes, tenths, {}, &Code::tenths);
  return found != codes.end() && found->tenths == tenths ? found->text : nullptr;
}

const char* text_not_supported(std::string_view text) {
  const auto is = [text](std::size_t at, char c) { return text.size() > at && text[at] == c; };
  if (is(0, '#') || is(1, '#')) return "# (a macro variable) is not supported";
  if (is(0, '[') || is(1, '[')) return "[ (an expression of a macro) is not supported";
  const std::span statements(kMacros);
  const auto found =
      std::ranges::find_if(statements, [text](const Statement& s) { return text.starts_with(s.begins); });
  return found == statements.end() ? nullptr : found->text;
}

}  // namespace toolcomp::spec
