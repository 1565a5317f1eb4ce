// SPDX-License-Identifier: Apache-2.0
// Finds time gaps in a recording.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "certify/trace/fault.h"

namespace toolcomp::certify {

// The time from one sample to the next.
struct TimeStep {
  double seconds = 0;
  double resolution = 0;   // of the time as written
  std::uint64_t line = 0;  // line of the CSV of the sample after the step
  MoveName move;           // there
  AxisPoint at{};
};

// Finds steps longer than one and a half periods. The period is the median of the kAround steps before, or of the same
// number of steps after if that is larger, because a recorder may change its period. The time of a step is known to its
// last written digit, so a step that is longer than the median by no more than that does not count. If there are fewer
// than kFew steps around, or if a quarter of them are not within half a period, or that digit, of their median, there
// is no period, and long steps are counted but not judged.
class TimeSteps {
 public:
  static constexpr std::size_t kAround = 31;
  static constexpr std::size_t kFew = 8;

  explicit TimeSteps(std::function<void(const TimeStep&)> gap) : gap_(std::move(gap)) {}
  void take(const TimeStep& step);
  void end();
  // The number of long steps at which there was no period.
  [[nodiscard]] std::uint64_t not_judged() const { return not_judged_; }

 private:
  // Steps by length.
  class Sorted {
   public:
    void add(double seconds);
    void remove(double seconds);
    [[nodiscard]] bool empty() const { return seconds_.empty(); }
    [[nodiscard]] bool few() const { return seconds_.size() < kFew; }
    [[nodiscard]] double median() const { return seconds_[seconds_.size() / 2]; }
    [[nodiscard]] bool steady(double resolution) const;

   private:
    std::vector<double> seconds_;
  };
  void judge();

  std::function<void(const TimeStep&)> gap_;
  std::deque<TimeStep> steps_;  // the steps before, the step to judge, the steps after
  std::size_t judged_ = 0;      // index of the step to judge, which is the number of steps before it
  Sorted before_;
  Sorted behind_;
  std::uint64_t not_judged_ = 0;
};

}  // namespace toolcomp::certify
