// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/fanuc/leading_edge.h"

#include <algorithm>

#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {
namespace {

bool moves(const Stop& stop) {
  return stop.displacement && std::ranges::any_of(*stop.displacement, certainly_not_zero);
}

// Whether the mode had a value all the way from the block that began it: D0 cancels.
bool has_value(const FanucScene& s, std::size_t block) {
  for (std::size_t i = block + 1; i-- > 0;) {
    const FanucBlock& b = s.program.blocks()[i];
    if (!b.d || *b.d == 0) return false;
    if (b.has_code(kG41_3)) return true;
  }
  return false;
}

}  // namespace

void leading_edge_vector(const FanucScene& s, Holding& holding) {
  exact::Rational range = 1;
  if (const auto p = s.c.setup.parameter(19631)) range = rational(*p);
  if (range >= 45 || s.c.setup.bit(5001, 2) ||
      s.program.has_code({kG10, kG37, kG52, kG92, kG53, kG28, kG29, kG30, kG30_1, kG45, kG46, kG47, kG48}))
    return;
  const Real sine = range > 0 ? exact::sin_degrees(range) : Real(0);
  for (std::size_t i = 0; i + 1 < s.stops.size(); ++i) {
    const Stop& stop = s.stops[i];
    const Stop& next = s.stops[i + 1];
    const FanucBlock& former = s.block(stop);
    const FanucBlock& latter = s.block(next);
    if (former.compensation != kG41_3 || latter.compensation != kG41_3 || latter.says_compensation()) continue;
    if (next.block != stop.block + 1 || !former.is_plain() || !latter.is_plain() || latter.has('D')) continue;
    if (!moves(next) || (!moves(stop) && !former.says_compensation())) continue;
    if (!stop.own->tool_axis || !has_value(s, stop.block)) continue;
    const auto radius = cutter_value(s.c.setup, *former.d);
    if (!radius) continue;
    const Vector& t = *stop.own->tool_axis;
    const Vector& movement = *next.displacement;
    const Vector across = cross(t, movement);
    const Real limit = sine * sine * dot(t, t) * dot(movement, movement);
    if (!certainly_positive(dot(across, across) - limit)) continue;
    const Vector& v = stop.heads.back().vector;
    holding.zero(dot(v, t), stop.event, "component of the vector along the tool");
    holding.zero(dot(v, across), stop.event, "component of the vector across the plane of tool and movement");
    holding.zero(dot(v, v) - Real(exact::Rational(*radius * *radius)), stop.event,
                 "square of the length of the vector, less that of the radius");
    const Real lean = dot(movement, t);
    if (certainly_positive(lean * lean - limit))
      holding.not_negative(-(dot(v, movement) * lean * Real(*radius)), stop.event,
                           "vector against the movement where the tool leans forward: its product");
  }
}

}  // namespace toolcomp::judge::laws
