// Boxes around straight lines in a row, so that those near a position are found without asking each.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>

#include "certify/trace/metric.h"

namespace toolcomp::certify {

// Lines are numbered in a row, from `first` on; 16 share a box, and 32 of those another.
class Boxes {
 public:
  explicit Boxes(std::size_t first = 0) : end_(first), blocks_first_(first / kBlock), groups_first_(first / kGroup) {}
  void add(const AxisPoint& a, const AxisPoint& b) {
    while (blocks_first_ + blocks_.size() <= end_ / kBlock) blocks_.emplace_back();
    while (groups_first_ + groups_.size() <= end_ / kGroup) groups_.emplace_back();
    for (AxisBox* box : {&blocks_.back(), &groups_.back()}) {
      box->add(a);
      box->add(b);
    }
    ++end_;
  }
  // The lines before `number` are not asked for any more.
  void drop_before(std::size_t number) {
    for (; blocks_first_ < number / kBlock && !blocks_.empty(); ++blocks_first_) blocks_.pop_front();
    for (; groups_first_ < number / kGroup && !groups_.empty(); ++groups_first_) groups_.pop_front();
  }
  // Calls `each(number)` for the lines in [from, to) in their order, but for those in boxes that `skip(box)`.
  template <class Skip, class Each>
  void visit(std::size_t from, std::size_t to, Skip skip, Each each) const {
    to = std::min(to, end_);
    while (from < to) {
      const std::size_t group = from / kGroup;
      const std::size_t block = from / kBlock;
      if (from % kGroup == 0 && skip(groups_[group - groups_first_])) {
        from = (group + 1) * kGroup;
      } else if (skip(blocks_[block - blocks_first_])) {
        from = (block + 1) * kBlock;
      } else {
        for (const std::size_t last = std::min(to, (block + 1) * kBlock); from < last; ++from) each(from);
      }
    }
  }

 private:
  static constexpr std::size_t kBlock = 16;
  static constexpr std::size_t kGroup = kBlock * 32;
  std::size_t end_;
  std::size_t blocks_first_;
  std::size_t groups_first_;
  std::deque<AxisBox> blocks_;
  std::deque<AxisBox> groups_;
};

}  // namespace toolcomp::certify
