// SPDX-License-Identifier: Apache-2.0
#include "model/kinematics/pair_choice.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "model/basis/alarm.h"
#include "model/kinematics/mechanism.h"

namespace toolcomp::model {
namespace {

// order(b, a) of angles in different half turns. Of those more than 90 degrees apart nothing else is asked: where they
// are apart by just a half turn that would be hard to prove.
Real order_of_halves(const Angle& a, const Integer& half_of_a, const Angle& b, const Integer& half_of_b) {
  const Integer apart = half_of_b - half_of_a;
  if (abs(apart) == 1 && (a.cosine() * b.cosine() + a.sine() * b.sine()).sign() == Sign::positive) return order(b, a);
  return apart > 0 ? 1 : -1;
}

// Not negative; but where a small move cannot be told from none, it may be, which its cosine does not show.
Angle moving_angle(const Angle& difference) try { return absolute(difference); } catch (const exact::Undecided&) {
  if (difference.cosine().sign() != Sign::positive) throw;
  return difference;
}

}  // namespace

std::optional<PairChoice::Range> PairChoice::range(const spec::Setup& setup, std::uint32_t upper) {
  Range result{parameter(setup, upper + 1), parameter(setup, upper)};
  if (result.lower == 0 && result.upper == 0) return std::nullopt;
  return result;
}

PairChoice::PairChoice(const spec::Setup& setup, const Machine& machine, Recorder& recorder)
    : machine_(machine), recorder_(recorder), reversed_(setup.bit(19608, 5)) {
  constexpr std::uint32_t first_upper = 19741;
  constexpr std::uint32_t second_upper = 19743;
  // The tool-side axis is the first one but on a tool rotation head.
  const bool head = machine.type() == MachineType::head;
  Axis tool{&Pose::tool, range(setup, head ? second_upper : first_upper), {}, {}};
  Axis work{&Pose::work, range(setup, head ? first_upper : second_upper), {}, {}};
  const bool tool_first = (machine.type() == MachineType::table) != reversed_;
  axes_ = tool_first ? std::array{tool, work} : std::array{work, tool};
  // fanuc.tool-center-point.choice-first-move: First step: the smaller moving angle of the axis judged first counts,
  // over both pairs and the turns down and up, but only in range. Two moving angles in different half turns are
  // compared by the half turns, others by cosines.
  axes_[0].move = Clause::fanuc_tool_center_point_choice_first_move;
  // fanuc.tool-center-point.choice-second-move: Second step: of the candidates left, the smaller moving angle of the
  // other axis counts.
  axes_[1].move = Clause::fanuc_tool_center_point_choice_second_move;
  // fanuc.tool-center-point.choice-first-near-zero: Third step: nearness to 0 of the axis judged first counts. Nearer
  // means the smaller absolute value after wrapping to (-180, 180].
  axes_[0].near_zero = Clause::fanuc_tool_center_point_choice_first_near_zero;
  // fanuc.tool-center-point.choice-second-near-zero: Fourth step: nearness to 0 of the other axis counts in the same
  // way.
  axes_[1].near_zero = Clause::fanuc_tool_center_point_choice_second_near_zero;
}

void PairChoice::require_ranges() const {
  // fanuc.tool-center-point.range-order: 19741 and 19742 are the upper and the lower limit of the first rotary axis for
  // type 2 (G43.5), 19743 and 19744 those of the second. An axis whose limits are both 0, or not given, has no limit.
  // That the parameters come in this order is a recollection.
  for (const Axis& axis : axes_)
    if (axis.range && axis.range->lower > axis.range->upper)
      raise(recorder_, Clause::fanuc_tool_center_point_range_order, AlarmCause::rotary_limits);
}

bool PairChoice::within(const Axis& axis, const Angle& position) const {
  if (!axis.range) return true;
  const auto not_negative = [this](const Real& quantity) {
    // fanuc.tool-center-point.range: Under G43.5 a position counts only if it is in the range of its axis. An axis with
    // a range does not take the short way through 0 and 360. The limits themselves are in range (ours). Asked of each
    // limit of each axis with a range.
    return recorder_.decide(Clause::fanuc_tool_center_point_range, quantity, 1) != Sign::negative;
  };
  return not_negative(order(axis.range->upper, position)) && not_negative(order(position, axis.range->lower));
}

bool PairChoice::inside(const Pose& pose) const {
  return std::ranges::all_of(axes_, [&](const Axis& axis) { return within(axis, pose.*axis.position); });
}

void PairChoice::require_inside(const Pose& pose) const {
  // fanuc.tool-center-point.range-none: PS5459 is raised if no pair has both axes in range. With posture control it is
  // also raised if the end pair is out of range, because the branch is not free there.
  if (!inside(pose)) raise(recorder_, Clause::fanuc_tool_center_point_range_none, AlarmCause::unreachable);
}

PairChoice::Targets PairChoice::targets(const Axis& axis, const Angle& angle, const Angle& present) const {
  Targets result;
  const Angle nearest = angle.plus_turns(-(angle - present).nearest_turns());
  result.at[0] = nearest;
  result.count = 1;
  if (axis.range && !within(axis, nearest)) {
    // The nearest in range: the greatest below the upper limit, or the least above the lower one.
    const Angle limit = nearest > Angle(axis.range->upper) ? axis.range->upper : axis.range->lower;
    const bool down = nearest > limit;
    const Integer turns = down ? (limit - nearest).whole_turns() : -(nearest - limit).whole_turns();
    result.at[0] = nearest.plus_turns(turns);
    if (!within(axis, result.at[0])) result.count = 0;
    result.move = absolute(result.at[0] - present);
    return result;
  }
  result.move = moving_angle(nearest - present);
  add_other_way(axis, present, result);
  return result;
}

// Of a pair that is not taken nobody asks by which turns it would be reached: just half a turn from the present
// position that may be hard to prove, and cosines tell the pairs apart without it.
PairChoice::Targets PairChoice::targets_or_open(const Axis& axis, const Angle& angle, const Angle& present) const try {
  return targets(axis, angle, present);
} catch (const exact::Undecided&) {
  if (axis.range) throw;
  const Real cosine = angle.cosine() * present.cosine() + angle.sine() * present.sine();
  const Real sine = angle.sine() * present.cosine() - angle.cosine() * present.sine();
  return {{angle, {}}, 1, Angle::known(cosine, sine, 0), true};
}

const Angle& PairChoice::greatest(const Targets& targets) const {
  if (targets.open) {
    recorder_.reach(Clause::fanuc_tool_center_point_choice);  // names what is not decided
    throw exact::Undecided();
  }
  return targets.count == 2 && targets.at[1] > targets.at[0] ? targets.at[1] : targets.at[0];
}

void PairChoice::add_other_way(const Axis& axis, const Angle& present, Targets& targets) const {
  // Only a move of almost half a turn needs to be asked about.
  const Real excess = order(180, targets.move);
  if (excess.is_rational() && excess == Real(1)) return;
  const bool up = targets.at[0] > present;
  const Angle other = targets.at[0].plus_turns(up ? -1 : 1);
  const Sign nearer = recorder_.decide(axis.move, excess, 1);
  if (nearer == Sign::positive || !within(axis, other)) return;
  if (nearer == Sign::zero) ++targets.count;
  targets.at.at(targets.count - 1) = other;
}

PairChoice::Targets PairChoice::standing(const Axis& axis, const Angle& present) const {
  Targets result;
  result.at[0] = present;
  result.count = 1;
  if (!within(axis, present)) {
    result.at[0] = present > Angle(axis.range->upper) ? axis.range->upper : axis.range->lower;
    result.move = absolute(result.at[0] - present);
  }
  return result;
}

bool PairChoice::are_alike(const Axis& axis, const Angle& about) const {
  if (axis.position != &Pose::tool) return false;
  try {
    return branch_quantity(machine_, about).sign() == Sign::zero;
  } catch (const exact::Undecided&) {
    return false;
  }
}

// By half turns first, which only a range can tell apart; within one half turn the cosine falls, within the next it
// rises.
Sign PairChoice::compare_moves(const Axis& axis, const Targets& a, const Targets& b, const Angle& present) const {
  Real quantity;
  if (axis.range || !are_alike(axis, present)) quantity = a.move.cosine() - b.move.cosine();
  if (axis.range) {
    const auto half_turns = [](const Angle& move) {
      const Integer turns = move.whole_turns();
      return 2 * turns + (move.plus_turns(-turns) > Angle(180) ? 1 : 0);
    };
    const Integer of_a = half_turns(a.move);
    const Integer of_b = half_turns(b.move);
    if (of_a != of_b)
      quantity = 2 * order_of_halves(a.move, of_a, b.move, of_b);
    else if (of_a % 2 != 0)
      quantity = -quantity;
  }
  return -recorder_.decide(axis.move, quantity, 2);
}

Sign PairChoice::compare_nearness(const Axis& axis, const Targets& a, const Targets& b) const {
  Real quantity;
  if (!are_alike(axis, 0)) quantity = a.at[0].cosine() - b.at[0].cosine();
  return -recorder_.decide(axis.near_zero, quantity, 2);
}

bool PairChoice::takes_second(const Candidate& a, const Candidate& b, const Pose& present) const {
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (const Sign sign = compare_moves(axes_.at(i), a.targets.at(i), b.targets.at(i), present.*axes_.at(i).position);
        sign != Sign::zero)
      return sign == Sign::positive;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (const Sign sign = compare_nearness(axes_.at(i), a.targets.at(i), b.targets.at(i)); sign != Sign::zero)
      return sign == Sign::positive;
  // fanuc.tool-center-point.choice-tie: If several candidates are left after the fourth step, the greater position of
  // the axis judged first counts, then that of the other axis. Positions count with sign and whole turns.
  recorder_.reach(Clause::fanuc_tool_center_point_choice_tie);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const Targets& of_a = a.targets.at(i);
    const Targets& of_b = b.targets.at(i);
    const Sign sign = order(greatest(of_a), greatest(of_b)).sign();
    if (sign != Sign::zero) return sign == Sign::negative;
  }
  return false;
}

