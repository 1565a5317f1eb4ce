// The path of the compensated tip in the system fixed to the table: a line, an arc or a helix.
#pragma once

#include <optional>

#include "model/geometry/plane.h"
#include "spec/language/axes.h"
#include "spec/language/event.h"

namespace toolcomp::model {

// X Y Z from point to point. Clause: fanuc.tool-center-point.tip-path.
class TipPath {
 public:
  TipPath(Vector from, Vector to) : from_(std::move(from)), to_(std::move(to)) {}
  // Along the arc about its centre; without a sweep straight.
  TipPath(Vector from, Vector to, const spec::Arc<Real>& arc, const spec::Axes& axes);

  // The point at the fraction t of the path.
  [[nodiscard]] Vector at(const Rational& t) const;

 private:
  struct Turn {
    spec::Plane plane = spec::Plane::xy;
    PlanePoint center;
    Real sweep;   // degrees, counter-clockwise positive
    Real growth;  // of the radius, as a multiple of the radius at the start
  };

  Vector from_;
  Vector to_;
  std::optional<Turn> turn_;
};

}  // namespace toolcomp::model
