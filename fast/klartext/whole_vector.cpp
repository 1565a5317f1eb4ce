#include "fast/klartext/whole_vector.h"

namespace toolcomp::fast::klartext {

bool not_normalized(const WholeVector& v) {
  if (v.narrow) [[likely]] {
    constexpr std::int64_t kSquare = WholeVector::kOne * WholeVector::kOne;
    const std::int64_t excess = v.small[0] * v.small[0] + v.small[1] * v.small[1] + v.small[2] * v.small[2] - kSquare;
    constexpr std::int64_t kLimit = kSquare / 5000;
    return excess > kLimit || excess < -kLimit;
  }
  // 5000 |v·v − 1| > 1 in units of 1e-36, whose 1 is Wide(1e18)².
  constexpr Int128 kOne = Int128{1'000'000'000} * 1'000'000'000;
  const WideVector3 exact = v.exact();
  const Wide excess = dot(exact, exact) - Wide(kOne) * Wide(kOne);
  const Wide magnitude = excess.sign() < 0 ? -excess : excess;
  return (Wide(5000) * magnitude - Wide(kOne) * Wide(kOne)).sign() > 0;
}

}  // namespace toolcomp::fast::klartext
