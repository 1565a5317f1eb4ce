// SPDX-License-Identifier: Apache-2.0
// Finds the rests in a recording, by which the programs of a kit are found.
#pragma once

#include <cstddef>
#include <vector>

#include "certify/kit/kit.h"
#include "certify/kit/marks.h"
#include "certify/trace/samples.h"
#include "spec/language/axes.h"

namespace toolcomp::certify::kit {

// The place at which the programs of a kit make their marks, in the coordinates of recordings.
struct MarkPlace {
  spec::AxisValues<double> at;
  std::size_t axis = 0;  // axis that makes the marks
  double tolerance = 0;  // of a position
};
MarkPlace mark_place(const Machine& machine, bool machine_coordinates, double tolerance);

// The rests, at which the axes do not move: rows of samples that last at least a second and are less than a hundredth
// of a mm (or degree) from the first of them.
std::vector<Rest> find_rests(const RecordedRun& recording, const MarkPlace& place);

}  // namespace toolcomp::certify::kit
