// SPDX-License-Identifier: Apache-2.0
// Recorded samples and their sources.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "certify/trace/space.h"

namespace toolcomp::certify {

// The largest accepted position. No axis is longer, and the squares of such lengths are far from overflow.
inline constexpr double kFarthest = 1e9;  // setup units, degrees
inline constexpr double kLatest = 1e12;   // seconds

struct RecordedSample {
  std::uint64_t line = 0;  // of the file, from 1
  AxisPoint at{};          // in the units of the source; degrees
  double time = 0;         // seconds; 0 if time is not recorded
  double resolution = 0;   // seconds: one unit of the last digit of the written time
};

// Samples one by one, in the order of time.
class SampleSource {
 public:
  virtual ~SampleSource() = default;
  // The next sample; false at the end.
  virtual bool next(RecordedSample& sample) = 0;
  // The axes that are recorded, by index.
  [[nodiscard]] virtual const std::vector<std::size_t>& recorded() const = 0;
  [[nodiscard]] virtual bool has_time() const = 0;
};

// A recording in memory.
struct RecordedRun {
  std::vector<std::size_t> recorded;  // axes, by index
  bool has_time = false;
  std::vector<RecordedSample> samples;
};

// The remaining samples of a source.
inline RecordedRun rest_of(SampleSource& source) {
  RecordedRun run{source.recorded(), source.has_time(), {}};
  for (RecordedSample sample; source.next(sample);) run.samples.push_back(sample);
  return run;
}

// The samples [first, end) of a recording in memory, which must outlive them.
class SampleRange : public SampleSource {
 public:
  SampleRange(const RecordedRun& run, std::size_t first, std::size_t end) : run_(run), next_(first), end_(end) {}
  bool next(RecordedSample& sample) override {
    if (next_ == end_) return false;
    sample = run_.samples[next_++];
    return true;
  }
  [[nodiscard]] const std::vector<std::size_t>& recorded() const override { return run_.recorded; }
  [[nodiscard]] bool has_time() const override { return run_.has_time; }

 private:
  const RecordedRun& run_;
  std::size_t next_;
  std::size_t end_;
};

}  // namespace toolcomp::certify
