// SPDX-License-Identifier: Apache-2.0
// 3D-ToolComp (option 92): deviations of the corner radius by the angle of the contact.
#pragma once

#include "model/basis/recorder.h"
#include "model/heidenhain/face_milling/contact_geometry.h"
#include "model/heidenhain/program/motion.h"

namespace toolcomp::model::klartext {

// What a table of deviations says of a contact.
struct Deviation {
  Real angle;  // theta, degrees
  Real value;  // tau, units of the program
  // The support points of the segment in which theta is; the same one twice where theta is exactly there.
  const SupportPoint* before = nullptr;
  const SupportPoint* behind = nullptr;
};

// Clauses: heidenhain.tool.deviation-below, .deviation-above, .deviation-segment. Throws Alarm E_3DTC_RANGE.
Deviation deviation_at(const Deviations& table, const ContactGeometry& contact, Recorder& recorder);

// A quantity with the sign of radius + deviation, and its scale: inside a segment the contact angle against the one at
// which that is 0, so that no angle decides by its digits. Clause: heidenhain.tool.effective-corner-radius.
struct SignedQuantity {
  Real quantity;
  Real scale;
};
SignedQuantity sign_of_sum(const Real& radius, const Deviation& deviation, const ContactGeometry& contact);

}  // namespace toolcomp::model::klartext
