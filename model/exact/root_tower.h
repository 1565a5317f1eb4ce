// SPDX-License-Identifier: Apache-2.0
// Polynomials in square roots and unknowns over sums of cosines, and the decision whether one is zero.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/exact/cosine_sum.h"
#include "model/exact/interval.h"
#include "model/exact/node.h"

namespace toolcomp::exact {

/// A set of roots, one bit each, in the order in which the roots were made.
using Roots = std::uint64_t;

/// The exponents of eight unknowns, below 128, a byte each.
using Powers = std::uint64_t;

/// factor * product of the roots * powers of the unknowns.
struct RootTerm {
  Roots roots;
  Powers powers;
  CosineSum factor;
  friend bool operator==(const RootTerm&, const RootTerm&) = default;
};

/// A sum of terms with distinct rising roots and powers and factors that are not empty.
using Element = std::vector<RootTerm>;

/// The square roots of one proof, and its unknowns: numbers of which only bounds are known (pi, arc tangents). The
/// radicand of a root is an element over the roots made before it.
class RootTower {
 public:
  RootTower(Circle circle, Work& work) : circle_(std::move(circle)), work_(work) {}

  [[nodiscard]] const Circle& circle() const { return circle_; }

  [[nodiscard]] Element constant(const Integer& value) const;
  [[nodiscard]] Element twice_cosine(std::int64_t angle) const;
  /// A number that is treated as an indeterminate, a different one for each call. The node must exist until the end of
  /// the proof.
  Element unknown(Node& node);
  /// The root of an element known not to be negative; the same element gives the same root.
  Element root_of(const Element& radicand);

  Element add(const Element& a, const Element& b);
  Element multiply(const Element& a, const Element& b);
  void multiply_by(Element& a, const Integer& factor);

  /// Whether an element e is zero, decided completely if there are no unknowns: with s the last root in e = A + B s, e
  /// is zero if and only if A*A = B*B*s*s and A, B s have opposite signs or are both zero. With unknowns: whether it is
  /// zero for all values of the unknowns. This is a proof, but other zeros are not found.
  bool vanishes(const Element& unpruned);

 private:
  struct Root {
    Element radicand;
    std::optional<bool> zero;
  };

  /// Adds up the terms with the same roots and powers.
  Element collected(Element terms);
  /// Without the terms whose factors are zero.
  Element pruned(Element e);
  bool root_vanishes(std::size_t index);
  bool opposite(const Element& whole, const Element& rest);
  void enclose(Interval& result, const Element& e);
  void enclose(Interval& result, const CosineSum& sum);

  Circle circle_;
  Work& work_;
  std::vector<Root> roots_;
  std::vector<Node*> unknowns_;
};

/// The value of an element that is an integer.
std::optional<Integer> integer_value(const Element& e);
/// The greatest common divisor of all coefficients; 0 for the empty element.
Integer content(const Element& e);
/// Divides all coefficients by a divisor of all of them.
void divide_by(Element& e, const Integer& divisor);
/// Changes the sign.
void negate(Element& e);

}  // namespace toolcomp::exact
