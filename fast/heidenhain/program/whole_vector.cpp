// SPDX-License-Identifier: Apache-2.0
#include "fast/heidenhain/program/whole_vector.h"

#include <cmath>

namespace toolcomp::fast::klartext {
namespace {

bool normalized(const WholeVector& v) {
  // 5000 |v·v − 1| > 1 in units of 1e-36, whose 1 is Wide(1e18)².
  constexpr Int128 kOne = Int128{1'000'000'000} * 1'000'000'000;
  const WideVector3 exact = v.exact();
  const Wide excess = dot(exact, exact) - Wide(kOne) * Wide(kOne);
  const Wide magnitude = excess.sign() < 0 ? -excess : excess;
  return (Wide(5000) * magnitude - Wide(kOne) * Wide(kOne)).sign() <= 0;
}

}  // namespace

void WholeVector::set_any(const std::array<spec::Decimal, 3>& v) {
  if (v[0].decimals <= kPlaces && v[1].decimals <= kPlaces && v[2].decimals <= kPlaces) {
    set_narrow(v);
    return;
  }
  narrow = false;
  for (std::size_t i = 0; i < 3; ++i) {
    auto magnitude = static_cast<Int128>(v[i].digits);
    for (int place = v[i].decimals; place < kWidePlaces; ++place) magnitude *= 10;
    wide[i] = v[i].negative ? -magnitude : magnitude;
  }
}

UnitVector unit_of_any(const WholeVector& v) {
  const Vector nearest = v.nearest();
  UnitVector u;
  u.scale = 1 / std::sqrt(dot(nearest, nearest));
  u.unit = nearest * u.scale;
  u.normalized = normalized(v);
  return u;
}

}  // namespace toolcomp::fast::klartext
