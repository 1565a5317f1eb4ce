// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/heidenhain/klartext_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <string_view>
#include "judge/oracle/number.h"

namespace toolcomp::fuzz {
namespace {

constexpr double kMillimetresAnInch = 25.4;
constexpr std::string_view kLetters = "XYZ";
constexpr std::int64_t kFarthest = 99'999;  // millimetres or inches from the datum

std::array<std::int64_t, 3> cross(const std::array<std::int64_t, 3>& a, const std::array<std::int64_t, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

KlartextProgram::KlartextProgram(Choices& choose, const spec::Setup& setup, const ProgramWeights& weights)
    : choose_(choose), setup_(setup), weights_(weights), write_(choose) {
  inch_ = setup.units == spec::Units::inch;
}

std::string KlartextProgram::text(std::uint32_t blocks) {
  drills_ = choose_.chance(17);
  head();
  while (motions_ < blocks) motion();
  tail();
  return write_.text();
}

void KlartextProgram::head() {
  if (choose_.chance(92)) {
    if (choose_.chance(14)) inch_ = !inch_;
    write_.word("BEGIN PGM")
        .word(choose_.one_of({"FINISH", "1", "H_7-2"}))
        .word(inch_ ? "INCH" : "MM")
        .end_block(false);
  }
  if (inch_ || choose_.chance(8)) decimals_ = 5;
  one_ = decimals_ == 5 ? 100'000 : 10'000;
  step_ = {10 * one_, 0, 0};
  if (choose_.chance(2))  // at the end of the range of coordinates
    for (std::int64_t& at : at_) at = choose_.one_of({-1, 0, 1}) * (kFarthest * one_ - choose_.between(0, 2));
  if (choose_.chance(20)) {
    write_.word("BLK FORM 0.1 Z X-50 Y-50 Z-20").end_block(false);
    write_.word(choose_.one_of({"BLK FORM 0.2 X+50 Y+50 Z+0", "BLK FORM 0.2 IX+100 IY+100 IZ+20"})).end_block(false);
  }
  if (choose_.chance(4)) write_.remark();
  if (!choose_.chance(2)) tool_call();
  if (choose_.chance(weights_.contour)) path(true);
  if (choose_.chance(45)) approach();
  if (choose_.chance(60)) tcpm_on();
}

void KlartextProgram::tail() {
  if (choose_.chance(20)) approach();
  if (tcpm_ && choose_.chance(40)) tcpm_off();
  if (choose_.chance(40)) write_.word(choose_.one_of({"M30", "M2", "M30 M9"})).end_block(false);
  if (choose_.chance(85)) write_.word("END PGM FINISH").word(inch_ ? "INCH" : "MM").end_block(false);
}

void KlartextProgram::motion() {
  if (drills_ && choose_.chance(30)) return holes();
  const int kinds[] = {weights_.face, weights_.beside, weights_.plain, weights_.statements, 2, 1};
  switch (choose_.weighted(kinds)) {
    case 0:
      return face();
    case 1:
      return stretch();
    case 2:
      return plain();
    case 3:
      return statement();
    case 4:
      return mistake();
    default:
      return out_of_scope();
  }
}

bool KlartextProgram::deviates() const { return tool_ < setup_.tools.size() && !setup_.tools[tool_].dr2_table.empty(); }

KlartextProgram::Radii KlartextProgram::radii() const {
  Radii radii;
  radii.off_r = call_r_;
  radii.off_r2 = call_r2_;
  if (tool_ < setup_.tools.size()) {
    const spec::ToolRow& tool = setup_.tools[tool_];
    radii.r = judge::approximate(tool.r);
    radii.r2 = judge::approximate(tool.r2);
    radii.off_r += judge::approximate(tool.dr);
    if (!deviates()) radii.off_r2 += judge::approximate(tool.dr2);
  }
  if (const auto row = setup_.tcs.find(row_); row != setup_.tcs.end()) {
    radii.off_r += judge::approximate(row->second.dr);
    radii.off_r2 += judge::approximate(row->second.dr2);
  }
  return radii;
}

// Positive deltas or a corner radius beyond the radius, which M107 permits.
bool KlartextProgram::is_oversize() const {
  constexpr double noise = 1.0 / 1'000'000'000;  // far below a digit of the tables
  const Radii now = radii();
  return now.off_r > noise || now.off_r2 > noise || (!deviates() && now.r2 + now.off_r2 > now.r + now.off_r + noise);
}

// DR and DR2 of a call, mostly such that radii stay positive.
void KlartextProgram::radius_deltas(std::int64_t r, std::int64_t r2, bool with_r, bool with_r2) {
  const double unit = (inch_ ? kMillimetresAnInch : 1) / 10'000;
  const bool careful = !choose_.chance(4);
  if (with_r) {
    call_r_ = 0;
    const Radii now = radii();
    if (careful && now.r + now.off_r + static_cast<double>(r) * unit < 0) r = -r;
    delta("DR", r);
    call_r_ = static_cast<double>(r) * unit;
  }
  if (with_r2) {
    call_r2_ = 0;
    const Radii now = radii();
    if (careful && now.r2 + now.off_r2 + static_cast<double>(r2) * unit < 0) r2 = -r2;
    delta("DR2", r2);
    call_r2_ = static_cast<double>(r2) * unit;
  }
}

void KlartextProgram::delta(std::string_view key, std::int64_t size) {
  const bool colon = choose_.chance(12);
  write_.value(std::string(key) + (colon ? ":" : ""), size, 4);
}

void KlartextProgram::tool_call() {
  const std::size_t rows = setup_.tools.size();
  const bool null = choose_.chance(2);
  tool_ = null ? rows : choose_.below(rows);
  std::string tool = "0";
  if (!null) {
    const spec::ToolRow& row = setup_.tools[tool_];
    tool = row.number % 10 == 0 ? fmt::format("{}", row.number / 10)
                                : fmt::format("{}.{}", row.number / 10, row.number % 10);
    if (!row.name.empty() && choose_.chance(70)) tool = '"' + row.name + '"';
  }
  write_.word("TOOL CALL").word(tool);
  if (choose_.chance(90)) {
    axis_ = choose_.chance(86) ? 'Z' : choose_.one_of({'X', 'Y'});
    write_.word(std::string(1, axis_));
  }
  if (choose_.chance(60)) write_.number("S", choose_.between(1, 20) * 500, 0);
  if (choose_.chance(40)) write_.number("F", choose_.between(1, 40) * 50, 0);
  call_r_ = call_r2_ = 0;
  side_ = Side::none;
  row_ = 0;
  had_normal_ = false;
  // In inches the sizes of these tools would be hundredths of them.
  const std::int64_t step = inch_ ? 4 : 100;
  if (choose_.chance(55)) {
    const bool even = choose_.chance(40);
    const std::int64_t size = choose_.between(-30, choose_.chance(50) ? 30 : 0) * step;
    if (even || choose_.chance(50)) delta("DL", even ? size : choose_.between(-30, 30) * step);
    const std::int64_t r = even ? size : choose_.between(-30, 10) * step;
    const std::int64_t r2 = even ? size : choose_.between(-30, 10) * step;
    const bool with_r = even || choose_.chance(60);
    const bool with_r2 = even || choose_.chance(60);
    radius_deltas(r, r2, with_r, with_r2);
  }
  write_.end_block();
  if (choose_.chance(setup_.tcs.empty() ? 0 : 40)) correction();
  if (is_oversize() && !oversize_permitted_ && choose_.chance(94)) {
    write_.word("M107").end_block(false);
    oversize_permitted_ = true;
  }
}

void KlartextProgram::call_without_tool() {
  write_.word("TOOL CALL");
  if (choose_.chance(20)) {
    axis_ = choose_.one_of({'X', 'Y', 'Z'});
    write_.word(std::string(1, axis_));
  }
  if (choose_.chance(40)) write_.number("S", choose_.between(1, 20) * 500, 0);
  const std::int64_t step = inch_ ? 4 : 100;
  const std::int64_t r = choose_.between(-20, 0) * step;
  const std::int64_t r2 = choose_.between(-20, 0) * step;
  const bool with_r = choose_.chance(40);
  const bool with_r2 = choose_.chance(40);
  radius_deltas(r, r2, with_r, with_r2);
  if (choose_.chance(40)) delta("DL", choose_.between(-20, 20) * step);
  write_.end_block();
}

void KlartextProgram::correction() {
  if (choose_.chance(30)) write_.word(R"(SEL CORR-TABLE TCS "TNC:\TAB\A.TCO")").end_block(false);
  if (!setup_.tcs.empty() && choose_.chance(75)) {
    const auto row = std::next(setup_.tcs.begin(), static_cast<std::ptrdiff_t>(choose_.below(setup_.tcs.size())));
    const std::uint32_t before = row_;
    row_ = row->first;
    const Radii now = radii();
    if ((now.r + now.off_r < 0 || now.r2 + now.off_r2 < 0) && !choose_.chance(10)) {
      row_ = before;
      return;
    }
    write_.word(fmt::format("FUNCTION CORRDATA TCS #{}", row->first)).end_block(false);
  } else if (choose_.chance(60)) {
    const char* const which = choose_.one_of({"", "TCS", "WPL"});
    write_.word("FUNCTION CORRDATA RESET").word(which).end_block(false);
    if (std::string_view(which) != "WPL") row_ = 0;
  } else {
    write_.word("FUNCTION CORRDATA WPL #3").end_block(false);
  }
}

void KlartextProgram::tcpm_on() {
  if (choose_.chance(30)) {
    write_.word("M128").end_block(false);
  } else {
    write_.word("FUNCTION TCPM");
    write_.word(choose_.one_of({"F TCP", "F CONT"}));
    write_.word(choose_.one_of({"AXIS POS", "AXIS SPAT"}));
    write_.word(choose_.one_of({"PATHCTRL AXIS", "PATHCTRL VECTOR"}));
    if (choose_.chance(65))
      write_.word("REFPNT").word(
          choose_.one_of({"TIP-TIP", "TIP-CNT", "CNT-CNT", "CNT-CNT", "CNT-CNT", "TIP-CENTER", "CENTER-CENTER"}));
    if (choose_.chance(10)) write_.word("F500");
    write_.end_block();
  }
  if (!tcpm_) tool_vector_ = tool_axis();
  tcpm_ = true;
}

void KlartextProgram::tcpm_off() {
  write_.word(choose_.one_of({"FUNCTION RESET TCPM", "FUNCTION TCPM OFF", "M129"})).end_block(false);
  tcpm_ = false;
}

void KlartextProgram::path(bool contour) {
  contour_ = contour;
  write_.word(contour ? "FUNCTION PROG PATH IS CONTOUR" : "FUNCTION PROG PATH OFF").end_block(false);
}

void KlartextProgram::cycle() {
  switch (choose_.weighted({5, 2, 2, 1})) {
    case 0:
      write_.word("CYCL DEF 7.0 DATUM SHIFT").end_block(false);
      for (int i = 1; i <= 3; ++i) {
        if (!choose_.chance(45)) continue;
        const std::string key = std::string(choose_.chance(30) ? "I" : "") + kLetters[static_cast<std::size_t>(i - 1)];
        write_.word(fmt::format("CYCL DEF 7.{}", i)).value(key, choose_.between(-50, 50) * one_ / 2, decimals_);
        write_.end_block(false);
      }
      return;
    case 1:
      write_.word("CYCL DEF 32.0 TOLERANCE").end_block(false);
      return write_.word("CYCL DEF 32.1 T0.01").end_block(false);
    case 2:
      return write_.word("CYCL DEF 247 DATUM SETTING ~\n  Q339=+1 ;DATUM NUMBER").end_block(false);
    default:
      return write_.word("CYCL DEF 19.0 WORKING PLANE").end_block(false);
  }
}

void KlartextProgram::other() {
  if (choose_.chance(25)) return write_.remark();
  if (choose_.chance(25)) {
    // L that moves nothing.
    write_.word("L");
    radius_word(choose_.one_of({Side::none, side_, Side::left, Side::right}));
    feed();
    return write_.word(choose_.one_of({"", "M8"})).end_block(false);
  }
  write_
      .word(choose_.one_of({"PLANE RESET STAY", "PLANE SPATIAL SPA+0 SPB+0 SPC+0 STAY", "STOP", "STOP M8", "TOOL DEF 5",
                            "TOOL DEF 7 L+10 R+3", "Q20 = +5.5", "FN 0: Q21 = -3", "/ M8", "M138"}))
      .end_block(false);
}

void KlartextProgram::functions_alone() {
  const std::size_t which = choose_.weighted({3, 2, 3, 2, 2});
  write_.word(choose_.one_of({"", "", "M8", "M3"}));
  constexpr const char* names[] = {"M107", "M108", "M128", "M129", "M0"};
  write_.word(names[which]).end_block(false);
  if (which == 0) oversize_permitted_ = true;
  if (which == 1) oversize_permitted_ = false;
  if (which == 2) tcpm_ = true;
  if (which == 3) tcpm_ = false;
}

void KlartextProgram::statement() {
  switch (choose_.weighted({12, 10, 12, 14, 10, 14, 8, 10, 10})) {
    case 0:
      if (tcpm_ && !choose_.chance(4)) tcpm_off();
      return tool_call();
    case 1:
      return call_without_tool();
    case 2:
      return correction();
    case 3:
      return tcpm_on();
    case 4:
      return tcpm_ ? tcpm_off() : tcpm_on();
    case 5:
      return path(!contour_);
    case 6:
      return cycle();
    case 7:
      return other();
    default:
      return functions_alone();
  }
}

// The next programmed point: near the last one, a whole one, the same, far away, or on from the last travel.
void KlartextProgram::travel() {
  const std::array<std::int64_t, 3> before = step_;
  const auto whole = [&] { return choose_.between(-20, 20) * one_; };
  switch (choose_.weighted({36, 22, 10, 5, 12, 6, 3, 3, 3})) {
    case 0:
      for (std::int64_t& s : step_) s = choose_.between(-30 * one_, 30 * one_);
      break;
    case 1:
      for (std::int64_t& s : step_) s = choose_.chance(35) ? 0 : whole();
      break;
    case 2:  // straight on
      if (choose_.chance(50))
        for (std::int64_t& s : step_) s = s / 4 * choose_.one_of({1, 2, 8});
      break;
    case 3:  // back
      for (std::int64_t& s : step_) s = -s;
      break;
    case 4:  // a quarter turn about an axis, or about the tool
      step_ = choose_.chance(50) ? std::array<std::int64_t, 3>{-before[1], before[0], before[2]}
                                 : std::array<std::int64_t, 3>{before[2], before[1], -before[0]};
      break;
    case 5:  // along the tool
      // Mostly by millimetres: vectors of one digit would be as many ten-thousandths.
      for (std::size_t i = 0; i < 3; ++i) step_[i] = tool_vector_.count[i] % 1'000'000'000;
      if (std::ranges::all_of(step_, [](std::int64_t s) { return std::abs(s) < 1'000; }) && choose_.chance(85))
        for (std::int64_t& s : step_) s *= one_;
      break;
    case 6:  // nearly back
      for (std::int64_t& s : step_) s = -s;
      step_[choose_.below(3)] += choose_.one_of({1, -1, 10, 100, 1000});
      break;
    case 7:
      step_ = {};
      break;
    default:
      step_ = cross(tool_vector_.decimals < 3 ? tool_vector_.count : std::array<std::int64_t, 3>{0, 0, 1},
                    {choose_.between(-9, 9) * 1000, choose_.between(-9, 9) * 1000, choose_.between(-9, 9) * 1000});
      break;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    at_[i] += step_[i];
    if (std::abs(at_[i]) > kFarthest * one_) at_[i] = 0;
  }
}

// X Y Z as they stand in at_; `all`: also those that do not move.
void KlartextProgram::position_words(std::string_view prefix, bool all) {
  write_.word(prefix);
  bool any = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!all && any && choose_.chance(25) && step_[i] == 0) continue;
    const std::string key(1, kLetters[i]);
    if (!all && choose_.chance(12))
      write_.value("I" + key, step_[i], decimals_);
    else if (choose_.chance(1))
      write_.number(key, at_[i] * 100 + choose_.between(1, 99), decimals_ + 2);
    else
      write_.value(key, at_[i], decimals_);
    any = true;
  }
  if (all) return;
  for (const char letter : {'U', 'V', 'W'})
    if (setup_.axes.has(letter) && choose_.chance(25))
      write_.value(std::string(1, letter), choose_.between(-20 * one_, 20 * one_), decimals_);
}

// Words of L that move something: X Y Z and rotary axes, seldom rotary axes alone.
void KlartextProgram::line_words(std::uint64_t rotary) {
  const bool turns = setup_.axes.has('B') || setup_.axes.has('C');
  if (turns && choose_.chance(6)) {
    for (std::size_t i = 0; i < 3; ++i) at_[i] -= step_[i];
    step_ = {};
    write_.word("L").number(setup_.axes.has('B') ? "B" : "C", choose_.between(-90, 90), 0);
    return;
  }
  position_words("L", false);
  if (choose_.chance(rotary)) rotary_words();
}

void KlartextProgram::rotary_words() {
  for (const char letter : {'A', 'B', 'C'}) {
    if (!setup_.axes.has(letter) || !choose_.chance(55)) continue;
    const std::string key(1, letter);
    switch (choose_.weighted({40, 40, 10, 10})) {
      case 0:
        write_.value(key, choose_.one_of({0, 30, -30, 45, 60, 90, -90, 180, 270, 360}), 0);
        break;
      case 1:
        write_.value(key, choose_.between(-900'000, 900'000), 4);
        break;
      case 2:
        write_.number("I" + key, choose_.between(-90, 90), 0);
        break;
      default:
        write_.number(key, choose_.between(-45'000, 45'000), 3);
        break;
    }
  }
}

void KlartextProgram::vector_words(char kind, const VectorWords& v) {
  for (std::size_t i = 0; i < 3; ++i) write_.number(std::string{kind, kLetters[i]}, v.count[i], v.decimals);
}

void KlartextProgram::radius_word(Side side) {
  if (side == side_ && choose_.chance(side == Side::none ? 45 : 65)) return;
  constexpr const char* words[] = {"R0", "RL", "RR"};
  write_.word(words[static_cast<std::size_t>(side)]);
  side_ = side;
}

void KlartextProgram::feed() {
  if (!choose_.chance(35)) return;
  switch (choose_.weighted({60, 20, 8, 6, 6})) {
    case 0:
      write_.value("F", choose_.between(1, 50) * 50, 0);
      break;
    case 1:
      write_.word(choose_.one_of({"FMAX", "F MAX"}));
      break;
    case 2:
      write_.word(choose_.one_of({"FAUTO", "F AUTO"}));
      break;
    case 3:
      write_.number("FZ", 12, 2);
      break;
    default:
      write_.number("FU", 5, 1);
      break;
  }
}

// M functions of a motion block, and its end.
void KlartextProgram::end_motion() {
  std::size_t most = 3;
  const auto put = [&](std::uint64_t percent, const char* name) {
    if (most == 0 || !choose_.chance(percent)) return false;
    --most;
    write_.word(name);
    return true;
  };
  put(6, "M3");
  put(4, "M8");
  const bool on = put(tcpm_ ? 3 : 8, "M128");
  const bool permit = put(oversize_permitted_ ? 1 : 3, "M107");
  const bool forbid = put(oversize_permitted_ ? 3 : 1, "M108");
  const bool off = put(tcpm_ ? 4 : 1, "M129");
  if (!tcpm_ && !on) put(1, "M91");
  write_.end_block();
  tcpm_ = (tcpm_ || on) && !off;
  oversize_permitted_ = (oversize_permitted_ || permit) && !forbid;
  ++motions_;
}

VectorWords KlartextProgram::tool_axis() const {
  VectorWords along;
  along.count[static_cast<std::size_t>(axis_ - 'X')] = 1;
  return along;
}

VectorWords KlartextProgram::tool_vector() {
  // Mostly near the vector before: the same, or a new one.
  if (choose_.chance(30)) return tool_vector_;
  return any_vector(choose_);
}

void KlartextProgram::approach() {
  step_ = {0, 0, 10 * one_};
  at_[2] = choose_.between(10, 100) * one_;
  write_.word("L");
  write_.number("Z", at_[2], decimals_);
  if (!tcpm_ && choose_.chance(25)) rotary_words();
  write_.word(choose_.one_of({"R0 FMAX", "R0 FMAX M3", "FMAX", "R0"}));
  side_ = Side::none;
  had_normal_ = false;
  write_.end_block();
  ++motions_;
}

void KlartextProgram::face() {
  if (side_ != Side::none && !choose_.chance(4)) {
    // R0 in the block of the normal ends the compensation beside the path.
    if (choose_.chance(40)) approach();
  }
  travel();
  const VectorWords along = tool_axis();
  const bool with_tool = choose_.chance(tcpm_ ? 75 : 20);
  VectorWords tool = with_tool ? tool_vector() : along;
  VectorWords normal = normal_for(choose_, tcpm_ ? tool : along);
  if (deviates() && choose_.chance(40)) {
    const NormalAndTool pair = whole_angle(choose_);
    normal = pair.normal;
    tool = pair.tool;
  }
  if (had_normal_ && choose_.chance(18)) {
    // To the other half of the ring, or a quarter round it.
    tool = with_tool ? tool_vector_ : tool;
    const auto [x, y, z] = normal_.count;
    normal = normal_;
    normal.count = choose_.chance(50) ? std::array<std::int64_t, 3>{-x, -y, z} : std::array<std::int64_t, 3>{-y, x, z};
  }
  position_words("LN", true);
  vector_words('N', normal);
  if (with_tool) {
    vector_words('T', tool);
    if (tcpm_) tool_vector_ = tool;
  } else if (tcpm_) {
    tool_vector_ = normal;
  }
  leave_side(4);
  feed();
  end_motion();
  normal_ = normal;
  had_normal_ = true;
}

// A stretch with RL or RR under TCPM: entry, inner blocks, and mostly its end.
void KlartextProgram::stretch() {
  if (!tcpm_) tcpm_on();
  const std::int64_t inner = choose_.between(0, 4);
  stretch_block(true);
  for (std::int64_t i = 0; i < inner; ++i) {
    if (choose_.chance(8)) statement();
    stretch_block(false);
  }
  if (choose_.chance(30)) return;
  if (choose_.chance(40)) return approach();
  if (choose_.chance(30)) return face();
  plain();
}

void KlartextProgram::stretch_block(bool first) {
  had_normal_ = false;
  travel();
  // Along the tool there is no direction beside the path: seldom, since the first one ends the run.
  if (cross(tool_vector_.count, step_) == std::array<std::int64_t, 3>{} && !choose_.chance(20)) {
    const std::size_t other = tool_vector_.count[0] == 0 ? 0 : 1;
    step_[other] += 7 * one_;
    at_[other] += 7 * one_;
  }
  Side side = side_;
  if (side == Side::none || choose_.chance(6)) side = choose_.chance(50) ? Side::left : Side::right;
  // LN takes its side from an earlier block as well as it brings it.
  if (choose_.chance(45)) {
    position_words("LN", true);
    const VectorWords tool = choose_.chance(45) ? tool_vector_ : tool_vector();
    vector_words('T', tool);
    tool_vector_ = tool;
  } else {
    line_words(first ? 60 : 45);
  }
  radius_word(side);
  feed();
  end_motion();
}

// R0 where a side is in force, but in `stays` of 100.
void KlartextProgram::leave_side(std::uint64_t stays) {
  if (side_ == Side::none || choose_.chance(stays)) return radius_word(side_);
  write_.word("R0");
  side_ = Side::none;
}

void KlartextProgram::plain() {
  had_normal_ = false;
  travel();
  if (choose_.chance(25)) {
    position_words("LN", true);
    const VectorWords tool = tool_vector();
    vector_words('T', tool);
    if (tcpm_) tool_vector_ = tool;
  } else {
    line_words(35);
  }
  leave_side(5);
  feed();
  end_motion();
}

// A block the control refuses; the run ends there.
void KlartextProgram::mistake() {
  travel();
  const std::string x = fmt::format("X{} Y{} Z{}", at_[0] / one_, at_[1] / one_, at_[2] / one_);
  const std::string vectors = "NX+0.6 NY+0 NZ+0.8";
  ++motions_;
  switch (choose_.below(12)) {
    case 0:
      return write_.word("LN X+1 Y+2").word(vectors).end_block();
    case 1:
      return write_.word("LN Y+1 X+2 Z+3").word(vectors).end_block();
    case 2:
      return write_.word("LN").word(x).word("NX+0.6 NZ+0.8").end_block();
    case 3:
      return write_.word("LN").word(x).word("NX0 NY0 NZ0").end_block();
    case 4:
      return write_.word("LN").word(x).word("NX+10 NY0 NZ1").end_block();
    case 5:
      return write_.word("LN").word(x).word("TX+Q1 TY0 TZ1").end_block();
    case 6:
      return write_.word("LN").word(x).end_block();
    case 7:
      return write_.word("L").word(x).word("M3 M8 M7 M13 M5").end_block();
    case 8:
      return write_.word("LN").word(x).word(vectors).word(choose_.one_of({"RL", "RR"})).end_block();
    case 9:
      return write_.word("TOOL CALL 99 Z").end_block();
    case 10:
      return write_.word("L").word(x).word("M91 M128").end_block();
    default:
      return write_.word("LN").word(x).word("TX0 TY0 TZ1").word(vectors).end_block();
  }
}

// RL or RR without TCPM, which is not modelled.
void KlartextProgram::out_of_scope() {
  if (tcpm_) tcpm_off();
  travel();
  position_words("L", false);
  side_ = Side::none;
  radius_word(choose_.chance(50) ? Side::left : Side::right);
  end_motion();
  if (choose_.chance(70)) approach();
}

}  // namespace toolcomp::fuzz
