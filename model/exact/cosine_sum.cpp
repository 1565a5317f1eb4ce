// SPDX-License-Identifier: Apache-2.0
#include "model/exact/cosine_sum.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace toolcomp::exact {
namespace {

// A prime p in a denominator that is not 2, 3 or 5 makes a term into up to p - 1 terms.
constexpr std::int64_t greatest_prime = 1000;
// Sums of two multiples must not overflow.
constexpr std::int64_t greatest_order = std::int64_t{1} << 61;

mpz_srcptr raw(const Integer& x) { return x.raw(); }
mpz_ptr raw(Integer& x) { return x.raw(); }

std::int64_t words(const Integer& x) { return 1 + static_cast<std::int64_t>(mpz_size(raw(x))); }

// weight * 2 cos(angle) with the angle brought below a quarter turn; weight 0 where the cosine is.
struct Folded {
  std::int64_t angle;
  int weight;
};
Folded fold(const Circle& circle, std::int64_t angle) {
  const std::int64_t turn = circle.order();
  angle %= turn;
  if (angle < 0) angle += turn;
  if (angle > turn / 2) angle = turn - angle;
  int weight = 1;
  if (angle > turn / 4) {
    angle = turn / 2 - angle;
    weight = -1;
  }
  if (angle == 0) return {0, 2 * weight};
  if (angle == turn / 4) return {0, 0};
  if (angle == turn / 6) return {0, weight};
  return {angle, weight};
}

// weight * a[i] * b[j] at an angle.
struct Part {
  std::int64_t angle;
  int weight;
  std::uint32_t i;
  std::uint32_t j;
};

void add_product(Integer& sum, const Integer& a, const Integer& b, int weight) {
  switch (weight) {
    case 2:
      mpz_addmul(raw(sum), raw(a), raw(b));
      [[fallthrough]];
    case 1:
      mpz_addmul(raw(sum), raw(a), raw(b));
      break;
    case -2:
      mpz_submul(raw(sum), raw(a), raw(b));
      [[fallthrough]];
    case -1:
      mpz_submul(raw(sum), raw(a), raw(b));
      break;
    default:
      break;
  }
}

// A power of the primitive root of unity of the circle's order, with a coefficient.
struct Power {
  std::int64_t exponent;
  Integer coefficient;
};
using Powers = std::vector<Power>;

// x^(order/2) = -1.
void push(Powers& powers, const Circle& circle, std::int64_t exponent, Integer coefficient) {
  const std::int64_t half = circle.order() / 2;
  if (exponent >= half) {
    exponent -= half;
    mpz_neg(raw(coefficient), raw(coefficient));
  }
  powers.push_back({exponent, std::move(coefficient)});
}

void collect(Powers& powers, Work& work) {
  work.spend(static_cast<std::int64_t>(powers.size()));
  std::sort(powers.begin(), powers.end(), [](const Power& a, const Power& b) { return a.exponent < b.exponent; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < powers.size();) {
    Power sum = std::move(powers[i]);
    for (++i; i < powers.size() && powers[i].exponent == sum.exponent; ++i) sum.coefficient += powers[i].coefficient;
    if (!sum.coefficient.is_zero()) powers[kept++] = std::move(sum);
  }
  powers.erase(powers.begin() + static_cast<std::ptrdiff_t>(kept), powers.end());
}

Powers powers_of(const Circle& circle, const CosineSum& sum) {
  Powers powers;
  powers.reserve(2 * sum.size());
  for (const CosineTerm& term : sum) {
    push(powers, circle, term.angle, term.coefficient);
    if (term.angle != 0) push(powers, circle, circle.order() - term.angle, term.coefficient);
  }
  return powers;
}

// The powers whose component at p is 0 are replaced by the others: the p powers that differ by order/p add up to zero.
Powers without_component(const Circle& circle, Powers powers, std::int64_t p, Work& work) {
  Powers result;
  result.reserve(2 * powers.size());
  const std::int64_t step = circle.order() / p;
  for (Power& power : powers) {
    if (power.exponent / circle.classes() % p != 0) {
      result.push_back(std::move(power));
      continue;
    }
    work.spend(p);
    const Integer opposite = -power.coefficient;
    for (std::int64_t k = 1; k < p; ++k) push(result, circle, (power.exponent + k * step) % circle.order(), opposite);
  }
  collect(result, work);
  return result;
}

}  // namespace

Circle::Circle(const Integer& denominator) {
  const Integer order = 360 * denominator;
  if (order > greatest_order) throw OutOfWork{};
  order_ = static_cast<std::int64_t>(order);
  std::int64_t rest = order_;
  std::int64_t radical = 1;
  for (std::int64_t p = 2; p <= greatest_prime && rest > 1; ++p) {
    if (rest % p != 0) continue;
    while (rest % p == 0) rest /= p;
    radical *= p;
    if (p != 2) odd_primes_.push_back(p);
  }
  if (rest != 1) throw OutOfWork{};
  classes_ = order_ / radical;
}

std::int64_t Circle::multiple(const Rational& degrees) const {
  const Rational steps = degrees * Rational(order_ / 360);
  return static_cast<std::int64_t>(Integer(numerator(steps) % order_));
}

CosineSum cosine_sum(const Integer& constant) {
  if (constant.is_zero()) return {};
  return {{0, constant}};
}

CosineSum twice_cosine(const Circle& circle, std::int64_t angle) {
  const Folded folded = fold(circle, angle);
  if (folded.weight == 0) return {};
  return {{folded.angle, folded.weight}};
}

CosineSum add(const CosineSum& a, const CosineSum& b, Work& work) {
  work.spend(static_cast<std::int64_t>(a.size() + b.size()));
  CosineSum sum;
  sum.reserve(a.size() + b.size());
  auto x = a.begin();
  auto y = b.begin();
  while (x != a.end() || y != b.end()) {
    if (y == b.end() || (x != a.end() && x->angle < y->angle)) {
      sum.push_back(*x++);
    } else if (x == a.end() || y->angle < x->angle) {
      sum.push_back(*y++);
    } else {
      Integer coefficient = x->coefficient + y->coefficient;
      if (!coefficient.is_zero()) sum.push_back({x->angle, std::move(coefficient)});
      ++x;
      ++y;
    }
  }
  return sum;
}

// 2 cos(s) * 2 cos(t) = 2 cos(s + t) + 2 cos(s - t).
CosineSum multiply(const Circle& circle, const CosineSum& a, const CosineSum& b, Work& work) {
  work.spend(static_cast<std::int64_t>(2 * a.size() * b.size()));
  std::vector<Part> parts;
  parts.reserve(2 * a.size() * b.size());
  const auto push_part = [&](std::int64_t angle, std::size_t i, std::size_t j) {
    const Folded folded = fold(circle, angle);
    if (folded.weight != 0)
      parts.push_back({folded.angle, folded.weight, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)});
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (a[i].angle == 0 || b[j].angle == 0) {
        parts.push_back({a[i].angle + b[j].angle, 1, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)});
      } else {
        push_part(a[i].angle + b[j].angle, i, j);
        push_part(a[i].angle - b[j].angle, i, j);
      }
    }
  }
  std::sort(parts.begin(), parts.end(), [](const Part& s, const Part& t) { return s.angle < t.angle; });
  CosineSum product;
  for (std::size_t k = 0; k < parts.size();) {
    const std::int64_t angle = parts[k].angle;
    Integer sum;
    for (; k < parts.size() && parts[k].angle == angle; ++k) {
      const Integer& s = a[parts[k].i].coefficient;
      const Integer& t = b[parts[k].j].coefficient;
      work.spend(words(s) * words(t) / 4);
      add_product(sum, s, t, parts[k].weight);
    }
    if (!sum.is_zero()) product.push_back({angle, std::move(sum)});
  }
  return product;
}

void multiply_by(CosineSum& a, const Integer& factor, Work& work) {
  for (CosineTerm& term : a) {
    work.spend(words(term.coefficient) * words(factor) / 4 + 1);
    term.coefficient *= factor;
  }
}

// With N the order, r the product of its primes and y = x^(N/r), the powers of x fall into N/r classes that are
// independent over Q(y), the field of the r-th roots of unity. There a basis is made of the powers of y whose component
// at each prime is not 0 (for the prime 2 a sign does it), so a sum is zero if and only if nothing is left of it.
bool vanishes(const Circle& circle, const CosineSum& a, Work& work) {
  if (a.empty()) return true;
  if (a.size() == 1) return false;
  Powers powers = powers_of(circle, a);
  collect(powers, work);
  for (const std::int64_t p : circle.odd_primes()) powers = without_component(circle, std::move(powers), p, work);
  return powers.empty();
}

}  // namespace toolcomp::exact
