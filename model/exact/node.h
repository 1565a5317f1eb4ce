// SPDX-License-Identifier: Apache-2.0
// The nodes behind Real: rationals and operations on other nodes, pooled and reference-counted within one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "model/exact/double_enclosure.h"
#include "model/exact/interval.h"
#include "model/exact/rational_value.h"

namespace toolcomp::exact {

enum class Kind : std::uint8_t {
  rational,
  sine,
  cosine,
  negation,
  sum,
  difference,
  product,
  quotient,
  root,
  arctangent,
  sine_of,    ///< of an operand in degrees
  cosine_of,  ///< of an operand in degrees
  pi
};

/// What is known of a node's sign in addition to its enclosure.
enum class Knowledge : std::uint8_t { none, negative, positive, undecided };

/// One value. Rational 0 is the null pointer; a node proven zero becomes a rational with value 0.
struct Node {
  std::uint32_t references = 0;
  Kind kind = Kind::rational;
  Knowledge knowledge = Knowledge::none;
  bool bounded = false;     ///< `bounds_in_double` is set (a rational's is made when first needed)
  bool enclosed = false;    ///< `enclosure` is set (made when first needed)
  std::uint64_t visit = 0;  ///< stamp of the last walk, see operands_first
  Node* left = nullptr;     ///< operand, counted
  Node* right = nullptr;    ///< second operand, counted; the factor of a square is both
  Node* next = nullptr;     ///< in the free list
  RationalValue value;      ///< or the degrees of a sine or cosine, between 0 and 90; its limbs are kept for reuse
  DoubleEnclosure bounds_in_double;
  InlineInterval enclosure;
  std::unique_ptr<HeapInterval> refined;  ///< at a higher precision, once needed

  Node() = default;
  ~Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  Node(Node&&) = delete;
  Node& operator=(Node&&) = delete;

  /// The node of a value (null: rational 0), not counted.
  static Node* of(const Real& x) { return x.node_; }
  /// A value that takes over one count of `node`.
  static Real adopt(Node* node) { return Real(node); }
  /// A value that adds a count to `node`.
  static Real share(Node* node) {
    ++node->references;
    return Real(node);
  }

  [[nodiscard]] bool is_rational() const { return kind == Kind::rational; }
  [[nodiscard]] bool has_value() const { return is_rational() || kind == Kind::sine || kind == Kind::cosine; }
  [[nodiscard]] bool is_zero() const { return is_rational() && value.sign() == 0; }
  /// The enclosure in double. For a rational without one it is made now.
  const DoubleEnclosure& bounds() {
    if (!bounded) make_bounds();
    return bounds_in_double;
  }
  /// The enclosure at base_precision. If it is missing, it is made now, also for the nodes below, without recursion.
  const Interval& base_enclosure();
  /// The best available enclosure.
  const Interval& best_enclosure() { return refined ? static_cast<const Interval&>(*refined) : base_enclosure(); }
  /// Replaces an operation by the rational 0, after a proof that it is zero.
  void become_zero();

 private:
  void make_bounds();
  bool has_open_operand();
  void make_enclosure();  // the operands must have theirs
};

/// A node from the pool of this thread, with one reference and no operands.
Node* new_node(Kind kind);
/// Drops one reference; nodes no longer referenced go back to the pool, without recursion.
void release(Node* node) noexcept;

/// The nodes below and including `root` for which `enter` is true, operands before the nodes that use them, without
/// recursion. Below a node that is not entered nothing is visited.
template <class Enter>
void operands_first(Node* root, std::vector<Node*>& list, Enter enter);

/// A stamp that no node has yet. Two stamps are used up: this one and the one before it.
std::uint64_t new_visit();

template <class Enter>
void operands_first(Node* root, std::vector<Node*>& list, Enter enter) {
  const std::uint64_t done = new_visit();
  const std::uint64_t entered = done - 1;
  std::vector<Node*> open{root};
  while (!open.empty()) {
    Node* const node = open.back();
    if (node->visit == done || !enter(*node)) {
      open.pop_back();
    } else if (node->visit == entered) {
      open.pop_back();
      node->visit = done;
      list.push_back(node);
    } else {
      node->visit = entered;
      for (Node* operand : {node->left, node->right})
        if (operand != nullptr && operand->visit != done) open.push_back(operand);
    }
  }
}

}  // namespace toolcomp::exact
