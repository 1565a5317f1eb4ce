// SPDX-License-Identifier: Apache-2.0
#include "fast/heidenhain/program/contact_angle.h"

#include "fast/arithmetic/trigonometry.h"

namespace toolcomp::fast::klartext {

ContactAngle::ContactAngle(const WholeVector& normal, const WholeVector& tool, double sine, double cosine)
    : normal_(normal), tool_(tool), degrees_(arctangent(sine, cosine)) {}

Count ContactAngle::fine() const {
  const WideVector3 n = normal_.exact();
  const WideVector3 t = tool_.exact();
  const WideVector3 c = cross(n, t);
  return fine_arctangent(sqrt(dot(c, c).to_double_double()), dot(n, t).to_double_double());
}

int ContactAngle::compare_exactly(const Count& degrees) const {
  const Int128 exact = fine().units() - degrees.units();
  if (exact > kFineUnits) return 1;
  return exact < -kFineUnits ? -1 : 0;
}

}  // namespace toolcomp::fast::klartext
