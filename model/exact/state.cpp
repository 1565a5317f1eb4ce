// SPDX-License-Identifier: Apache-2.0
#include "model/exact/state.h"

#include <vector>

#include "model/exact/node.h"

namespace toolcomp::exact {
namespace {

void write(spec::StateWriter& out, mpz_srcptr value) {
  out(value->_mp_size);
  out.bytes(mpz_limbs_read(value), mpz_size(value) * sizeof(mp_limb_t));
}

void write(spec::StateWriter& out, mpq_srcptr value) {
  write(out, mpq_numref(value));
  write(out, mpq_denref(value));
}

void write(spec::StateWriter& out, mpfr_srcptr value) {
  out(mpfr_get_prec(value), mpfr_signbit(value) != 0, mpfr_inf_p(value) != 0, mpfr_zero_p(value) != 0);
  if (mpfr_regular_p(value) == 0) return;
  out(mpfr_get_exp(value));
  const auto limbs = static_cast<std::size_t>((mpfr_get_prec(value) + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS);
  out.bytes(value->_mpfr_d, limbs * sizeof(mp_limb_t));
}

void write(spec::StateWriter& out, const Interval& interval) {
  write(out, interval.lower);
  write(out, interval.upper);
}

std::uint32_t number(spec::StateWriter& out, const Node* node) { return node == nullptr ? 0 : out.shared(node).number; }

void write(spec::StateWriter& out, const Real& value) {
  Node* const root = Node::of(value);
  std::vector<Node*> anew;
  if (root != nullptr) operands_first(root, anew, [&out](const Node& node) { return !out.knows(&node); });
  out(anew.size());
  for (const Node* node : anew) {
    out(number(out, node), node->kind, node->knowledge == Knowledge::undecided, number(out, node->left),
        number(out, node->right), node->refined != nullptr);
    if (node->has_value()) write(out, node->value.rational().raw());
    if (node->refined) write(out, *node->refined);
  }
  out(number(out, root));
}

}  // namespace
}  // namespace toolcomp::exact

namespace toolcomp::spec {

void StateOf<exact::Real>::write(StateWriter& out, const exact::Real& value) { exact::write(out, value); }
void StateOf<exact::Rational>::write(StateWriter& out, const exact::Rational& value) { exact::write(out, value.raw()); }

}  // namespace toolcomp::spec
