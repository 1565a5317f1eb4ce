// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "certify/convert.h"
#include "judge/oracle/number.h"
#include "spec/language/decimal_order.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::kit {

double value_in(const spec::AxisTable& table, char axis) {
  const auto entry = table.find(axis);
  return entry == table.end() ? 0 : judge::approximate(entry->second);
}

namespace {

[[noreturn]] void refuse(std::string_view text, const std::string& what) {
  throw spec::InputError("--travel", 0, 0, "\"" + std::string(text) + "\": " + what);
}

// What the moves pass, axis by axis, in the coordinates of `axes`.
class Passed {
 public:
  explicit Passed(const spec::Axes& axes) : axes_(axes) {}

  void take(const spec::Event<double>& event) {
    using enum spec::EventKind;
    if (event.hole) {
      for (const double level : {event.hole->point_r, event.hole->bottom})
        reach(event.hole->axis, event.axes[event.hole->axis] + level - event.hole->level);
      for (std::size_t i = 0; i < axes_.size(); ++i)
        if (event.axes.has(i)) reach(i, event.axes[i]);
      last_ = event.axes;
      in_samples_ = false;
    }
    if (event.kind != move && event.kind != sample) return;
    steps(event);
    for (std::size_t i = 0; i < axes_.size(); ++i)
      if (event.axes.has(i)) reach(i, event.axes[i]);
    if (event.kind == move && event.arc) arc(event, *event.arc);
    last_ = event.axes;
    in_samples_ = event.kind == sample;
  }

  [[nodiscard]] const std::map<std::size_t, Extent>& extents() const { return extents_; }

 private:
  void reach(std::size_t axis, double value) {
    const auto [entry, added] = extents_.try_emplace(axis, Extent{value, value});
    entry->second.least = std::min(entry->second.least, value);
    entry->second.greatest = std::max(entry->second.greatest, value);
  }

  // Between samples the path bends: it may leave what they span by no more than the step between them.
  void steps(const spec::Event<double>& event) {
    if (!in_samples_ && event.kind != spec::EventKind::sample) return;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      if (!event.axes.has(i) || !last_.has(i)) continue;
      const double step = std::abs(event.axes[i] - last_[i]);
      reach(i, event.axes[i] + step);
      reach(i, event.axes[i] - step);
    }
  }

  // The outermost points of the arc that lie inside its sweep. `axes` stand beside the tool's point by the length
  // offset, which an arc does not change.
  void arc(const spec::Event<double>& event, const spec::Arc<double>& arc) {
    const char first = arc.plane == spec::Plane::xy ? 'X' : arc.plane == spec::Plane::zx ? 'Z' : 'Y';
    const char second = arc.plane == spec::Plane::xy ? 'Y' : arc.plane == spec::Plane::zx ? 'X' : 'Z';
    const std::size_t u = axes_.index(first);
    const std::size_t v = axes_.index(second);
    if (u == spec::Axes::kNone || v == spec::Axes::kNone || !event.point.has(u) || !event.point.has(v)) return;
    const double along = event.point[u] - arc.center[u];
    const double across = event.point[v] - arc.center[v];
    double radius = std::hypot(along, across);
    if (arc.radius) radius = std::max({radius, arc.radius->first, arc.radius->second});
    const double end = std::atan2(across, along);
    const double sweep = arc.sweep.value_or(360) * std::numbers::pi / 180;
    const double turn = arc.direction == spec::ArcDirection::ccw ? 1 : -1;
    const double quarter = std::numbers::pi / 2;
    for (int k = 0; k < 4; ++k) {
      // How far before the end the arc passes this quarter.
      double back = std::remainder(turn * (end - k * quarter), 4 * quarter);
      if (back < 0) back += 4 * quarter;
      if (back > sweep + quarter / 90) continue;
      const double at_u = arc.center[u] + radius * std::cos(k * quarter);
      const double at_v = arc.center[v] + radius * std::sin(k * quarter);
      reach(u, at_u + event.axes[u] - event.point[u]);
      reach(v, at_v + event.axes[v] - event.point[v]);
    }
  }

  const spec::Axes& axes_;
  spec::AxisValues<double> last_;
  bool in_samples_ = false;
  std::map<std::size_t, Extent> extents_;
};

}  // namespace

void add_travel(Machine& machine, std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::size_t comma = text.find(',');
  if (equals != 1 || comma == std::string_view::npos || comma < equals)
    refuse(text, "expected AXIS=LEAST,GREATEST, as in X=-300,300");
  const char axis = text[0];
  const auto least = spec::parse_decimal(text.substr(equals + 1, comma - equals - 1));
  const auto greatest = spec::parse_decimal(text.substr(comma + 1));
  if (!least || !greatest) refuse(text, "expected two decimal numbers");
  if (!machine.setup.axes.has(axis)) refuse(text, std::string("the setup has no axis ") + axis);
  if (spec::compare(*least, *greatest) != std::strong_ordering::less)
    refuse(text, "the least must be below the greatest");
  if (!machine.travels.try_emplace(axis, Travel{*least, *greatest}).second) refuse(text, "the axis is given twice");
}

void expect_whole(const Machine& machine) {
  bool linear = false;
  for (const char axis : machine.setup.axes.letters()) {
    linear = linear || spec::is_linear_axis(axis);
    const auto travel = machine.travels.find(axis);
    if (travel == machine.travels.end())
      throw spec::InputError(
          "--travel", 0, 0,
          fmt::format("axis {0} has no travel; give --travel {0}=LEAST,GREATEST in machine coordinates", axis));
    const double place = value_in(machine.setup.position, axis) + value_in(machine.setup.workpiece[0], axis);
    const double room = axis == mark_axis(machine) ? 1 : 0;
    if (place < judge::approximate(travel->second.least) || place + room > judge::approximate(travel->second.greatest))
      throw spec::InputError("--travel", 0, 0,
                             fmt::format("axis {}: the place of the marks ([position] of the setup), {:g} in machine "
                                         "coordinates, with 1 of room in the + direction, is outside the travel",
                                         axis, place));
  }
  if (!linear) throw spec::InputError("--setup", 0, 0, "the setup has no linear axis");
}

char mark_axis(const Machine& machine) {
  for (const char axis : machine.setup.axes.letters())
    if (spec::is_linear_axis(axis)) return axis;
  return machine.setup.axes.letter(0);
}

std::map<char, Extent> extents(const Machine& machine, std::span<const model::Event> events) {
  Passed passed(machine.setup.axes);
  for (const model::Event& event : events) passed.take(certify::in_double(event));
  std::map<char, Extent> all;
  for (const auto& [index, extent] : passed.extents()) {
    const char axis = machine.setup.axes.letter(index);
    const double origin = value_in(machine.setup.workpiece[0], axis);
    all[axis] = {extent.least + origin, extent.greatest + origin};
  }
  return all;
}

std::string outside_travels(const Machine& machine, std::span<const model::Event> events) {
  for (const auto& [axis, extent] : extents(machine, events)) {
    const Travel& travel = machine.travels.at(axis);
    if (!(extent.least >= judge::approximate(travel.least)))
      return fmt::format("{} goes to {:.6g}, below {}", axis, extent.least, spec::to_string(travel.least));
    if (!(extent.greatest <= judge::approximate(travel.greatest)))
      return fmt::format("{} goes to {:.6g}, above {}", axis, extent.greatest, spec::to_string(travel.greatest));
  }
  return {};
}

}  // namespace toolcomp::certify::kit
