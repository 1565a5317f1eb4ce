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

// What is left of the vectors: at the start those up to this one, at the end those from this one on.
void leave(SpaceGroup& at_start, SpaceGroup& at_end, std::size_t from, std::size_t to) {
  at_start.resize(from + 1);
  at_end.erase(at_end.begin(), at_end.begin() + static_cast<std::ptrdiff_t>(to));
}

// Not less than the length, and cheap.
Real bound(const PlanePoint& vector) {
  Real sum;
  for (const Real& component : vector) sum += component.sign() == Sign::negative ? -component : component;
  return sum;
}

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

// By how much the offset is larger than the radius: at the start, or where it is not, at the end; 0: at neither.
Real excess(const PathEnd& start, const PathEnd& end) {
  for (const PathEnd* at : {&start, &end})
    if (offset_radius(*at) == Sign::negative) return -at->radius();
  return {};
}

}  // namespace

// The tool's path against the programmed one.
WayAlong way_along(const OffsetPath& path, const PlanePoint& from, const PlanePoint& to) {
  const Real length2 = path.is_arc() ? squared_norm(path.travel) : path.start.heading.length2;
  const Real length = path.is_arc() ? sqrt(length2) : path.start.heading.length;
  return {length2 + dot(path.travel, to - from), length * (length + bound(from) + bound(to)), length2};
}

// fanuc.cutter-c.interference-at-once: With No. 5008 bit 3, CNV, at 1, cutter compensation C on series 30i drops no
// vector. The first pair with interference is then the last one, so PS0041 comes at once. On series 16i the bit means
// nothing.
// fanuc.cutter-c.interference-without-alarm: With No. 5008 bit 1, CNC, at 1, cutter compensation C raises no alarm if
// the last pair interferes because the directions differ by 90 to 270 degrees (fanuc.cutter-c.interference-direction).
// The block then runs between the vectors that are left.
// fanuc.cutter-c.interference-straightened: An arc block that has interfered in its first pair is a straight block from
// then on. The next pairs are tested as for a line from P to Q. The block's own move is linear, from the last vector
// left at its start to the first vector left at its end, with the block's feed; the cause is programmed.
Checked check_interference(Recorder& recorder, const InterferenceRules& rules, const CheckedPath& path,
                           SpaceGroup& at_start, SpaceGroup& at_end, ToolArcRun* run) {
  std::size_t from = at_start.size() - 1;
  std::size_t to = 0;
  bool by_direction = run == nullptr;
  WayAlong way;
  const auto interferes = [&] {
    if (!by_direction) return arc_interferes(recorder, path.start, path.end, *run);
    way = path.along(at_start[from].vector, at_end[to].vector);
    // fanuc.cutter-c.interference-direction: A straight block interferes if the tool's direction differs from the
    // programmed one by more than 90 degrees. Exactly 90 degrees, and a tool that does not move, are no interference
    // (ours).
    return recorder.decide(Clause::fanuc_cutter_c_interference_direction, way.product, way.scale) == Sign::negative;
  };
  const std::size_t pairs = rules.keeps_vectors ? 1 : std::max(at_start.size(), at_end.size());
  for (std::size_t q = 0; q < pairs; ++q) {
    if (q > 0) {
      by_direction = true;
      if (from > 0) --from;
      if (to + 1 < at_end.size()) ++to;
    }
    const bool found = interferes();
    if (q == 0 && found && rules.by_parameters)
      recorder.decide(Clause::fanuc_cutter_c_interference_at_once, rules.keeps_vectors);
    // fanuc.cutter-c.interference-pairs: The check tests pairs of a vector at the start and a vector at the end of the
    // block, from the innermost pair outward. For q = 0, 1, …, max(m, n) - 1 the pair is number max(m - q, 1) of V and
    // number min(1 + q, n) of W, with m and n as at the beginning. The first pair without interference ends the check.
    if (recorder.decide(Clause::fanuc_cutter_c_interference_pairs, found)) continue;
    if (q == 0) return {};
    recorder.decide(Clause::fanuc_cutter_c_interference_straightened, run != nullptr);
    leave(at_start, at_end, from, to);
    return {Passage::shortened, {}};
  }
  if (!by_direction || !rules.by_parameters ||
      !recorder.decide(Clause::fanuc_cutter_c_interference_without_alarm, rules.no_alarm))
    return {Passage::blocked, by_direction ? -way.product / sqrt(way.length2) : excess(path.start, path.end)};
  if (pairs == 1) return {};
  recorder.decide(Clause::fanuc_cutter_c_interference_straightened, run != nullptr);
  leave(at_start, at_end, 0, at_end.size() - 1);
  return {Passage::shortened, {}};
}

}  // namespace toolcomp::model
