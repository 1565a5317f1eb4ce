// 3D-ToolComp: deviations of the corner radius by the contact angle (sheet 5.9).
#pragma once

#include <cstddef>
#include <vector>

#include "fast/arithmetic/count.h"
#include "fast/face_milling/contact_angle.h"
#include "spec/language/setup.h"

namespace toolcomp::fast::klartext {

class DeviationTable {
 public:
  // At least one point, angles ascending.
  explicit DeviationTable(const spec::DeviationTable& points);
  // Deviations are in mm.
  void set_units(Factor factor);

  // tau in units of the program, or E_3DTC_RANGE: false.
  [[nodiscard]] bool find(const ContactAngle& angle, double& deviation) const;
  // After find(): corner + tau < 0, exactly.
  [[nodiscard]] bool below(const Count& corner, const ContactAngle& angle, double deviation) const;

 private:
  struct Point {
    Count angle, deviation;
    double degrees = 0, value = 0;
  };
  // The first of the two points of the segment.
  [[nodiscard]] std::size_t segment(double degrees) const;

  const spec::DeviationTable& points_;
  std::vector<Point> point_;
};

}  // namespace toolcomp::fast::klartext
