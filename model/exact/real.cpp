// SPDX-License-Identifier: Apache-2.0
// Construction of values: everything that can be folded to a rational or to a smaller expression is folded here.
#include "model/exact/real.h"

#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

#include "model/exact/node.h"
#include "model/exact/refinement.h"
#include "model/exact/sign.h"
#include "model/exact/trigonometry.h"

namespace toolcomp::exact {
namespace {

bool is_zero(const Node* node) { return node == nullptr || node->is_zero(); }
bool is_unit(const Node& node, int value) { return node.is_rational() && node.value.is_unit(value); }
bool is_negation(const Node& node) { return node.kind == Kind::negation; }
// A sum or product with a rational operand has it on the left.
bool has_rational(const Node& node, Kind kind) { return node.kind == kind && node.left->is_rational(); }

bool is_sum(const Node& node) { return node.kind == Kind::sum || node.kind == Kind::difference; }

// What a sum is made of, by signs.
struct Addends {
  struct Addend {
    Node* node = nullptr;  // null: taken out
    bool negative = false;
  };
  std::array<Addend, 6> list{};  // of one sum of sums and one of others
  std::size_t size = 0;

  // `depth`: of the sums in it that are looked into.
  void add(Node* node, bool negative, int depth) {
    if (depth == 0 || !is_sum(*node)) {
      list.at(size++) = {node, negative};
      return;
    }
    add(node->left, negative, depth - 1);
    add(node->right, negative != (node->kind == Kind::difference), depth - 1);
  }
};

// x - y where both are sums with a number in common, which goes out: what is measured from an irrational position does
// not hang on it.
std::optional<Real> difference_of_sums(Node* x, int depth_of_x, Node* y, int depth_of_y) {
  Addends a;
  a.add(x, false, depth_of_x);
  a.add(y, true, depth_of_y);
  bool common = false;
  for (std::size_t i = 0; i < a.size; ++i)
    for (std::size_t j = i + 1; j < a.size && a.list.at(i).node != nullptr; ++j) {
      if (a.list.at(i).node != a.list.at(j).node || a.list.at(i).negative == a.list.at(j).negative) continue;
      a.list.at(i).node = a.list.at(j).node = nullptr;
      common = true;
    }
  if (!common) return std::nullopt;
  Real rest;
  for (const Addends::Addend& addend : a.list) {
    if (addend.node == nullptr) continue;
    const Real value = Node::share(addend.node);
    rest = addend.negative ? rest - value : rest + value;
  }
  return rest;
}

// A rational node whose value has just been computed.
Real settle(Node* node) {
  if (node->value.sign() != 0) return Node::adopt(node);
  release(node);
  return {};
}

Real operation(Kind kind, Node* left, Node* right = nullptr) {
  Node* const node = new_node(kind);
  ++left->references;
  node->left = left;
  if (right != nullptr) {
    ++right->references;
    node->right = right;
  }
  node->bounds();  // now, so that none is made by a long recursion
  return Node::adopt(node);
}

using RationalOperation = void (RationalValue::*)(const RationalValue&, const RationalValue&);
Real fold(RationalOperation compute, const Node& a, const Node& b) {
  Node* const node = new_node(Kind::rational);
  (node->value.*compute)(a.value, b.value);
  return settle(node);
}

Real inverse(const Node& rational) {
  Node* const node = new_node(Kind::rational);
  node->value.invert(rational.value);
  return Node::adopt(node);
}

// A root that is rational, or none.
std::optional<Real> rational_root(const Node& radicand) {
  Node* const node = new_node(Kind::rational);
  if (node->value.root(radicand.value)) return Node::adopt(node);
  release(node);
  return std::nullopt;
}

Real sine_or_cosine(Kind kind, const mpq_t degrees) {
  // The only rational ones strictly between 0 and 90 degrees.
  if (mpq_cmp_ui(degrees, kind == Kind::sine ? 30 : 60, 1) == 0) return Rational(1, 2);
  Node* const node = new_node(kind);
  node->value.set(degrees);
  node->bounds();
  return Node::adopt(node);
}

// The angle turned into [0, 90) and the quarter turns taken away, modulo 4.
struct Quadrant {
  Rational degrees;
  int quarter;
};
Quadrant quadrant(const Rational& degrees) {
  Quadrant result{degrees, 0};
  auto* const rest = result.degrees.raw();
  if (mpq_sgn(rest) >= 0 && mpq_cmp_ui(rest, 90, 1) < 0) return result;
  Integer per_quarter;
  Integer quarters;
  mpz_mul_ui(per_quarter.raw(), mpq_denref(rest), 90);
  // What is left is in lowest terms as the whole was.
  mpz_fdiv_qr(quarters.raw(), mpq_numref(rest), mpq_numref(rest), per_quarter.raw());
  if (mpq_sgn(rest) == 0) mpq_set_ui(rest, 0, 1);
  result.quarter = static_cast<int>(mpz_fdiv_ui(quarters.raw(), 4));
  return result;
}

// cos(90 q + degrees), degrees in [0, 90).
Real cosine_at(int quarter, const Rational& degrees) {
  const bool swapped = quarter % 2 != 0;
  const bool negative = quarter == 1 || quarter == 2;
  if (degrees.is_zero()) return swapped ? Real() : Real(negative ? -1 : 1);
  const Real value = sine_or_cosine(swapped ? Kind::sine : Kind::cosine, degrees.raw());
  return negative ? -value : value;
}

}  // namespace

Real::Real() : node_(nullptr) {}
Real::Real(int value) : node_(nullptr) {
  if (value == 0) return;
  node_ = new_node(Kind::rational);
  node_->value.set(value);
}
Real::Real(const Rational& value) : node_(nullptr) {
  if (value.is_zero()) return;
  node_ = new_node(Kind::rational);
  node_->value.set(value.raw());
}
Real::Real(const Real& other) : node_(other.node_) {
  if (node_ != nullptr) ++node_->references;
}
Real::Real(Real&& other) noexcept : node_(std::exchange(other.node_, nullptr)) {}
Real& Real::operator=(const Real& other) {
  if (this == &other) return *this;
  if (other.node_ != nullptr) ++other.node_->references;
  if (node_ != nullptr) release(node_);
  node_ = other.node_;
  return *this;
}
Real& Real::operator=(Real&& other) noexcept {
  std::swap(node_, other.node_);
  return *this;
}
Real::~Real() {
  if (node_ != nullptr) release(node_);
}

Sign Real::sign() const { return node_ == nullptr ? Sign::zero : decide(*node_); }
bool Real::is_rational() const { return node_ == nullptr || node_->is_rational(); }
Rational Real::rational() const { return node_ == nullptr ? Rational() : node_->value.rational(); }

Real operator-(const Real& a) {
  Node* const x = Node::of(a);
  if (is_zero(x)) return {};
  if (x->is_rational()) {
    Node* const node = new_node(Kind::rational);
    node->value.negate(x->value);
    return Node::adopt(node);
  }
  if (is_negation(*x)) return Node::share(x->left);
  return operation(Kind::negation, x);
}

Real operator+(const Real& a, const Real& b) {
  Node* x = Node::of(a);
  Node* y = Node::of(b);
  if (is_zero(x)) return b;
  if (is_zero(y)) return a;
  if (y->is_rational()) std::swap(x, y);
  if (y->is_rational()) return fold(&RationalValue::add, *x, *y);
  if (x->is_rational() && has_rational(*y, Kind::sum))
    return fold(&RationalValue::add, *x, *y->left) + Node::share(y->right);
  if (x->is_rational() && has_rational(*y, Kind::difference))
    return fold(&RationalValue::add, *x, *y->left) - Node::share(y->right);
  if (is_negation(*y)) return x == y->left ? Real() : operation(Kind::difference, x, y->left);
  if (is_negation(*x)) return x->left == y ? Real() : operation(Kind::difference, y, x->left);
  return operation(Kind::sum, x, y);
}

Real operator-(const Real& a, const Real& b) {
  Node* const x = Node::of(a);
  Node* const y = Node::of(b);
  if (x == y) return {};
  if (is_zero(y)) return a;
  if (is_zero(x)) return -b;
  if (y->is_rational()) return x->is_rational() ? fold(&RationalValue::subtract, *x, *y) : -b + a;
  if (is_negation(*y)) return a + Node::share(y->left);
  if (x->is_rational() && has_rational(*y, Kind::sum))
    return fold(&RationalValue::subtract, *x, *y->left) - Node::share(y->right);
  if (x->is_rational() && has_rational(*y, Kind::difference))
    return fold(&RationalValue::subtract, *x, *y->left) + Node::share(y->right);
  if (is_sum(*x) && is_sum(*y)) {
    if (auto rest = difference_of_sums(x, 1, y, 1)) return *std::move(rest);
    if (auto rest = difference_of_sums(x, 1, y, 2)) return *std::move(rest);
    if (auto rest = difference_of_sums(x, 2, y, 1)) return *std::move(rest);
  }
  return operation(Kind::difference, x, y);
}

Real operator*(const Real& a, const Real& b) {
  Node* x = Node::of(a);
  Node* y = Node::of(b);
  if (is_zero(x) || is_zero(y)) return {};
  if (y->is_rational()) std::swap(x, y);
  if (y->is_rational()) return fold(&RationalValue::multiply, *x, *y);
  if (x->is_rational()) {
    if (is_unit(*x, 1)) return Node::share(y);
    if (is_unit(*x, -1)) return -Node::share(y);
    if (has_rational(*y, Kind::product)) return fold(&RationalValue::multiply, *x, *y->left) * Node::share(y->right);
    if (is_negation(*y)) return -Node::share(x) * Node::share(y->left);
  }
  if (x == y && x->kind == Kind::root) return Node::share(x->left);
  return operation(Kind::product, x, y);
}

Real operator/(const Real& a, const Real& b) {
  Node* const x = Node::of(a);
  Node* const y = Node::of(b);
  if (b.sign() == Sign::zero) throw std::domain_error("division by zero");
  if (is_zero(x)) return {};
  if (x == y) return 1;
  if (y->is_rational()) return x->is_rational() ? fold(&RationalValue::divide, *x, *y) : inverse(*y) * a;
  return operation(Kind::quotient, x, y);
}

Real sqrt(const Real& a) {
  const Sign sign = a.sign();
  if (sign == Sign::negative) throw std::domain_error("square root of a negative number");
  if (sign == Sign::zero) return {};
  Node* const x = Node::of(a);
  if (x->is_rational())
    if (auto folded = rational_root(*x)) return *folded;
  if (x->kind == Kind::product && x->left == x->right)
    if (auto of_factor = enclosed_sign(*x->left))
      return *of_factor == Sign::negative ? -Node::share(x->left) : Node::share(x->left);
  return operation(Kind::root, x);
}

Real cos_degrees(const Rational& degrees) {
  const Quadrant q = quadrant(degrees);
  return cosine_at(q.quarter, q.degrees);
}

Real sin_degrees(const Rational& degrees) {
  // sin(d) = cos(d - 90).
  const Quadrant q = quadrant(degrees);
  return cosine_at((q.quarter + 3) % 4, q.degrees);
}

Real arctangent_degrees(const Real& tangent) {
  Node* const x = Node::of(tangent);
  // The only rational tangents of rational degrees.
  if (is_zero(x)) return {};
  if (is_unit(*x, 1)) return 45;
  if (is_unit(*x, -1)) return -45;
  return operation(Kind::arctangent, x);
}

Real sin_real_degrees(const Real& degrees) {
  if (degrees.is_rational()) return sin_degrees(degrees.rational());
  Node* const x = Node::of(degrees);
  return is_negation(*x) ? -operation(Kind::sine_of, x->left) : operation(Kind::sine_of, x);
}

Real cos_real_degrees(const Real& degrees) {
  if (degrees.is_rational()) return cos_degrees(degrees.rational());
  Node* const x = Node::of(degrees);
  return operation(Kind::cosine_of, is_negation(*x) ? x->left : x);
}

Real pi() { return Node::adopt(new_node(Kind::pi)); }

Real square(const Real& a) { return a * a; }

}  // namespace toolcomp::exact
