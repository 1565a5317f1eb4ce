// SPDX-License-Identifier: Apache-2.0
// Drilling cycles of Klartext programs: their definitions, what changes between definition and call, and the calls.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "fuzz/gen/heidenhain/klartext_program.h"

namespace toolcomp::fuzz {
namespace {

constexpr std::string_view kLetters = "XYZ";
constexpr int kCentering = 240;

struct NamedCycle {
  int number;
  std::string_view name;
};
constexpr NamedCycle kCycles[] = {{200, "DRILLING"},
                                  {201, "REAMING"},
                                  {202, "BORING"},
                                  {203, "UNIVERSAL DRILLING"},
                                  {205, "UNIVERSAL PECKING"},
                                  {206, "TAPPING NEW"},
                                  {207, "RIGID TAPPING NEW"},
                                  {209, "TAPPING W/ CHIP BRKG"},
                                  {kCentering, "CENTERING"},
                                  {241, "SINGLE-FLUTE D.H.DRLNG"}};

// Words that no rule here asks for.
struct OtherWord {
  std::string_view parameter;
  std::int64_t value;
  std::string_view meaning;
};
constexpr OtherWord kOthers[] = {
    {"Q206", 250, "FEED RATE FOR PLNGNG"}, {"Q202", 5, "PLUNGING DEPTH"},         {"Q210", 0, "DWELL TIME AT TOP"},
    {"Q211", 1, "DWELL TIME AT DEPTH"},    {"Q208", 500, "RETRACTION FEED RATE"}, {"Q395", 0, "DEPTH REFERENCE"},
    {"Q256", 1, "DIST. FOR CHIP BRKNG"},   {"Q239", 2, "THREAD PITCH"},           {"Q212", 1, "DECREMENT"},
    {"Q214", 1, "DISENGAGING DIRECTN"}};

}  // namespace

// A few holes, with what goes before them.
void KlartextProgram::holes() {
  if (choose_.chance(3)) return refused_call();
  rest_before_holes();
  if (choose_.chance(10)) tool_call();
  if (!defined_ || choose_.chance(25)) define_cycle();
  if (choose_.chance(22)) shift_along_the_tool();
  for (std::int64_t n = choose_.between(1, 4); n > 0; --n) {
    if (choose_.chance(25)) change_cycle();
    if (choose_.chance(10)) retract();
    hole();
  }
}

// R0 and no TCPM, in either order. A motion beside a path may still wait for the next one.
void KlartextProgram::rest_before_holes() {
  const bool off_first = choose_.chance(50);
  if (tcpm_ && off_first) tcpm_off();
  if (side_ != Side::none || choose_.chance(15)) {
    if (choose_.chance(25)) {
      approach();
    } else {
      write_.word("L");
      if (choose_.chance(25)) cross_the_tool();
      write_.word("R0").word(choose_.one_of({"", "", "FMAX", "M8"})).end_block();
      side_ = Side::none;
      had_normal_ = false;
    }
  }
  if (tcpm_) tcpm_off();
}

void KlartextProgram::define_cycle() {
  const NamedCycle& cycle = choose_.one_of(kCycles);
  write_.word(fmt::format("CYCL DEF {}", cycle.number));
  if (choose_.chance(85)) write_.word(cycle.name);
  lines_of_cycle_ = choose_.chance(75);
  // By diameter it would not be followed.
  if (cycle.number == kCentering && choose_.chance(60)) cycle_word("Q343", 0, "SELECT DIA./DEPTH");
  choose_levels();
  const bool usual = choose_.chance(85);
  if (!usual) cycle_word("Q204", levels_.second, "2ND SET-UP CLEARANCE");
  cycle_word("Q200", levels_.clearance, "SET-UP CLEARANCE");
  cycle_word("Q201", levels_.depth, "DEPTH");
  for (std::int64_t n = choose_.between(0, 3); n > 0; --n) {
    const OtherWord& other = choose_.one_of(kOthers);
    cycle_word(other.parameter, other.value * one_, other.meaning);
  }
  if (!choose_.chance(5)) cycle_word("Q203", levels_.surface, "SURFACE COORDINATE");
  if (usual && !choose_.chance(5)) cycle_word("Q204", levels_.second, "2ND SET-UP CLEARANCE");
  write_.end_block(false);
  defined_ = true;
}

// Second clearances greater than the first, equal, less, and none.
void KlartextProgram::choose_levels() {
  const bool whole = choose_.chance(70);
  const auto up_to = [&](std::int64_t most) {
    return whole ? choose_.between(0, most) * one_ : choose_.between(0, most * one_);
  };
  levels_.clearance = choose_.chance(70) ? choose_.one_of({1, 2, 5}) * one_ : up_to(10);
  if (choose_.chance(3)) levels_.clearance = -levels_.clearance;
  levels_.depth = choose_.chance(10) ? 0 : -up_to(40);
  levels_.surface = choose_.chance(35) ? 0 : up_to(40) - 20 * one_;
  switch (choose_.weighted({45, 18, 18, 19})) {
    case 0:
      levels_.second = levels_.clearance + up_to(60);
      break;
    case 1:
      levels_.second = levels_.clearance;
      break;
    case 2:
      levels_.second = levels_.clearance - up_to(3);
      break;
    default:
      levels_.second = 0;
      break;
  }
}

// Q200=+2 in a line of its own, with what it means, or behind the words before it.
void KlartextProgram::cycle_word(std::string_view parameter, std::int64_t count, std::string_view meaning) {
  write_.value(fmt::format("{}{}=", lines_of_cycle_ ? "~\n  " : "", parameter), count, decimals_, 12);
  if (lines_of_cycle_ && choose_.chance(80)) write_.word(fmt::format(";{}", meaning));
}

// The parameters of a cycle are parameters like others.
void KlartextProgram::change_cycle() {
  switch (choose_.weighted({42, 10, 10, 10, 8, 8, 6, 6})) {
    case 0:
      assign_level();
      break;
    case 1:
      write_.word("Q201 = Q201 - 2.5");
      levels_.depth -= one_ * 5 / 2;
      break;
    case 2:
      write_.word("Q204 = Q200");
      levels_.second = levels_.clearance;
      break;
    case 3:
      write_.word("Q204 = 2 * Q200 - 1");
      levels_.second = 2 * levels_.clearance - one_;
      break;
    case 4:
      write_.word("FN 2: Q203 = +Q203 - +5");
      levels_.surface -= 5 * one_;
      break;
    case 5:
      write_.word("FN 4: Q200 = +5 DIV +2");
      levels_.clearance = one_ * 5 / 2;
      break;
    case 6:
      write_.word("Q203 = -Q204");
      levels_.surface = -levels_.second;
      break;
    default:
      write_.word("Q201 = ( Q201 - 1 ) * 1.5");
      levels_.depth = (levels_.depth - one_) / 2 * 3;
      break;
  }
  write_.end_block(false);
}

// One of those a call takes.
void KlartextProgram::assign_level() {
  struct Named {
    std::string_view name;
    std::int64_t Levels::* level;
  };
  constexpr Named kNamed[] = {{"Q200 =", &Levels::clearance},
                              {"Q201 =", &Levels::depth},
                              {"Q203 =", &Levels::surface},
                              {"Q204 =", &Levels::second}};
  const Levels before = levels_;
  choose_levels();
  const auto& [name, level] = choose_.one_of(kNamed);
  const std::int64_t value = levels_.*level;
  levels_ = before;
  levels_.*level = value;
  if (choose_.chance(25)) write_.word("FN 0:");
  write_.word(name).number("", value, decimals_);
}

void KlartextProgram::shift_along_the_tool() {
  const std::int64_t by = choose_.between(-40, 40) * one_ / 2;
  const std::string key = std::string(choose_.chance(25) ? "I" : "") + axis_;
  if (choose_.chance(20)) {
    write_.word("TRANS DATUM AXIS").value(key, by, decimals_);
  } else {
    write_.word("CYCL DEF 7.0 DATUM SHIFT").end_block(false);
    write_.word("CYCL DEF 7.1").value(key, by, decimals_);
  }
  write_.end_block(false);
  if (!choose_.chance(25)) return;
  const char other = axis_ == 'X' ? 'Y' : 'X';
  write_.word("CYCL DEF 7.2").value(std::string(1, other), choose_.between(-30, 30) * one_, decimals_).end_block(false);
}

void KlartextProgram::retract() {
  if (choose_.chance(30)) write_.word(choose_.one_of({"L", "L R0"}));
  write_.word("M140 MB");
  if (choose_.chance(65))
    write_.word("MAX");
  else
    write_.number("", choose_.between(1, 50) * one_, decimals_);
  write_.word(choose_.one_of({"", "F MAX", "F500"})).end_block(false);
  had_normal_ = false;
  ++motions_;
}

void KlartextProgram::hole() {
  switch (choose_.weighted({35, 45, 8, 6, 6})) {
    case 0:
      write_.word("CYCL CALL").word(choose_.one_of({"", "", "M3", "M13", "M8 M9"}));
      break;
    case 1:
      write_.word("L");
      cross_the_tool();
      write_.word(choose_.one_of({"", "R0"})).word(choose_.one_of({"FMAX", "F MAX", "F500", ""}));
      write_.word(choose_.one_of({"M99", "M99", "M3 M99", "M99 M8"}));
      break;
    case 2:
      write_.word(choose_.one_of({"M99", "M8 M99", "M99 M9"}));
      break;
    case 3:
      write_.word(choose_.one_of({"L M99", "L R0 FMAX M99"}));
      break;
    default:
      write_.word("CYCL CALL").end_block();
      write_.word("L");
      cross_the_tool();
      break;
  }
  write_.end_block();
  had_normal_ = false;
  ++motions_;
  if (levels_.depth != 0)
    at_[static_cast<std::size_t>(axis_ - 'X')] = levels_.surface + std::max(levels_.clearance, levels_.second);
}

// Words of the two axes across the tool, or one of them; seldom along it, or of rotary axes.
void KlartextProgram::cross_the_tool() {
  travel();
  const auto along = static_cast<std::size_t>(axis_ - 'X');
  const bool moves_along = choose_.chance(10);
  if (!moves_along) {
    at_[along] -= step_[along];
    step_[along] = 0;
  }
  const std::size_t left_out = choose_.chance(30) ? choose_.below(3) : 3;
  bool any = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if ((i == along && !moves_along) || (i == left_out && any)) continue;
    const std::string key(1, kLetters[i]);
    if (choose_.chance(20))
      write_.value("I" + key, step_[i], decimals_);
    else
      write_.value(key, at_[i], decimals_);
    any = true;
  }
  if (choose_.chance(6)) rotary_words();
}

