// Lines of no compensation but offsets on axes (G43, G44), by arrays.
#pragma once

#include <cstddef>

#include "fast/arrays/instructions.h"

namespace toolcomp::fast {

// Positions and an offset in 10^-6, whole numbers whose sum is below 2^53: where the axis is sent to.
void send_axis_to(Instructions by, const double* position, double offset, double* to, std::size_t size);

}  // namespace toolcomp::fast
