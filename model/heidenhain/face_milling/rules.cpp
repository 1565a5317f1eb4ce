// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/face_milling/rules.h"

namespace toolcomp::model::klartext {
namespace {

// A component that is 0 becomes the number 0, so that it stays so in products with an angle.
Vector settled(Vector v) {
  for (Real* part : {&v.x, &v.y, &v.z})
    if (part->sign() == Sign::zero) *part = 0;
  return v;
}

}  // namespace

// heidenhain.face.applies: A straight line LN with a surface normal is compensated by the deltas. The normal points
// from the workpiece into the tool, to the centre CR2 of its corner radius. Only X, Y and Z are compensated.
// heidenhain.face.without-tcpm: Without TCPM the contact rule is the same as under TCPM, with the tool along its axis.
// The manual says that compensation is perpendicular to the contour. Its example measured at the tip fits a shift of
// the corner centre along N, not a shift of the tip.
bool FaceRules::applies(const Motion& motion) const {
  recorder_.reach(Clause::heidenhain_face_applies);
  recorder_.reach(Clause::heidenhain_face_effective_tip);
  if (!motion.tcpm) recorder_.reach(Clause::heidenhain_face_without_tcpm);
  return contour_.on_contour(motion);
}

// heidenhain.face.side: The normal leans toward the holder, is at right angles to the tool, or leans away from the
// holder.
bool FaceRules::is_below(const ContactGeometry& geometry) const {
  const Sign side = recorder_.decide(Clause::heidenhain_face_side, geometry.along, geometry.lengths);
  // heidenhain.peripheral.by-normal: The manual says that an LN block with a normal perpendicular to T is peripheral
  // milling too. The contact rule of face milling holds for it. For end mills both rules agree. For rounded corners the
  // contact rule makes no break between this normal and normals that are nearly perpendicular.
  if (side == Sign::zero) recorder_.reach(Clause::heidenhain_peripheral_by_normal);
  if (side != Sign::negative) return false;
  const Real within = Rational(4, 100'000'000) * geometry.lengths2 - square(geometry.along);
  // heidenhain.face.below: A normal that leans away from the holder gives W_N_BELOW if n.t < -0.0002, which is more
  // than rounding to 4 decimals can cause. The formulas do not change. The syntax example of the manual is such a
  // block.
  return recorder_.decide(Clause::heidenhain_face_below, within, geometry.lengths2) == Sign::negative;
}

// heidenhain.face.ring-direction: The rounded corner of the tool is a ring of radius rho around the axis of the tool,
// R2 above the tip, thickened by R2. The tool touches the wall where the ring is nearest to the wall. The direction
// from that point of the ring to the axis is that of the part of n across the tool.
Ring FaceRules::ring(const EffectiveTool& tool, const FaceContact& contact) const {
  const ContactGeometry& geometry = contact.geometry;
  Ring result;
  // heidenhain.face.along-the-tool: If the normal is parallel or opposite to the tool, the flat bottom touches, and the
  // contact is taken on the axis: u = 0. The test is exact. No other choice is independent of the blocks before. If the
  // normal leans only slightly, the contact jumps by the radius of the flat.
  result.flat =
      recorder_.decide(Clause::heidenhain_face_along_the_tool, geometry.across2, geometry.lengths2) == Sign::zero;
  if (!result.flat) {
    recorder_.reach(Clause::heidenhain_face_ring_direction);
    result.u = geometry.ring_direction();
  }
  if (contact.angle) return result;  // a ball
  const Real difference = tool.r + tool.dr - (tool.r2 + contact.dr2);
  // heidenhain.tool.effective-flat: The flat of the effective bottom has the radius R' - R2'. If M107 lets R2' be
  // larger than R', there is no flat, and the tool is then a ball of R2'. So an allowance by DR2 alone keeps its stated
  // size. With a table of deviations there is no flat either. Asked in blocks with a normal after all checks, but not
  // with a table of deviations.
  result.has_bottom = recorder_.decide(Clause::heidenhain_tool_effective_flat, difference, 1) == Sign::positive;
  if (result.has_bottom) result.effective = difference;
  result.change = result.effective - (tool.r - tool.r2);
  // heidenhain.tool.ring-change: dR counts in face milling too, through the radius of the ring on which the corner
  // centres lie. The manual names DR and DR2 for 3D compensation, and it distinguishes its classes of tools with DR.
  // Only with this reading does the full radius R + DR of the programmed contour agree. Asked in blocks with a normal,
  // but not with a table of deviations.
  recorder_.decide(Clause::heidenhain_tool_ring_change, result.change, 1);
  return result;
}

// heidenhain.face.contact-point: The nominal tool, with the values of the tool table, touches the wall at q. The tip of
// the nominal tool follows from the programmed point (heidenhain.contour.nominal-tip).
// heidenhain.face.effective-tip: The effective tool touches the same plane at the same contact point as the nominal
// tool. Its corner centre moves by exactly dR2 along n, and its length changes by dL along t. DR changes only the
// distance between the axis and the corner centre.
Compensated FaceRules::compensate(const Motion& motion, const FaceContact& contact, const Ring& ring,
                                  bool on_contour) const {
  const EffectiveTool& tool = *motion.tool;
  const Vector& n = contact.geometry.n;
  const Vector& t = contact.geometry.t;
  const Vector lean = contact.angle ? settled(n - t) : n - t;
  Compensated result;
  Vector q;
  result.shift = contact.dr2 * lean + ring.change * ring.u;
  if (on_contour) {
    q = contour_.contact_point(motion);
    const Real r2 = tool.r2 + contact.dr2;
    result.point = q + r2 * lean + ring.effective * ring.u;
    result.tool_center = q + r2 * n + ring.effective * ring.u;
  } else {
    recorder_.reach(Clause::heidenhain_face_contact_point);
    const Vector center = contour_.nominal_center(motion);
    q = center - (tool.r - tool.r2) * ring.u - tool.r2 * n;
    result.point = ProgrammedContour::tip_of_reference(motion) + result.shift;
    result.tool_center = center + contact.dr2 * n + ring.change * ring.u;
  }
  auto& touched = result.contact.emplace();
  touched.point = {q.x, q.y, q.z};
  touched.normal = {n.x, n.y, n.z};
  touched.flat = ring.flat;
  touched.angle = contact.angle;
  return result;
}

// heidenhain.face.contact-before: To find a jump, the contact of an LN block with a normal is compared with that of the
// LN block with a normal right before it. Any other motion between, and any TOOL CALL, clears the earlier contact.
std::optional<Clause> FaceRules::jump(const Ring& ring, const Vector& w, const std::optional<Vector>& w_before) const {
  if (!ring.has_bottom || !recorder_.decide(Clause::heidenhain_face_contact_before, w_before.has_value()))
    return std::nullopt;
  const bool flat_before = exact::is_zero(*w_before);
  // heidenhain.face.contact-to-flat: If the effective bottom has a flat, a contact that goes from the axis to the ring,
  // or from the ring to the axis, gives W_CONTACT_JUMP. Another vendor inserts moves there. Here nothing is inserted.
  if (recorder_.decide(Clause::heidenhain_face_contact_to_flat, ring.flat != flat_before))
    return Clause::heidenhain_face_contact_to_flat;
  if (ring.flat) return std::nullopt;
  const Real scale = sqrt(squared_norm(w) * squared_norm(*w_before));
  // heidenhain.face.contact-jump: If the effective bottom has a flat, a contact that goes to the other half of the ring
  // gives W_CONTACT_JUMP. Asked if both contacts are on the ring.
  if (recorder_.decide(Clause::heidenhain_face_contact_jump, dot(w, *w_before), scale) == Sign::negative)
    return Clause::heidenhain_face_contact_jump;
  return std::nullopt;
}

}  // namespace toolcomp::model::klartext
