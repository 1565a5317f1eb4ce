// SPDX-License-Identifier: Apache-2.0
#include "model/exact/limb_pool.h"

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

namespace toolcomp::exact {
namespace {

// What GMP asks for is a C interface of malloc's kind.
// NOLINTBEGIN(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory)

constexpr std::size_t kWord = sizeof(void*);
// Blocks of up to so many words are kept.
constexpr std::size_t kKeptWords = 63;

struct FreeBlock {
  FreeBlock* next;
};

// Trivial, so that reaching it costs no initialization check and it outlives every number of the thread.
struct LimbPool {
  enum class State { unused, open, ended };
  std::array<FreeBlock*, kKeptWords + 1> free{};  // by words
  State state = State::unused;
};
constinit thread_local LimbPool pool;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

struct ThreadEnd {
  ThreadEnd() = default;
  ThreadEnd(const ThreadEnd&) = delete;
  ThreadEnd& operator=(const ThreadEnd&) = delete;
  ThreadEnd(ThreadEnd&&) = delete;
  ThreadEnd& operator=(ThreadEnd&&) = delete;
  ~ThreadEnd() {
    pool.state = LimbPool::State::ended;
    for (FreeBlock*& first : pool.free)
      while (first != nullptr) std::free(std::exchange(first, first->next));
  }
};

bool is_open() {
  if (pool.state == LimbPool::State::unused) {
    thread_local const ThreadEnd at_end;
    pool.state = LimbPool::State::open;
  }
  return pool.state == LimbPool::State::open;
}

std::size_t words(std::size_t bytes) { return std::max<std::size_t>(1, (bytes + kWord - 1) / kWord); }

// GMP cannot go on without memory, and no exception passes through it.
void* whole(void* block) {
  if (block == nullptr) {
    static_cast<void>(std::fputs("out of memory for an exact number\n", stderr));
    std::abort();
  }
  return block;
}

void* allocate(std::size_t bytes) {
  const std::size_t size = words(bytes);
  if (size <= kKeptWords)
    if (FreeBlock*& first = pool.free.at(size); first != nullptr) return std::exchange(first, first->next);
  return whole(std::malloc(size * kWord));
}

void release(void* block, std::size_t bytes) {
  const std::size_t size = words(bytes);
  if (size > kKeptWords || !is_open()) {
    std::free(block);
    return;
  }
  FreeBlock*& first = pool.free.at(size);
  first = new (block) FreeBlock{first};
}

void* reallocate(void* block, std::size_t old_bytes, std::size_t new_bytes) {
  const std::size_t before = words(old_bytes);
  const std::size_t after = words(new_bytes);
  if (before == after) return block;
  if (before > kKeptWords && after > kKeptWords) return whole(std::realloc(block, after * kWord));
  void* const moved = allocate(new_bytes);
  std::memcpy(moved, block, std::min(old_bytes, new_bytes));
  release(block, old_bytes);
  return moved;
}

// NOLINTEND(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory)

}  // namespace

void use_limb_pool() { mp_set_memory_functions(allocate, reallocate, release); }

}  // namespace toolcomp::exact
