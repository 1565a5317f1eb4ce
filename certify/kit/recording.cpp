// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/recording.h"

#include <cmath>

namespace toolcomp::certify::kit {
namespace {

bool stands(const RecordedSample& a, const RecordedSample& b, double most) {
  for (std::size_t axis = 0; axis < spec::kMaxAxes; ++axis)
    if (std::abs(a.at.at(axis) - b.at.at(axis)) > most) return false;
  return true;
}

}  // namespace

MarkPlace mark_place(const Machine& machine, bool machine_coordinates, double tolerance) {
  MarkPlace place;
  for (std::size_t i = 0; i < machine.setup.axes.size(); ++i) {
    const char axis = machine.setup.axes.letter(i);
    place.at.set(i, value_in(machine.setup.position, axis) +
                        (machine_coordinates ? value_in(machine.setup.workpiece[0], axis) : 0));
  }
  place.axis = machine.setup.axes.index(mark_axis(machine));
  place.tolerance = tolerance;
  return place;
}

std::vector<Rest> find_rests(const RecordedRun& recording, const MarkPlace& place) {
  constexpr double kShortest = 0.7;  // s
  constexpr double kStill = 0.01;    // mm, inch or degrees
  const std::vector<RecordedSample>& samples = recording.samples;
  std::vector<Rest> rests;
  for (std::size_t first = 0; first < samples.size();) {
    std::size_t last = first;
    while (last + 1 < samples.size() && stands(samples[first], samples[last + 1], kStill)) ++last;
    if (samples[last].time - samples[first].time >= kShortest) {
      Rest rest{samples[first].time, samples[last].time, samples[first].at.at(place.axis), true, false, first, last};
      rest.above = std::abs(rest.at - place.at[place.axis] - 1) <= place.tolerance;
      for (const std::size_t axis : recording.recorded) {
        const double off = std::abs(samples[first].at.at(axis) - place.at[axis]);
        if (off > place.tolerance && (axis != place.axis || !rest.above)) rest.at_place = false;
      }
      rests.push_back(rest);
    }
    first = last + 1;
  }
  return rests;
}

}  // namespace toolcomp::certify::kit
