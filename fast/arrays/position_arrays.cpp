// SPDX-License-Identifier: Apache-2.0
#include "fast/arrays/position_arrays.h"

#include "fast/arithmetic/count.h"

namespace toolcomp::fast {
namespace {

constexpr auto kPerOne = static_cast<double>(Count::kSmallPerOne);

struct WithVector {
  [[gnu::always_inline]] static void run(const double* position, const double* vector, double* to, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) to[i] = position[i] / kPerOne + vector[i];
  }
};

struct WithOffset {
  [[gnu::always_inline]] static void run(const double* position, double offset, double* to, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) to[i] = (position[i] + offset) / kPerOne;
  }
};

}  // namespace

void write_positions(Instructions by, const double* position, const double* vector, double* to, std::size_t size) {
  run_by<WithVector>(by, position, vector, to, size);
}

void write_positions(Instructions by, const double* position, double offset, double* to, std::size_t size) {
  run_by<WithOffset>(by, position, offset, to, size);
}

}  // namespace toolcomp::fast
