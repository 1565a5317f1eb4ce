// SPDX-License-Identifier: Apache-2.0
// A sign is read off the enclosure, else off a finer one, else zero is proven, else a still finer enclosure is tried.
#include "model/exact/sign.h"

#include <vector>

#include "model/exact/refinement.h"
#include "model/exact/zero_proof.h"

namespace toolcomp::exact {
namespace {

// About 5 ms.
constexpr std::int64_t refinement_work = 60'000;
// About 80 ms: postures of a programming system that stands at a pose of a posture, three times over, need 50. An
// undecided run costs its reader more than that, and is met once in thousands of programs.
constexpr std::int64_t proof_work = 1'500'000;
// Near misses that are not ties are told from them here, before a proof is tried.
constexpr mpfr_prec_t precision_before_proof = 256;
// Far below any difference of program decimals; the work ends earlier except for the smallest expressions.
constexpr mpfr_prec_t greatest_precision = mpfr_prec_t{1} << 20;

// What can be told without work.
std::optional<Sign> at_hand(Node& node) {
  if (node.is_rational()) return static_cast<Sign>(node.value.sign());
  if (node.knowledge == Knowledge::positive) return Sign::positive;
  if (node.knowledge == Knowledge::negative) return Sign::negative;
  return enclosed_sign(node);
}

// The same; a zero becomes a rational. Its enclosure may tell it where an operand has become zero since.
std::optional<Sign> settled(Node& node) {
  const auto sign = at_hand(node);
  if (sign == Sign::zero && !node.is_rational()) node.become_zero();
  return sign;
}

bool is_open(Node& node) { return !at_hand(node) && node.knowledge != Knowledge::undecided; }

// The sign of these is that of their operands.
bool is_factored(const Node& node) {
  switch (node.kind) {
    case Kind::negation:
    case Kind::product:
    case Kind::quotient:
    case Kind::root:
      return true;
    default:
      return false;
  }
}

void remember(Node& node, std::optional<Sign> sign) {
  if (!sign)
    node.knowledge = Knowledge::undecided;
  else if (*sign == Sign::zero)
    node.become_zero();
  else
    node.knowledge = *sign == Sign::positive ? Knowledge::positive : Knowledge::negative;
}

std::optional<Sign> refined_sign(Node& node, mpfr_prec_t first, mpfr_prec_t last, Work& work) {
  try {
    for (mpfr_prec_t precision = first; precision <= last; precision *= 2) {
      refine(node, precision, work);
      if (auto sign = certain_sign(*node.refined)) return sign;
    }
  } catch (const OutOfWork&) {
    return std::nullopt;
  }
  return std::nullopt;
}

std::optional<Sign> sign_of_sum(Node& node) {
  Work work(refinement_work);
  if (auto sign = refined_sign(node, precision_before_proof, precision_before_proof, work)) return sign;
  // Whether the work for that sufficed or not: the proof has its own.
  if (prove_zero(node, proof_work) == ZeroProof::zero) return Sign::zero;
  return refined_sign(node, 2 * precision_before_proof, greatest_precision, work);
}

std::optional<Sign> sign_of_factor(Node& node) {
  if (is_open(node) && !is_factored(node)) remember(node, sign_of_sum(node));
  return settled(node);
}

std::optional<Sign> sign_of_factors(const Node& node) {
  const auto left = sign_of_factor(*node.left);
  if (node.kind == Kind::root || left == Sign::zero) return left;
  if (node.kind == Kind::negation) return left ? std::optional(-*left) : std::nullopt;
  const auto right = sign_of_factor(*node.right);
  if (right == Sign::zero) return right;
  if (!left || !right) return std::nullopt;
  return *left == *right ? Sign::positive : Sign::negative;
}

}  // namespace

std::optional<Sign> enclosed_sign(Node& node) {
  if (auto sign = certain_sign(node.bounds())) return sign;
  return certain_sign(node.base_enclosure());
}

std::optional<Sign> try_decide(Node& node) {
  if (auto sign = settled(node)) return sign;
  if (!is_open(node)) return std::nullopt;
  if (!is_factored(node)) return sign_of_factor(node);
  std::vector<Node*> products;
  operands_first(&node, products, [](Node& n) { return is_factored(n) && is_open(n); });
  for (Node* product : products) remember(*product, sign_of_factors(*product));
  return settled(node);
}

Sign decide(Node& node) {
  if (auto sign = try_decide(node)) return *sign;
  throw Undecided();
}

}  // namespace toolcomp::exact
