#include "certify/kit/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "certify/trace_csv.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::kit {
namespace {

double value_in(const spec::AxisTable& table, char axis) {
  const auto entry = table.find(axis);
  return entry == table.end() ? 0 : std::stod(spec::to_string(entry->second));
}

// Where `time` stands among the columns; nothing where there is none.
std::optional<std::size_t> time_column(std::string_view header) {
  std::size_t column = 0;
  std::string name;
  for (const char c : header) {
    if (c == ',') {
      if (name == "time" || name == "t") return column;
      name.clear();
      ++column;
    } else if (c >= 'A' && c <= 'Z') {
      name += static_cast<char>(c - 'A' + 'a');
    } else if (c >= 'a' && c <= 'z') {
      name += c;
    }
  }
  return name == "time" || name == "t" ? std::optional(column) : std::nullopt;
}

double field(std::string_view line, std::size_t column) {
  for (; column > 0; --column) line.remove_prefix(line.find(',') + 1);
  return std::stod(std::string(line.substr(0, line.find(','))));
}

bool stands(const RecordedSample& a, const RecordedSample& b, double most) {
  for (std::size_t axis = 0; axis < spec::kMaxAxes; ++axis)
    if (a.axes.has(axis) && std::abs(a.axes[axis] - b.axes[axis]) > most) return false;
  return true;
}

}  // namespace

Recording read_recording(std::istream& stream, const std::string& file, const spec::Axes& axes) {
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::istringstream in(text);
  TraceReader reader(in, file, axes);
  Recording recording{file, false, reader.recorded(), {}};
  // The reader of traces sees that time is a number and never runs backwards; what it is is read here.
  std::istringstream lines(text);
  std::string line;
  std::uint64_t number = 0;
  std::optional<std::size_t> time;
  TraceSample sample;
  while (reader.next(sample)) {
    while (number < sample.line && std::getline(lines, line)) {
      if (++number < sample.line && !recording.has_time && recording.samples.empty())
        if (const auto column = time_column(line)) {
          time = column;
          recording.has_time = true;
        }
    }
    recording.samples.push_back({sample.line, time ? field(line, *time) : 0, sample.axes});
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
