// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/program/tool_checks.h"

#include "model/basis/alarm.h"

namespace toolcomp::model::klartext {

void ToolChecks::block(const Motion& motion) const {
  // heidenhain.tool.none: 3D compensation before any tool call raises E_NO_TOOL. TOOL CALL 0 calls a tool.
  if (recorder_.decide(Clause::heidenhain_tool_none, !motion.tool->called)) throw Alarm(AlarmCause::no_tool);
  // heidenhain.face.radius-compensation: A block with a normal raises E_RC_WITH_N if RL or RR is in force or is
  // programmed in the block itself. The direction would be defined twice.
  if (motion.normal && motion.side != Side::none)
    raise(recorder_, Clause::heidenhain_face_radius_compensation, AlarmCause::normal_with_radius_compensation);
}

Sign ToolChecks::table(const EffectiveTool& tool) const {
  // heidenhain.tool.table-radius: A negative radius R in the tool table raises E_TOOL.
  if (recorder_.decide(Clause::heidenhain_tool_table_radius, tool.r, 1) == Sign::negative)
    throw Alarm(AlarmCause::tool_shape);
  // heidenhain.tool.table-corner-radius: A negative corner radius R2 in the tool table raises E_TOOL.
  if (recorder_.decide(Clause::heidenhain_tool_table_corner_radius, tool.r2, 1) == Sign::negative)
    throw Alarm(AlarmCause::tool_shape);
  // heidenhain.tool.table-shape: The tool table describes an end mill (R2 = 0), a toroid cutter (R2 > 0) or a ball-nose
  // cutter (R2 = R). A corner radius larger than the radius is none of these and raises E_TOOL.
  const Sign shape = recorder_.decide(Clause::heidenhain_tool_table_shape, tool.r - tool.r2, 1);
  if (shape == Sign::negative) throw Alarm(AlarmCause::tool_shape);
  return shape;
}

// heidenhain.tool.effective-radius: An effective radius below 0 raises E_TOOL_EFF, also under M107.
void ToolChecks::radius(const EffectiveTool& tool) const {
  if (recorder_.decide(Clause::heidenhain_tool_effective_radius, tool.r + tool.dr, 1) == Sign::negative)
    throw Alarm(AlarmCause::effective_radius);
}

// heidenhain.tool.effective-corner-radius: An effective corner radius below 0 raises E_R2_NEG, also under M107, because
// no such geometry exists.
void ToolChecks::corner(const Real& quantity, const Real& scale) const {
  if (recorder_.decide(Clause::heidenhain_tool_effective_corner_radius, quantity, scale) == Sign::negative)
    throw Alarm(AlarmCause::corner_radius_negative);
}

// heidenhain.tool.oversize-permitted: Under M107 positive deltas, and deltas that make the corner radius larger than
// the radius, raise no alarm. A tool table with R2 larger than R raises E_TOOL all the same. M107 changes verdicts,
// never coordinates.
bool ToolChecks::oversize_allowed(const Motion& motion) const {
  return recorder_.decide(Clause::heidenhain_tool_oversize_permitted, motion.oversize_allowed);
}

// heidenhain.tool.oversize-radius: A tool with oversize raises an error unless M107 suppresses it, so dR > 0 raises
// E_OVERSIZE_DR. A positive dL never raises it, because the manual's conditions name only R, R2, DR and DR2.
void ToolChecks::oversize(const EffectiveTool& tool) const {
  if (recorder_.decide(Clause::heidenhain_tool_oversize_radius, tool.dr, 1) == Sign::positive)
    throw Alarm(AlarmCause::oversize_radius);
}

// heidenhain.tool.order-of-checks: The checks run in every LN block, and under RL or RR and TCPM also in every L block
// with an axis word and in M140. They run in this order: E_NO_TOOL, E_RC_WITH_N, E_TOOL, E_3DTC_SHAPE, E_TOOL_EFF,
// E_3DTC_RANGE, E_R2_NEG. Without M107, E_OVERSIZE_DR comes next, and then, in blocks with a normal, E_OVERSIZE_DR2 and
// E_R2_GT_R.
void ToolChecks::without_normal(const Motion& motion) const {
  const EffectiveTool& tool = *motion.tool;
  block(motion);
  table(tool);
  radius(tool);
  corner(tool.r2 + tool.dr2, 1);
  if (!oversize_allowed(motion)) oversize(tool);
}

}  // namespace toolcomp::model::klartext
