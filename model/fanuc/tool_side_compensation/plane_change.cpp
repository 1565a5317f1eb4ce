// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/plane_change.h"

#include "model/basis/number.h"
#include "spec/language/input_error.h"

namespace toolcomp::model {
namespace {

Rational limit_angle(const spec::Setup& setup) {
  const std::optional<spec::Decimal> given = setup.parameter(6261);
  const Rational degrees = given ? plain(*given) : Rational(0);
  if (degrees < 0 || degrees > 180)
    throw spec::InputError("setup", 0, 0, "parameters.6261: expected an angle from 0 to 180");
  return degrees == 0 ? Rational(45) : degrees;
}

}  // namespace

PlaneChangeCheck::PlaneChangeCheck(const spec::Setup& setup, Recorder& recorder)
    : recorder_(recorder), checks_(!setup.bit(19605, 5)) {
  const Rational degrees = limit_angle(setup);
  cosine_ = exact::cos_degrees(degrees);
  cosine2_ = (1 + exact::cos_degrees(Rational(2 * degrees))) / 2;
}

// cos(limit) |Va||Vb| - Va · Vb. Where both terms have one sign their squares tell it, without a root.
bool PlaneChangeCheck::turns_far(const Direction& former, const Direction& latter) const {
  const Real product = dot(former.vector, latter.vector);
  const Real norms2 = former.norm2 * latter.norm2;
  const bool both_positive = cosine_.sign() == Sign::positive && product.sign() == Sign::positive;
  const bool both_negative = cosine_.sign() == Sign::negative && product.sign() == Sign::negative;
  const bool equal = (both_positive || both_negative) && (cosine2_ * norms2 - square(product)).sign() == Sign::zero;
  const Real scale = sqrt(norms2);
  const Real quantity = equal ? Real(0) : cosine_ * scale - product;
  // fanuc.tool-side.plane-change-angle: The first condition of the plane change check is that Va, the tool direction at
  // the end of A, and Vb, the tool direction at the end of B, differ by the limit angle or more.
  return recorder_.decide(Clause::fanuc_tool_side_plane_change_angle, quantity, scale) != Sign::negative;
}

bool PlaneChangeCheck::interferes(const SidePlan& former, const SidePlan& latter) const {
  // fanuc.tool-side.plane-change-check: 19605 bit 5, NIC, switches the interference check where the compensation plane
  // changes: 0 checks, 1 does not.
  if (!recorder_.decide(Clause::fanuc_tool_side_plane_change_check, checks_)) return false;
  const Direction& va = former.plane.tool();
  const Direction& vb = latter.plane.tool();
  const Vector& ua = former.path.travel;
  const Vector& ub = latter.path.travel;
  if (!turns_far(va, vb)) return false;
  const Vector wa = cross(va.vector, ua);
  const Vector wb = cross(vb.vector, ub);
  const Real travels = sqrt(squared_norm(ua) * squared_norm(ub));
  // fanuc.tool-side.plane-change-side: The second condition of the plane change check, asked if the first holds, is
  // that the directions Wa = Va x Ua and Wb = Vb x Ub do not point against each other. Ua and Ub are the displacements
  // of A and B from start to end, also of arcs.
  const Sign side =
      recorder_.decide(Clause::fanuc_tool_side_plane_change_side, dot(wa, wb), sqrt(va.norm2 * vb.norm2) * travels);
  if (side == Sign::negative) return false;
  const Real along = dot(wa, cross(va.vector, ub));
  // fanuc.tool-side.plane-change-reversal: The third condition of the plane change check, asked if the first two hold,
  // is that Ra and Rb point against each other. Ra and Rb are the projections of Ua and Ub onto the plane perpendicular
  // to Va.
  return recorder_.decide(Clause::fanuc_tool_side_plane_change_reversal, -along, va.norm2 * travels) == Sign::positive;
}

}  // namespace toolcomp::model
