// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/corner/interference.h"

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
  // fanuc.cutter-c.interference-sweep: An arc block that fanuc.cutter-c.interference-radius does not decide interferes,
  // in the pair q = 0, if the sweep of the tool's arc (fanuc.cutter-c.arc-sweep) differs from the programmed one by
  // more than 180 degrees.
  return recorder.decide(Clause::fanuc_cutter_c_interference_sweep, programmed.up_to_half() ? -gain : gain,
                         run.radii()) == Sign::positive;
}

// Not less than the length, and cheap.
Real bound(const PlanePoint& vector) {
  Real sum;
  for (const Real& component : vector) sum += component.sign() == Sign::negative ? -component : component;
  return sum;
}

}  // namespace

bool arc_interferes(Recorder& recorder, const PathEnd& start, const PathEnd& end, ToolArcRun& run) {
  // fanuc.cutter-c.interference-radius: An arc block interferes, in the pair q = 0, if the offset is larger than its
  // radius at either end. At the start this is R' < 0 with |P - O| and the rho of the corner there; at the end it is R'
  // < 0 with |Q - O| and the rho of the block's own end. The start is asked first.
  const Clause radius = Clause::fanuc_cutter_c_interference_radius;
  const Sign at_start = decide_offset_radius(recorder, radius, start);
  if (at_start == Sign::negative) return true;
  const Sign at_end = decide_offset_radius(recorder, radius, end);
  if (at_end == Sign::negative) return true;
  if (at_start == Sign::zero || at_end == Sign::zero) return false;
  if (run.in_center() || run.turns_as_programmed()) return false;
  return sweeps_far_apart(recorder, run);
}

Real excess(const PathEnd& start, const PathEnd& end) {
  for (const PathEnd* at : {&start, &end})
    if (offset_radius(*at) == Sign::negative) return -at->radius();
  return {};
}

// The tool's path against the programmed one.
bool line_interferes(Recorder& recorder, const OffsetPath& path, const PlanePoint& from, const PlanePoint& to) {
  const Real length2 = path.is_arc() ? squared_norm(path.travel) : path.start.heading.length2;
  const Real length = path.is_arc() ? sqrt(length2) : path.start.heading.length;
  const Real along = length2 + dot(path.travel, to - from);
  const Real scale = length * (length + bound(from) + bound(to));
  // fanuc.cutter-c.interference-direction: A straight block interferes if the tool's direction differs from the
  // programmed one by more than 90 degrees. Exactly 90 degrees, and a tool that does not move, are no interference
  // (ours).
  return recorder.decide(Clause::fanuc_cutter_c_interference_direction, along, scale) == Sign::negative;
}

// The pairs from the inside outwards until one does not interfere.
Passage remove_interference(Recorder& recorder, SpaceGroup& at_start, SpaceGroup& at_end, const Interferes& interferes,
                            bool drops) {
  Passage passage = Passage::free;
  std::size_t from = at_start.size() - 1;
  std::size_t to = 0;
  for (std::size_t pairs = drops ? std::max(at_start.size(), at_end.size()) : 1; pairs > 0; --pairs) {
    const bool first = passage == Passage::free;
    // fanuc.cutter-c.interference-pairs: The check tests pairs of a vector at the start and a vector at the end of the
    // block, from the innermost pair outward. For q = 0, 1, …, max(m, n) - 1 the pair is number max(m - q, 1) of V and
    // number min(1 + q, n) of W, with m and n as at the beginning. The first pair without interference ends the check.
    if (!recorder.decide(Clause::fanuc_cutter_c_interference_pairs, interferes(first, at_start[from], at_end[to]))) {
      at_start.resize(from + 1);
      at_end.erase(at_end.begin(), at_end.begin() + static_cast<std::ptrdiff_t>(to));
      return passage;
    }
    passage = Passage::shortened;
    if (from > 0) --from;
    if (to + 1 < at_end.size()) ++to;
  }
  return Passage::blocked;
}

Passage leave_outer_vectors(SpaceGroup& at_start, SpaceGroup& at_end) {
  if (at_start.size() == 1 && at_end.size() == 1) return Passage::free;
  at_start.resize(1);
  at_end.erase(at_end.begin(), at_end.end() - 1);
  return Passage::shortened;
}

}  // namespace toolcomp::model