void PairChoice::put(const Pose& pose, Solutions& solutions) const {
  if (solutions.work_free) return;
  const bool on_edge = solutions.count == 1;
  const int branch = on_edge ? 0 : branch_of(machine_, pose.tool);
  for (std::size_t i = 0; i < solutions.count; ++i) {
    Pose& of_pair = solutions.at.at(i).pose;
    if (solutions.at.at(i).branch == branch) {
      of_pair = {pose.tool.principal(), pose.work.principal()};
    } else if (machine_.is_orthogonal()) {
      const Angle& singular = machine_.singular(1)->tool;
      of_pair = {((singular - pose.tool) + singular).principal(), (pose.work + 180).principal()};
    }
  }
}

void PairChoice::put_present(const Pose& present, Sign has_it, Solutions& solutions) const {
  if (has_it == Sign::positive) put(present, solutions);
  if (has_it == Sign::negative && machine_.is_orthogonal()) put({present.tool + 180, present.work}, solutions);
}

Solution PairChoice::choose(const Direction& direction, const Pose& present) const {
  return choose(inverse(machine_, recorder_, direction), present, Sign::zero);
}

Solution PairChoice::choose(Solutions solutions, const Pose& present, Sign has_it) const {
  put_present(present, has_it, solutions);
  // fanuc.tool-center-point.choice: The pair is chosen in four steps among the two pairs and all whole turns of each
  // axis. Each step keeps only the candidates that are best in it: the smallest moving angle, from the present
  // position, of the axis judged first; then that of the other axis; then the axis judged first nearest to 0; then the
  // other axis nearest to 0.
  recorder_.reach(Clause::fanuc_tool_center_point_choice);
  // fanuc.tool-center-point.choice-order: On tool rotation and table rotation machines the first axis is judged first,
  // on the mixed type the second axis, which is the table axis. PRI (19608#5) = 1 reverses the order.
  recorder_.decide(Clause::fanuc_tool_center_point_choice_order, reversed_);
  std::vector<Candidate> candidates;
  for (const Solution& solution : solutions) {
    Candidate candidate{solution, {}};
    bool in_range = true;
    for (std::size_t i = 0; i < axes_.size() && in_range; ++i) {
      const Axis& axis = axes_.at(i);
      const Angle& now = present.*axis.position;
      const bool stands = solutions.work_free && axis.position == &Pose::work;
      candidate.targets.at(i) = stands ? standing(axis, now) : targets_or_open(axis, solution.pose.*axis.position, now);
      in_range = candidate.targets.at(i).count != 0;
    }
    if (in_range) candidates.push_back(std::move(candidate));
  }
  if (candidates.empty()) raise(recorder_, Clause::fanuc_tool_center_point_range_none, AlarmCause::unreachable);
  const bool second = candidates.size() == 2 && takes_second(candidates[0], candidates[1], present);
  const Candidate& taken = candidates.at(second ? 1 : 0);
  Solution result = taken.solution;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const Targets& of_axis = taken.targets.at(i);
    if (of_axis.count == 2) recorder_.reach(Clause::fanuc_tool_center_point_choice_tie);
    result.pose.*axes_.at(i).position = greatest(of_axis);
  }
  return result;
}

}  // namespace toolcomp::model
