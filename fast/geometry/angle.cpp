// SPDX-License-Identifier: Apache-2.0
#include "fast/geometry/angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "fast/arithmetic/trigonometry.h"

namespace toolcomp::fast {
namespace {

constexpr int kSteps = 64;
// atan(i / 64) in degrees, nearest doubles.
constexpr std::array<double, kSteps + 1> kArcTangent{0,
                                                     0.8951737102110743,
                                                     1.7899106082460694,
                                                     2.6837751594689845,
                                                     3.576334374997351,
                                                     4.467159061389273,
                                                     5.35582504285519,
                                                     6.241914347415048,
                                                     7.125016348901798,
                                                     8.004728857292855,
                                                     8.880659150520245,
                                                     9.752424941653784,
                                                     10.619655276155134,
                                                     11.481991354748095,
                                                     12.339087278326195,
                                                     13.190610712206851,
                                                     14.036243467926479,
                                                     14.875682001638797,
                                                     15.708637829015744,
                                                     16.534837857345153,
                                                     17.35402463626132,
                                                     18.16595652922553,
                                                     18.970407808486545,
                                                     19.76716867679165,
                                                     20.556045219583464,
                                                     21.336859291805652,
                                                     22.109448343751673,
                                                     22.873665190626713,
                                                     23.629377730656817,
                                                     24.37646861667477,
                                                     25.11483488614456,
                                                     25.844387554560335,
                                                     26.56505117707799,
                                                     27.276763383113682,
                                                     27.979474388480146,
                                                     28.67314648943499,
                                                     29.357753542791272,
                                                     30.033280435995138,
                                                     30.699722550814414,
                                                     31.357085224009932,
                                                     32.005383208083494,
                                                     32.64464013491648,
                                                     33.27488798483492,
                                                     33.89616656336391,
                                                     34.5085229876684,
                                                     35.1120111844222,
                                                     35.706691400602885,
                                                     36.2926297284796,
                                                     36.86989764584402,
                                                     37.43857157233304,
                                                     37.99873244250466,
                                                     38.550465296157725,
                                                     39.0938588862295,
                                                     39.62900530446429,
                                                     40.15599962491932,
                                                     40.67493956526154,
                                                     41.18592516570965,
                                                     41.68905848538856,
                                                     42.18444331578877,
                                                     42.67218491095885,
                                                     43.1523897340054,
                                                     43.62516521943059,
                                                     44.09061955080086,
                                                     44.548861453212716,
                                                     45};

// atan(r) in degrees for |r| <= 1/128: r (1 - r^2/3 + r^4/5 - r^6/7), the rest is below 2^-59 of it.
constexpr std::array<double, 4> kSeries{57.29577951308232, -19.09859317102744, 11.459155902616464, -8.18511135901176};

}  // namespace

double polar_angle(double x, double y) {
  const double ax = std::abs(x);
  const double ay = std::abs(y);
  // Up to 45 degrees: from the nearest angle of the table by the tangent of the difference.
  const double tangent = std::min(ax, ay) / std::max(ax, ay);
  const double step = nearest_whole(kSteps * tangent);
  const double near = step / kSteps;
  const double r = (tangent - near) / (1 + tangent * near);
  const double s = r * r;
  const double rest = r * (kSeries[0] + s * (kSeries[1] + s * (kSeries[2] + s * kSeries[3])));
  const double angle = kArcTangent[static_cast<std::size_t>(step)] + rest;
  // The octant; in which it is cannot be foreseen: no branch.
  static constexpr std::array<double, 4> kFrom{0, 90, 180, 90};
  static constexpr std::array<double, 4> kSense{1, -1, -1, 1};
  const std::size_t octant = (ay > ax ? 1U : 0U) + (x < 0 ? 2U : 0U);
  return std::copysign(kFrom[octant] + kSense[octant] * angle, y);
}

}  // namespace toolcomp::fast
