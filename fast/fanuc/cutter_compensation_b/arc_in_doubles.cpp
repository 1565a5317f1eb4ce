// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/cutter_compensation_b/arc_in_doubles.h"

#include <cmath>

#include "fast/fanuc/corner/tool_arc.h"

namespace toolcomp::fast {

// Heads, the tool's places from the centre of its arc, are sums of two terms that are right to a few 2^-53. Radii that
// may be equal go the general way: 2^-44 of the terms is far more than their errors.
bool make_arc_in_doubles(const WholePair& from, const WholePair& to, int sigma, DoublePair vector, double offset,
                         ArcInDoubles& arc) {
  const auto is_center = [](const WholePair& at) { return at[0] == 0 && at[1] == 0; };
  if (!is_usual_way(from) || !is_usual_way(to) || is_center(from) || is_center(to)) [[unlikely]]
    return false;
  arc.normal = {-sigma * to[0], -sigma * to[1]};
  const DoublePair normal = to_doubles(arc.normal);
  const DoublePair squares = normal * normal;
  arc.vector = normal * (offset / std::sqrt(squares[0] + squares[1]));
  const DoublePair start = to_doubles(from) / kWholePerOne;
  const DoublePair end = to_doubles(to) / kWholePerOne;
  const DoublePair first = start + vector;
  const DoublePair last = end + arc.vector;
  const DoublePair first_squares = first * first;
  const DoublePair last_squares = last * last;
  const double first_radius = std::sqrt(first_squares[0] + first_squares[1]);
  const double last_radius = std::sqrt(last_squares[0] + last_squares[1]);
  const double terms = extent(start) + extent(vector) + extent(end) + extent(arc.vector);
  arc.radius = DoublePair{first_radius, last_radius};
  return std::abs(last_radius - first_radius) > 0x1p-44 * terms &&
         set_clear_sweep(sigma, to_vector(start), to_vector(end), to_vector(first), to_vector(last), arc.sweep);
}

}  // namespace toolcomp::fast
