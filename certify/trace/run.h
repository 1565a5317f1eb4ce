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
  std::uint64_t stands_for = 1;  // itself and those left out behind it
  Distance error;                // how far the line behind it is from those through the samples left out (Fréchet)
};

// Samples in a row, joined by straight lines. At most kMost are kept: then a quarter of them is left out, those that
// change the lines least, and it is known how far the lines are from those through all samples. So distances stay
// certified, however long a match is lost: their bounds move apart by that error.
class Run {
 public:
  static constexpr std::size_t kMost = 32768;
  // A match is lost some tolerances behind the place where the recording was nearest to what it left out: so far back,
  // in tolerances, and by so many samples at most, what was recorded before counts for lower bounds.
  static constexpr double kApproach = 4;
  static constexpr std::size_t kApproachSamples = 256;

  explicit Run(const Metric& metric) : metric_(metric) {}
  void add(const Sample& sample);
  void clear();
  // The samples before that number are not needed any more, but for those that lead there.
  void drop_before(std::uint64_t number);
  [[nodiscard]] bool full() const { return samples_.size() >= kMost; }
  [[nodiscard]] bool empty() const { return samples_.empty(); }
  [[nodiscard]] const std::vector<RunSample>& samples() const { return samples_; }
  // The largest error of a line.
  [[nodiscard]] const Distance& error() const { return error_; }
  // The indices of the kept samples [first, last] that hold those numbered `from` to `to` between them.
  [[nodiscard]] std::pair<std::size_t, std::size_t> between(std::uint64_t from, std::uint64_t to) const;
  // The index of the first kept sample that leads to that one.
  [[nodiscard]] std::size_t approach(std::size_t index) const;

 private:
  [[nodiscard]] Distance error_without(std::size_t index) const;
  void thin();

  const Metric& metric_;
  std::vector<RunSample> samples_;
  Distance error_;
};

// Distances from a stretch of a run.
class RunDistance {
 public:
  // Of the lines through the kept samples [first, last].
  RunDistance(const Run& run, const Metric& metric, std::size_t first, std::size_t last);

  struct Nearest {
    std::size_t line = 0;  // begins at the kept sample of that index
    AxisPoint at{};
    Distance distance;
    double in_tolerances = 0;
  };
  // Fast where it is asked for places in a row.
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