// What is not followed: the run ends there.
void KlartextProgram::refused_call() {
  const std::size_t which = choose_.below(11);
  if (which != 0 && tcpm_) tcpm_off();
  ++motions_;
  switch (which) {
    case 0:
      if (!tcpm_) tcpm_on();
      break;
    case 1:
      return write_.word(choose_.one_of({"CYCL CALL POS X+10 Y+5 Z+0", "CYCL CALL PAT FMAX"})).end_block();
    case 2:
      return write_.word(choose_.one_of({"M89", "L X+5 M89"})).end_block();
    case 3:
      write_.word("CYCL DEF 208 BORE MILLING Q200=+2 Q201=-5 Q335=+20").end_block();
      break;
    case 4:
      write_.word(choose_.one_of({"Q201 = 5", "Q201 = 0 - Q201 + 0.5"})).end_block();
      break;
    case 5:
      write_.word("CYCL DEF 240 CENTERING Q343=+1 Q344=-8 Q201=-2").end_block();
      break;
    case 6:
      return write_.word(choose_.one_of({"L X+5 RL M99", "L Y+5 RR F500 M99"})).end_block();
    case 7:
      return write_.word("LN X+5 Y+1 Z+2 TX0 TY0 TZ1 R0 M99").end_block();
    case 8:
      write_.word("FN 18: SYSREAD Q201 = ID270 NR1 IDX3").end_block();
      break;
    case 9:  // the axis of the tool before is not known
      write_.word("M140 MB MAX").end_block(false);
      axis_ = axis_ == 'X' ? 'Y' : 'X';
      write_.word(fmt::format("TOOL CALL {}", axis_)).end_block();
      break;
    default:
      return write_.word(choose_.one_of({"STOP M99", "L M140 MB MAX M99"})).end_block();
  }
  write_.word(choose_.one_of({"CYCL CALL", "CYCL CALL M3", "M99", "L X+5 M99"})).end_block();
}

}  // namespace toolcomp::fuzz
