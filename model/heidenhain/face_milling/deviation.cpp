// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/face_milling/deviation.h"

#include "model/basis/alarm.h"

namespace toolcomp::model::klartext {
namespace {

// |N||T| (cos b - cos theta): positive where theta is beyond b.
Real beyond(const Real& cosine, const ContactGeometry& contact) { return cosine * contact.lengths - contact.along; }

Deviation at(const SupportPoint& point, const Real& angle) { return {angle, point.value, &point, &point}; }

Deviation between(const SupportPoint& before, const SupportPoint& behind, const Real& angle) {
  const Real slope = (behind.value - before.value) / (behind.angle - before.angle);
  return {angle, before.value + slope * (angle - before.angle), &before, &behind};
}

}  // namespace

Deviation deviation_at(const Deviations& table, const ContactGeometry& contact, Recorder& recorder) {
  const Real scale = 2 * contact.lengths;
  const SupportPoint& first = table.front();
  const SupportPoint& last = table.back();
  // heidenhain.tool.deviation-below: A contact angle below the first support point b raises E_3DTC_RANGE. The support
  // point itself is inside the range.
  const Sign below = recorder.decide(Clause::heidenhain_tool_deviation_below, beyond(first.cosine, contact), scale);
  if (below == Sign::negative) throw Alarm(AlarmCause::deviation_range);
  // heidenhain.tool.deviation-above: A contact angle above the last support point b raises E_3DTC_RANGE. The support
  // point itself is inside the range.
  const Sign above = recorder.decide(Clause::heidenhain_tool_deviation_above, -beyond(last.cosine, contact), scale);
  if (above == Sign::negative) throw Alarm(AlarmCause::deviation_range);

  const Real angle = contact.angle();
  if (below == Sign::zero) return at(first, angle);
  if (above == Sign::zero) return at(last, angle);
  const SupportPoint* before = &first;
  for (std::size_t i = 1; i + 1 < table.size(); ++i) {
    const SupportPoint& point = table[i];
    // heidenhain.tool.deviation-segment: Between two support points the deviation is interpolated linearly in the
    // angle. The support points between the first and the last are tested in ascending order, until one is not below
    // the contact angle. In the manual's example, 0.03 at 40 degrees and -0.02 at 50 degrees give 0.005 at 45 degrees.
    const Sign side = recorder.decide(Clause::heidenhain_tool_deviation_segment, beyond(point.cosine, contact), scale);
    if (side == Sign::zero) return at(point, angle);
    if (side == Sign::negative) return between(*before, point, angle);
    before = &point;
  }
  // A table of one point comes here only by a forced outcome.
  return before == &last ? at(last, angle) : between(*before, last, angle);
}

// heidenhain.tool.effective-corner-radius: An effective corner radius below 0 raises E_R2_NEG, also under M107, because
// no such geometry exists. With a table of deviations the value of that table counts in dR2. The sign is then that of
// an angle: inside a segment the contact angle is compared with the angle at which R2 + dR2 is 0.
SignedQuantity sign_of_sum(const Real& radius, const Deviation& deviation, const ContactGeometry& contact) {
  const Real start = radius + deviation.before->value;
  const Real end = radius + deviation.behind->value;
  const bool crosses = start.sign() == -end.sign() && start.sign() != Sign::zero;
  if (!crosses) return {radius + deviation.value, 1};
  const Real share = start / (start - end);
  const Real zero = deviation.before->angle + share * Real(deviation.behind->angle - deviation.before->angle);
  const Real past = beyond(exact::cos_degrees(zero.rational()), contact);
  return {end.sign() == Sign::positive ? past : -past, 2 * contact.lengths};
}

}  // namespace toolcomp::model::klartext
