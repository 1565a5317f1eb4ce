// SPDX-License-Identifier: Apache-2.0
// The path of the compensated tip in the system fixed to the table: a line, an arc or a helix.
#pragma once

#include <utility>

#include "model/geometry/point_path.h"

namespace toolcomp::model {

// X Y Z from point to point. Clause: fanuc.tool-center-point.tip-path.
class TipPath {
 public:
  explicit TipPath(PointPath path) : path_(std::move(path)) {}

  // The point at the fraction t of the path.
  [[nodiscard]] Vector at(const Rational& t) const;

 private:
  PointPath path_;
};

}  // namespace toolcomp::model
