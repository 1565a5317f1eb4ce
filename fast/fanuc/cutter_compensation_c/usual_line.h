// SPDX-License-Identifier: Apache-2.0
// The usual lines of cutter compensation C, one behind another: straight from the words of the block to the event,
// without the look-ahead machine. What it does is what CutterCompensationC::block() would do, bit for bit.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/arithmetic/trigonometry.h"
#include "fast/basis/event.h"
#include "fast/fanuc/control/control.h"
#include "fast/fanuc/control/usual_words.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::fast {

class CutterCompensationC;

// The line that is held while the next one is awaited.
struct UsualLine {
  // What starts it: the line is the one that has been lent, or a usual one behind a corner of one vector or of two.
  enum class Start : std::uint8_t { lent, one_vector, two_vectors };

  Event* event = nullptr;  // of its block; in the plane not filled in
  EventSink* sink = nullptr;
  double radius = 0;  // without sign
  double offset = 0;  // positive: to the left
  double limit = 0;   // No. 5010
  Start start = Start::lent;
  std::array<std::int64_t, 2> way{};  // 10^-6
  DoublePair unit{};
  double norm = 0;                       // |way|
  DoublePair vector{};                   // at its start, the last one
  std::array<std::int64_t, 2> before{};  // the way of the line before it; not of a line that has been lent
};

// Takes blocks as they are read, while cutter compensation C holds a line and they are usual: a move in the plane by
// words of few places, F and the code in force again.
class UsualCutterLines final : public BlockTaker {
 public:
  UsualCutterLines(Control& control, CutterCompensationC& compensation)
      : control_(control), compensation_(compensation), handover_(control) {}

  // Behind a block that has been taken: the next ones come here, if they may be usual. False: they do not.
  bool await();
  void block(const spec::Block& block) override;
  [[nodiscard]] std::size_t lines(const LineChunk& chunk) override;
  void end() override { leave().end(); }

 private:
  // False, and nothing is done: any other block.
  [[nodiscard]] bool take(const spec::Block& block);
  // The first and the last vector of a corner, to a line. `acute`: there are two. False: it is no usual one, or doubles
  // cannot tell.
  struct Corner {
    bool acute = false;
    DoublePair first{};
    DoublePair last{};
  };
  [[nodiscard]] bool make_corner(const std::array<std::int64_t, 2>& way, double norm, DoublePair unit,
                                 Corner& corner) const;
  void send_corner_move();
  // F of the line that is held now.
  void set_feed();
  // Before any other block. Who takes that.
  BlockTaker& leave();

  Control& control_;
  CutterCompensationC& compensation_;
  Handover handover_;
  std::array<std::size_t, 2> axis_{};
  std::array<std::size_t, 2> letter_{};
  std::array<std::int64_t, 2> at_{};  // the programmed position, 10^-6
  DoublePair at_value_{};
  UsualWords words_;
  UsualLine line_;
};

}  // namespace toolcomp::fast
