// SPDX-License-Identifier: Apache-2.0
// Boxes around consecutive straight lines, to find the lines near a position without testing each.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>

#include "certify/trace/metric.h"

namespace toolcomp::certify {

// Lines are numbered consecutively from `first` on. 16 lines share a box, 16 boxes share a larger box, and 16 of those
// another one.
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
  // The lines before `number` are no longer needed.
  void drop_before(std::size_t number) {
    for (std::size_t i = 0; i < kSizes.size(); ++i)
      for (Level& level = levels_[i]; level.first < number / kSizes[i] && !level.boxes.empty(); ++level.first)
        level.boxes.pop_front();
  }
  // Calls `each(number)` for the lines in [from, to) in order, except for lines in boxes for which `skip(box)` is true.
  template <class Skip, class Each>
  void visit(std::size_t from, std::size_t to, Skip skip, Each each) const {
    to = std::min(to, end_);
    for (bool first = true; from < to; first = false) {
      std::size_t behind = from;
      for (std::size_t i = 0; i < kSizes.size() && behind == from; ++i) {
        // A box that was tested at its first line need not be tested again.
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
