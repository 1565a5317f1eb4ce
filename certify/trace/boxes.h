// SPDX-License-Identifier: Apache-2.0
// Boxes around straight lines in a row, so that those near a position are found without asking each.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>

#include "certify/trace/metric.h"

namespace toolcomp::certify {

// Lines are numbered in a row, from `first` on; 16 share a box, 16 of those another, and 16 of those.
class Boxes {
 public:
  explicit Boxes(std::size_t first = 0) : end_(first) {
    for (std::size_t i = 0; i < kSizes.size(); ++i) levels_[i].first = first / kSizes[i];
  }
  void add(const AxisPoint& a, const AxisPoint& b) {
    for (std::size_t i = 0; i < kSizes.size(); ++i) {
      Level& level = levels_[i];
      while (level.first + level.boxes.size() <= end_ / kSizes[i]) level.boxes.emplace_back();
      level.boxes.back().add(a);
      level.boxes.back().add(b);
    }
    ++end_;
  }
  // The lines before `number` are not asked for any more.
  void drop_before(std::size_t number) {
    for (std::size_t i = 0; i < kSizes.size(); ++i)
      for (Level& level = levels_[i]; level.first < number / kSizes[i] && !level.boxes.empty(); ++level.first)
        level.boxes.pop_front();
  }
  // Calls `each(number)` for the lines in [from, to) in their order, but for those in boxes that `skip(box)`.
  template <class Skip, class Each>
  void visit(std::size_t from, std::size_t to, Skip skip, Each each) const {
    to = std::min(to, end_);
    for (bool first = true; from < to; first = false) {
      std::size_t behind = from;
      for (std::size_t i = 0; i < kSizes.size() && behind == from; ++i) {
        // Inside a box that was looked at already there is no use in looking again.
        if (!first && from % kSizes[i] != 0) continue;
        if (skip(levels_[i].boxes[from / kSizes[i] - levels_[i].first])) behind = (from / kSizes[i] + 1) * kSizes[i];
      }
      if (behind == from)
        for (behind = std::min(to, (from / kSizes.back() + 1) * kSizes.back()); from < behind; ++from) each(from);
      from = behind;
    }
  }

 private:
  struct Level {
    std::deque<AxisBox> boxes;
    std::size_t first = 0;
  };
  static constexpr std::array<std::size_t, 3> kSizes{4096, 256, 16};
  std::size_t end_;
  std::array<Level, kSizes.size()> levels_;
};

}  // namespace toolcomp::certify
