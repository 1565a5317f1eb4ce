// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_posture_control/posture.h"

#include <cmath>
#include <string>

#include "spec/language/input_error.h"

namespace toolcomp::fast {
namespace {

Count angle(const spec::Setup& setup, std::uint32_t number) {
  const auto value = setup.parameter(number);
  if (!value) return {};
  if (!fits_count(*value))
    throw spec::InputError("setup", 0, 0, "parameters.\"" + std::to_string(number) + "\": is too large");
  return Count::of(*value);
}

constexpr Int128 kTurn = 360 * Count::kRestPerOne;
constexpr Int128 kHalf = kTurn / 2;
// Positions nearer than this are the same: 8e-18 degrees.
constexpr Int128 kSlack = 1024;

Int128 magnitude(Int128 x) { return x < 0 ? -x : x; }
Int128 signed_by(double sense, Int128 x) { return sense < 0 ? -x : x; }
// x in [-180, 180) modulo whole turns.
Int128 wrapped(Int128 x) {
  Int128 rest = (x + kHalf) % kTurn;
  if (rest < 0) rest += kTurn;
  return rest - kHalf;
}
// The count that is `value` modulo whole turns and nearest to `near`.
Count nearest_turn(const Count& value, Int128 near) { return Count::of_units(near + wrapped(value.units() - near)); }

// How far the azimuth of c(psi) swings on one branch, from one horizontal part to another: on the positive branch they
// point into y <= 0, on the negative one into y >= 0, so exactly opposite ones have a sign too.
double swing(const Vector2<double>& from, const Vector2<double>& to, int branch) {
  return -branch * (arctangent(std::abs(to.y), to.x) - arctangent(std::abs(from.y), from.x));
}

const NearLimit kNoLimit;

}  // namespace

// A block whose decisions are made in double-double.
struct ToolPostureControl::FineArc {
  const Pose& start;
  const Target& target;
  Vector3<DoubleDouble> s, e;
  PolarRoots roots;           // of the end
  Reach reach = Reach::none;  // of the end
  ArcFindings found;
  std::array<Int128, 2> from;  // positions at the start
  int branch = 0;              // at the start
  Int128 psi = 0;              // at the start, with that branch at 180
};

ToolPostureControl::ToolPostureControl(const spec::Setup& setup, const Machine& machine)
    : machine_(machine),
      by_default_(setup.bit(19604, 0)),
      refusal_alarms_(setup.bit(19696, 3)),
      veto_(angle(setup, 19739)) {
  const Count limit = angle(setup, 19738);
  near_.counts = Count() < limit;
  near_.above_90 = Count::of(spec::decimal(90)) < limit;
  near_.above_180 = Count::of(spec::decimal(180)) < limit;
  near_.fine = fine_sine_cosine(limit);
  near_.square = (near_.fine.sine * near_.fine.sine).hi;
  near_.cosine = near_.fine.cosine.hi;
}

void ToolPostureControl::begin(PosturePlan& plan) {
  plan.outcome = PosturePlan::Outcome::good;
  plan.branch_warning = false;
  plan.changed = false;
  plan.pre_turn = false;
  plan.post_turn = false;
}

void ToolPostureControl::stand(const Pose& start, PosturePlan& plan) const {
  begin(plan);
  plan.end = start;
  plan.motion.set_still(machine_, start);
}

void ToolPostureControl::conventional(const Pose& start, const Pose& end, PosturePlan& plan) const {
  plan.motion.set_linear(machine_, start, end);
}

void ToolPostureControl::plan(const Pose& start, const Pose& commanded, bool posture, PosturePlan& plan) const {
  begin(plan);
  if (!posture || !machine_.invertible()) {
    if (&commanded != &plan.end) plan.end = commanded;
    conventional(start, plan.end, plan);
    return;
  }
  const Target target{&commanded, nullptr};
  if (!plan_in_doubles(start, target, plan)) plan_finely(start, target, plan);
}

void ToolPostureControl::plan(const Pose& start, const Direction& tool, bool posture, PosturePlan& plan) const {
  begin(plan);
  if (!machine_.invertible()) {
    plan.outcome = PosturePlan::Outcome::unreachable;
    return;
  }
  const Target target{nullptr, &tool};
  if (posture && !stays(start, tool)) {
    if (!plan_in_doubles(start, target, plan)) plan_finely(start, target, plan);
    return;
  }
  if (machine_.choose(tool, start, plan.end))
    conventional(start, plan.end, plan);
  else
    plan.outcome = PosturePlan::Outcome::unreachable;
}

// A direction that is commanded again: no plane, and fanuc.tool-center-point.choice keeps the pose.
bool ToolPostureControl::stays(const Pose& start, const Direction& tool) {
  return start.tool.is_whole && tool.is_whole && start.tool.whole() == tool.whole();
}

// From one edge of reach to the other, which may be a singular posture; 1 where both are one edge.
int ToolPostureControl::branch_toward(const Pose& from, const Pose& to) const {
  constexpr double kQuarter = 90;
  const bool near = std::abs(from.psi) < kQuarter;
  if (near == (std::abs(to.psi) < kQuarter)) return 1;
  const std::size_t t = machine_.tool_side();
  const bool up = (to.axis[t].degrees > from.axis[t].degrees) == (machine_.sense(t) > 0);
  return up == near ? 1 : -1;
}

void ToolPostureControl::mismatch(const FineArc& arc, PosturePlan& plan) const {
  plan.branch_warning = true;
  conventional(arc.start, plan.end, plan);
}

void ToolPostureControl::plan_finely(const Pose& start, const Target& target, PosturePlan& plan) const {
  const PolarFrame& polar = machine_.polar();
  const bool commanded = target.pose != nullptr;
  FineArc arc{start, target, machine_.fine_seen(start.tool), {}, {}, Reach::none, {}, {}, start.branch, 0};
  arc.e = machine_.fine_seen(commanded ? target.pose->tool : *target.tool);
  arc.reach = polar.solve(arc.e, arc.roots);
  if (!commanded && arc.reach == Reach::none) {
    plan.outcome = PosturePlan::Outcome::unreachable;
    return;
  }
  (void)find(polar, PostureArc<DoubleDouble>{arc.s, arc.e}, commanded ? kNoLimit : near_, arc.found);
  if (commanded && target.pose != &plan.end) plan.end = *target.pose;

  // The pair by fanuc.tool-center-point.choice, where no branch is to be followed.
  const bool singular = arc.found.start_pole != 0;
  const bool chosen = arc.found.parallel || singular || start.branch == 0;
  if (chosen && !commanded && !machine_.choose(*target.tool, start, plan.end)) {
    plan.outcome = PosturePlan::Outcome::unreachable;
    return;
  }
  if (arc.found.parallel) {
    conventional(start, plan.end, plan);
    return;
  }
  for (std::size_t i = 0; i < 2; ++i) arc.from[i] = machine_.count(start, i).units();
  if (arc.branch == 0) arc.branch = plan.end.branch != 0 ? plan.end.branch : branch_toward(start, plan.end);
  const std::size_t t = machine_.tool_side();
  arc.psi = wrapped(signed_by(machine_.sense(t), arc.from[t]) - polar.phase().units());
  // At 180 on the side of the branch.
  if (magnitude(arc.psi) >= kHalf - kSlack) arc.psi = arc.branch * magnitude(arc.psi);
  if (arc.found.leaves)
    plan.outcome = PosturePlan::Outcome::unreachable;
  else if (singular)
    from_singular(arc, plan);
  else if (arc.found.end_pole != 0)
    to_singular(arc, plan);
  else
    along(arc, plan);
}

namespace {

// The azimuth of the tool, horizontal unit vector.
Vector2<double> heading_of(const Vector3<DoubleDouble>& v) {
  const DoubleDouble length = sqrt(v.x * v.x + v.y * v.y);
  return {(v.x / length).hi, (v.y / length).hi};
}

// How far the azimuth of c(psi) is from where it goes in a singular posture, on the branch: (hx, hy) turned by 90 b.
Count from_limit(const DoubleDouble& hx, const DoubleDouble& hy, int branch) {
  return branch > 0 ? fine_arctangent(hx, -hy) : fine_arctangent(-hx, hy);
}

}  // namespace

// The great circle followed back from the end to a singular start.
void ToolPostureControl::from_singular(const FineArc& arc, PosturePlan& plan) const {
  const std::size_t t = machine_.tool_side();
  const std::size_t w = machine_.work_side();
  const Pose& end = plan.end;
  const int pole = arc.found.start_pole;
  const Int128 end_tool = signed_by(machine_.sense(t), machine_.count(end, t).units());
  const Int128 end_psi = wrapped(end_tool - machine_.polar().phase().units());
  // At 180, the edge of reach, the branch that leads back to the start.
  int branch = end.branch;
  const auto led_back = [&](int b) {
    const Int128 psi = magnitude(end_psi) >= kHalf - kSlack ? b * magnitude(end_psi) : end_psi;
    return end_tool - (psi - (pole > 0 ? Int128{0} : b * kHalf));
  };
  const Int128 start_tool = signed_by(machine_.sense(t), arc.from[t]);
  const auto reaches = [&](int b) { return magnitude(led_back(b) - start_tool) < Count::kRestPerOne; };
  if (branch == 0) branch = reaches(1) ? 1 : -1;
  if (!reaches(branch)) {
    mismatch(arc, plan);
    return;
  }
  const DoubleDouble hy = branch < 0 ? -arc.roots.hy : arc.roots.hy;
  const Int128 swung = from_limit(arc.roots.hx, hy, branch).units();
  const Int128 work = machine_.count(end, w).units() + signed_by(machine_.sense(w), swung);
  plan.turned = arc.start;
  if (magnitude(work - arc.from[w]) > kSlack) {
    plan.pre_turn = true;
    if (swung == 0) {
      plan.turned.axis[w] = end.axis[w];
      if (end.axis[w].kind == RotaryPosition::Kind::inverse)
        machine_.set_rounded(plan.turned, w, Count::of_units(work));
    } else {
      machine_.set_rounded(plan.turned, w, Count::of_units(work));
    }
  }
  plan.motion.set_meridian(machine_, plan.turned, end, branch, pole, heading_of(arc.e));
}

void ToolPostureControl::to_singular(const FineArc& arc, PosturePlan& plan) const {
  const PolarFrame& polar = machine_.polar();
  const std::size_t t = machine_.tool_side();
  const std::size_t w = machine_.work_side();
  const int pole = arc.found.end_pole;
  const Int128 end_psi = pole > 0 ? Int128{0} : arc.branch * kHalf;
  const Int128 tool = arc.from[t] + signed_by(machine_.sense(t), end_psi - arc.psi);
  PolarRoots roots;
  (void)polar.solve(arc.s, roots);
  const DoubleDouble hy = arc.branch < 0 ? -roots.hy : roots.hy;
  const Int128 swung = from_limit(roots.hx, hy, arc.branch).units();
  const Int128 work = arc.from[w] + signed_by(machine_.sense(w), swung);
  const Vector2<double> heading = heading_of(arc.s);
  if (arc.target.pose != nullptr) {
    if (magnitude(machine_.count(plan.end, t).units() - tool) > Count::kRestPerOne) {
      mismatch(arc, plan);
      return;
    }
    plan.post_turn = magnitude(machine_.count(plan.end, w).units() - work) > kSlack;
    plan.arrived = plan.end;
    if (plan.post_turn) {
      plan.arrived.axis[w] = arc.start.axis[w];
      if (swung != 0 || arc.start.axis[w].kind == RotaryPosition::Kind::inverse)
        machine_.set_rounded(plan.arrived, w, Count::of_units(work));
    }
    plan.motion.set_meridian(machine_, arc.start, plan.arrived, arc.branch, pole, heading);
    return;
  }
  Pose& end = plan.end;
  Machine::set_direction(*arc.target.tool, arc.e, end);
  machine_.set_rounded(end, t, Count::of_units(tool));
  end.axis[w] = arc.start.axis[w];
  if (swung != 0 || end.axis[w].kind == RotaryPosition::Kind::inverse)
    machine_.set_rounded(end, w, Count::of_units(work));
  machine_.set_branch(end);
  if (!ends_in_range(end)) {
    plan.outcome = PosturePlan::Outcome::unreachable;
    return;
  }
  plan.motion.set_meridian(machine_, arc.start, end, arc.branch, pole, heading);
}

// A block between postures that are not singular: past a singular posture, or exactly through it.
void ToolPostureControl::along(const FineArc& arc, PosturePlan& plan) const {
  const PolarFrame& polar = machine_.polar();
  const std::size_t t = machine_.tool_side();
  const std::size_t w = machine_.work_side();
  const int crossing = arc.found.crossing;
  const int branch = crossing != 0 ? -arc.branch : arc.branch;  // at the end
  const std::array<Count, 2> pair = machine_.fine_pair(arc.roots, branch);
  // psi at the end, as the lift comes there: it passes 0 or 180 where it crosses.
  const Int128 distance = magnitude(fine_arctangent(arc.roots.sin_psi, arc.roots.cos_psi).units());
  const Int128 end_psi = crossing < 0 ? arc.branch * (kTurn - distance) : branch * distance;
  std::array<Count, 2> lifted;
  lifted[t] = nearest_turn(pair[t], arc.from[t] + signed_by(machine_.sense(t), end_psi - arc.psi));
  // The azimuth of c(psi) on its way, with the half turn of a crossing taken off: by less than 180.
  PolarRoots from;
  (void)polar.solve(arc.s, from);
  const double half = crossing != 0 ? -1 : 1;
  const double swung = swing({from.hx.hi, from.hy.hi}, {half * arc.roots.hx.hi, arc.roots.hy.hi}, arc.branch);
  const double estimate = machine_.sense(w) * (90 * arc.found.azimuth - swung);
  const auto by = static_cast<Int128>(estimate * static_cast<double>(Count::kRestPerOne));
  lifted[w] = nearest_turn(pair[w], arc.from[w] + by);

  if (arc.target.pose != nullptr) {
    const auto same = [&](std::size_t i) {
      return magnitude(machine_.count(plan.end, i).units() - lifted[i].units()) < Count::kRestPerOne / 2;
    };
    const bool on_branch = plan.end.branch == 0 || plan.end.branch == branch;
    if (!on_branch || !same(0) || !same(1)) {
      mismatch(arc, plan);
      return;
    }
  } else {
    Machine::set_direction(*arc.target.tool, arc.e, plan.end);
    for (std::size_t i = 0; i < 2; ++i) machine_.set_rounded(plan.end, i, lifted[i]);
    machine_.set_branch(plan.end, branch);
    if (arc.found.near != 0) {
      if (change_end(arc, arc.found.near, plan)) return;
      if (refusal_alarms_) {
        plan.outcome = PosturePlan::Outcome::refused;
        return;
      }
    }
    if (!ends_in_range(plan.end)) {
      plan.outcome = PosturePlan::Outcome::unreachable;
      return;
    }
  }
  const bool up = arc.s.z.hi + arc.e.z.hi > 0;
  if (crossing != 0 || (arc.found.azimuth == 0 && (up ? polar.has_plus() : polar.has_minus()))) {
    const int pole = crossing != 0 ? crossing : (up ? 1 : -1);
    plan.motion.set_meridian(machine_, arc.start, plan.end, arc.branch, pole, heading_of(arc.s));
  } else {
    plan.motion.set_circle(machine_, arc.start, plan.end, arc.branch, arc.found.azimuth);
  }
  plan.motion.refine_circle(arc.s, arc.e);
}

// The end mirrored at the singular position, plan.end being the one it replaces. False: refused.
bool ToolPostureControl::change_end(const FineArc& arc, int pole, PosturePlan& plan) const {
  const PolarFrame& polar = machine_.polar();
  const std::size_t t = machine_.tool_side();
  const std::size_t w = machine_.work_side();
  const Int128 work = machine_.count(plan.end, w).units();
  const Int128 veto = veto_.units();
  if (veto < 0) return false;
  if (magnitude(wrapped(work - arc.from[w] - kHalf)) > veto + kSlack) return false;
  const Int128 singular_psi = pole > 0 ? Int128{0} : arc.branch * kHalf;
  Int128 singular = arc.from[t] + signed_by(machine_.sense(t), singular_psi - arc.psi);
  Pose changed = plan.end;
  machine_.set_rounded(changed, t, Count::of_units(2 * singular - machine_.count(plan.end, t).units()));
  changed.axis[w] = arc.start.axis[w];
  if (changed.axis[w].kind == RotaryPosition::Kind::inverse)
    machine_.set_rounded(changed, w, Count::of_units(arc.from[w]));
  if (!ends_in_range(changed)) return false;

  // c(2 psi_s - psi_e) turned by the work-side axis as it stands.
  const SineCosine<DoubleDouble> turn = machine_.fine_turns(arc.start)[w];
  const DoubleDouble sine = machine_.sense(w) < 0 ? -turn.sine : turn.sine;
  const DoubleDouble hy = arc.branch > 0 ? -arc.roots.hy : arc.roots.hy;
  const DoubleDouble hx = arc.roots.hx;
  const Vector3<DoubleDouble> seen{hx * turn.cosine - hy * sine, hx * sine + hy * turn.cosine, arc.e.z};
  const Vector3<DoubleDouble> on_table = seen_back(polar.fine_constants(), seen);
  // The work-side position is rounded, or as badly known as the azimuth of the tool; (hx, hy) follows from the height
  // of the tool, which near the edge of reach, not on it, tells little about it.
  constexpr double kFine = 0x1p-94;
  const RotaryPosition::Kind kind = arc.start.axis[w].kind;
  double error = kFine + arc.target.tool->refined_error();
  if (!polar.orthogonal() && arc.roots.sin_psi.hi > 0) error /= arc.roots.sin_psi.hi;
  if (kind == RotaryPosition::Kind::rounded) error += RotaryPosition::kRounded;
  if (kind == RotaryPosition::Kind::inverse)
    error += (arc.start.tool.refined_error() + kFine) / std::hypot(arc.s.x.hi, arc.s.y.hi);
  error += machine_.kinematics().frame().fine_error;
  Machine::set_direction(fine_direction(machine_.fine_in_frame(on_table), error), seen, changed);
  machine_.set_branch(changed, -arc.branch);
  plan.end = changed;
  plan.changed = true;
  conventional(arc.start, plan.end, plan);
  return true;
}

}  // namespace toolcomp::fast
