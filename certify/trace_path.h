// The exact path of a run as straight pieces in the space of the recorded axes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "spec/language/case.h"
#include "spec/language/event.h"

namespace toolcomp::certify {

using AxisPoint = std::array<double, spec::kMaxAxes>;

// From `begin` to `end`; all axes run evenly.
struct PathPiece {
  AxisPoint begin{};
  AxisPoint end{};
  bool corner = true;      // a move ends here; false: inside an arc
  bool ends_only = false;  // its inside is not judged
  double length = 0;       // of the linear axes recorded
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;
};

// Which axes count, and how.
struct PathSpace {
  std::vector<std::size_t> linear;  // axis indices
  std::vector<std::size_t> rotary;
  double tolerance = 0;
};

// The pieces of the moves in `events`. Arcs become chords whose sagitta is at most a thousandth of the tolerance; a
// move with samples becomes chords from one to the next. Between two moves with a block that changes the workpiece
// system (G54–G59, G92) the coordinates may jump: the inside of the latter move is not judged, nor that of rapid moves
// if `judge_rapids` is false.
std::vector<PathPiece> path_pieces(const spec::Case& c, std::span<const spec::Event<double>> events,
                                   const PathSpace& space, bool judge_rapids);

// How far the path is off its chords at most, by the bend from one to the next.
double largest_sagitta(const spec::Case& c, std::span<const spec::Event<double>> events, const PathSpace& space);

// The part of the piece within the tolerance of `p`, as parameters from 0 to 1; nothing if there is none. Each rotary
// axis is compared by itself.
std::optional<std::pair<double, double>> part_near(const PathSpace& space, const AxisPoint& begin, const AxisPoint& end,
                                                   const AxisPoint& p);

// Distance of the linear axes between `p` and the point of the piece at `t`, and the largest of a rotary axis.
struct Distance {
  double linear = 0;
  double rotary = 0;
};
Distance distance_at(const PathSpace& space, const AxisPoint& begin, const AxisPoint& end, double t,
                     const AxisPoint& p);
// The parameter in [low, high] whose point lies closest, by the linear axes (the rotary ones if none is linear).
double closest(const PathSpace& space, const AxisPoint& begin, const AxisPoint& end, const AxisPoint& p, double low = 0,
               double high = 1);

}  // namespace toolcomp::certify
