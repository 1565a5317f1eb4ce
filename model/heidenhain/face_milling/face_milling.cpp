#include "model/heidenhain/face_milling/face_milling.h"

#include <utility>

#include "model/basis/alarm.h"
#include "model/heidenhain/face_milling/deviation.h"

namespace toolcomp::model::klartext {
namespace {

// A component that is 0 becomes the number 0, so that it stays so in products with an angle.
Vector settled(Vector v) {
  for (Real* part : {&v.x, &v.y, &v.z})
    if (part->sign() == Sign::zero) *part = 0;
  return v;
}

}  // namespace

FaceMilling::Checked FaceMilling::check(const Motion& motion) const {
  const EffectiveTool& tool = *motion.tool;
  checks_.block(motion);
  const Sign shape = checks_.table(tool);
  Checked result{ContactGeometry(motion), tool.dr2, {}};
  const bool by_table = recorder_.decide(Clause::heidenhain_tool_deviation_table, !tool.deviations.empty());
  if (by_table && !recorder_.decide(Clause::heidenhain_tool_deviation_shape, shape == Sign::zero)) {
    recorder_.list(Clause::heidenhain_tool_deviation_shape);
    throw Alarm("E_3DTC_SHAPE", "a table of deviations with a tool that is no ball-nose cutter");
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
  if (recorder_.decide(Clause::heidenhain_tool_oversize_corner, oversize, 1) == Sign::positive)
    throw Alarm("E_OVERSIZE_DR2", "an oversize corner radius without M107");
  if (!by_table && recorder_.decide(Clause::heidenhain_tool_corner_beyond_radius,
                                    tool.r + tool.dr - (tool.r2 + tool.dr2), 1) == Sign::negative)
    throw Alarm("E_R2_GT_R", "the effective corner radius is beyond the effective radius");
  return result;
}

Compensated FaceMilling::compensate(Motion& motion, const Checked& checked) {
  const EffectiveTool& tool = *motion.tool;
  const ContactGeometry& geometry = checked.geometry;
  const Vector& n = geometry.n;
  const Vector& t = geometry.t;
  recorder_.reach(Clause::heidenhain_face_applies);
  recorder_.reach(Clause::heidenhain_face_effective_tip);
  if (!motion.tcpm) recorder_.reach(Clause::heidenhain_face_without_tcpm);
  const bool on_contour = contour_.on_contour(motion);
  look_at_side(motion, geometry);
  const Ring ring = this->ring(tool, checked);
  look_for_jump(motion, ring, geometry.w);

  const Vector lean = checked.angle ? settled(n - t) : n - t;
  Compensated result;
  Vector contact_point;
  result.shift = checked.dr2 * lean + ring.change * ring.u;
  if (on_contour) {
    contact_point = contour_.contact_point(motion);
    const Real r2 = tool.r2 + checked.dr2;
    result.point = contact_point + r2 * lean + ring.effective * ring.u;
    result.tool_center = contact_point + r2 * n + ring.effective * ring.u;
  } else {
    recorder_.reach(Clause::heidenhain_face_contact_point);
    const Vector center = contour_.nominal_center(motion);
    contact_point = center - (tool.r - tool.r2) * ring.u - tool.r2 * n;
    result.point = ProgrammedContour::tip_of_reference(motion) + result.shift;
    result.tool_center = center + checked.dr2 * n + ring.change * ring.u;
  }
  auto& contact = result.contact.emplace();
  contact.point = {contact_point.x, contact_point.y, contact_point.z};
  contact.normal = {n.x, n.y, n.z};
  contact.flat = ring.flat;
  contact.angle = checked.angle;
  return result;
}

// Whether the normal points below the tool.
void FaceMilling::look_at_side(Motion& motion, const ContactGeometry& geometry) const {
  const Sign side = recorder_.decide(Clause::heidenhain_face_side, geometry.along, geometry.lengths);
  if (side == Sign::zero) recorder_.reach(Clause::heidenhain_peripheral_by_normal);
  if (side != Sign::negative) return;
  const Real within = Rational(4, 100'000'000) * geometry.lengths2 - square(geometry.along);
  if (recorder_.decide(Clause::heidenhain_face_below, within, geometry.lengths2) == Sign::negative)
    motion.warnings.push_back({"W_N_BELOW", "the surface normal points below the tool", Clause::heidenhain_face_below});
}

FaceMilling::Ring FaceMilling::ring(const EffectiveTool& tool, const Checked& checked) const {
  const ContactGeometry& geometry = checked.geometry;
  Ring result;
  result.flat =
      recorder_.decide(Clause::heidenhain_face_along_the_tool, geometry.across2, geometry.lengths2) == Sign::zero;
  if (!result.flat) {
    recorder_.reach(Clause::heidenhain_face_ring_direction);
    result.u = geometry.ring_direction();
  }
  if (checked.angle) return result;  // a ball
  const Real rho = tool.r - tool.r2;
  const Real difference = tool.r + tool.dr - (tool.r2 + checked.dr2);
  result.has_bottom = recorder_.decide(Clause::heidenhain_tool_effective_flat, difference, 1) == Sign::positive;
  if (result.has_bottom) result.effective = difference;
  result.change = result.effective - rho;
  recorder_.decide(Clause::heidenhain_tool_ring_change, result.change, 1);
  return result;
}

void FaceMilling::look_for_jump(Motion& motion, const Ring& ring, const Vector& w) {
  const std::optional<Vector> before = std::exchange(before_, ring.flat ? Vector() : w);
  if (!ring.has_bottom || !recorder_.decide(Clause::heidenhain_face_contact_before, before.has_value())) return;
  constexpr const char* kMessage = "the contact jumps over the flat bottom of the tool";
  const bool flat_before = exact::is_zero(*before);
  if (recorder_.decide(Clause::heidenhain_face_contact_to_flat, ring.flat != flat_before)) {
    motion.warnings.push_back({"W_CONTACT_JUMP", kMessage, Clause::heidenhain_face_contact_to_flat});
  } else if (!ring.flat) {
    const Real scale = sqrt(squared_norm(w) * squared_norm(*before));
    if (recorder_.decide(Clause::heidenhain_face_contact_jump, dot(w, *before), scale) == Sign::negative)
      motion.warnings.push_back({"W_CONTACT_JUMP", kMessage, Clause::heidenhain_face_contact_jump});
  }
}

}  // namespace toolcomp::model::klartext
