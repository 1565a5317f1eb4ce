// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/fanuc/setups.h"

#include <cstdlib>
#include <string>

namespace toolcomp::fuzz {
namespace {

using spec::Decimal;
using spec::Setup;

constexpr std::int64_t power_of_ten(int n) { return n == 0 ? 1 : 10 * power_of_ten(n - 1); }

void set(Setup& setup, std::uint32_t number, Decimal value) { setup.parameters[{number, -1}] = value; }
void set_bit(Setup& setup, std::uint32_t number, int bit, bool value) {
  setup.parameters[{number, bit}] = spec::decimal(value ? 1 : 0);
}

// Round values, values of every decimal, the extremes of the memory and zero.
Decimal offset(Choices& choose, const Setup& setup, bool wear) {
  const int decimals = increment_decimals(setup);
  const std::int64_t one = power_of_ten(decimals);
  // ±999.999 mm and ±99.9999 inch, wear a tenth; IS-A is narrower in the same digits.
  const std::int64_t limit = (setup.units == spec::Units::mm ? 1000 : 100) * one / (wear ? 10 : 1) - 1;
  const std::int64_t sign = choose.chance(25) ? -1 : 1;
  switch (choose.weighted({50, 25, 10, 8, 7})) {
    case 0:
      return decimal(sign * choose.between(1, 30) * one / (wear ? 100 : 1), decimals);
    case 1:
      return decimal(sign * choose.between(0, 20 * one), decimals);
    case 2:
      return decimal(sign * choose.between(0, limit), decimals);
    case 3:
      return decimal(0, 0);
    default:
      return decimal(sign * choose.one_of({std::int64_t{1}, limit / 2}), decimals);
  }
}

spec::OffsetEntry entry(Choices& choose, const Setup& setup) {
  spec::OffsetEntry e{offset(choose, setup, false), {}};
  if (setup.memory != spec::OffsetMemory::a && choose.chance(60)) e.wear = offset(choose, setup, true);
  return e;
}

// Radii of some millimetres (tenths of inches), of any decimals, negative, zero; seldom one a contour has no room for.
spec::OffsetEntry cutter_offset(Choices& choose, const Setup& setup) {
  const int decimals = increment_decimals(setup);
  const std::int64_t one = power_of_ten(decimals);
  const std::int64_t sign = choose.chance(15) ? -1 : 1;
  std::int64_t counts = 0;
  switch (choose.weighted({66, 20, 5, 4, 5})) {
    case 0:
      counts = choose.between(1, 12) * one;
      break;
    case 1:
      counts = choose.between(1, 12 * one);
      break;
    case 2:
      break;
    case 3:
      counts = choose.between(1, 3);
      break;
    default:
      counts = choose.between(12, 90) * one;
      break;
  }
  spec::OffsetEntry e{decimal(sign * counts, decimals), {}};
  if (setup.memory != spec::OffsetMemory::a && choose.chance(40)) {
    const std::int64_t wear = choose.between(-one / 2, one / 2);
    e.wear = decimal(wear, decimals);
  }
  return e;
}

Decimal coordinate(Choices& choose, const Setup& setup) {
  const int decimals = increment_decimals(setup);
  const std::int64_t one = power_of_ten(decimals);
  if (choose.chance(60)) return decimal(choose.between(-40, 40) * 10 * one, decimals);
  return decimal(choose.between(-400 * one, 400 * one), decimals);
}

spec::AxisTable table(Choices& choose, const Setup& setup, std::uint64_t percent) {
  spec::AxisTable values;
  for (const char letter : setup.axes.letters())
    if (choose.chance(percent))
      values[letter] =
          spec::is_linear_axis(letter) ? coordinate(choose, setup) : decimal(choose.between(-18, 18) * 10, 0);
  return values;
}

// Programs that begin at the end of the range of coordinates, ±999999.999 at IS-B, or a few increments inside it.
void far_away(Choices& choose, Setup& setup) {
  const int decimals = increment_decimals(setup);
  for (const char letter : setup.axes.letters()) {
    if (!spec::is_linear_axis(letter) || !choose.chance(50)) continue;
    const std::int64_t last = 1'000'000 * power_of_ten(decimals) - 1 - choose.between(0, 2);
    setup.position[letter] = decimal(choose.chance(50) ? last : -last, decimals);
  }
}

int direction_code(char rotary) { return rotary - 'A' + 1; }

std::int64_t axis_number(const Setup& setup, char letter) {
  return static_cast<std::int64_t>(setup.axes.index(letter)) + 1;
}

Decimal small_angle(Choices& choose) { return decimal(choose.between(-90'000, 90'000), 3); }

// 19680–19699, orthogonal axes named after what they turn about, sometimes tilted.
void machine(Choices& choose, Setup& setup, char first, char second) {
  const auto type = choose.one_of<std::int64_t>({2, 2, 12, 21});
  set(setup, 19680, spec::decimal(type));
  set(setup, 19681, spec::decimal(axis_number(setup, first)));
  set(setup, 19682, spec::decimal(direction_code(first)));
  set(setup, 19686, spec::decimal(axis_number(setup, second)));
  set(setup, 19687, spec::decimal(direction_code(second)));
  const bool tables[] = {type == 12, type != 2};
  for (const std::uint32_t i : {0U, 1U})
    if (choose.chance(80) ? tables[i] : choose.chance(50)) set(setup, 19684 + 5 * i, spec::decimal(1));
  if (choose.chance(15)) {
    const std::uint32_t tilted = choose.one_of({19682U, 19687U});
    set(setup, tilted, spec::decimal(choose.between(4, 6)));
    set(setup, tilted + 1, choose.chance(60) ? spec::decimal(45) : small_angle(choose));
  }
  if (choose.chance(20)) set(setup, 19697, spec::decimal(choose.between(1, 3)));
  if (choose.chance(8)) set(setup, 19698, small_angle(choose));
  if (choose.chance(8)) set(setup, 19699, choose.chance(50) ? spec::decimal(90) : small_angle(choose));
  if (type != 2 && choose.chance(5)) {
    const bool which = choose.chance(50);
    set_bit(setup, 19696, which ? 1 : 0, true);
    set(setup, which ? 19686 : 19681, spec::decimal(0));
    set(setup, which ? 19690 : 19685, small_angle(choose));
  }
}

// 19610–19623: each group's linear axes so that + turns as the letter of the axis says.
void groups(Choices& choose, Setup& setup, char first, char second) {
  const auto group = [&](std::uint32_t base, char rotary) {
    set(setup, base, spec::decimal(axis_number(setup, rotary)));
    const int code = direction_code(rotary);
    for (int i = 1; i <= 3; ++i)
      set(setup, base + static_cast<std::uint32_t>(i),
          spec::decimal(axis_number(setup, static_cast<char>('X' + (code + i - 1) % 3))));
    if (choose.chance(20)) set(setup, base + 4, choose.chance(50) ? spec::decimal(45) : small_angle(choose));
  };
  group(19610, second);
  if (choose.chance(85)) group(19615, first);
  for (const std::uint32_t parameter : {19620U, 19621U, 19622U, 19623U})
    if (choose.chance(12)) set(setup, parameter, choose.chance(40) ? spec::decimal(90) : small_angle(choose));
}

void kinematics(Choices& choose, Setup& setup) {
  std::string rotary;
  for (const char letter : setup.axes.letters())
    if (spec::is_rotary_axis(letter)) rotary += letter;
  if (rotary.size() < 2) return;
  const std::size_t second = choose.below(rotary.size());
  const std::size_t first = (second + 1 + choose.below(rotary.size() - 1)) % rotary.size();
  if (choose.chance(75))
    machine(choose, setup, rotary[first], rotary[second]);
  else
    groups(choose, setup, rotary[first], rotary[second]);
}

// Mostly the usual degree; zero, negative, Niven's angles (whose squared cosines are rational) and any decimal.
void angle_range(Choices& choose, Setup& setup) {
  switch (choose.weighted({30, 20, 10, 8, 17, 15})) {
    case 0:
      return;
    case 1:
      return set(setup, 19631, decimal(10, 1));
    case 2:
      return set(setup, 19631, spec::decimal(0));
    case 3:
      return set(setup, 19631, decimal(-choose.between(1, 90'000), 3));
    case 4:
      return set(setup, 19631, spec::decimal(choose.one_of<std::int64_t>({30, 45, 60, 90})));
    default:
      return set(setup, 19631, decimal(choose.between(1, choose.chance(70) ? 15'000 : 90'000), 3));
  }
}

}  // namespace

Decimal decimal(std::int64_t count, int decimals) {
  Decimal d = spec::decimal(count);
  d.decimals = static_cast<std::uint8_t>(decimals);
  d.point = decimals > 0;
  return d;
}

int increment_decimals(const Setup& setup) {
  const int mm = setup.increment == spec::IncrementSystem::is_a   ? 2
                 : setup.increment == spec::IncrementSystem::is_b ? 3
                                                                  : 4;
  return setup.units == spec::Units::mm ? mm : mm + 1;
}

std::int64_t counts_of(const Decimal& value, const Setup& setup) {
  auto counts = static_cast<std::int64_t>(value.digits);
  for (int i = value.decimals; i < increment_decimals(setup); ++i) counts *= 10;
  for (int i = value.decimals; i > increment_decimals(setup); --i) counts /= 10;
  return value.negative ? -counts : counts;
}

Setup random_setup(Choices& choose, Kinematics wanted) {
  Setup setup;
  if (choose.chance(20)) setup.units = spec::Units::inch;
  setup.increment =
      choose.one_of({spec::IncrementSystem::is_b, spec::IncrementSystem::is_b, spec::IncrementSystem::is_b,
                     spec::IncrementSystem::is_c, spec::IncrementSystem::is_a});
  const bool five = wanted == Kinematics::always || (wanted == Kinematics::maybe && choose.chance(35));
  setup.axes = spec::Axes(five ? choose.one_of({"XYZBC", "XYZBC", "XYZAC", "XYZAB", "XYZABC", "ZYXCB", "XYZUVWABC"})
                               : choose.one_of({"XYZ", "XYZ", "XYZB", "XYZUVW", "YZX"}));
  if (five && (wanted == Kinematics::always ? choose.chance(90) : choose.chance(50))) kinematics(choose, setup);
  if (wanted != Kinematics::none) {
    angle_range(choose, setup);
    if (choose.chance(25)) setup.rotary_angles = spec::RotaryAngles::programmed;
  }
  for (const int bit : {0, 1, 2, 3, 6})
    if (choose.chance(40)) set_bit(setup, 5001, bit, choose.chance(70));
  if (choose.chance(12)) set_bit(setup, 3401, 0, choose.chance(30));
  if (choose.chance(15)) set_bit(setup, 5006, 6, choose.chance(80));
  if (choose.chance(40)) setup.series = spec::Series::series_30i;
  if (wanted != Kinematics::none && setup.series == spec::Series::series_30i) {
    if (choose.chance(40)) set_bit(setup, 19746, 4, choose.chance(80));
    if (choose.chance(15)) set_bit(setup, 19696, 5, choose.chance(80));
  }

  setup.memory =
      choose.one_of({spec::OffsetMemory::a, spec::OffsetMemory::a, spec::OffsetMemory::b, spec::OffsetMemory::c});
  setup.offset_count = choose.one_of({400U, 400U, 99U, 32U});
  const std::size_t entries = choose.below(5) + 1;
  for (std::size_t i = 0; i < entries; ++i) {
    setup.h[static_cast<std::uint32_t>(i + 1)] = entry(choose, setup);
    if (choose.chance(80)) setup.d[static_cast<std::uint32_t>(i + 1)] = entry(choose, setup);
  }
  for (spec::AxisTable& origin : setup.workpiece)
    if (choose.chance(40)) origin = table(choose, setup, 70);
  for (const std::uint32_t number : {0U, 1U, 2U, 48U})
    if (choose.chance(4)) {
      spec::AxisTable origin = table(choose, setup, 70);
      std::erase_if(origin, [](const auto& axis) { return spec::is_rotary_axis(axis.first); });
      if (!origin.empty()) setup.additional_workpiece[number] = std::move(origin);
    }
  if (choose.chance(40)) setup.position = table(choose, setup, 60);
  if (choose.chance(2)) far_away(choose, setup);
  for (int number = 1; number <= 4; ++number)
    if (choose.chance(30))
      if (spec::AxisTable point = table(choose, setup, 70); !point.empty()) setup.reference[number] = std::move(point);
  if (choose.chance(20)) setup.floating_reference = table(choose, setup, 70);
  return setup;
}

namespace {

// Two to four numbers.
void cutter_offsets(Choices& choose, Setup& setup) {
  const std::int64_t numbers = choose.between(2, 4);
  setup.d.clear();
  for (std::int64_t n = 1; n <= numbers; ++n) {
    spec::OffsetEntry& e = setup.d[static_cast<std::uint32_t>(n)];
    e = cutter_offset(choose, setup);
    // Where both tables give a number each address reads its own; with OFH H counts for the cutter too.
    if (choose.chance(50)) setup.h[static_cast<std::uint32_t>(n)] = cutter_offset(choose, setup);
  }
}

// From which turn of the tool on a change of the compensation plane is checked: the usual 45, 0 that means it, Niven's
// angles, and any up to a half turn.
void plane_change_angle(Choices& choose, Setup& setup) {
  switch (choose.weighted({40, 10, 15, 25, 10})) {
    case 0:
      return;
    case 1:
      return set(setup, 6261, spec::decimal(choose.one_of<std::int64_t>({0, 45})));
    case 2:
      return set(setup, 6261, spec::decimal(choose.one_of<std::int64_t>({30, 60, 90, 120, 135, 180})));
    case 3:
      return set(setup, 6261, decimal(choose.between(1, 60'000), 3));
    default:
      return set(setup, 6261, decimal(choose.between(60'000, 180'000), 3));
  }
}

// What no setup may name: axes the machine does not have.
void drop_absent_axes(Setup& setup) {
  const auto drop = [&setup](spec::AxisTable& table) {
    std::erase_if(table, [&setup](const auto& entry) { return !setup.axes.has(entry.first); });
  };
  for (spec::AxisTable& origin : setup.workpiece) drop(origin);
  for (auto& entry : setup.additional_workpiece) drop(entry.second);
  std::erase_if(setup.additional_workpiece, [](const auto& entry) { return entry.second.empty(); });
  for (auto& entry : setup.reference) drop(entry.second);
  std::erase_if(setup.reference, [](const auto& entry) { return entry.second.empty(); });
  for (spec::AxisTable* const table : {&setup.position, &setup.floating_reference, &setup.measurement}) drop(*table);
}

void stop_codes(Choices& choose, Setup& setup) {
  if (choose.chance(12))
    set(setup, static_cast<std::uint32_t>(3411 + choose.below(10)),
        spec::decimal(choose.one_of<std::int64_t>({8, 8, 5, 0, 30, 98, 99'999'999})));
  if (!choose.chance(20)) return;
  const auto first = static_cast<std::uint32_t>(3421 + 2 * choose.below(6));
  if (choose.chance(90)) set(setup, first, spec::decimal(choose.between(0, 9)));
  if (choose.chance(90)) set(setup, first + 1, spec::decimal(choose.between(4, 12)));
}

// Series, and how many blocks are read.
void reading_ahead(Choices& choose, Setup& setup) {
  if (choose.chance(40)) setup.series = spec::Series::series_30i;
  if (choose.chance(setup.series == spec::Series::series_30i ? 70 : 5))
    set(setup, 19625, spec::decimal(choose.between(3, 8)));
  stop_codes(choose, setup);
}

}  // namespace

Setup random_cutter_setup(Choices& choose, spec::CutterCompensationType type) {
  Setup setup = random_setup(choose, Kinematics::none);
  setup.cutter_compensation = type;
  if (choose.chance(2)) {  // not every plane
    setup.axes = spec::Axes(choose.one_of({"XZ", "XY", "XZB"}));
    drop_absent_axes(setup);
  }
  for (const int bit : {4, 5})
    if (choose.chance(20)) set_bit(setup, 5001, bit, choose.chance(70));
  if (type == spec::CutterCompensationType::c) {
    for (const int bit : {0, 1, 2})
      if (choose.chance(50)) set_bit(setup, 5003, bit, choose.chance(75));
    if (choose.chance(35)) set_bit(setup, 5008, 0, choose.chance(75));
    if (choose.chance(15)) {
      const int decimals = increment_decimals(setup);
      set(setup, 5010, decimal(choose.between(0, 3 * power_of_ten(decimals)), decimals));
    }
  }
  if (choose.chance(75))
    for (spec::AxisTable& origin : setup.workpiece) origin.clear();
  cutter_offsets(choose, setup);
  if (type == spec::CutterCompensationType::c) {
    if (choose.chance(40)) setup.series = spec::Series::series_30i;
    for (const int bit : {1, 3})
      if (choose.chance(30)) set_bit(setup, 5008, bit, choose.chance(80));
    reading_ahead(choose, setup);
  }
  return setup;
}

Setup random_tool_side_setup(Choices& choose) {
  Setup setup = random_setup(choose, Kinematics::always);
  if (choose.chance(90)) setup.parameters.erase({19631, -1});
  for (const int bit : {0, 1, 2})
    if (choose.chance(45)) set_bit(setup, 5003, bit, choose.chance(75));
  if (choose.chance(50)) set_bit(setup, 5008, 0, choose.chance(80));
  if (choose.chance(25)) set_bit(setup, 19605, 5, choose.chance(60));
  const int decimals = increment_decimals(setup);
  const std::int64_t one = power_of_ten(decimals);
  setup.type_b_without_perpendicular = choose.chance(20);
  plane_change_angle(choose, setup);
  // Least travel in the plane: parts of a millimetre, or more than most movements.
  switch (choose.weighted({60, 10, 22, 5, 3})) {
    case 0:
      break;
    case 1:
      set(setup, 19630, decimal(choose.between(1, 3), decimals));
      break;
    case 2:
      set(setup, 19630, decimal(choose.between(1, 5 * one), decimals));
      break;
    case 3:
      set(setup, 19630, decimal(choose.between(5, 60) * one, decimals));
      break;
    default:
      set(setup, 19630, decimal(-choose.between(0, 5 * one), decimals));
      break;
  }
  if (choose.chance(80)) {
    for (spec::AxisTable& origin : setup.workpiece) origin.clear();
    setup.position.clear();
  }
  cutter_offsets(choose, setup);
  if (choose.chance(20)) {
    // Heads lie apart by r at right angles, by 2 r where the path goes straight back.
    const std::int64_t r = std::abs(counts_of(setup.d.begin()->second.geometry, setup));
    const std::int64_t about = choose.one_of<std::int64_t>({1, 2}) * r + choose.between(-1, 1);
    const std::int64_t limit = choose.chance(60) ? about : choose.between(-1, 4 * one);
    set(setup, 5010, decimal(limit, decimals));
  }
  reading_ahead(choose, setup);
  return setup;
}

}  // namespace toolcomp::fuzz
