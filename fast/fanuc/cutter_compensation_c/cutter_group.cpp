// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/cutter_compensation_c/cutter_group.h"

#include <cmath>

namespace toolcomp::fast {
namespace {

// Two heads of a group in one axis: |a - b| against the limit of No. 5010.
struct Distance {
  const CutterGroup& group;
  std::size_t a;
  std::size_t b;
  const CornerParameters& parameters;

  [[nodiscard]] double scale(double va, double vb) const {
    return std::abs(va) + std::abs(vb) + group.corner.offset->nearest + parameters.limit_value;
  }
  // > 0 beyond it, < 0 within it; 0 where doubles cannot tell.
  [[nodiscard]] double over(double Vector2<double>::* axis) const {
    const double va = group.head[a].vector.*axis;
    const double vb = group.head[b].vector.*axis;
    const double over = std::abs(va - vb) - parameters.limit_value;
    return std::abs(over) > 0x1p-46 * scale(va, vb) ? over : 0;
  }
  // What double-double cannot tell is taken for equal.
  [[nodiscard]] bool is_finely_within(DoubleDouble Vector2<DoubleDouble>::* axis) const {
    const DoubleDouble va = group.fine(a).*axis;
    const DoubleDouble vb = group.fine(b).*axis;
    const DoubleDouble difference = va - vb;
    const DoubleDouble over = (difference.hi < 0 ? -difference : difference) - parameters.fine_limit();
    return over.hi <= 0x1p-88 * scale(va.hi, vb.hi);
  }
};

}  // namespace

CutterParameters::CutterParameters(const spec::Setup& setup)
    : CornerParameters(setup), acts_alone(setup.bit(5003, 1)), keeps_mode(setup.bit(5003, 2)) {
  interference.keeps_vectors = setup.series == spec::Series::series_30i && setup.bit(5008, 3);
  interference.no_direction_alarm = setup.bit(5008, 1);
}

// (tan 1 k)^2 > c^2.
bool CutterGroups::is_under_one_degree(const Corner& corner) {
  const double left = kTangentOfOneDegree.hi * corner.turn.k;
  const double difference = left * left - corner.turn.c * corner.turn.c;
  if (std::abs(difference) > 0x1p-48 * left * left) return difference > 0;
  const Vector2<DoubleDouble> t1 = fine_unit(*corner.last);
  const Vector2<DoubleDouble> t2 = fine_unit(*corner.next);
  const DoubleDouble tangent = kTangentOfOneDegree * dot(t1, t2);
  const DoubleDouble sine = fast::cross(t1, t2);
  return (tangent * tangent - sine * sine).hi > 0;
}

bool CutterGroups::is_small_movement(const CutterGroup& group, std::size_t a, std::size_t b) const {
  const Distance distance{group, a, b, parameters_};
  const double x = distance.over(&Vector2<double>::x);
  const double y = distance.over(&Vector2<double>::y);
  if (x > 0 || y > 0) return false;
  return (x < 0 || distance.is_finely_within(&Vector2<DoubleDouble>::x)) &&
         (y < 0 || distance.is_finely_within(&Vector2<DoubleDouble>::y));
}

}  // namespace toolcomp::fast
