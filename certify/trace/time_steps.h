// SPDX-License-Identifier: Apache-2.0
// Where a record has no samples for a while.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "certify/trace/fault.h"

namespace toolcomp::certify {

// From one sample to the next.
struct TimeStep {
  double seconds = 0;
  double resolution = 0;   // of the time as written
  std::uint64_t line = 0;  // of the CSV: the sample behind the step
  MoveName move;           // there
  AxisPoint at{};
};

// Steps longer than one and a half periods. The period is the median of the kAround steps before, or of as many behind
// if that is larger: a recorder may change its period. A step is known to the last digit in which time is written, so
// one longer than the median by no more than that is none. Where fewer than kFew steps are around, or a quarter of them
// are not within half a period, or that digit, of their median, there is no period, and long steps are counted, not
// judged.
class TimeSteps {
 public:
  static constexpr std::size_t kAround = 31;
  static constexpr std::size_t kFew = 8;

  explicit TimeSteps(std::function<void(const TimeStep&)> gap) : gap_(std::move(gap)) {}
  void take(const TimeStep& step);
  void end();
  // Long steps where there was no period.
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
  std::deque<TimeStep> steps_;  // those before, the one to judge, those behind
  std::size_t judged_ = 0;      // index of the one to judge: how many are before
  Sorted before_;
  Sorted behind_;
  std::uint64_t not_judged_ = 0;
};

}  // namespace toolcomp::certify
