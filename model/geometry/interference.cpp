#include "model/geometry/interference.h"

#include <algorithm>

namespace toolcomp::model {
namespace {

// Sweeps of up to 360° differ by more than 180° only if one is over a half circle and the other is not: L - S > 180
// where sin(S - L) is positive.
bool sweeps_far_apart(Recorder& recorder, ToolArcRun& run) {
  const Sweep programmed = run.programmed();
  const Sweep& tool = run.sweep();
  if (programmed.up_to_half() == tool.up_to_half()) return false;
  const Real gain = tool.sine * programmed.cosine - tool.cosine * programmed.sine;
  return recorder.decide(Clause::fanuc_cutter_c_interference_sweep, programmed.up_to_half() ? -gain : gain,
                         run.radii()) == Sign::positive;
}

bool arc_interferes(Recorder& recorder, const OffsetPath& path, ToolArcRun& run) {
  const Clause radius = Clause::fanuc_cutter_c_interference_radius;
  const Sign at_start = decide_offset_radius(recorder, radius, path.start);
  if (at_start == Sign::negative) return true;
  const Sign at_end = decide_offset_radius(recorder, radius, path.end);
  if (at_end == Sign::negative) return true;
  if (at_start == Sign::zero || at_end == Sign::zero) return false;
  if (run.in_center() || run.turns_as_programmed()) return false;
  return sweeps_far_apart(recorder, run);
}

// Not less than the length, and cheap.
Real bound(const PlanePoint& vector) {
  Real sum;
  for (const Real& component : vector) sum += component.sign() == Sign::negative ? -component : component;
  return sum;
}

// The tool's path against the programmed one, end to end.
bool line_interferes(Recorder& recorder, const OffsetPath& path, const CornerVector& from, const CornerVector& to) {
  const Real length2 = path.is_arc() ? squared_norm(path.travel) : path.start.heading.length2;
  const Real length = path.is_arc() ? sqrt(length2) : path.start.heading.length;
  const Real along = length2 + dot(path.travel, to.vector - from.vector);
  const Real scale = length * (length + bound(from.vector) + bound(to.vector));
  return recorder.decide(Clause::fanuc_cutter_c_interference_direction, along, scale) == Sign::negative;
}

}  // namespace

Passage remove_interference(Recorder& recorder, const OffsetPath& path, VectorGroup& at_start, VectorGroup& at_end,
                            ToolArcRun* arc) {
  const std::size_t pairs = std::max(at_start.size(), at_end.size());
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    const bool interferes = arc != nullptr && pair == 0
                                ? arc_interferes(recorder, path, *arc)
                                : line_interferes(recorder, path, at_start.back(), at_end.front());
    if (!recorder.decide(Clause::fanuc_cutter_c_interference_pairs, interferes))
      return pair == 0 ? Passage::free : Passage::shortened;
    if (at_start.size() > 1) at_start.pop_back();
    if (at_end.size() > 1) at_end.erase(at_end.begin());
  }
  return Passage::blocked;
}

}  // namespace toolcomp::model
