#include "certify/kit/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "certify/trace/recording.h"

namespace toolcomp::certify::kit {
namespace {

bool stands(const RecordedSample& a, const RecordedSample& b, double most) {
  for (std::size_t axis = 0; axis < spec::kMaxAxes; ++axis)
    if (a.axes.has(axis) && std::abs(a.axes[axis] - b.axes[axis]) > most) return false;
  return true;
}

}  // namespace

Recording read_recording(std::istream& stream, const std::string& file, const spec::Setup& setup) {
  certify::Recording reader(stream, file, setup.axes, setup.units);
  Recording recording{file, reader.has_time(), reader.recorded(), {}};
  for (certify::RecordedSample sample; reader.next(sample);) {
    RecordedSample& taken = recording.samples.emplace_back();
    taken.line = sample.line;
    taken.time = sample.time;
    for (const std::size_t axis : recording.columns) taken.axes.set(axis, sample.at.at(axis));
  }
  return recording;
}

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

std::vector<Rest> find_rests(const Recording& recording, const MarkPlace& place) {
  constexpr double kShortest = 0.7;  // s
  constexpr double kStill = 0.01;    // mm, inch or degrees
  const std::vector<RecordedSample>& samples = recording.samples;
  std::vector<Rest> rests;
  for (std::size_t first = 0; first < samples.size();) {
    std::size_t last = first;
    while (last + 1 < samples.size() && stands(samples[first], samples[last + 1], kStill)) ++last;
    if (samples[last].time - samples[first].time >= kShortest) {
      Rest rest{samples[first].time, samples[last].time, samples[first].axes[place.axis], true, false, first, last};
      rest.above = std::abs(rest.at - place.at[place.axis] - 1) <= place.tolerance;
      for (const std::size_t axis : recording.columns) {
        const double off = std::abs(samples[first].axes[axis] - place.at[axis]);
        if (off > place.tolerance && (axis != place.axis || !rest.above)) rest.at_place = false;
      }
      rests.push_back(rest);
    }
    first = last + 1;
  }
  return rests;
}

std::string cut(const Recording& recording, std::size_t first, std::size_t last, const Machine& machine,
                bool machine_coordinates) {
  std::string text = "time";
  for (const std::size_t axis : recording.columns) text += std::string(",") + machine.setup.axes.letter(axis);
  text += '\n';
  std::uint64_t line = 2;
  for (std::size_t i = first; i <= last; ++i) {
    const RecordedSample& sample = recording.samples[i];
    for (; line < sample.line; ++line) text += '\n';
    text += fmt::format("{}", sample.time);
    for (const std::size_t axis : recording.columns) {
      const double origin =
          machine_coordinates ? value_in(machine.setup.workpiece[0], machine.setup.axes.letter(axis)) : 0;
      text += fmt::format(",{}", sample.axes[axis] - origin);
    }
    text += '\n';
    ++line;
  }
  return text;
}

}  // namespace toolcomp::certify::kit
