// SPDX-License-Identifier: Apache-2.0
#include "model/exact/refinement.h"

#include "model/exact/trigonometry.h"

namespace toolcomp::exact {
namespace {

std::int64_t cost(const Node& node, mpfr_prec_t precision) {
  const std::int64_t limbs = precision / GMP_NUMB_BITS;
  switch (node.kind) {
    case Kind::sine:
    case Kind::cosine:
    case Kind::arctangent:
    case Kind::sine_of:
    case Kind::cosine_of:
    case Kind::pi:
      return 10 + limbs * limbs;
    case Kind::rational:
      return 2 + limbs * limbs / 16;
    default:
      return 2 + limbs * limbs / 64;
  }
}

const Interval* refined_or_null(const Node* node) { return node == nullptr ? nullptr : node->refined.get(); }

}  // namespace

void enclose(Interval& result, const Node& node, const Interval* left, const Interval* right) {
  // NOLINTBEGIN(clang-analyzer-core.NonNullParamChecker): an operation has the operands its kind needs
  switch (node.kind) {
    case Kind::rational:
      set(result, node.value.numerator(), node.value.denominator());
      break;
    case Kind::sine:
      sine_and_cosine(&result, nullptr, node.value.rational().raw());
      break;
    case Kind::cosine:
      sine_and_cosine(nullptr, &result, node.value.rational().raw());
      break;
    case Kind::negation:
      negate(result, *left);
      break;
    case Kind::sum:
      add(result, *left, *right);
      break;
    case Kind::difference:
      subtract(result, *left, *right);
      break;
    case Kind::product:
      if (left == right)
        square(result, *left);
      else
        multiply(result, *left, *right);
      break;
    case Kind::quotient:
      divide(result, *left, *right);
      break;
    case Kind::root:
      root(result, *left);
      break;
    case Kind::arctangent:
      arctangent_degrees(result, *left);
      break;
    case Kind::sine_of:
      sine_of_degrees(result, *left);
      break;
    case Kind::cosine_of:
      cosine_of_degrees(result, *left);
      break;
    case Kind::pi:
      mpfr_const_pi(result.lower, MPFR_RNDD);
      mpfr_const_pi(result.upper, MPFR_RNDU);
      break;
  }
  // NOLINTEND(clang-analyzer-core.NonNullParamChecker)
}

DoubleEnclosure enclosed_in_double(const Node& node, const DoubleEnclosure& left, const DoubleEnclosure& right) {
  switch (node.kind) {
    case Kind::rational:
      return enclosing(node.value.numerator(), node.value.denominator());
    case Kind::sine:
      return sine(enclosing(node.value.numerator(), node.value.denominator()));
    case Kind::cosine:
      return cosine(enclosing(node.value.numerator(), node.value.denominator()));
    case Kind::negation:
      return negate(left);
    case Kind::sum:
      return add(left, right);
    case Kind::difference:
      return subtract(left, right);
    case Kind::product:
      return node.left == node.right ? square(left) : multiply(left, right);
    case Kind::quotient:
      return divide(left, right);
    case Kind::root:
      return root(left);
    case Kind::arctangent:
      return arctangent(left);
    case Kind::sine_of:
      return sine(left);
    case Kind::cosine_of:
      return cosine(left);
    case Kind::pi:
      return pi_in_double;
  }
  return whole_line;
}

void refine(Node& root, mpfr_prec_t precision, Work& work) {
  std::vector<Node*> nodes;
  operands_first(&root, nodes,
                 [&](const Node& node) { return !node.refined || node.refined->precision() < precision; });
  for (Node* node : nodes) {
    work.spend(cost(*node, precision));
    auto better = std::make_unique<HeapInterval>(precision);
    enclose(*better, *node, refined_or_null(node->left), refined_or_null(node->right));
    if (node->refined) intersect(*better, *node->refined);
    node->refined = std::move(better);
    if (node->enclosed) intersect(node->enclosure, *node->refined);
    if (node->bounded) node->bounds_in_double = intersection(node->bounds_in_double, enclosing(*node->refined));
  }
}

}  // namespace toolcomp::exact
