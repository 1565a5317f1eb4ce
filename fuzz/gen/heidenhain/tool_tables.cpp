// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/heidenhain/tool_tables.h"

#include <algorithm>
#include <iterator>

namespace toolcomp::fuzz {
namespace {

using spec::Decimal;

constexpr int kTableDecimals = 4;
constexpr std::int64_t kOne = 10'000;

Decimal length(std::int64_t count) {
  spec::Decimal d = spec::decimal(count);
  d.decimals = kTableDecimals;
  while (d.decimals > 0 && d.digits % 10 == 0) {
    d.digits /= 10;
    --d.decimals;
  }
  d.point = d.decimals > 0;
  return d;
}

struct Shape {
  std::int64_t r = 0;
  std::int64_t r2 = 0;
};

Shape shape(Choices& choose) {
  const std::int64_t whole = choose.one_of({3, 5, 6, 8, 10}) * kOne;
  switch (choose.weighted({26, 26, 30, 14, 2, 1, 1})) {
    case 0:
      return {whole, 0};
    case 1:
      return {whole, choose.one_of({5'000, 10'000, 20'000})};
    case 2:
      return {whole, whole};
    case 3: {
      const std::int64_t r = choose.between(kOne / 2, 20 * kOne);
      const std::int64_t r2 = choose.between(0, r);
      return {r, r2};
    }
    case 4:
      return {0, 0};
    case 5:
      return {whole, whole + choose.between(1, kOne)};  // no tool
    default:
      return choose.chance(50) ? Shape{-whole, 0} : Shape{whole, -1};
  }
}

struct Deltas {
  std::int64_t l = 0;
  std::int64_t r = 0;
  std::int64_t r2 = 0;
};

// None, an even allowance, re-worked, any; those that take a radius to exactly 0 or just below; that make the corner
// radius the radius.
Deltas deltas(Choices& choose, const Shape& tool) {
  const std::int64_t even = choose.between(-30, 10) * 100;
  // A sharp corner cannot be made smaller: mostly it is left.
  const bool sharp = tool.r2 == 0 && !choose.chance(8);
  Deltas d;
  switch (choose.weighted({34, 24, 14, 18, 3, 2, 4})) {
    case 0:
      return {};
    case 1:
      d = {even, even, even};
      break;
    case 2:
      d = {0, -1'000, -1'000};
      break;
    case 3:
      d.l = choose.between(-3'000, 3'000);
      d.r = choose.between(-3'000, choose.chance(25) ? 3'000 : 0);
      d.r2 = choose.between(-3'000, choose.chance(25) ? 3'000 : 0);
      break;
    case 4:
      return {0, 0, -tool.r2 - (choose.chance(30) ? 1 : 0)};
    case 5:
      return {0, -tool.r - (choose.chance(30) ? 1 : 0), -tool.r2};
    default:
      return {0, tool.r2 - tool.r - (choose.chance(30) ? 1 : 0), 0};
  }
  if (sharp && d.r2 < 0) d.r2 = 0;
  return d;
}

// Ascending angles of whole tens mostly; deviations of some hundredths, seldom beyond the radius.
spec::DeviationTable deviations(Choices& choose) {
  static constexpr std::int64_t angles[] = {0, 30, 40, 45, 50, 60, 90, 120, 135, 180};
  spec::DeviationTable table;
  const bool whole = choose.chance(65);
  for (std::size_t i = 0; i < std::size(angles); ++i) {
    const bool end = i == 0 || i + 1 == std::size(angles);
    if (!(whole && end) && !choose.chance(35)) continue;
    std::int64_t deviation = choose.between(-60, 60) * 10;
    if (choose.chance(4)) deviation = -choose.between(1, 12) * kOne;
    const std::int64_t beside = !end && choose.chance(10) ? choose.between(-9'999, 9'999) : 0;
    table.emplace_back(length(angles[i] * kOne + beside), length(deviation));
  }
  if (table.empty()) table.emplace_back(spec::decimal(40), length(300));
  return table;
}

spec::ToolRow tool_row(Choices& choose, std::uint32_t tenths, bool may_deviate) {
  spec::ToolRow row;
  row.number = tenths;
  const Shape form = shape(choose);
  const Deltas off = deltas(choose, form);
  row.r = length(form.r);
  row.r2 = length(form.r2);
  row.dl = length(off.l);
  row.dr = length(off.r);
  row.dr2 = length(off.r2);
  if (choose.chance(60)) row.l = length(choose.between(-20, 200) * 5'000);
  if (choose.chance(25)) {
    const std::string name = choose.one_of({"BALL", "MILL 12 ", "T", "Fr\u00e4ser"});
    row.name = name + std::to_string(tenths);
  }
  // Tables are for balls; seldom one at another tool.
  const bool ball = form.r == form.r2;
  if (may_deviate && choose.chance(ball ? 40 : 4)) row.dr2_table = "DEV";
  return row;
}

}  // namespace

spec::Setup random_heidenhain_setup(Choices& choose) {
  spec::Setup setup;
  setup.control = spec::Control::heidenhain;
  setup.axes = spec::Axes(choose.one_of({"XYZABC", "XYZABC", "XYZABC", "XYZ", "XYZBC", "CBZYX", "XYZABCUVW", "XYZAC"}));
  if (choose.chance(8)) setup.units = spec::Units::inch;
  setup.block_skip = choose.chance(15);
  if (choose.chance(25)) setup.m128_reference = spec::M128Reference::center;
  const bool deviating = choose.chance(22);
  if (deviating) setup.dr2_tables["DEV"] = deviations(choose);
  const auto rows = static_cast<std::uint32_t>(choose.between(1, 3));
  for (std::uint32_t i = 1; i <= rows; ++i) {
    const std::uint32_t step = choose.chance(10) ? 1 : 0;
    setup.tools.push_back(tool_row(choose, i * 10 + step, deviating));
  }
  const std::int64_t corrections = choose.chance(45) ? choose.between(1, 2) : 0;
  for (std::int64_t i = 0; i < corrections; ++i) {
    spec::CorrectionRow row;
    const std::int64_t even = choose.between(-50, 20) * 10;
    const bool equal = choose.chance(40);
    row.dl = length(equal ? even : choose.between(-500, 500));
    row.dr = length(equal ? even : choose.between(-500, 100));
    row.dr2 = length(equal ? even : choose.chance(50) ? choose.between(-500, 100) : 0);
    setup.tcs[static_cast<std::uint32_t>(i) * 7 + 1] = row;
  }
  if (choose.chance(25))
    for (const char axis : {'X', 'Y', 'Z'}) setup.position[axis] = length(choose.between(-100, 100) * kOne);
  return setup;
}

}  // namespace toolcomp::fuzz
