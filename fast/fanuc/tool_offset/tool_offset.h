// SPDX-License-Identifier: Apache-2.0
// Tool offset G45 to G48 (chapter 14.3): travels made longer or shorter by an offset value.
#pragma once

#include <array>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/basis/alarm.h"
#include "fast/fanuc/program/words.h"
#include "spec/language/axes.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// By how much the axes stand away from the programmed position, and the rules that change it. Setup units, exact.
class ToolOffset {
 public:
  explicit ToolOffset(const spec::Setup& setup);

  // The number is the H of the length offset (5001#2 = 0, 5001#5 = 1), not that of the cutter.
  [[nodiscard]] bool number_by_h() const { return number_by_h_; }
  // The shift: actual less programmed position.
  [[nodiscard]] const Count& operator[](std::size_t axis) const { return shift_[axis]; }
  [[nodiscard]] std::uint16_t live() const { return live_; }  // axes whose shift is not 0
  void add(std::size_t axis, const Count& change);
  // G53, G28, G30, G30.1 on this axis.
  void clear(std::size_t axis);

  // What a code adds to the magnitude of a travel: the value, its negative, or twice that.
  [[nodiscard]] static Count increase(Code code, const Count& value);
  // The sense of a travel, 1 or -1; 0 where it leaves the axis alone. `word`: as written, for the sign of a zero.
  [[nodiscard]] static int sense(const Count& travel, const spec::Decimal& word, bool incremental);

  // The tool's arc, from the programmed one: travel and I J K in the plane. G45_ARC, PS0038.
  struct Arc {
    std::size_t along = 0;  // the plane axis on which the centre lies
    Count to_center;        // from where the tool stands, on that axis
    bool zero = false;      // the radius is zero
  };
  [[nodiscard]] static Alarm arc(const std::array<Count, 2>& travel, const std::array<Count, 2>& to_center,
                                 const Count& increase, Arc& arc);

 private:
  bool number_by_h_;
  std::uint16_t live_ = 0;
  std::array<Count, spec::kMaxAxes> shift_;
};

}  // namespace toolcomp::fast
