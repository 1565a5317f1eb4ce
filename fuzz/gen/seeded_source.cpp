// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/generator.h"

namespace toolcomp::fuzz {

// SplitMix64 (Steele, Lea, Flood 2014): one addition and a mixing of bits, the same everywhere.
std::uint64_t SeededSource::below(std::uint64_t n) {
  state_ += 0x9E3779B97F4A7C15ULL;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  z ^= z >> 31;
  // The bias of the remainder is n / 2^64: none that a run could show.
  return z % n;
}

}  // namespace toolcomp::fuzz
