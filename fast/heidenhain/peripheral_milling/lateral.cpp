// SPDX-License-Identifier: Apache-2.0
#include "fast/heidenhain/peripheral_milling/lateral.h"

namespace toolcomp::fast::klartext {
namespace {

FineVector3 fine(const Displacement& travel) {
  if (travel.narrow) return {{travel.value[0], 0}, {travel.value[1], 0}, {travel.value[2], 0}};
  return {to_double_double(travel.wide[0]), to_double_double(travel.wide[1]), to_double_double(travel.wide[2])};
}

// Below 2^192 with a tool vector below 2^64.
WideVector3 exact_cross(const Lateral& c) {
  const auto d = c.travel->whole();
  const WideVector3 travel{Wide(d[0]), Wide(d[1]), Wide(d[2])};
  return cross(c.tool->vector().exact(), travel);
}

DoubleDouble length(const FineVector3& v) { return sqrt(dot(v, v)); }

// c to about 2^-90, or as good as the whole numbers allow.
FineVector3 fine_unit(const Lateral& c) {
  FineVector3 v = cross(c.tool->fine(), fine(*c.travel));
  if (c.tool->is_whole()) {
    const double square =
        dot(Vector(nearest(c.tool->fine())), Vector(nearest(c.tool->fine()))) * c.travel->value.squaredNorm();
    if (dot(v, v).hi < 0x1p-20 * square) {
      const WideVector3 exact = exact_cross(c);
      v = {exact.x.to_double_double(), exact.y.to_double_double(), exact.z.to_double_double()};
    }
  }
  const DoubleDouble size = length(v);
  const DoubleDouble one{c.side > 0 ? 1.0 : -1.0, 0};
  return {v.x / size * one, v.y / size * one, v.z / size * one};
}

Vector signed_unit(const Vector& v, int side) { return v * (side / std::sqrt(dot(v, v))); }

Vector nearest(const WideVector3& v) { return {v.x.to_double(), v.y.to_double(), v.z.to_double()}; }

// |t x d| may be off by so much, where the ends of d are rounded: by themselves, and by the product.
double rounding_of(const FineVector3& tool, const FineVector3& travel, double slack) {
  const double t = length(tool).hi;
  return t * (2 * slack + 0x1p-90 * length(travel).hi);
}

// The same of the direction, as an angle; 0 where the ends of d are exact.
double angle_off(const Lateral& c) {
  if (c.travel->slack == 0) return 0;
  const FineVector3 tool = c.tool->fine();
  const FineVector3 travel = fine(*c.travel);
  return rounding_of(tool, travel, c.travel->slack) / length(cross(tool, travel)).hi;
}

// Of directions that are opposite but for a hair: c turned by a right angle within their plane, as long as the tangent
// of half their angle, and c. Their sum is so short that it has lost its direction. `axis`: of the turn from c to c',
// unit; `sine`: of their angle; `share`: 1 + c.c'.
Vector long_mitre(const Vector& c, const Vector& axis, double sine, double share) {
  return c + cross(axis, c) * ((2 - share) / sine);
}

}  // namespace

bool lean_direction(const Lateral& made_from, Vector& c) {
  const FineVector3 tool = made_from.tool->fine();
  const FineVector3 travel = fine(*made_from.travel);
  const FineVector3 v = cross(tool, travel);
  const double square = dot(nearest(tool), nearest(tool)) * dot(nearest(travel), nearest(travel));
  const double sine = dot(nearest(v), nearest(v)) / square;  // squared
  if (const double slack = made_from.travel->slack; slack != 0) {
    if (length(v).hi <= rounding_of(tool, travel, slack)) return false;
    c = signed_unit(Vector(nearest(v)), made_from.side);
    return true;
  }
  if (made_from.tool->is_whole() && sine < 0x1p-80) {
    const WideVector3 exact = exact_cross(made_from);
    if (exact.x.sign() == 0 && exact.y.sign() == 0 && exact.z.sign() == 0) return false;
    c = signed_unit({exact.x.to_double(), exact.y.to_double(), exact.z.to_double()}, made_from.side);
    return true;
  }
  if (sine < 0x1p-180) return false;
  c = signed_unit(Vector(nearest(v)), made_from.side);
  return true;
}

bool sharp_mitre(const Lateral& c, const Lateral& next, Vector& between) {
  const FineVector3 own = fine_unit(c);
  const FineVector3 other = fine_unit(next);
  const FineVector3 sum = own + other;
  const DoubleDouble square = dot(sum, sum);  // 2 (1 + c.c')
  if (const double off = angle_off(c) + angle_off(next); off != 0 && square.hi <= 4 * off * off) return false;
  if (square.hi >= 0x1p-80) {
    const DoubleDouble two{2, 0};
    between = Vector(nearest(FineVector3{two * sum.x / square, two * sum.y / square, two * sum.z / square}));
    return true;
  }
  const Vector unit(nearest(own));
  const double share = square.hi / 2;
  if (c.tool->is_whole() && next.tool->is_whole()) {
    const WideVector3 a = exact_cross(c);
    const WideVector3 b = exact_cross(next);
    const Vector turn = nearest(cross(a, b));
    const double size = dot(turn, turn);
    // Opposite it is: a double cannot come near 1 + c.c' = 0 from vectors that agree.
    if (size == 0) return false;
    const double lengths = dot(nearest(a), nearest(a)) * dot(nearest(b), nearest(b));
    between = long_mitre(unit, signed_unit(turn, c.side * next.side), std::sqrt(size / lengths), share);
    return true;
  }
  if (square.hi < 0x1p-170) return false;
  const Vector turn(nearest(cross(own, other)));
  const double size = dot(turn, turn);
  if (size == 0) return false;
  // Both are across the same tool, as a rule: it is the axis, better than so short a product.
  const int along = c.tool == next.tool ? (dot(turn, c.tool->unit()) < 0 ? -1 : 1) : 0;
  const Vector axis = along == 0 ? signed_unit(turn, 1) : c.tool->unit() * along;
  between = long_mitre(unit, axis, std::sqrt(size), share);
  return true;
}

}  // namespace toolcomp::fast::klartext
