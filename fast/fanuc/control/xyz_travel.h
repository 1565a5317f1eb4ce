// SPDX-License-Identifier: Apache-2.0
// The travel of a block in X, Y and Z, exactly: where it started, and how that compares with where it ends.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fast/arithmetic/count.h"
#include "fast/fanuc/control/control.h"

namespace toolcomp::fast {

// Made before the words of a block are placed, asked behind that. Axes that are not there stay at 0.
class XyzTravel {
 public:
  explicit XyzTravel(const Control& control)
      : control_(control),
        at_{&control.positions.xyz(0), &control.positions.xyz(1), &control.positions.xyz(2)},
        rounded_(control.positions.rounded()),
        small_(rounded_ == 0 && at_small()),
        from_small_{at_[0]->small(), at_[1]->small(), at_[2]->small()} {
    if (!small_) [[unlikely]]
      from_ = control.positions.programmed_xyz();
  }

  // In whole 10^-6 all along: then small() is the travel in them.
  [[nodiscard]] bool is_small() const { return small_ && control_.positions.rounded() == 0 && at_small(); }
  [[nodiscard]] std::int64_t small(std::size_t i) const { return at_[i]->small() - from_small_[i]; }

  [[nodiscard]] std::array<Count, 3> from() const {
    if (from_) return *from_;
    std::array<Count, 3> from;
    for (std::size_t i = 0; i < 3; ++i) from[i].set_small(from_small_[i]);
    return from;
  }
  // How far each component may be from the truth, in units of Count: not 0 only where a position of an axis of the
  // block was rounded before or behind it.
  [[nodiscard]] double slack(Mask named) const {
    Mask xyz = 0;
    for (const std::size_t axis : control_.axes.xyz)
      if (axis != spec::Axes::kNone) xyz = static_cast<Mask>(xyz | bit(axis));
    return ((rounded_ | control_.positions.rounded()) & named & xyz) != 0 ? 2 : 0;
  }

 private:
  [[nodiscard]] bool at_small() const { return at_[0]->is_small() && at_[1]->is_small() && at_[2]->is_small(); }

  const Control& control_;
  std::array<const Count*, 3> at_;
  Mask rounded_;
  bool small_;
  std::array<std::int64_t, 3> from_small_;
  std::optional<std::array<Count, 3>> from_;  // not small
};

}  // namespace toolcomp::fast
