// SPDX-License-Identifier: Apache-2.0
// Machines with two rotary axes for tool center point control and tool posture control.
#include <algorithm>
#include <string>

#include "fuzz/gen/fanuc/setups.h"

namespace toolcomp::fuzz {
namespace {

using spec::Decimal;
using spec::Setup;

void set(Setup& setup, std::uint32_t number, Decimal value) { setup.parameters[{number, -1}] = value; }
void set_bit(Setup& setup, std::uint32_t number, int bit, bool value) {
  setup.parameters[{number, bit}] = spec::decimal(value ? 1 : 0);
}

// Which axes turn about what: lines 1 2 3 are X Y Z, 4 5 6 inclined from X to Y, Y to Z, Z to X.
struct Layout {
  std::int64_t type;
  char first;
  std::int64_t first_line;
  char second;
  std::int64_t second_line;
};
constexpr Layout kOrthogonal[] = {
    {2, 'C', 3, 'B', 2},  {2, 'C', 3, 'B', 2},  {2, 'C', 3, 'A', 1},  {2, 'A', 1, 'B', 2},  {2, 'B', 2, 'A', 1},
    {12, 'A', 1, 'C', 3}, {12, 'A', 1, 'C', 3}, {12, 'B', 2, 'C', 3}, {12, 'A', 1, 'B', 2}, {12, 'B', 2, 'A', 1},
    {21, 'B', 2, 'C', 3}, {21, 'B', 2, 'C', 3}, {21, 'A', 1, 'C', 3}, {21, 'A', 1, 'B', 2}, {21, 'B', 2, 'A', 1}};
constexpr Layout kNutating[] = {{2, 'C', 3, 'B', 5},  {2, 'C', 3, 'B', 5},  {12, 'B', 5, 'C', 3}, {12, 'B', 5, 'C', 3},
                                {21, 'B', 5, 'C', 3}, {2, 'C', 3, 'A', 6},  {2, 'A', 4, 'B', 2},  {12, 'A', 1, 'C', 6},
                                {2, 'C', 5, 'B', 2},  {21, 'A', 6, 'C', 3}, {21, 'B', 2, 'C', 5}};

constexpr std::int64_t kThousandths = 1000;

Decimal degrees(std::int64_t thousandths) {
  return thousandths % kThousandths == 0 ? spec::decimal(thousandths / kThousandths) : decimal(thousandths, 3);
}

std::int64_t axis_number(const Setup& setup, char letter) {
  return static_cast<std::int64_t>(setup.axes.index(letter)) + 1;
}

// 19680 to 19699.
void mechanism(Choices& choose, Setup& setup, const Layout& layout) {
  set(setup, 19680, spec::decimal(layout.type));
  set(setup, 19681, spec::decimal(axis_number(setup, layout.first)));
  set(setup, 19682, spec::decimal(layout.first_line));
  set(setup, 19686, spec::decimal(axis_number(setup, layout.second)));
  set(setup, 19687, spec::decimal(layout.second_line));
  // Usual senses: a table turns left-handed for +.
  const bool tables[] = {layout.type == 12, layout.type != 2};
  const std::int64_t lines[] = {layout.first_line, layout.second_line};
  for (const std::uint32_t i : {0U, 1U}) {
    const bool usual = choose.chance(85);
    if (tables[i] == usual) set(setup, 19684 + 5 * i, spec::decimal(1));
    if (lines[i] <= 3) continue;
    switch (choose.weighted({70, 15, 15})) {
      case 0:
        set(setup, 19683 + 5 * i, spec::decimal(45));
        break;
      case 1:
        set(setup, 19683 + 5 * i, spec::decimal(choose.one_of<std::int64_t>({30, 60, -45, 50})));
        break;
      default:
        set(setup, 19683 + 5 * i, degrees(choose.between(5 * kThousandths, 85 * kThousandths)));
        break;
    }
  }
  if (choose.chance(10)) set(setup, 19697, spec::decimal(choose.between(1, 3)));
  for (const std::uint32_t tilt : {19698U, 19699U}) {
    if (!choose.chance(8)) continue;
    const auto round = choose.one_of<std::int64_t>({5, 20, 45, 90, -30});
    const std::int64_t any = choose.between(-90 * kThousandths, 90 * kThousandths);
    set(setup, tilt, degrees(choose.chance(60) ? round * kThousandths : any));
  }
  if (choose.chance(3)) {  // a hypothetical axis
    const bool second = choose.chance(50);
    set_bit(setup, 19696, second ? 1 : 0, true);
    set(setup, second ? 19686 : 19681, spec::decimal(0));
    set(setup, second ? 19690 : 19685, spec::decimal(choose.between(-6, 6) * 15));
  }
}

// 19666 and 19700 to 19714.
void distances(Choices& choose, Setup& setup, std::int64_t type) {
  const int decimals = increment_decimals(setup);
  std::int64_t one = 1;
  for (int i = 0; i < decimals; ++i) one *= 10;
  if (setup.units == spec::Units::inch) one /= 10;
  const auto length = [&](std::int64_t most) {
    const std::int64_t counts =
        choose.chance(70) ? choose.between(-most, most) * one : choose.between(-most * one, most * one);
    return decimal(counts, decimals);
  };
  if (choose.chance(25)) set(setup, 19666, length(100));
  const auto vector = [&](std::uint32_t first, std::int64_t most) {
    for (std::uint32_t i = 0; i < 3; ++i)
      if (choose.chance(70)) set(setup, first + i, length(most));
  };
  if (type != 2 && choose.chance(55)) vector(19700, 300);
  if (type == 12 && choose.chance(50)) vector(19703, 100);
  if (type != 12 && choose.chance(35)) vector(19709, 80);
  if (type == 2 && choose.chance(25)) vector(19712, 80);
}

// 19741 to 19744: upper and lower of the first axis, then of the second.
void ranges(Choices& choose, Setup& setup) {
  for (const std::uint32_t upper : {19741U, 19743U}) {
    if (!choose.chance(10)) continue;
    auto high = choose.one_of<std::int64_t>({360, 360, 180, 120, 90, 720});
    auto low = choose.one_of<std::int64_t>({0, -180, -120, -90, -360, -360});
    if (choose.chance(3)) std::swap(high, low);
    const std::int64_t aside = choose.chance(80) ? 0 : choose.between(-kThousandths, kThousandths);
    set(setup, upper, degrees(high * kThousandths + aside));
    set(setup, upper + 1, degrees(low * kThousandths));
  }
}

// 19738, 19739 and the bits of the sections.
void posture(Choices& choose, Setup& setup) {
  switch (choose.weighted({22, 38, 18, 18, 4})) {
    case 0:
      break;
    case 1:
      set(setup, 19738, degrees(choose.one_of<std::int64_t>({500, 1000, 1000, 2000, 5000, 10'000, 20'000})));
      break;
    case 2:
      set(setup, 19738, degrees(choose.between(1, 30 * kThousandths)));
      break;
    case 3:
      set(setup, 19738,
          degrees(choose.one_of<std::int64_t>({0, 30'000, 45'000, 45'000, 60'000, 90'000, 120'000, 180'000})));
      break;
    default:
      set(setup, 19738, degrees(-choose.between(1, 5 * kThousandths)));
      break;
  }
  switch (choose.weighted({20, 40, 20, 15, 5})) {
    case 0:
      break;
    case 1:
      set(setup, 19739, degrees(choose.one_of<std::int64_t>({3000, 5000, 10'000, 30'000, 45'000, 90'000, 90'000})));
      break;
    case 2:
      set(setup, 19739, degrees(choose.between(1, 60 * kThousandths)));
      break;
    case 3:
      set(setup, 19739, degrees(choose.one_of<std::int64_t>({0, 60'000, 120'000, 180'000, 360'000})));
      break;
    default:
      set(setup, 19739, degrees(-choose.between(1, 5 * kThousandths)));
      break;
  }
  if (choose.chance(20)) set_bit(setup, 19696, 3, choose.chance(80));
  if (choose.chance(12)) set_bit(setup, 19696, 5, choose.chance(85));
  if (choose.chance(30)) set_bit(setup, 19608, 5, choose.chance(80));
  if (choose.chance(40)) set_bit(setup, 19604, 0, choose.chance(75));
}

// Tools of some ten units' length, and what lengths may be besides.
void tools(Choices& choose, Setup& setup) {
  const int decimals = increment_decimals(setup);
  std::int64_t one = 1;
  for (int i = 0; i < decimals; ++i) one *= 10;
  for (auto& [number, entry] : setup.h) {
    std::int64_t counts = 0;
    switch (choose.weighted({60, 25, 8, 7})) {
      case 0:
        counts = choose.between(1, 20) * 10 * one;
        break;
      case 1:
        counts = choose.between(-20 * one, 200 * one);
        break;
      case 2:
        break;
      default:
        counts = -choose.between(1, 100) * one;
        break;
    }
    if (setup.units == spec::Units::inch) counts /= 10;
    entry.geometry = decimal(counts, decimals);
  }
}

}  // namespace

Setup random_rotary_setup(Choices& choose) {
  Setup setup = random_tool_side_setup(choose);
  std::erase_if(setup.parameters, [](const auto& parameter) {
    const std::uint32_t n = parameter.first.number;
    return (n >= 19610 && n <= 19623) || n >= 19680 || n == 19666;
  });
  const bool nutating = choose.chance(28);
  const Layout layout = nutating ? choose.one_of(kNutating) : choose.one_of(kOrthogonal);
  std::string letters = choose.chance(90) ? "XYZ" : "ZYX";
  const char one = std::min(layout.first, layout.second);
  const char other = std::max(layout.first, layout.second);
  const bool ascending = choose.chance(75);
  if (choose.chance(8)) letters += "U";
  letters += ascending ? one : other;
  letters += ascending ? other : one;
  setup.axes = spec::Axes(letters);
  const auto drop = [&setup](spec::AxisTable& table) {
    std::erase_if(table, [&setup](const auto& entry) { return !setup.axes.has(entry.first); });
  };
  for (spec::AxisTable& origin : setup.workpiece) drop(origin);
  setup.additional_workpiece.clear();
  drop(setup.position);
  drop(setup.measurement);
  setup.reference.clear();
  setup.floating_reference.clear();
  if (choose.chance(70))
    for (spec::AxisTable& origin : setup.workpiece)
      std::erase_if(origin, [](const auto& entry) { return spec::is_rotary_axis(entry.first); });
  tools(choose, setup);
  if (choose.chance(4)) return setup;  // no kinematics: a direction is I J K itself
  mechanism(choose, setup, layout);
  distances(choose, setup, layout.type);
  ranges(choose, setup);
  posture(choose, setup);
  return setup;
}

}  // namespace toolcomp::fuzz
