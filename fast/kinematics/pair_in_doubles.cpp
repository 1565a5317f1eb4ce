// SPDX-License-Identifier: Apache-2.0
// The choice of the pair of rotary positions in doubles, where they can tell: one is nearer, and inside the movement
// ranges.
#include <algorithm>
#include <cmath>

#include "fast/kinematics/machine.h"
#include "fast/kinematics/unit_angle.h"

namespace toolcomp::fast {

[[gnu::always_inline]] inline DoublePair Machine::set_pair_here(const PolarPairs& pairs, int branch, DoublePair near,
                                                                Pose& pose) const {
  const SineCosine<double> psi{branch < 0 ? -pairs.sin_psi : pairs.sin_psi, pairs.cos_psi};
  const SineCosine<double> work = pairs.work(branch);
  const DoublePair angles = unit_angle(DoublePair{psi.sine, work.sine}, DoublePair{psi.cosine, work.cosine});
  pose.psi = angles[0];
  pose.branch = branch < 0 ? -1 : 1;
  const DoublePair basic = DoublePair{polar_.phase_degrees() + angles[0], angles[1]} *
                           DoublePair{axis_[tool_side_].sense, axis_[work_side()].sense};
  constexpr double kShift = 0x1.8p52;
  const DoublePair turned = (near - basic) * (1.0 / 360) + kShift;
  DoublePair degrees = basic + 360.0 * (turned - kShift);
  const auto set = [&](RotaryPosition& tool_axis, RotaryPosition& work_axis) {
    tool_axis.degrees = degrees[0];
    work_axis.degrees = degrees[1];
    tool_axis.kind = work_axis.kind = RotaryPosition::Kind::inverse;
    set_turns(psi, work, tool_axis.turn, work_axis.turn);
  };
  // Not by index, as in turns_of().
  if (tool_side_ == 0)
    set(pose.axis[0], pose.axis[1]);
  else
    set(pose.axis[1], pose.axis[0]);
  return degrees - near;
}

DoublePair Machine::set_pair(const PolarPairs& pairs, int branch, DoublePair near, Pose& pose) const {
  return set_pair_here(pairs, branch, near, pose);
}

// By half the difference of the cosines of the moves.
[[gnu::always_inline]] inline int Machine::nearer(const PolarPairs& pairs, const Pose& present) const {
  const SineCosine<double>& at = present.axis[judged_first_].turn;
  const double sine = axis_[judged_first_].sense * at.sine;
  const SineCosine<double>& phase = polar_.constants().phase;
  const double gain = judged_first_ == tool_side_ ? pairs.sin_psi * (sine * phase.cosine - at.cosine * phase.sine)
                                                  : -(sine * pairs.apart[0] + at.cosine * pairs.apart[1]);
  // Positions differ by more than 1e-10 degrees then.
  constexpr double kSure = 0x1p-38;
  return gain > kSure ? 1 : (gain < -kSure ? -1 : 0);
}

[[gnu::always_inline]] inline bool Machine::choose_in_doubles(const Direction& tool, const Pose& present,
                                                              Pose& end) const {
  set_direction(tool, end);
  PolarPairs pairs;
  if (polar_.solve(end.seen, end.relative, pairs) != Reach::two_pairs) [[unlikely]]
    return false;
  // One pair is nearer in the axis judged first, by more than any rounding.
  const int branch = nearer(pairs, present);
  if (branch == 0) [[unlikely]]
    return false;
  const DoublePair near{present.axis[tool_side_].degrees, present.axis[work_side()].degrees};
  const DoublePair move = set_pair_here(pairs, branch, near, end);
  // Half a turn either way is a tie, and so is a limit.
  const double slack = 1e-10 + 0x1p-45 * (std::abs(near[0]) + std::abs(near[1]));
  if (std::max(std::abs(move[0]), std::abs(move[1])) > 180 - slack) [[unlikely]]
    return false;
  for (std::size_t i = 0; i < 2; ++i)
    if (axis_[i].limited &&
        (end.axis[i].degrees < axis_[i].least + slack || end.axis[i].degrees > axis_[i].most - slack)) [[unlikely]]
      return false;
  return true;
}

bool Machine::choose(const Direction& tool, const Pose& present, Pose& end) const {
  return choose_in_doubles(tool, present, end) || choose_fine(tool, present, end);
}

}  // namespace toolcomp::fast
