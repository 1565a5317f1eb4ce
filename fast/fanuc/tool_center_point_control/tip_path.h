// SPDX-License-Identifier: Apache-2.0
// The path of the tip in one block (fanuc.tool-center-point.tip-path): a line, an arc or a helix.
#pragma once

#include <array>
#include <cstddef>

#include "fast/basis/event.h"
#include "fast/geometry/vector3.h"

namespace toolcomp::fast {

// In X, Y, Z of the frame that its ends are given in. The fraction of the path is that of its length; on an arc whose
// radius changes, that of its sweep.
class TipPath {
 public:
  TipPath() = default;
  // A line.
  TipPath(const Vector3<double>& start, const Vector3<double>& end) : start_(start), way_(end - start) {}
  // The tool's own arc; without a sweep, where an end lies in the centre, a line. `xyz`: the axes of the events that
  // X, Y, Z are.
  TipPath(const Vector3<double>& start, const Vector3<double>& end, const spec::Arc<double>& arc,
          const std::array<std::size_t, 3>& xyz);

  // The point at fraction t of the path, 0 < t < 1.
  [[nodiscard]] Vector3<double> at(double t) const {
    if (arc_) [[unlikely]]
      return on_arc(t);
    // A coordinate that does not move stays as it is.
    return start_ + way_ * t;
  }

 private:
  [[nodiscard]] Vector3<double> on_arc(double t) const;

  Vector3<double> start_;
  Vector3<double> way_;
  bool arc_ = false;
  std::array<std::size_t, 2> in_{};  // which of X Y Z the plane has
  // From the end with the longer radius, where it is better known.
  bool from_end_ = false;
  std::array<double, 2> center_{};
  std::array<double, 2> radial_{};
  double sweep_ = 0;   // radians, counterclockwise
  double growth_ = 0;  // of the radius over the whole arc, by that radius
};

}  // namespace toolcomp::fast
