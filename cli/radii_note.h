// SPDX-License-Identifier: Apache-2.0
// A note on arcs whose programmed radii differ, for a setup without parameter 3410: a control that has it raises
// PS0020. Often I and J were written as absolute coordinates.
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>

#include "spec/language/event.h"
#include "spec/language/setup.h"

namespace toolcomp::cli {

// Looks at the moves of one run in their order. Approximate: it tells, and decides nothing.
class RadiiNote {
 public:
  explicit RadiiNote(const spec::Setup& setup);

  // `nearest` makes a double of a number of the event.
  template <class Number, class Nearest>
  void on(const spec::Event<Number>& event, Nearest nearest) {
    if (!watches_ || event.kind != spec::EventKind::move) return;
    if (event.arc && event.arc->sweep && event.cause == spec::Cause::programmed) see_arc(event, nearest);
    for (std::size_t axis = 0; axis < axes_.size(); ++axis)
      if (event.point.has(axis)) offset_.at(axis) = nearest(event.point[axis]) - nearest(event.programmed[axis]);
  }

  // The first arc that is worth a word, 0 where there was none, and what to say of all.
  [[nodiscard]] std::uint64_t first_line() const { return first_line_; }
  [[nodiscard]] std::string text() const;

 private:
  // The tool's own arc is turned back from its end to its start, which no shift of coordinates between two blocks
  // changes; without the offsets of both ends these are the programmed radii.
  template <class Number, class Nearest>
  void see_arc(const spec::Event<Number>& event, Nearest nearest) {
    const spec::Arc<Number>& arc = *event.arc;
    const auto [first, second] = letters(arc.plane);
    const auto in_plane = [&, u = axes_.index(first), v = axes_.index(second)](auto of) {
      return std::complex<double>(of(u), of(v));
    };
    const auto end = in_plane([&](std::size_t axis) { return nearest(event.point[axis]) - nearest(arc.center[axis]); });
    const auto programmed =
        in_plane([&](std::size_t axis) { return nearest(event.programmed[axis]) - nearest(arc.center[axis]); });
    const double turn =
        (arc.direction == spec::ArcDirection::cw ? 1 : -1) * nearest(*arc.sweep) * std::numbers::pi / 180;
    const double shrink = arc.radius ? nearest(arc.radius->first) / nearest(arc.radius->second) : 1;
    const auto start = end * std::polar(shrink, turn) - in_plane([&](std::size_t axis) { return offset_.at(axis); });
    see(event.line, std::abs(std::abs(programmed) - std::abs(start)));
  }
  static std::pair<char, char> letters(spec::Plane plane) {
    if (plane == spec::Plane::xy) return {'X', 'Y'};
    return plane == spec::Plane::zx ? std::pair('Z', 'X') : std::pair('Y', 'Z');
  }
  void see(std::uint64_t line, double difference);

  const spec::Axes& axes_;
  bool watches_;
  double least_;  // from this difference on it is told
  std::array<double, spec::kMaxAxes> offset_{};
  std::uint64_t others_ = 0;
  std::uint64_t first_line_ = 0;
  double largest_ = 0;
};

}  // namespace toolcomp::cli
