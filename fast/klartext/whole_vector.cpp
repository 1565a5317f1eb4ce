#include "fast/klartext/whole_vector.h"

namespace toolcomp::fast::klartext {

bool not_normalized_wide(const WholeVector& v) {
  // 5000 |v·v − 1| > 1 in units of 1e-36, whose 1 is Wide(1e18)².
  constexpr Int128 kOne = Int128{1'000'000'000} * 1'000'000'000;
  const WideVector3 exact = v.exact();
  const Wide excess = dot(exact, exact) - Wide(kOne) * Wide(kOne);
  const Wide magnitude = excess.sign() < 0 ? -excess : excess;
  return (Wide(5000) * magnitude - Wide(kOne) * Wide(kOne)).sign() > 0;
}

}  // namespace toolcomp::fast::klartext
