// SPDX-License-Identifier: Apache-2.0
// The inverse kinematics of any pair of rotary axes (fanuc.tool-center-point.inverse), in the system of the
// work-side axis.
//
// e3 is the work-side axis u_w, the tool-side axis is u_t = (sin b, 0, cos b), and t0 lies at the angle a from u_t. psi
// is the mechanical angle of the tool-side axis from where it brings the tool nearest to u_w. Then, for every machine,
//   c(psi) = (cos a sin b - sin a cos b cos psi, -sin a sin psi, cos a cos b + sin a sin b cos psi)
// is the tool before the work-side axis turns it about e3, so k = V.e3 gives cos psi, and two azimuths the rest.
#pragma once

#include <array>
#include <cmath>
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
struct PolarRoots {
  DoubleDouble cos_psi{};
  DoubleDouble sin_psi{};  // >= 0
  DoubleDouble hx{};       // the horizontal part of c(psi), psi >= 0
  DoubleDouble hy{};       // <= 0; its opposite for psi <= 0
  std::array<SineCosine<DoubleDouble>, 2> work{};
};

// The same in doubles; the work-side axis is made for the pair that is taken.
struct PolarPairs {
  double cos_psi = 0;
  double sin_psi = 0;  // >= 0
  double hx = 0;
  double hy = 0;
  // Sine and cosine: middle - branch * apart.
  DoublePair middle{};
  DoublePair apart{};
  [[nodiscard]] SineCosine<double> work(int branch) const {
    const DoublePair turn = branch < 0 ? middle + apart : middle - apart;
    return {turn[0], turn[1]};
  }
};

class PolarFrame {
 public:
  template <class T>
  struct Constants {
    std::array<Vector3<T>, 3> row{};  // e1, e2, e3
    T cc{}, ss{}, sc{}, sa{};         // cos a cos b, sin a sin b, sin a cos b, sin a
    T per_ss{}, sc_per_ss{};          // 1 / ss, sc / ss
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
  [[nodiscard]] double phase_degrees() const { return phase_degrees_; }
  [[nodiscard]] const Constants<double>& constants() const { return rough_; }
  [[nodiscard]] const Constants<DoubleDouble>& fine_constants() const { return fine_; }

  // `seen`: the direction in this system, unit. `relative`: every component has a small relative error.
  [[nodiscard]] Reach solve(const Vector3<double>& seen, bool relative, PolarPairs& pairs) const;
  [[nodiscard]] Reach solve(const Vector3<DoubleDouble>& seen, PolarRoots& roots) const;

 private:
  Constants<double> rough_;
  Constants<DoubleDouble> fine_;
  Count phase_;
  double phase_degrees_ = 0;
  bool invertible_ = false;
  bool plus_ = false;
  bool minus_ = false;
  bool orthogonal_ = false;
  bool along_axes_ = false;
};

[[gnu::always_inline]] inline Reach PolarFrame::solve(const Vector3<double>& seen, bool relative,
                                                      PolarPairs& pairs) const {
  // With an absolute error of 2^-50 in every component the azimuth loses a few bits here, and psi there.
  constexpr double kSteep = 0x1p-3;
  constexpr double kEdge = 0x1p-4;
  const double n2 = seen.x * seen.x + seen.y * seen.y;
  if (n2 == 0 || (!relative && n2 < kSteep * kSteep)) [[unlikely]]
    return Reach::unsure;
  const double k = seen.z;
  if (orthogonal_) [[likely]] {
    // c(psi) = (0, -sin psi, cos psi).
    const double width = std::sqrt(n2);
    pairs.cos_psi = k;
    pairs.sin_psi = width;
    pairs.hx = 0;
    pairs.hy = -width;
    pairs.middle = DoublePair{};
    pairs.apart = DoublePair{-seen.x, seen.y} / width;
    return Reach::two_pairs;
  }
  const Constants<double>& c = rough_;
  double f1 = c.top - k;
  double f2 = k - c.bottom;
  if (plus_ && k > 0)
    f1 = n2 / (1 + k);
  else if (f1 < kEdge)
    return f1 < -kEdge ? Reach::none : Reach::unsure;
  if (minus_ && k < 0)
    f2 = n2 / (1 - k);
  else if (f2 < kEdge)
    return f2 < -kEdge ? Reach::none : Reach::unsure;
  const double per_n2 = 1 / n2;
  pairs.cos_psi = (k - c.cc) * c.per_ss;
  pairs.sin_psi = std::sqrt(f1 * f2) * c.per_ss;
  // cos a sin b - sin a cos b cos psi, without cancellation at the end that is near.
  pairs.hx = f1 <= f2 ? c.skew + c.sc_per_ss * f1 : c.sum - c.sc_per_ss * f2;
  pairs.hy = -(c.sa * pairs.sin_psi);
  pairs.middle = DoublePair{seen.y, seen.x} * (pairs.hx * per_n2);
  pairs.apart = DoublePair{seen.x, -seen.y} * (pairs.hy * per_n2);
  return Reach::two_pairs;
}

template <class T>
Vector3<T> seen_from(const PolarFrame::Constants<T>& constants, const Vector3<T>& v) {
  return {dot(constants.row[0], v), dot(constants.row[1], v), dot(constants.row[2], v)};
}
template <class T>
Vector3<T> seen_back(const PolarFrame::Constants<T>& constants, const Vector3<T>& v) {
  return constants.row[0] * v.x + constants.row[1] * v.y + constants.row[2] * v.z;
}

}  // namespace toolcomp::fast
