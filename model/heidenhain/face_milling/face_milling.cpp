// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/face_milling/face_milling.h"

#include <utility>

#include "model/basis/alarm.h"
#include "model/heidenhain/face_milling/deviation.h"

namespace toolcomp::model::klartext {

// heidenhain.tool.order-of-checks: The checks run in every LN block, and under RL or RR and TCPM also in every L block
// with an axis word and in M140. They run in this order: E_NO_TOOL, E_RC_WITH_N, E_TOOL, E_3DTC_SHAPE, E_TOOL_EFF,
// E_3DTC_RANGE, E_R2_NEG. Without M107, E_OVERSIZE_DR comes next, and then, in blocks with a normal, E_OVERSIZE_DR2 and
// E_R2_GT_R.
FaceContact FaceMilling::check(const Motion& motion) const {
  const EffectiveTool& tool = *motion.tool;
  checks_.block(motion);
  const Sign shape = checks_.table(tool);
  FaceContact result{ContactGeometry(motion), tool.dr2, {}};
  // heidenhain.tool.deviation-table: In a block with a normal, a tool with DR2TABLE takes its deviation from that table
  // instead of DR2 of the tool table. DR2 of TOOL CALL and of the compensation table are added.
  const bool by_table = recorder_.decide(Clause::heidenhain_tool_deviation_table, !tool.deviations.empty());
  // heidenhain.tool.deviation-shape: A table of deviations is for ball-nose cutters, so with R2 other than R it raises
  // E_3DTC_SHAPE.
  if (by_table && !recorder_.decide(Clause::heidenhain_tool_deviation_shape, shape == Sign::zero)) {
    recorder_.list(Clause::heidenhain_tool_deviation_shape);
    throw Alarm(AlarmCause::deviation_shape);
  }
  checks_.radius(tool);
  if (by_table) {
    const Deviation deviation = deviation_at(tool.deviations, result.geometry, recorder_);
    result.angle = deviation.angle;
    result.dr2 = deviation.value + tool.dr2_of_program;
    const SignedQuantity corner = sign_of_sum(tool.r2 + tool.dr2_of_program, deviation, result.geometry);
    checks_.corner(corner.quantity, corner.scale);
  } else {
    checks_.corner(tool.r2 + tool.dr2, 1);
  }
  if (checks_.oversize_allowed(motion)) return result;
  checks_.oversize(tool);
  const Real& oversize = by_table ? tool.dr2_of_program : tool.dr2;
  // heidenhain.tool.oversize-corner: In a block with a normal, dR2 > 0 raises E_OVERSIZE_DR2 unless M107 is on. The
  // value of a table of deviations needs no M107. With such a table, only the deltas of TOOL CALL and of the
  // compensation table count here.
  if (recorder_.decide(Clause::heidenhain_tool_oversize_corner, oversize, 1) == Sign::positive)
    throw Alarm(AlarmCause::oversize_corner);
  // heidenhain.tool.corner-beyond-radius: In a block with a normal, an effective corner radius larger than the
  // effective radius raises E_R2_GT_R unless M107 is on. Not asked with a table of deviations. This is why DR and DR2
  // of a ball-nose cutter are entered together.
  if (!by_table && recorder_.decide(Clause::heidenhain_tool_corner_beyond_radius,
                                    tool.r + tool.dr - (tool.r2 + tool.dr2), 1) == Sign::negative)
    throw Alarm(AlarmCause::corner_beyond_radius);
  return result;
}

Compensated FaceMilling::compensate(Motion& motion, const FaceContact& contact) {
  const bool on_contour = rules_.applies(motion);
  if (rules_.is_below(contact.geometry))
    motion.warnings.push_back({"W_N_BELOW", "the surface normal points below the tool", Clause::heidenhain_face_below});
  const Ring ring = rules_.ring(*motion.tool, contact);
  const Vector& w = contact.geometry.w;
  const std::optional<Vector> before = std::exchange(before_, ring.flat ? Vector() : w);
  if (const auto clause = rules_.jump(ring, w, before))
    motion.warnings.push_back({"W_CONTACT_JUMP", "the contact jumps over the flat bottom of the tool", *clause});
  return rules_.compensate(motion, contact, ring, on_contour);
}

}  // namespace toolcomp::model::klartext
