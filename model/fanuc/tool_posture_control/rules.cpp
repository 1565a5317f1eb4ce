// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_posture_control/rules.h"

#include "model/basis/alarm.h"
#include "model/kinematics/inverse.h"
#include "model/kinematics/mechanism.h"

namespace toolcomp::model {
namespace {

// Of the distance from the axis to the great circle, at the foot. Both ends at right angles to the axis: so is all of
// the circle; that the difference below is zero then would have to be proven.
Real cosine_at_foot(const AxisPassed& work_axis) {
  if (known_zero(work_axis.along_from) && known_zero(work_axis.along_to)) return {};
  return sqrt(1 - square(work_axis.side) / work_axis.arc.normal2());
}

}  // namespace

// fanuc.tool-posture.no-plane: If Vs and Ve are equal or opposite, there is no plane, and the block runs under
// conventional control. It goes to the pair of fanuc.tool-center-point.choice (type 2) or to the one commanded (type
// 1). The test is exact. The questions of the later clauses are then not asked.
bool PostureRules::spans_plane(const Direction& from, const Direction& to) const {
  const bool same = known_same(from.vector, to.vector);
  const Real normal2 = same ? Real() : squared_norm(cross(from.vector, to.vector));
  return recorder_.decide(Clause::fanuc_tool_posture_no_plane, normal2, from.norm2 * to.norm2) == Sign::positive;
}

// fanuc.tool-posture.singular: A posture is singular if the tool is parallel to the work-side axis, so that this axis
// may stand anywhere.
PostureRules::PostureRules(const spec::Setup& setup, const Machine& machine, Recorder& recorder)
    : machine_(machine),
      recorder_(recorder),
      poles_(machine.singular_postures()),
      limit_(parameter(setup, 19738)),
      veto_(parameter(setup, 19739)),
      refuses_(setup.bit(19696, 3)) {}

// fanuc.tool-posture.at-start: The question whether the block starts in a singular posture is asked of +u_w, then of
// -u_w, as far as they exist.
// fanuc.tool-posture.at-end: The question whether the block ends in a singular posture is asked of +u_w, then of -u_w,
// of a block that does not start in one.
const SingularPosture* PostureRules::pole_along(Clause clause, const Vector& axis, const Direction& direction) const {
  for (const SingularPosture& pole : poles_) {
    if (recorder_.decide(clause, squared_norm(cross(axis, direction.vector)), direction.norm2) == Sign::positive)
      continue;
    if ((pole.side * dot(axis, direction.vector)).sign() == Sign::positive) return &pole;
  }
  return nullptr;
}

// fanuc.tool-posture.pre-turn: The turn at a singular start is a move of its own just before the own move of the block,
// and after all moves inserted there. Its cause is pre-turn, and it has the feed of the block. It is rapid if the block
// is rapid, otherwise linear. Only the work-side axis turns, and X Y Z follow while the tip stands. The programmed end
// is that of the start of the block, the point is where the tip is, and the tool axis stays. With WKP = 0 the tip is at
// the start; with WKP = 1 it stands on the table, which turns it. The move is made only if the position changes.
// fanuc.tool-posture.post-turn: In type 1, at a singular end, the work-side axis turns to its commanded position if
// that differs from the one that it has reached. It turns in one move just after the own move of the block, before
// every inserted move, and the cause is post-turn. The programmed end is that of the block, the point is where the tip
// is, and the tool axis stays. With WKP = 1 the path ends at the point of the table that the turn brings to the
// programmed place, and the point of the block's own move is where that point is before the turn. Kind and feed are
// those of fanuc.tool-posture.pre-turn.
bool PostureRules::turns(Clause clause, const Angle& to, const Angle& from) const {
  return recorder_.decide(clause, order(to, from), 1) != Sign::zero;
}

// fanuc.tool-posture.branch: The branch is the side on which the tool-side angle lies, seen from the angle at which the
// tool is nearest to u_w, given as a sign. It is kept through the block, even if the edge of reach is touched inside. A
// start on the edge of reach that is not singular has no branch. Then the branch is the one toward the pair of
// fanuc.tool-center-point.choice (type 1: toward the pair commanded), whatever the end is, a singular posture or the
// other edge included. If that pair is on the same edge, the branch is the one above the angle nearest to u_w. Not
// asked at a singular start.
Sign PostureRules::branch(const Angle& tool) const {
  return -recorder_.decide(Clause::fanuc_tool_posture_branch, -branch_quantity(machine_, tool), 2);
}

// fanuc.tool-posture.crossing: If the great circle goes exactly through a singular posture inside the block, the
// posture at the end is not changed. Asked of +u_w, then of -u_w, of a block that neither starts nor ends in a singular
// posture; then fanuc.tool-posture.foot-behind-the-start and -foot-before-the-end are asked.
Passing PostureRules::passing(const AxisPassed& work_axis) const {
  Passing result;
  result.side = static_cast<int>(work_axis.side.sign());
  const Real scale = sqrt(work_axis.arc.from().norm2 * work_axis.arc.to().norm2);
  for (const SingularPosture& pole : poles_) {
    const Sign side = recorder_.decide(Clause::fanuc_tool_posture_crossing, pole.side * work_axis.side, scale);
    const bool ahead = (pole.side * (work_axis.along_from + work_axis.along_to)).sign() == Sign::positive;
    if (side == Sign::zero && has_foot_inside(work_axis, pole.side)) return {&pole, 0};
    // The pole on the side of the arc tells how that passes the axis.
    if (ahead || poles_.size() == 1) result.side = pole.side * static_cast<int>(side);
  }
  return result;
}

// fanuc.tool-posture.foot-behind-the-start: The question is whether the foot of s on the great circle, or s itself if
// it lies in the plane, comes after the start of the arc.
// fanuc.tool-posture.foot-before-the-end: The question is whether the foot of s comes before the end of the arc. It is
// asked after fanuc.tool-posture.foot-behind-the-start, if that holds. Both together mean inside the arc.
bool PostureRules::has_foot_inside(const AxisPassed& work_axis, int sign) const {
  const Direction& from = work_axis.arc.from();
  const Direction& to = work_axis.arc.to();
  return recorder_.decide(Clause::fanuc_tool_posture_foot_behind_the_start, sign * work_axis.behind_start,
                          from.norm2 * sqrt(to.norm2)) != Sign::negative &&
         recorder_.decide(Clause::fanuc_tool_posture_foot_before_the_end, sign * work_axis.before_end,
                          sqrt(from.norm2) * to.norm2) != Sign::negative;
}

// fanuc.tool-posture.reach-inside: A great circle that leaves the directions that can be reached raises PS5459, in type
// 1 too. Asked at the point of the arc nearest to u_w, if the foot of u_w lies inside and alpha differs from beta.
// Asked at the farthest point, if the foot of -u_w lies inside and alpha + beta differs from 180. The ends are always
// in reach.
void PostureRules::require_reach_inside(const AxisPassed& work_axis) const {
  const Machine::Heights& heights = machine_.heights();
  for (const int sign : {1, -1}) {
    if (machine_.singular(sign) != nullptr || !has_foot_inside(work_axis, sign)) continue;
    const Real nearest = cosine_at_foot(work_axis);
    const Real greatest = sign * heights.mean + sqrt(heights.swing2);
    if (recorder_.decide(Clause::fanuc_tool_posture_reach_inside, greatest - nearest, 2) == Sign::negative)
      throw Alarm(AlarmCause::unreachable);
  }
}

// fanuc.tool-posture.branch-mismatch: If the end pair found along the great circle is not the one that has to be
// reached, the block runs under conventional control, with the warning posture-branch. The warning comes just before
// the own move of the block and the samples of that move, after every inserted move there and after ARC_PLANE_MISMATCH.
// In type 1 this is so if the pair is not the one commanded, by whole turns or by the branch. At a singular end it is
// so if the tool side is not the one commanded, and then there is no turn after the block. At a singular start, in both
// types, it is so if the tool-side axis, followed back, does not come to its position at the start; then there is no
// turn before the block. Otherwise type 2 never asks. The other vendor raises an alarm.
bool PostureRules::is_mismatch(bool differs) const {
  return recorder_.decide(Clause::fanuc_tool_posture_branch_mismatch, differs);
}

// fanuc.tool-posture.near-limit: 19738 is the angle, in degrees, under which a posture is near a singular one. It
// counts in type 2 only. If it is 0, negative or not given, no end posture is changed, and NPC raises no alarm.
bool PostureRules::looks(bool type_2) const {
  return recorder_.decide(Clause::fanuc_tool_posture_near_limit, type_2 && limit_ > 0);
}

// fanuc.tool-posture.nearer-singular: If both +u_w and -u_w exist, the one that is nearer to the great circle between
// the ends counts, and +u_w if they are equally near. Its distance d is that of its foot if the foot lies inside,
// otherwise that of the nearer end.
PostureRules::Distance PostureRules::distance(const AxisPassed& work_axis, int sign) const {
  if (has_foot_inside(work_axis, sign)) return {true, cosine_at_foot(work_axis)};
  const Real at_start = sign * dot(work_axis.arc.from().unit, work_axis.axis);
  const Real at_end = sign * dot(work_axis.arc.to().unit, work_axis.axis);
  return {false, at_start < at_end ? at_end : at_start};
}

// fanuc.tool-posture.near: In type 2 a block is near a singular posture if d is strictly smaller than 19738. This
// concerns only blocks that neither start nor end in a singular posture nor cross one exactly. If 19738 is above 90
// degrees, d is compared all the same, as an angle from 0 to 180.
const SingularPosture* PostureRules::near(const AxisPassed& work_axis) const {
  if (poles_.empty()) return nullptr;
  const SingularPosture* pole = &poles_.front();
  Distance least = distance(work_axis, pole->side);
  if (poles_.size() > 1) {
    const Distance other = distance(work_axis, poles_.back().side);
    if (recorder_.decide(Clause::fanuc_tool_posture_nearer_singular, least.cosine - other.cosine, 2) ==
        Sign::negative) {
      pole = &poles_.back();
      least = other;
    }
  }
  const Real& normal2 = work_axis.arc.normal2();
  bool is_near = false;
  if (least.foot_inside && limit_ <= 90) {
    // By the cosine of the double angle: rational where its square is.
    const Real sine2 = (1 - exact::cos_degrees(Rational(2 * limit_))) / 2;
    is_near = recorder_.decide(Clause::fanuc_tool_posture_near, sine2 * normal2 - square(work_axis.side), normal2) ==
              Sign::positive;
  } else
    is_near = least.foot_inside || limit_ > 180 ||
              recorder_.decide(Clause::fanuc_tool_posture_near, least.cosine - exact::cos_degrees(limit_), 2) ==
                  Sign::positive;
  return is_near ? pole : nullptr;
}

// fanuc.tool-posture.veto: The end posture is not changed if the work-side position would differ by more than 19739
// from the one that it replaces, seen with the tool side turned over. We read the difference as the smallest one modulo
// 360. A limit below 0 always vetoes, a limit of 180 or more never does. If 19739 is not given, it is 0.
bool PostureRules::may_stand(const Angle& turned) const {
  if (veto_ < 0) return false;
  if (veto_ >= 180) return true;
  return recorder_.decide(Clause::fanuc_tool_posture_veto, -turned.cosine() - exact::cos_degrees(veto_), 2) !=
         Sign::negative;
}

// fanuc.tool-posture.changed: At a changed end the tool side is mirrored at the singular position, and the work side
// stays where it was at the start. The end of the tip does not change. Both positions must be in range
// (fanuc.tool-center-point.range), otherwise the change is refused. The next block starts from this pair, and the
// direction of this pair is the one kept.
Pose PostureRules::changed(const Pose& start, const Pose& end, const Angle& singular) {
  return {singular + (singular - end.tool), start.work};
}

// fanuc.tool-posture.refused: NPC (19696#3) decides about a block that is near a singular posture and whose end is not
// changed, because of the veto or the range. With NPC = 1 the block raises PS5421, with NPC = 0 it runs as it is.
void PostureRules::keep_end() const {
  if (recorder_.decide(Clause::fanuc_tool_posture_refused, refuses_)) throw Alarm(AlarmCause::singular_posture);
}

}  // namespace toolcomp::model
