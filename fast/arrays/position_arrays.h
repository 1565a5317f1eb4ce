// SPDX-License-Identifier: Apache-2.0
// What arrays of lines have in common: where their axes go.
#pragma once

#include <cstddef>

#include "fast/arrays/instructions.h"

namespace toolcomp::fast {

// The nearest doubles to positions in 10^-6, whole numbers, and a vector added to each.
void write_positions(Instructions by, const double* position, const double* vector, double* to, std::size_t size);
// The same of positions with one offset, 10^-6; the sums are below 2^53.
void write_positions(Instructions by, const double* position, double offset, double* to, std::size_t size);

}  // namespace toolcomp::fast
