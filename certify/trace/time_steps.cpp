// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/time_steps.h"

#include <algorithm>

namespace toolcomp::certify {
namespace {

constexpr double kLong = 1.5;  // periods

}  // namespace

void TimeSteps::Sorted::add(double seconds) { seconds_.insert(std::ranges::upper_bound(seconds_, seconds), seconds); }

void TimeSteps::Sorted::remove(double seconds) { seconds_.erase(std::ranges::lower_bound(seconds_, seconds)); }

bool TimeSteps::Sorted::steady(double resolution) const {
  const double period = median();
  const auto low = std::ranges::lower_bound(seconds_, std::min(period / 2, period - resolution));
  const auto high = std::ranges::upper_bound(seconds_, std::max(kLong * period, period + resolution));
  return 4 * (high - low) >= 3 * static_cast<std::ptrdiff_t>(seconds_.size());
}

void TimeSteps::take(const TimeStep& step) {
  steps_.push_back(step);
  if (steps_.size() > judged_ + 1) behind_.add(step.seconds);
  if (steps_.size() > judged_ + kAround) judge();
}

void TimeSteps::end() {
  while (judged_ < steps_.size()) judge();
}

void TimeSteps::judge() {
  const TimeStep& step = steps_[judged_];
  // A side with few steps counts only where the other one has few too.
  const bool known = !before_.few() || !behind_.few();
  const auto counts = [&](const Sorted* around) { return !around->empty() && (!known || !around->few()); };
  double period = 0;
  for (const Sorted* around : {&before_, &behind_})
    if (counts(around)) period = std::max(period, around->median());
  if (step.seconds > kLong * period) {
    double resolution = step.resolution;
    for (const TimeStep& other : steps_) resolution = std::min(resolution, other.resolution);
    resolution += resolution / 1000;  // stamps as doubles are rounded, by far less
    bool steady = known;
    for (const Sorted* around : {&before_, &behind_})
      steady = steady && (!counts(around) || around->steady(resolution));
    if (step.seconds > period + resolution) {
      if (steady)
        gap_(step);
      else
        ++not_judged_;
    }
  }
  before_.add(step.seconds);
  if (judged_ + 1 < steps_.size()) behind_.remove(steps_[judged_ + 1].seconds);
  if (judged_ < kAround) {
    ++judged_;
    return;
  }
  before_.remove(steps_.front().seconds);
  steps_.pop_front();
}

}  // namespace toolcomp::certify
