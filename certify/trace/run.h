// SPDX-License-Identifier: Apache-2.0
// The samples since a match was lost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "certify/trace/boxes.h"
#include "certify/trace/free_space.h"
#include "certify/trace/metric.h"

namespace toolcomp::certify {

struct RunSample {
  Sample sample;
  std::uint64_t stands_for = 1;  // itself and the samples left out after it
  Distance error;                // distance of the line after it from the lines through the samples left out (Fréchet)
};

// Samples in a row, joined by straight lines. At most kMost samples are kept. Then a quarter of them is left out, those
// that change the lines least, and the distance of the lines from those through all samples is kept as an error. So
// distances stay certified, however long a match is lost; their bounds only become wider by that error.
class Run {
 public:
  static constexpr std::size_t kMost = 32768;
  // A match is lost some tolerances after the place at which the recording was nearest to the part it left out. The
  // recording up to this far back, in tolerances, and at most this number of samples, still counts for lower bounds.
  static constexpr double kApproach = 4;
  static constexpr std::size_t kApproachSamples = 256;

  explicit Run(const Metric& metric) : metric_(metric) {}
  void add(const Sample& sample);
  void clear();
  // The samples before this number are no longer needed, except those that lead there.
  void drop_before(std::uint64_t number);
  [[nodiscard]] bool full() const { return samples_.size() >= kMost; }
  [[nodiscard]] bool empty() const { return samples_.empty(); }
  [[nodiscard]] const std::vector<RunSample>& samples() const { return samples_; }
  // The largest error of a line.
  [[nodiscard]] const Distance& error() const { return error_; }
  // The indices of the kept samples [first, last] that enclose the samples with the numbers `from` to `to`.
  [[nodiscard]] std::pair<std::size_t, std::size_t> between(std::uint64_t from, std::uint64_t to) const;
  // The index of the first kept sample that leads to this one.
  [[nodiscard]] std::size_t approach(std::size_t index) const;

 private:
  [[nodiscard]] Distance error_without(std::size_t index) const;
  void thin();

  const Metric& metric_;
  std::vector<RunSample> samples_;
  Distance error_;
};

// Distances from a part of a run.
class RunDistance {
 public:
  // For the lines through the kept samples [first, last].
  RunDistance(const Run& run, const Metric& metric, std::size_t first, std::size_t last);

  struct Nearest {
    std::size_t line = 0;  // the line that begins at the kept sample with this index
    AxisPoint at{};
    Distance distance;
    double in_tolerances = 0;
  };
  // Fast for consecutive places.
  [[nodiscard]] Nearest nearest(const AxisPoint& p);
  // From `p` to the nearest point of that line, in tolerances.
  [[nodiscard]] double from(const AxisPoint& p, std::size_t line) const;

 private:
  [[nodiscard]] const AxisPoint& end_of(std::size_t line) const;

  const Run& run_;
  const Metric& metric_;
  std::size_t first_;
  std::size_t last_;
  std::size_t near_;  // the line found last
  Boxes boxes_;
};

}  // namespace toolcomp::certify
