// SPDX-License-Identifier: Apache-2.0
// 3D-ToolComp: deviations of the corner radius by the contact angle (heidenhain.tool.deviation-*).
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "fast/arithmetic/count.h"
#include "fast/heidenhain/program/contact_angle.h"
#include "spec/language/setup.h"

namespace toolcomp::fast::klartext {

class DeviationTable {
 public:
  // At least one point, angles ascending.
  explicit DeviationTable(const spec::DeviationTable& points);
  // Deviations are in mm.
  void set_units(Factor factor);

  // tau in units of the program, and the segment of the table it is from.
  struct Deviation {
    double value = 0;
    std::size_t segment = 0;
  };
  // Begins with the segment of `deviation`. False: E_3DTC_RANGE.
  [[nodiscard]] bool find(const ContactAngle& angle, Deviation& deviation) const {
    const double degrees = angle.degrees();
    constexpr double kSure = 2 * ContactAngle::kError;
    if (degrees - point_.front().degrees > kSure && point_.back().degrees - degrees > kSure &&
        holds(deviation.segment, degrees)) [[likely]] {
      deviation.value = point_[deviation.segment].value_at(degrees);
      return true;
    }
    return find_anew(angle, deviation);
  }
  // After find(): corner + tau < 0, exactly. `nearest` is the double nearest to `corner`.
  [[nodiscard]] bool below(const Count& corner, double nearest, const ContactAngle& angle,
                           const Deviation& deviation) const {
    const double sum = nearest + deviation.value;
    const double bound = point_[deviation.segment].bound + kBound * std::abs(nearest);
    if (sum > bound) [[likely]]
      return false;
    return sum < -bound || exactly_below(corner, angle, deviation.segment);
  }

 private:
  // With the straight line to the next one.
  struct Point {
    Count angle, deviation;
    double degrees = 0, value = 0;
    double rate = 0;   // by degrees
    double bound = 0;  // of the error of a deviation

    [[nodiscard]] double value_at(double other_degrees) const { return value + rate * (other_degrees - degrees); }
  };
  static constexpr double kBound = 0x1p-48;
  // The first of the two points of the segment.
  [[nodiscard]] std::size_t segment(double degrees) const;
  [[nodiscard]] bool holds(std::size_t segment, double degrees) const {
    return segment + 1 < point_.size() && (segment == 0 || point_[segment].degrees <= degrees) &&
           (segment + 2 == point_.size() || degrees < point_[segment + 1].degrees);
  }
  [[nodiscard]] bool find_anew(const ContactAngle& angle, Deviation& deviation) const;
  [[nodiscard]] bool exactly_below(const Count& corner, const ContactAngle& angle, std::size_t segment) const;

  const spec::DeviationTable& points_;
  std::vector<Point> point_;
};

}  // namespace toolcomp::fast::klartext
