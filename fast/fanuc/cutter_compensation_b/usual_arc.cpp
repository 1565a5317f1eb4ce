// SPDX-License-Identifier: Apache-2.0
// The usual arc of cutter compensation B: by its centre, and nothing of it cancels, so that doubles are enough.
#include <cmath>

#include "fast/basis/fault.h"
#include "fast/basis/short_cut.h"
#include "fast/fanuc/corner/tool_arc.h"
#include "fast/fanuc/cutter_compensation_b/cutter_compensation_b.h"
#include "fast/geometry/path.h"

namespace toolcomp::fast {

// Heads, the tool's places from the centre of its arc, are sums of two terms that are right to a few 2^-53. Radii that
// may be equal go the general way: 2^-44 of the terms is far more than their errors.
bool CutterCompensationB::usual_arc() {
  if (!is_open(ShortCut::cutter_b_arc) || block_.by_radius || fault(Fault::arc_vector_wrong_side) ||
      fault(Fault::arc_radii_dropped))
    return false;
  constexpr auto kPerOne = static_cast<double>(Count::kSmallPerOne);
  std::array<double, 2> from{};
  std::array<double, 2> to{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Count& start = block_.start[i];
    const Count& end = block_.end[i];
    const Count& to_center = block_.to_center[i];
    if (!start.is_small() || !end.is_small() || !to_center.is_small()) return false;
    const std::int64_t from_center = end.small() - start.small() - to_center.small();
    if (!is_narrow(to_center.small()) || !is_narrow(from_center)) return false;
    from[i] = static_cast<double>(-to_center.small());
    to[i] = static_cast<double>(from_center);
  }
  if (to[0] == 0 && to[1] == 0) return false;

  const int sigma = block_.clockwise ? -1 : 1;
  const Vector made = vector_along({DoubleDouble{-sigma * to[0]}, DoubleDouble{-sigma * to[1]}}, signed_offset());
  const Vector2<double> start{from[0] / kPerOne, from[1] / kPerOne};
  const Vector2<double> end{to[0] / kPerOne, to[1] / kPerOne};
  const Vector2<double> v{vector_.value[0], vector_.value[1]};
  const Vector2<double> w{made.value[0], made.value[1]};
  const Vector2<double> first = start + v;
  const Vector2<double> last = end + w;
  const double first_radius = length(first);
  const double last_radius = length(last);
  const double terms = extent(start) + extent(v) + extent(end) + extent(w);
  double sweep = 0;
  if (std::abs(last_radius - first_radius) <= 0x1p-44 * terms ||
      !set_clear_sweep(fault(Fault::usual_b_arc_sense) ? 1 : sigma, start, end, first, last, sweep))
    return false;
  block_.event.arc->sweep = sweep;
  block_.event.arc->radius = {first_radius, fault(Fault::usual_b_arc_radius) ? first_radius : last_radius};
  vector_ = made;
  send(vector_, true);
  return true;
}

}  // namespace toolcomp::fast
