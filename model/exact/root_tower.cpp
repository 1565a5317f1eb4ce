// SPDX-License-Identifier: Apache-2.0
#include "model/exact/root_tower.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>

#include "model/exact/refinement.h"
#include "model/exact/trigonometry.h"

namespace toolcomp::exact {
namespace {

constexpr std::size_t greatest_roots = 64;
constexpr std::size_t greatest_unknowns = 8;
constexpr std::size_t bits_of_power = 8;
constexpr Powers too_great = 0x8080808080808080;  // the highest bit of each exponent
constexpr mpfr_prec_t first_precision = 128;

mpz_srcptr raw(const Integer& x) { return x.raw(); }
mpz_ptr raw(Integer& x) { return x.raw(); }

Roots bit(std::size_t root) { return Roots{1} << root; }
std::size_t last(Roots roots) { return static_cast<std::size_t>(std::bit_width(roots)) - 1; }

Roots used_roots(const Element& e) {
  Roots used = 0;
  for (const RootTerm& term : e) used |= term.roots;
  return used;
}

Roots common_roots(const Element& e) {
  Roots common = ~Roots{0};
  for (const RootTerm& term : e) common &= term.roots;
  return common;
}

// Divides by roots that all terms have; the order of the terms stays.
Element without(Element e, Roots common) {
  for (RootTerm& term : e) term.roots &= ~common;
  return e;
}

// The terms with and without a root; the root is taken out.
struct Split {
  Element rest;
  Element factor;
};
Split split(const Element& e, std::size_t root) {
  Split parts;
  for (const RootTerm& term : e) {
    if ((term.roots & bit(root)) != 0)
      parts.factor.push_back({term.roots & ~bit(root), term.powers, term.factor});
    else
      parts.rest.push_back(term);
  }
  return parts;
}

}  // namespace

Element RootTower::constant(const Integer& value) const {
  if (value.is_zero()) return {};
  return {{0, 0, cosine_sum(value)}};
}

Element RootTower::twice_cosine(std::int64_t angle) const {
  CosineSum sum = exact::twice_cosine(circle_, angle);
  if (sum.empty()) return {};
  return {{0, 0, std::move(sum)}};
}

Element RootTower::unknown(Node& node) {
  if (unknowns_.size() == greatest_unknowns) throw OutOfWork{};
  unknowns_.push_back(&node);
  return {{0, Powers{1} << (bits_of_power * (unknowns_.size() - 1)), cosine_sum(1)}};
}

Element RootTower::root_of(const Element& radicand) {
  if (radicand.empty()) return {};
  const auto known = std::find_if(roots_.begin(), roots_.end(), [&](const Root& r) { return r.radicand == radicand; });
  const auto index = static_cast<std::size_t>(known - roots_.begin());
  if (known == roots_.end()) {
    if (roots_.size() == greatest_roots) throw OutOfWork{};
    roots_.push_back({radicand, std::nullopt});
  }
  return {{bit(index), 0, cosine_sum(1)}};
}

Element RootTower::add(const Element& a, const Element& b) {
  Element terms;
  terms.reserve(a.size() + b.size());
  for (const Element* part : {&a, &b}) {
    for (const RootTerm& term : *part) {
      work_.spend(1 + static_cast<std::int64_t>(term.factor.size()));
      terms.push_back(term);
    }
  }
  return collected(std::move(terms));
}

Element RootTower::multiply(const Element& a, const Element& b) {
  Element terms;
  for (const RootTerm& x : a) {
    for (const RootTerm& y : b) {
      CosineSum factor = exact::multiply(circle_, x.factor, y.factor, work_);
      if (factor.empty()) continue;
      const Powers powers = x.powers + y.powers;
      if ((powers & too_great) != 0) throw OutOfWork{};
      Element term{{x.roots ^ y.roots, powers, std::move(factor)}};
      // Roots on both sides leave their radicands, which hold earlier roots only.
      for (Roots squared = x.roots & y.roots; squared != 0; squared &= squared - 1) {
        const auto index = static_cast<std::size_t>(std::countr_zero(squared));
        term = multiply(term, roots_[index].radicand);
      }
      std::move(term.begin(), term.end(), std::back_inserter(terms));
    }
  }
  return collected(std::move(terms));
}

Element RootTower::collected(Element terms) {
  const auto of = [](const RootTerm& term) { return std::pair(term.roots, term.powers); };
  std::ranges::sort(terms, {}, of);
  Element sum;
  for (RootTerm& term : terms) {
    if (sum.empty() || of(sum.back()) != of(term)) {
      if (!sum.empty() && sum.back().factor.empty()) sum.pop_back();
      sum.push_back(std::move(term));
    } else {
      sum.back().factor = exact::add(sum.back().factor, term.factor, work_);
    }
  }
  if (!sum.empty() && sum.back().factor.empty()) sum.pop_back();
  return sum;
}

void RootTower::multiply_by(Element& a, const Integer& factor) {
  if (factor == 1) return;
  for (RootTerm& term : a) exact::multiply_by(term.factor, factor, work_);
}

bool RootTower::root_vanishes(std::size_t index) {
  if (!roots_[index].zero) roots_[index].zero = vanishes(Element(roots_[index].radicand));
  return *roots_[index].zero;
}

Element RootTower::pruned(Element e) {
  std::erase_if(e, [this](const RootTerm& term) { return exact::vanishes(circle_, term.factor, work_); });
  return e;
}

bool RootTower::vanishes(const Element& unpruned) {
  const Element e = pruned(unpruned);
  if (e.empty()) return true;
  const Roots used = used_roots(e);
  if (used == 0) return false;  // sums with distinct powers, none of them pruned
  if (const Roots common = common_roots(e); common != 0) {
    if (vanishes(without(e, common))) return true;
    for (Roots left = common; left != 0; left &= left - 1)
      if (root_vanishes(static_cast<std::size_t>(std::countr_zero(left)))) return true;
    return false;
  }
  const std::size_t root = last(used);
  const Split parts = split(e, root);
  Element difference = multiply(parts.factor, parts.factor);
  difference = multiply(difference, roots_[root].radicand);
  negate(difference);
  difference = add(multiply(parts.rest, parts.rest), difference);
  return vanishes(difference) && opposite(e, parts.rest);
}

// For whole = A + B s with A*A = B*B*s*s, the whole is 0 or 2 A: decided by the signs of whole and A.
bool RootTower::opposite(const Element& whole, const Element& rest) {
  bool rest_known_nonzero = false;
  for (mpfr_prec_t precision = first_precision;; precision *= 2) {
    HeapInterval value(precision);
    enclose(value, whole);
    if (certain_sign(value)) return *certain_sign(value) == Sign::zero;
    HeapInterval of_rest(precision);
    enclose(of_rest, rest);
    HeapInterval twice(precision);
    exact::add(twice, of_rest, of_rest);
    const bool apart = mpfr_less_p(value.upper, twice.lower) != 0 || mpfr_greater_p(value.lower, twice.upper) != 0;
    if (apart) return true;
    if (!rest_known_nonzero) {
      if (vanishes(rest)) return true;
      rest_known_nonzero = true;
    }
  }
}

void RootTower::enclose(Interval& result, const CosineSum& sum) {
  const mpfr_prec_t precision = result.precision();
  const std::int64_t limbs = precision / GMP_NUMB_BITS;
  HeapInterval cosine(precision);
  HeapInterval coefficient(precision);
  HeapInterval product(precision);
  HeapInterval total(precision);
  for (const CosineTerm& term : sum) {
    work_.spend(20 + limbs * limbs);
    exact::set(coefficient, raw(term.coefficient));
    if (term.angle == 0) {
      exact::set(product, coefficient);
    } else {
      const Rational degrees(Integer(term.angle) * 360, Integer(circle_.order()));
      sine_and_cosine(nullptr, &cosine, degrees.raw());
      exact::multiply(product, coefficient, cosine);
      mpfr_mul_2ui(product.lower, product.lower, 1, MPFR_RNDD);
      mpfr_mul_2ui(product.upper, product.upper, 1, MPFR_RNDU);
    }
    exact::add(total, result, product);
    exact::set(result, total);
  }
}

void RootTower::enclose(Interval& result, const Element& e) {
  const mpfr_prec_t precision = result.precision();
  HeapInterval total(precision);
  exact::set(total, raw(Integer(0)));
  for (const RootTerm& term : e) {
    HeapInterval product(precision);
    exact::set(product, raw(Integer(0)));
    enclose(product, term.factor);
    for (Roots roots = term.roots; roots != 0; roots &= roots - 1) {
      HeapInterval radicand(precision);
      HeapInterval root(precision);
      HeapInterval next(precision);
      enclose(radicand, roots_[static_cast<std::size_t>(std::countr_zero(roots))].radicand);
      exact::root(root, radicand);
      exact::multiply(next, product, root);
      exact::set(product, next);
    }
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
      Powers left = term.powers >> (bits_of_power * i) & 0x7F;
      if (left == 0) continue;
      refine(*unknowns_[i], precision, work_);
      for (; left != 0; --left) {
        HeapInterval next(precision);
        exact::multiply(next, product, *unknowns_[i]->refined);
        exact::set(product, next);
      }
    }
    exact::add(result, total, product);
    exact::set(total, result);
  }
  exact::set(result, total);
}

std::optional<Integer> integer_value(const Element& e) {
  if (e.empty()) return Integer(0);
  if (e.size() > 1 || e.front().roots != 0 || e.front().powers != 0) return std::nullopt;
  const CosineSum& sum = e.front().factor;
  if (sum.size() > 1 || sum.front().angle != 0) return std::nullopt;
  return sum.front().coefficient;
}

Integer content(const Element& e) {
  Integer divisor = 0;
  for (const RootTerm& term : e) {
    for (const CosineTerm& part : term.factor) {
      mpz_gcd(raw(divisor), raw(divisor), raw(part.coefficient));
      if (divisor == 1) return divisor;
    }
  }
  return divisor;
}

void divide_by(Element& e, const Integer& divisor) {
  if (divisor == 1) return;
  for (RootTerm& term : e)
    for (CosineTerm& part : term.factor) mpz_divexact(raw(part.coefficient), raw(part.coefficient), raw(divisor));
}

void negate(Element& e) {
  for (RootTerm& term : e)
    for (CosineTerm& part : term.factor) mpz_neg(raw(part.coefficient), raw(part.coefficient));
}

}  // namespace toolcomp::exact
