#include "model/heidenhain/program/tool_checks.h"

#include "model/basis/alarm.h"

namespace toolcomp::model::klartext {

void ToolChecks::block(const Motion& motion) const {
  if (recorder_.decide(Clause::heidenhain_tool_none, !motion.tool->called))
    throw Alarm("E_NO_TOOL", "3D compensation before any TOOL CALL");
  if (motion.normal && motion.side != Side::none)
    raise(recorder_, Clause::heidenhain_face_radius_compensation, "E_RC_WITH_N",
          "a surface normal while RL or RR is in force");
}

Sign ToolChecks::table(const EffectiveTool& tool) const {
  constexpr const char* kMessage = "the tool table describes no tool";
  if (recorder_.decide(Clause::heidenhain_tool_table_radius, tool.r, 1) == Sign::negative)
    throw Alarm("E_TOOL", kMessage);
  if (recorder_.decide(Clause::heidenhain_tool_table_corner_radius, tool.r2, 1) == Sign::negative)
    throw Alarm("E_TOOL", kMessage);
  const Sign shape = recorder_.decide(Clause::heidenhain_tool_table_shape, tool.r - tool.r2, 1);
  if (shape == Sign::negative) throw Alarm("E_TOOL", kMessage);
  return shape;
}

void ToolChecks::radius(const EffectiveTool& tool) const {
  if (recorder_.decide(Clause::heidenhain_tool_effective_radius, tool.r + tool.dr, 1) == Sign::negative)
    throw Alarm("E_TOOL_EFF", "the effective radius is negative");
}

void ToolChecks::corner(const Real& quantity, const Real& scale) const {
  if (recorder_.decide(Clause::heidenhain_tool_effective_corner_radius, quantity, scale) == Sign::negative)
    throw Alarm("E_R2_NEG", "the effective corner radius is negative");
}

bool ToolChecks::oversize_allowed(const Motion& motion) const {
  return recorder_.decide(Clause::heidenhain_tool_oversize_permitted, motion.oversize_allowed);
}

void ToolChecks::oversize(const EffectiveTool& tool) const {
  if (recorder_.decide(Clause::heidenhain_tool_oversize_radius, tool.dr, 1) == Sign::positive)
    throw Alarm("E_OVERSIZE_DR", "an oversize radius without M107");
}

void ToolChecks::without_normal(const Motion& motion) const {
  const EffectiveTool& tool = *motion.tool;
  block(motion);
  table(tool);
  radius(tool);
  corner(tool.r2 + tool.dr2, 1);
  if (!oversize_allowed(motion)) oversize(tool);
}

}  // namespace toolcomp::model::klartext
