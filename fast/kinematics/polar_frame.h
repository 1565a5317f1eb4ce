// The inverse kinematics of any pair of rotary axes (posture sheet 3.3), in the system of the work-side axis.
//
// e3 is the work-side axis u_w, the tool-side axis is u_t = (sin b, 0, cos b), and t0 lies at the angle a from u_t. psi
// is the mechanical angle of the tool-side axis from where it brings the tool nearest to u_w. Then, for every machine,
//   c(psi) = (cos a sin b - sin a cos b cos psi, -sin a sin psi, cos a cos b + sin a sin b cos psi)
// is the tool before the work-side axis turns it about e3, so k = V.e3 gives cos psi, and two azimuths the rest.
#pragma once

#include <array>
#include <cstdint>

#include "fast/arithmetic/double_double.h"
#include "fast/arithmetic/trigonometry.h"
#include "fast/geometry/vector3.h"
#include "fast/kinematics/direction.h"

namespace toolcomp::fast {

// Relative to the scale of a decision: what double-double cannot tell from zero is an exact tie. Positions out of
// inverse kinematics are rounded at 2^-73 rad.
inline constexpr double kPoseTie = 0x1p-66;

// How a direction can be reached.
enum class Reach : std::uint8_t {
  two_pairs,
  edge,      // |C| = rho: psi is 0 or 180, one pair
  singular,  // parallel to the work-side axis: any position of it
  none,
  unsure,  // doubles cannot tell, or would lose more than a few bits
};

// The pairs as sines and cosines of psi and of the mechanical angle of the work-side axis, for psi >= 0 (0) and psi <=
// 0 (1).
template <class T>
struct PolarRoots {
  T cos_psi{};
  T sin_psi{};  // >= 0
  T hx{};       // the horizontal part of c(psi), psi >= 0
  T hy{};       // <= 0; its opposite for psi <= 0
  std::array<SineCosine<T>, 2> work{};
};

// Their angles in degrees: psi of the first one, that of the work-side axis of both.
struct RootAngles {
  double psi = 0;
  std::array<double, 2> work{};
};
inline RootAngles angles_of(const PolarRoots<double>& roots) {
  const DoublePair first =
      arctangent(DoublePair{roots.sin_psi, roots.work[0].sine}, DoublePair{roots.cos_psi, roots.work[0].cosine});
  return {first[0], {first[1], arctangent(roots.work[1].sine, roots.work[1].cosine)}};
}

class PolarFrame {
 public:
  template <class T>
  struct Constants {
    std::array<Vector3<T>, 3> row{};  // e1, e2, e3
    T cc{}, ss{}, sc{}, sa{};         // cos a cos b, sin a sin b, sin a cos b, sin a
    T top{}, bottom{};                // cos(a - b), cos(a + b): the reach of k
    T skew{}, sum{};                  // sin(b - a), sin(a + b)
    T above{}, below{};               // 1 - top, 1 + bottom
    SineCosine<T> phase{};            // of the mechanical angle of the tool-side axis at psi = 0
  };

  PolarFrame() = default;
  // Unit vectors: tool-side and work-side axis, tool at zero.
  PolarFrame(const FineVector& tool_side, const FineVector& work_side, const FineVector& zero);

  [[nodiscard]] bool invertible() const { return invertible_; }
  // +u_w, -u_w can be reached.
  [[nodiscard]] bool has_plus() const { return plus_; }
  [[nodiscard]] bool has_minus() const { return minus_; }
  // The azimuth of c does not depend on psi: orthogonal axes, the tool at right angles to the tool-side axis.
  [[nodiscard]] bool orthogonal() const { return orthogonal_; }
  // The rows are directions of machine axes: components of a whole direction keep their relative accuracy.
  [[nodiscard]] bool along_axes() const { return along_axes_; }
  [[nodiscard]] const Count& phase() const { return phase_; }  // degrees, rounded
  [[nodiscard]] const Constants<double>& constants() const { return rough_; }
  [[nodiscard]] const Constants<DoubleDouble>& fine_constants() const { return fine_; }

  // `seen`: the direction in this system, unit. `relative`: every component has a small relative error.
  [[nodiscard]] Reach solve(const Vector3<double>& seen, bool relative, PolarRoots<double>& roots) const;
  [[nodiscard]] Reach solve(const Vector3<DoubleDouble>& seen, PolarRoots<DoubleDouble>& roots) const;

 private:
  Constants<double> rough_;
  Constants<DoubleDouble> fine_;
  Count phase_;
  bool invertible_ = false;
  bool plus_ = false;
  bool minus_ = false;
  bool orthogonal_ = false;
  bool along_axes_ = false;
};

template <class T>
Vector3<T> seen_from(const PolarFrame::Constants<T>& constants, const Vector3<T>& v) {
  return {dot(constants.row[0], v), dot(constants.row[1], v), dot(constants.row[2], v)};
}
template <class T>
Vector3<T> seen_back(const PolarFrame::Constants<T>& constants, const Vector3<T>& v) {
  return constants.row[0] * v.x + constants.row[1] * v.y + constants.row[2] * v.z;
}

}  // namespace toolcomp::fast
