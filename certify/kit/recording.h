// A recording of a machine's axes, and the programs of a kit in it.
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "certify/kit/kit.h"
#include "certify/kit/marks.h"
#include "spec/language/axes.h"
#include "spec/language/setup.h"

namespace toolcomp::certify::kit {

struct RecordedSample {
  std::uint64_t line = 0;  // of the file, from 1
  double time = 0;         // seconds
  spec::AxisValues<double> axes;
};

struct Recording {
  std::string file;
  bool has_time = false;
  std::vector<std::size_t> columns;  // axis indices, in the order of the file
  std::vector<RecordedSample> samples;
};

// Reads a CSV as certify::Recording describes it. Throws spec::InputError, with line and column.
Recording read_recording(std::istream& stream, const std::string& file, const spec::Setup& setup);

// Where the programs of a kit make their marks, in the coordinates of recordings.
struct MarkPlace {
  spec::AxisValues<double> at;
  std::size_t axis = 0;  // that makes the marks
  double tolerance = 0;  // of a position
};
MarkPlace mark_place(const Machine& machine, bool machine_coordinates, double tolerance);

// Where the axes stand still: rows of samples, a second apart at least and less than a hundredth of a mm (or degree)
// from the first of them.
std::vector<Rest> find_rests(const Recording& recording, const MarkPlace& place);

// The samples of one program as a CSV in coordinates of G54, each on the line it has in the recording; blank lines
// stand for the others.
std::string cut(const Recording& recording, std::size_t first, std::size_t last, const Machine& machine,
                bool machine_coordinates);

}  // namespace toolcomp::certify::kit
