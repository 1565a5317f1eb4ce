#include "model/exact/refinement.h"

#include "model/exact/trigonometry.h"
#include "model/exact/zero_proof.h"

namespace toolcomp::exact {
namespace {

// About 5 ms each for refinement and for the proof of zero.
constexpr std::int64_t refinement_work = 60'000;
constexpr std::int64_t proof_work = 60'000;
// Near misses that are not ties are told from them here, before a proof is tried.
constexpr mpfr_prec_t precision_before_proof = 256;
// 2^-1e6 is far below any difference of program decimals; the work ends earlier except for the smallest expressions.
constexpr mpfr_prec_t greatest_precision = mpfr_prec_t{1} << 20;

std::int64_t cost(const Node& node, mpfr_prec_t precision) {
  const std::int64_t limbs = precision / GMP_NUMB_BITS;
  switch (node.kind) {
    case Kind::sine:
    case Kind::cosine:
    case Kind::arctangent:
      return 10 + limbs * limbs;
    case Kind::rational:
      return 2 + limbs * limbs / 16;
    default:
      return 2 + limbs * limbs / 64;
  }
}

const Interval* refined_or_null(const Node* node) { return node == nullptr ? nullptr : node->refined.get(); }

std::optional<Sign> known(const Node& node) {
  if (node.knowledge == Knowledge::positive) return Sign::positive;
  if (node.knowledge == Knowledge::negative) return Sign::negative;
  return std::nullopt;
}

std::optional<Sign> sign_at(Node& node, mpfr_prec_t precision, Work& work) {
  refine(node, precision, work);
  return certain_sign(*node.refined);
}

std::optional<Sign> refined_sign(Node& node) {
  Work work(refinement_work);
  try {
    if (auto sign = sign_at(node, precision_before_proof, work)) return sign;
  } catch (const OutOfWork&) {
    // The proof has its own budget.
  }
  switch (prove_zero(node, proof_work)) {
    case ZeroProof::zero:
      return Sign::zero;
    case ZeroProof::nonzero:
      node.knowledge = Knowledge::nonzero;
      break;
    case ZeroProof::none:
      break;
  }
  try {
    for (mpfr_prec_t precision = 2 * precision_before_proof; precision <= greatest_precision; precision *= 2)
      if (auto sign = sign_at(node, precision, work)) return sign;
  } catch (const OutOfWork&) {
    // Undecided.
  }
  return std::nullopt;
}

}  // namespace

void enclose(Interval& result, const Node& node, const Interval* left, const Interval* right) {
  switch (node.kind) {
    case Kind::rational:
      set(result, node.value);
      break;
    case Kind::sine:
      sine_and_cosine(&result, nullptr, node.value);
      break;
    case Kind::cosine:
      sine_and_cosine(nullptr, &result, node.value);
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
  }
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
  }
}

std::optional<Sign> try_decide(Node& node) {
  if (node.is_rational()) return static_cast<Sign>(mpq_sgn(node.value));
  if (auto sign = certain_sign(node.enclosure)) return sign;
  if (auto sign = known(node)) return sign;
  if (node.knowledge == Knowledge::undecided) return std::nullopt;
  const auto sign = refined_sign(node);
  if (!sign)
    node.knowledge = Knowledge::undecided;
  else if (*sign == Sign::zero)
    node.become_zero();
  else
    node.knowledge = *sign == Sign::positive ? Knowledge::positive : Knowledge::negative;
  return sign;
}

Sign decide(Node& node) {
  if (auto sign = try_decide(node)) return *sign;
  throw Undecided();
}

}  // namespace toolcomp::exact
