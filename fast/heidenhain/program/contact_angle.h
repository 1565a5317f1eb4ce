// SPDX-License-Identifier: Apache-2.0
// The angle between surface normal and tool, 0 at the tip (heidenhain.tool.deviation-table).
#pragma once

#include "fast/arithmetic/count.h"
#include "fast/heidenhain/program/whole_vector.h"

namespace toolcomp::fast::klartext {

class ContactAngle {
 public:
  // `sine` and `cosine` are |N x T| and N.T, or both of them times the same; they are good to a few ulps of the larger.
  ContactAngle(const WholeVector& normal, const WholeVector& tool, double sine, double cosine);

  [[nodiscard]] double degrees() const { return degrees_; }
  // How far degrees() may be off.
  static constexpr double kError = 0x1p-42;
  // Within kFineUnits of the units of counts.
  [[nodiscard]] Count fine() const;
  static constexpr int kFineUnits = 3;
  // The sign of theta less `degrees`, whose double is `nearest`.
  [[nodiscard]] int compare(const Count& degrees, double nearest) const {
    const double difference = degrees_ - nearest;
    if (difference > 2 * kError) return 1;
    if (difference < -2 * kError) return -1;
    return compare_exactly(degrees);
  }

 private:
  [[nodiscard]] int compare_exactly(const Count& degrees) const;

  const WholeVector& normal_;
  const WholeVector& tool_;
  double degrees_;
};

}  // namespace toolcomp::fast::klartext
