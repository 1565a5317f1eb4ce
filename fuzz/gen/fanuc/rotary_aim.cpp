// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/fanuc/rotary_aim.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fuzz/gen/fanuc/tool_turns.h"
#include "judge/oracle/number.h"
#include "judge/oracle/policy.h"

namespace toolcomp::fuzz {
namespace {

constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

// Whole directions, most of whole length.
constexpr SpaceCounts kRational[] = {
    {3, 0, 4}, {4, 0, 3}, {0, 3, 4}, {5, 0, 12}, {0, 8, 15}, {1, 2, 2},        {2, 3, 6},  {1, 4, 8},  {-1, 1, 2},
    {1, 1, 2}, {1, 2, 3}, {6, 6, 7}, {0, 0, 1},  {1, 0, 0},  {0, 1, 0},        {1, 0, 1},  {1, 1, 1},  {0, -1, 1},
    {0, 1, 1}, {1, 0, 5}, {1, 0, 2}, {3, 4, 0},  {1, 1, 0},  {400, 0, 39'999}, {0, 1, 20}, {1, 1, 50}, {-10, 1, 50}};

double clamped(double x) { return std::clamp(x, -1.0, 1.0); }

}  // namespace

RotaryAim::RotaryAim(Choices& choose, ProgramWriter& write, const spec::Setup& setup, bool posture)
    : choose_(choose), write_(write), setup_(setup), posture_(posture), machine_(judge::RotaryMachine::of(setup)) {
  if (!machine_) return;
  if (setup.rotary_angles == spec::RotaryAngles::machine) {
    const auto zero = [&](std::size_t axis) {
      if (axis == spec::Axes::kNone) return 0.0;
      const auto found = setup.workpiece.front().find(setup.axes.letter(axis));
      return found == setup.workpiece.front().end() ? 0.0 : judge::approximate(found->second);
    };
    machine_->tool_angle += zero(machine_->tool);
    machine_->work_angle += zero(machine_->work);
  }
  const judge::RotaryMachine& m = *machine_;
  // cos(polar) = mean + a cos(turn) + b sin(turn).
  const double along = dot(m.reference, m.tool_line);
  Direction across{};
  for (std::size_t i = 0; i < 3; ++i) across.at(i) = m.reference.at(i) - along * m.tool_line.at(i);
  const double a = dot(m.work_line, across);
  const double b = dot(m.work_line, cross(m.tool_line, across));
  const double mean = along * dot(m.work_line, m.tool_line);
  const double swing = std::hypot(a, b);
  foot_ = counts(m.tool_sense * std::atan2(b, a) * kDegreesPerRadian - m.tool_angle);
  least_ = std::acos(clamped(mean + swing)) * kDegreesPerRadian;
  most_ = std::acos(clamped(mean - swing)) * kDegreesPerRadian;
}

bool RotaryAim::complete() const {
  return machine_ && machine_->tool != spec::Axes::kNone && machine_->work != spec::Axes::kNone;
}

double RotaryAim::degrees(std::int64_t counts) const {
  return static_cast<double>(counts) / static_cast<double>(write_.one());
}
std::int64_t RotaryAim::counts(double degrees) const {
  return std::llround(degrees * static_cast<double>(write_.one()));
}
std::int64_t RotaryAim::at(std::size_t axis) const {
  return axis == spec::Axes::kNone ? 0 : write_.at(setup_.axes.letter(axis));
}
double RotaryAim::parameter(std::uint32_t number) const {
  const auto given = setup_.parameter(number);
  if (!given) return 0;
  const double magnitude = static_cast<double>(given->digits) * std::pow(10.0, -given->decimals);
  return given->negative ? -magnitude : magnitude;
}

Direction RotaryAim::to_frame(const Direction& table_direction) const {
  if (!machine_ || head()) return table_direction;
  const judge::RotaryMachine& m = *machine_;
  Direction v = turned(table_direction, m.work_line, -m.work_sense * (frozen_work_ + m.work_angle));
  if (m.type == judge::RotaryMachine::Type::table)
    v = turned(v, m.tool_line, -m.tool_sense * (frozen_tool_ + m.tool_angle));
  return v;
}
Direction RotaryAim::to_table(const Direction& frame_direction) const {
  if (!machine_ || head()) return frame_direction;
  const judge::RotaryMachine& m = *machine_;
  Direction v = frame_direction;
  if (m.type == judge::RotaryMachine::Type::table)
    v = turned(v, m.tool_line, m.tool_sense * (frozen_tool_ + m.tool_angle));
  return turned(v, m.work_line, m.work_sense * (frozen_work_ + m.work_angle));
}

void RotaryAim::start(bool by_words) {
  by_words_ = by_words;
  words_.reset();
  if (machine_) {
    frozen_tool_ = degrees(at(machine_->tool));
    frozen_work_ = degrees(at(machine_->work));
    direction_ = to_frame(machine_->direction(frozen_tool_, frozen_work_));
  } else {
    direction_ = {0, 0, 1};
  }
}

void RotaryAim::end() {
  by_words_ = false;
  words_.reset();
}

ToolAim RotaryAim::aim() const {
  if (by_words_) return {direction_, words_ ? words_ : whole_along(direction_, 12)};
  if (!machine_) return {{0, 0, 1}, SpaceCounts{0, 0, 1}};
  const Direction d = to_frame(machine_->direction(degrees(at(machine_->tool)), degrees(at(machine_->work))));
  return {d, whole_along(d, 12)};
}

void RotaryAim::position() {
  if (!machine_) return;
  const std::int64_t one = write_.one();
  for (const std::size_t axis : {machine_->tool, machine_->work}) {
    if (axis == spec::Axes::kNone || choose_.chance(30)) continue;
    std::int64_t target = 0;
    switch (choose_.weighted({40, 30, 20, 10})) {
      case 0:
        target = choose_.between(-8, 8) * 15 * one;
        break;
      case 1:
        target = choose_.between(-4, 4) * 90 * one;
        break;
      case 2:
        target = choose_.between(-100 * one, 100 * one);
        break;
      default:
        target = choose_.between(-20, 20) * 90 * one;
        break;
    }
    write_.axis(setup_.axes.letter(axis), target - at(axis));
  }
}

void RotaryAim::turn() {
  if (by_words_)
    turn_by_words();
  else
    turn_axes();
}

void RotaryAim::move_to(std::int64_t tool, std::int64_t work) {
  const auto word = [&](std::size_t axis, std::int64_t target) {
    if (axis == spec::Axes::kNone) return;
    const std::int64_t travel = target - at(axis);
    if (travel != 0 || choose_.chance(15)) write_.axis(setup_.axes.letter(axis), travel);
  };
  word(machine_->tool, tool);
  word(machine_->work, work);
}

void RotaryAim::turn_axes() {
  if (!machine_) return;
  const std::int64_t one = write_.one();
  const std::int64_t tool = at(machine_->tool);
  const std::int64_t work = at(machine_->work);
  const std::int64_t side = tool < foot_ ? -1 : 1;
  // From the position nearest to the work-side axis, on this side of it.
  const auto beside = [&](std::int64_t tilt) { return foot_ + side * tilt; };
  const int often = posture_ ? 14 : 4;
  switch (choose_.weighted({20, 24, often, often, often, 6, 10, 8, 3, 4})) {
    case 0: {
      const std::int64_t t = choose_.between(-6, 6) * 15 * one;
      const std::int64_t w = choose_.between(-12, 12) * 15 * one;
      return move_to(t, w);
    }
    case 1: {  // on this side, by less than half a turn
      const std::int64_t t = choose_.chance(50) ? choose_.between(1, 17) * 5 * one : choose_.between(1, 85 * one);
      const std::int64_t w =
          choose_.chance(50) ? choose_.between(-17, 17) * 10 * one : choose_.between(-175 * one, 175 * one);
      return move_to(beside(t), work + w);
    }
    case 2: {  // straight through
      const std::int64_t t = choose_.chance(40) ? tool - foot_ : side * choose_.between(1, 12) * 5 * one;
      return move_to(foot_ - t, work + (choose_.chance(80) ? 0 : choose_.between(-2, 2)));
    }
    case 3: {  // to where the tool is nearest to the work-side axis, or farthest
      const std::int64_t t = foot_ + (choose_.chance(85) ? 0 : 180 * one);
      return move_to(t, work + (choose_.chance(50) ? 0 : choose_.between(-12, 12) * 15 * one));
    }
    case 4: {
      const std::int64_t tilt = choose_.chance(60) ? choose_.between(1, 5) : choose_.between(1, 3 * one);
      const std::int64_t around =
          choose_.chance(50) ? choose_.between(-17, 17) * 10 * one : choose_.between(-175 * one, 175 * one);
      return move_to(beside(tilt), work + around);
    }
    case 5: {  // half a turn, more, whole turns
      const auto by = choose_.one_of<std::int64_t>({180, -180, 200, 360, -360, 720, 540});
      const std::int64_t aside = choose_.chance(70) ? 0 : choose_.between(-1, 1);
      return move_to(choose_.chance(50) ? tool : beside(choose_.between(1, 17) * 5 * one), work + by * one + aside);
    }
    case 6: {
      const std::int64_t t = tool + choose_.between(-20 * one, 20 * one);
      const std::int64_t w = work + choose_.between(-60 * one, 60 * one);
      return move_to(t, w);
    }
    case 7: {  // one axis
      const bool first = choose_.chance(50);
      const std::int64_t by = choose_.between(-12, 12) * 10 * one;
      return move_to(first ? tool + by : tool, first ? work : work + by);
    }
    case 8:  // the opposite direction
      return move_to(2 * foot_ + 180 * one - (tool), work + 180 * one);
    default:  // the same direction by the other pair
      return move_to(2 * foot_ - tool, work + (choose_.chance(50) ? 180 : -180) * one);
  }
}

Direction RotaryAim::direction_at(const Polar& p) const {
  const Direction& w = machine_->work_line;
  const Direction e = unit(cross(cross(w, axis_off(w)), w));
  return turned(turned(w, cross(w, e), p.polar), w, p.azimuth);
}

// A great circle whose nearest point to the work-side axis is exactly 45 degrees off: across (3, 4, 5) from (1, -7, 5)
// to (-7, -1, 5), counted from behind the axis.
bool RotaryAim::at_45_degrees() {
  constexpr double angle = 45;
  const auto axis = whole_along(to_frame(machine_->work_line), 1);
  if (!axis || parameter(19738) != angle) return false;
  const auto* const place = std::ranges::find_if(*axis, [](std::int64_t x) { return x != 0; });
  const auto along = static_cast<std::size_t>(place - axis->begin());
  if (along > 2) return false;
  const auto about = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
    SpaceCounts d{};
    d.at((along + 1) % 3) = a;
    d.at((along + 2) % 3) = b;
    d.at(along) = c;
    return d;
  };
  const SpaceCounts from = about(1, -7, 5);
  write_words(words_ == from ? about(-7, -1, 5) : from);
  return true;
}

RotaryAim::Polar RotaryAim::polar_of(const Direction& table_direction) const {
  const Direction& w = machine_->work_line;
  const Direction e = unit(cross(cross(w, axis_off(w)), w));
  const double height = dot(table_direction, w);
  const double ahead = dot(table_direction, e);
  const double aside = dot(table_direction, cross(w, e));
  return {std::atan2(std::hypot(ahead, aside), height) * kDegreesPerRadian,
          std::atan2(aside, ahead) * kDegreesPerRadian};
}

void RotaryAim::write_words(const SpaceCounts& whole) {
  direction_words(choose_, write_, whole, 25);
  words_ = whole;
  direction_ = as_direction(whole);
}

void RotaryAim::write_direction(const Direction& frame_direction, bool whole_if_possible) {
  if (whole_if_possible)
    if (const auto whole = whole_along(frame_direction, 60)) return write_words(*whole);
  constexpr double sizes[] = {50, 900, 9000, 9000, 90'000};
  const double size = choose_.one_of(sizes) * static_cast<double>(write_.one());
  SpaceCounts d{};
  for (std::size_t i = 0; i < 3; ++i) d.at(i) = std::llround(frame_direction.at(i) * size);
  if (d == SpaceCounts{}) d[2] = 1;
  write_words(d);
}

SpaceCounts RotaryAim::rational() {
  SpaceCounts d = choose_.one_of(kRational);
  if (choose_.chance(30)) std::swap(d[0], d[1]);
  return of_any_sense(choose_, d);
}

// Beyond the work-side axis in the plane of it and the present direction, where both are whole numbers.
bool RotaryAim::cross_exactly() {
  const auto axis = whole_along(to_frame(machine_->work_line), 1);
  const auto from = words_ ? words_ : whole_along(direction_, 12);
  if (!axis || !from) return false;
  std::size_t along = 3;
  std::size_t others = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (axis->at(i) == 0) continue;
    along = i;
    ++others;
  }
  if (others != 1 || std::abs(from->at(0)) + std::abs(from->at(1)) + std::abs(from->at(2)) > 100'000'000) return false;
  SpaceCounts to = *from;
  const std::int64_t beyond = choose_.between(1, 4);
  const std::int64_t height = choose_.between(1, 3);
  for (std::size_t i = 0; i < 3; ++i) to.at(i) *= i == along ? height : -beyond;
  if (choose_.chance(12)) to.at(choose_.below(3)) += choose_.one_of<std::int64_t>({-1, 1});
  if (to == SpaceCounts{}) return false;
  write_words(to);
  return true;
}

void RotaryAim::turn_by_words() {
  if (!machine_) {
    if (choose_.chance(70)) return write_words(rational());
    const bool opposite = choose_.chance(20) && words_;
    if (opposite) return write_words({-(*words_)[0], -(*words_)[1], -(*words_)[2]});
    Direction d{};
    for (double& x : d) x = static_cast<double>(choose_.between(-1000, 1000)) / 1000;
    return write_direction(dot(d, d) > 0 ? unit(d) : Direction{0, 0, 1}, false);
  }
  const Polar now = polar_of(to_table(direction_));
  const double near = std::fabs(parameter(19738));
  const double turned_by = std::fabs(parameter(19739));
  const int often = posture_ ? 12 : 4;
  Polar to = now;
  bool whole = choose_.chance(70);
  const auto sign = [&] { return choose_.chance(50) ? 1.0 : -1.0; };
  // Thousandths, or a unit beside.
  const auto aside = [&] { return static_cast<double>(choose_.between(-1, 1)) / 1000; };
  const auto inside = [&](double polar) { return std::clamp(polar, least_, most_); };
  switch (choose_.weighted({22, 16, 8, often, often, often, often, 5, 7, 12, 1, 4, posture_ ? 5 : 1})) {
    case 0: {  // rational, where it can be reached
      SpaceCounts d = rational();
      for (int tries = 0; tries < 6; ++tries) {
        const double polar = polar_of(to_table(as_direction(d))).polar;
        if (polar >= least_ - judge::policy::kSlack && polar <= most_ + judge::policy::kSlack) break;
        d = rational();
      }
      return write_words(d);
    }
    case 1:
      to.polar = inside(static_cast<double>(choose_.between(0, 90'000)) / 1000);
      to.azimuth = static_cast<double>(choose_.between(-180'000, 180'000)) / 1000;
      whole = false;
      break;
    case 2:  // along the work-side axis
      to.polar = choose_.chance(80) || most_ < 179 ? 0 : 180;
      to.polar = inside(to.polar);
      break;
    case 3: {  // near it
      const double tiny[] = {0.0001, 0.001, 0.01, 0.1, near, near, near + aside(), 2};
      to.polar = inside(choose_.one_of(tiny));
      to.azimuth = static_cast<double>(choose_.between(-24, 24) * 15);
      break;
    }
    case 4:  // through it
      if (cross_exactly()) return;
      to.polar = inside(static_cast<double>(choose_.between(1, 60)));
      to.azimuth = now.azimuth + 180;
      whole = true;
      break;
    case 5: {  // past it, turned by nearly half a turn
      const double s = sign();
      const double off =
          choose_.chance(50) ? turned_by + aside() : static_cast<double>(choose_.between(0, 20'000)) / 1000;
      to.azimuth = now.azimuth + 180 + s * off;
      to.polar = inside(static_cast<double>(choose_.between(500, 40'000)) / 1000);
      whole = false;
      break;
    }
    case 6: {  // so that the great circle passes at about the angle of 19738
      const double off = std::max(1.0, turned_by * static_cast<double>(choose_.between(10, 120)) / 100);
      const double s = sign();
      to.azimuth = now.azimuth + 180 + s * off;
      // sin d = sin a sin b sin(off)/sin(angle): for small angles d = a b sin(off)/(a + b).
      const double a = std::max(now.polar, 0.001);
      const double want = near * std::numbers::pi / 180 / std::max(std::sin(off * std::numbers::pi / 180), 0.000001);
      const double da = a * std::numbers::pi / 180;
      const double b = da > want ? want * da / (da - want) : 0.3;
      to.polar = inside(b * kDegreesPerRadian * static_cast<double>(choose_.between(60, 140)) / 100);
      whole = false;
      break;
    }
    case 7: {  // the same, the opposite, or one a unit beside
      if (!words_) return write_direction(direction_, true);
      SpaceCounts d = *words_;
      const auto factor = choose_.one_of<std::int64_t>({1, 2, -1, -1, -2});
      for (std::int64_t& x : d) x *= factor;
      if (choose_.chance(25)) d.at(choose_.below(3)) += choose_.one_of<std::int64_t>({-1, 1});
      if (d == SpaceCounts{}) d[2] = 1;
      return write_words(d);
    }
    case 8:  // the edges of reach
      to.polar = choose_.chance(50) ? least_ : most_;
      to.azimuth = static_cast<double>(choose_.between(-12, 12) * 15);
      whole = true;
      break;
    case 9:  // a little
      to.polar = inside(std::fabs(now.polar + static_cast<double>(choose_.between(-9000, 9000)) / 1000));
      to.azimuth += static_cast<double>(choose_.between(-20'000, 20'000)) / 1000;
      whole = false;
      break;
    case 10:  // any at all
      to.polar = static_cast<double>(choose_.between(0, 180));
      to.azimuth = static_cast<double>(choose_.between(-180, 180));
      break;
    case 11:
      if (at_45_degrees()) return;
      return write_words(rational());
    default:  // one word
      return write_words(choose_.one_of<SpaceCounts>({{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}));
  }
  write_direction(to_frame(direction_at(to)), whole);
}

}  // namespace toolcomp::fuzz
