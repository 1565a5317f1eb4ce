// SPDX-License-Identifier: Apache-2.0
// The posture at the end of a block in doubles, where they can tell: away from singular postures and the limits of
// reach.
#include <cmath>

#include "fast/fanuc/tool_posture_control/posture.h"

namespace toolcomp::fast {
namespace {

// The same to within 20 degrees: 90 (1 - cos) for the angle.
double rough_swing(const Vector2<double>& from, const Vector2<double>& to, int branch) {
  const Vector2<double> a{from.x, std::abs(from.y)};
  const Vector2<double> b{to.x, std::abs(to.y)};
  const double angle = 90 - 90 * dot(a, b) / std::sqrt(dot(a, a) * dot(b, b));
  return cross(a, b) < 0 ? branch * angle : -branch * angle;
}

const NearLimit kNoLimit;

}  // namespace

// From `start` to plan.end along their circle.
[[gnu::always_inline]] inline void ToolPostureControl::set_motion_in_doubles(const Pose& start, int azimuth,
                                                                             PosturePlan& plan) const {
  const PolarFrame& polar = machine_.polar();
  const Pose& end = plan.end;
  const bool up = start.seen.z + end.seen.z > 0;
  if (azimuth == 0 && (up ? polar.has_plus() : polar.has_minus())) {
    const Vector2<double> a{start.seen.x, start.seen.y};
    const Vector2<double> b{end.seen.x, end.seen.y};
    const Vector2<double>& heading = dot(a, a) > dot(b, b) ? a : b;
    plan.motion.set_meridian(machine_, start, end, start.branch, up ? 1 : -1, heading * (1 / length(heading)));
  } else {
    plan.motion.set_circle(machine_, start, end, start.branch, azimuth);
  }
}

bool ToolPostureControl::plan_in_doubles(const Pose& start, const Target& target, PosturePlan& plan) const {
  const PolarFrame& polar = machine_.polar();
  if (start.branch == 0) return false;
  Pose& end = plan.end;
  if (target.pose != nullptr) {
    if (target.pose != &end) end = *target.pose;
    if (end.branch == 0) return false;
  } else {
    machine_.set_direction(*target.tool, end);
  }
  const std::size_t t = machine_.tool_side();
  const std::size_t w = machine_.work_side();
  PostureArc<double> arc{start.seen, end.seen, start.relative && end.relative, false};
  // Type 1, the work-side axis standing, orthogonal axes: the tool stays in a plane through the work-side axis.
  arc.meridian = target.pose != nullptr && polar.orthogonal() && start.axis[w].kind == RotaryPosition::Kind::exact &&
                 end.axis[w].kind == RotaryPosition::Kind::exact && start.axis[w].count == end.axis[w].count;
  ArcFindings found;
  if (!find(polar, arc, target.tool != nullptr ? near_ : kNoLimit, found)) [[unlikely]]
    return false;
  if (found.parallel || found.start_pole != 0 || found.end_pole != 0 || found.crossing != 0 || found.near != 0)
    return false;

  PolarPairs pairs;
  if (target.pose == nullptr && polar.solve(end.seen, end.relative, pairs) != Reach::two_pairs) return false;
  if (found.leaves) {
    plan.outcome = PosturePlan::Outcome::unreachable;
    return true;
  }
  // Where the lift ends, to less than half a turn: V(t) turns about the work-side axis by less than that.
  double swung = 0;
  if (!polar.orthogonal()) {
    const auto leaned = [&](const SineCosine<double>& psi) {
      const PolarFrame::Constants<double>& c = polar.constants();
      return Vector2<double>{c.sc * (1 - psi.cosine) + c.skew, -c.sa * psi.sine};
    };
    const Vector2<double> to =
        target.pose != nullptr ? leaned(machine_.psi_of(end)) : Vector2<double>{pairs.hx, pairs.hy};
    swung = rough_swing(leaned(machine_.psi_of(start)), to, start.branch);
  }
  const double near_work = start.axis[w].degrees + machine_.sense(w) * (90 * found.azimuth - swung);
  if (target.pose != nullptr) {
    // Other whole turns, or the other branch: at least half a turn away.
    const double near_tool = start.axis[t].degrees + machine_.sense(t) * (start.branch * std::abs(end.psi) - start.psi);
    if (end.branch != start.branch || std::abs(end.axis[t].degrees - near_tool) > 1 ||
        std::abs(end.axis[w].degrees - near_work) > 180) {
      plan.branch_warning = true;
      conventional(start, end, plan);
      return true;
    }
  } else {
    // psi keeps its sign.
    const double near_tool = start.axis[t].degrees + machine_.sense(t) * (90 * start.branch - start.psi);
    machine_.set_pair(pairs, start.branch, DoublePair{near_tool, near_work}, end);
    if (!ends_in_range(end)) [[unlikely]] {
      plan.outcome = PosturePlan::Outcome::unreachable;
      return true;
    }
  }
  set_motion_in_doubles(start, found.azimuth, plan);
  return true;
}

}  // namespace toolcomp::fast
