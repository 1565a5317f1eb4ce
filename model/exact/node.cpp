// SPDX-License-Identifier: Apache-2.0
#include "model/exact/node.h"

#include <algorithm>
#include <array>
#include <utility>

#include "model/exact/limb_pool.h"
#include "model/exact/refinement.h"
#include "model/exact/trigonometry.h"

namespace toolcomp::exact {
namespace {

constexpr std::size_t kChunkNodes = 128;
// Larger rationals give their limbs back when a node is released.
constexpr int kKeptLimbs = 16;

struct Chunk {
  std::array<Node, kChunkNodes> nodes;
  Chunk* previous = nullptr;
};

// Trivial, so that reaching it costs no initialization check and it outlives every value of the thread.
struct Pool {
  Node* free = nullptr;
  Chunk* chunks = nullptr;
  std::size_t live = 0;
  std::uint64_t visit = 0;
};
constinit thread_local Pool pool;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

// Gives back at the end of a thread what the thread's pool and the caches of MPFR and FLINT hold. Values that live
// longer (they may, in static storage) keep the pool alive.
struct ThreadEnd {
  ThreadEnd() = default;
  ThreadEnd(const ThreadEnd&) = delete;
  ThreadEnd& operator=(const ThreadEnd&) = delete;
  ThreadEnd(ThreadEnd&&) = delete;
  ThreadEnd& operator=(ThreadEnd&&) = delete;
  ~ThreadEnd() {
    free_trigonometry();
    mpfr_free_cache();
    if (pool.live != 0) return;
    pool.free = nullptr;
    while (pool.chunks != nullptr) delete std::exchange(pool.chunks, pool.chunks->previous);
  }
};

// Before any number of a program is made, those of static storage too.
[[gnu::constructor(101)]] void begin() { use_limb_pool(); }

// A new chunk's nodes, linked; the pool has none free.
Node* grow() {
  thread_local const ThreadEnd at_end;
  auto* const chunk = new Chunk;
  chunk->previous = std::exchange(pool.chunks, chunk);
  Node* first = nullptr;
  for (Node& node : chunk->nodes) node.next = std::exchange(first, &node);
  return first;
}

}  // namespace

void Node::make_bounds() {
  bounds_in_double = enclosed_in_double(*this, left == nullptr ? whole_line : left->bounds(),
                                        right == nullptr ? whole_line : right->bounds());
  bounded = true;
}

const Interval& Node::base_enclosure() {
  if (enclosed) return enclosure;
  if (!has_open_operand()) {
    make_enclosure();
    return enclosure;
  }
  // No walk of operands_first, which may be under way around this one: what is done is told by `enclosed`.
  std::vector<Node*> open{this};
  while (!open.empty()) {
    Node& node = *open.back();
    if (node.has_open_operand()) {
      for (Node* operand : {node.left, node.right})
        if (operand != nullptr && !operand->enclosed) open.push_back(operand);
    } else {
      open.pop_back();
      if (!node.enclosed) node.make_enclosure();
    }
  }
  return enclosure;
}

// An operand whose enclosure is not made yet; that of a number without operands is made here.
bool Node::has_open_operand() {
  bool open = false;
  for (Node* operand : {left, right}) {
    if (operand == nullptr || operand->enclosed) continue;
    if (operand->left == nullptr)
      operand->make_enclosure();
    else
      open = true;
  }
  return open;
}

void Node::make_enclosure() {
  enclose(enclosure, *this, left == nullptr ? nullptr : &left->enclosure,
          right == nullptr ? nullptr : &right->enclosure);
  enclosed = true;
  if (refined) intersect(enclosure, *refined);
}

void Node::become_zero() {
  Node* const operands[] = {std::exchange(left, nullptr), std::exchange(right, nullptr)};
  for (Node* operand : operands)
    if (operand != nullptr) release(operand);
  refined.reset();
  kind = Kind::rational;
  value.set(std::int64_t{0});
  bounded = enclosed = false;
}

Node* new_node(Kind kind) {
  Node* const node = pool.free != nullptr ? pool.free : grow();
  pool.free = node->next;
  ++pool.live;
  node->references = 1;
  node->kind = kind;
  node->knowledge = Knowledge::none;
  node->bounded = false;
  node->enclosed = false;
  node->left = nullptr;
  node->right = nullptr;
  return node;
}

void release(Node* node) noexcept {
  if (--node->references != 0) return;
  node->next = nullptr;
  // Nodes whose count fell to zero, linked by `next`, wait here for their operands to be dropped.
  Node* waiting = node;
  while (waiting != nullptr) {
    Node* const dead = std::exchange(waiting, waiting->next);
    for (Node* operand : {dead->left, dead->right})
      if (operand != nullptr && --operand->references == 0) operand->next = std::exchange(waiting, operand);
    dead->refined.reset();
    if (dead->left == nullptr) dead->value.trim(kKeptLimbs);
    dead->next = std::exchange(pool.free, dead);
    --pool.live;
  }
}

std::uint64_t new_visit() { return pool.visit += 2; }

std::size_t live_nodes() { return pool.live; }

}  // namespace toolcomp::exact
