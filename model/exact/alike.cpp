// SPDX-License-Identifier: Apache-2.0
#include "model/exact/alike.h"

#include <set>
#include <utility>
#include <vector>

#include "model/exact/node.h"

namespace toolcomp::exact {

bool alike(const Real& a, const Real& b) {
  constexpr std::size_t budget = 5000;  // pairs of nodes, about a millisecond
  using Pair = std::pair<const Node*, const Node*>;
  std::set<Pair> seen;
  std::vector<Pair> open{{Node::of(a), Node::of(b)}};
  while (!open.empty()) {
    const Pair pair = open.back();
    open.pop_back();
    const auto [x, y] = pair;
    if (x == y || !seen.insert(pair).second) continue;
    // The null pointer is 0 or no operand.
    if (x == nullptr || y == nullptr || x->kind != y->kind || seen.size() > budget) return false;
    if (x->has_value() && !x->value.equals(y->value)) return false;
    open.emplace_back(x->left, y->left);
    open.emplace_back(x->right, y->right);
  }
  return true;
}

}  // namespace toolcomp::exact
