// SPDX-License-Identifier: Apache-2.0
// Numbers for nodes, by which nodes that were made in the same way are recognised.
#pragma once

#include <cstddef>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "model/exact/node.h"

namespace toolcomp::exact {

/// Numbers from 0 on for the nodes of an expression. Nodes made in the same way, by the same operation on operands made
/// in the same way (for sums and products in either order), have the same number, and the same value.
class Numbering {
 public:
  /// Numbers a node whose operands have numbers already. The node must not change as long as the numbering exists.
  void add(const Node& node) { numbers_.emplace(&node, first_.try_emplace(making(node), first_.size()).first->second); }

  [[nodiscard]] std::size_t size() const { return first_.size(); }
  [[nodiscard]] std::size_t of(const Node& node) const { return numbers_.at(&node); }
  /// Whether a node with a number is the difference of two nodes made in the same way. Then it is zero, whatever they
  /// are.
  [[nodiscard]] bool is_zero(const Node& node) const {
    return node.kind == Kind::difference && of(*node.left) == of(*node.right);
  }

 private:
  using Making = std::tuple<Kind, std::size_t, std::size_t, Rational>;

  [[nodiscard]] Making making(const Node& node) const {
    std::size_t left = of_operand(node.left);
    std::size_t right = of_operand(node.right);
    const bool commutes = node.kind == Kind::sum || node.kind == Kind::product;
    if (commutes && right < left) std::swap(left, right);
    return {node.kind, left, right, node.has_value() ? node.value.rational() : Rational()};
  }
  // The kind tells how many operands there are.
  [[nodiscard]] std::size_t of_operand(const Node* operand) const { return operand == nullptr ? 0 : of(*operand); }

  std::unordered_map<const Node*, std::size_t> numbers_;
  std::map<Making, std::size_t> first_;
};

}  // namespace toolcomp::exact
