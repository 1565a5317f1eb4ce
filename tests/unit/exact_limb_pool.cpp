// SPDX-License-Identifier: Apache-2.0
// The memory of exact numbers, through the functions that GMP and MPFR call.
#include <gmp.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <string>
#include <thread>

#include "model/exact/real.h"

namespace toolcomp::exact {
namespace {

struct Functions {
  void* (*allocate)(std::size_t) = nullptr;
  void* (*reallocate)(void*, std::size_t, std::size_t) = nullptr;
  void (*release)(void*, std::size_t) = nullptr;
  Functions() { mp_get_memory_functions(&allocate, &reallocate, &release); }
};

// In every program that has a Real.
TEST(LimbPool, IsInForce) {
  ASSERT_EQ((Real(Rational(1, 3)) * Rational(3)).decimal(1), "1");
  const Functions gmp;
  void* const first = gmp.allocate(24);
  gmp.release(first, 24);
  void* const second = gmp.allocate(24);
  EXPECT_EQ(second, first) << "what was given back is taken next";
  void* const other = gmp.allocate(16);
  EXPECT_NE(other, first) << "but for its size";
  gmp.release(other, 16);
  gmp.release(second, 24);
}

// A text of 17 bytes has a block of three words; so has one of 24.
TEST(LimbPool, SizesAreWholeWords) {
  const Functions gmp;
  void* const block = gmp.allocate(17);
  EXPECT_EQ(gmp.reallocate(block, 17, 24), block);
  std::memset(block, 1, 24);
  gmp.release(block, 24);
}

TEST(LimbPool, ContentsMoveWithTheirBlock) {
  const Functions gmp;
  for (const std::size_t before : {8U, 40U, 504U, 512U, 4096U})
    for (const std::size_t after : {8U, 40U, 504U, 512U, 4096U}) {
      auto* block = static_cast<char*>(gmp.allocate(before));
      for (std::size_t i = 0; i < before; ++i) block[i] = static_cast<char>(i);
      block = static_cast<char*>(gmp.reallocate(block, before, after));
      for (std::size_t i = 0; i < std::min(before, after); ++i) ASSERT_EQ(block[i], static_cast<char>(i));
      std::memset(block, 2, after);
      gmp.release(block, after);
    }
}

// Under AddressSanitizer nothing may be left of the threads.
TEST(LimbPool, NumbersChangeTheirThread) {
  auto power = std::make_unique<Rational>(1);
  std::string text;
  std::thread([&] {
    for (int i = 0; i < 2000; ++i) *power *= 10;
    std::thread([&] { text = Rational(*power / 7).str(); }).join();
  }).join();
  // 10^2000 is not a multiple of 7.
  EXPECT_EQ(text, "1" + std::string(2000, '0') + "/7");
  std::thread([&] { power.reset(); }).join();
}

// A thread that only gives back, and one whose last number dies with the thread.
TEST(LimbPool, ThreadsOfOneSide) {
  auto number = std::make_unique<Rational>(1, 3);
  std::thread([&] { number.reset(); }).join();
  std::thread([] {
    thread_local const Rational last(22, 7);
    EXPECT_EQ(last.str(), "22/7");
  }).join();
}

}  // namespace
}  // namespace toolcomp::exact
