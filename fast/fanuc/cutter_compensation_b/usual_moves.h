// SPDX-License-Identifier: Apache-2.0
// The usual lines and arcs of cutter compensation B, one behind another: straight from the words of the block to the
// event. What it does is what CutterCompensationB::block() would do, bit for bit.
#pragma once

#include <array>
#include <cstddef>

#include "fast/arithmetic/trigonometry.h"
#include "fast/basis/event.h"
#include "fast/fanuc/control/control.h"
#include "fast/fanuc/control/usual_moves.h"
#include "fast/geometry/whole_pair.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::fast {

class CutterCompensationB;

// The vector in force.
struct UsualVector {
  const Event* event = nullptr;  // of the block before
  EventSink* sink = nullptr;
  double offset = 0;    // to the left, setup units
  DoublePair value{};   // setup units
  bool is_new = false;  // made since it was lent
  WholePair normal{};   // then: along it, of any length
};

// Takes blocks as they are read, while cutter compensation B has a vector and they are usual: moves in the plane by
// words of few places, F, and the codes G01 G02 G03; arcs about a centre.
class UsualCutterMoves final : public BlockTaker {
 public:
  UsualCutterMoves(Control& control, CutterCompensationB& compensation)
      : control_(control), compensation_(compensation), handover_(control), words_(control) {}

  // Behind a block that has been taken: the next ones come here, if they may be usual. False: they do not.
  bool await();
  void block(const spec::Block& block) override;
  void end() override { leave().end(); }

 private:
  // False, and nothing is done: any other block.
  [[nodiscard]] bool take(const spec::Block& block);
  // The vector at the end of a line or an arc. False: it is for the general way.
  [[nodiscard]] bool make_line(const WholePair& way);
  [[nodiscard]] bool make_arc(const WholePair& way, const UsualMove& move);
  void set_feed();
  // Before any other block. Who takes that.
  BlockTaker& leave();

  Control& control_;
  CutterCompensationB& compensation_;
  Handover handover_;
  std::array<std::size_t, 2> axis_{};
  UsualMoveWords words_;
  UsualVector vector_;
  WholePair at_{};  // the programmed position, 10^-6
  DoublePair at_value_{};
  // Events, in the plane not filled in.
  Event line_;
  Event arc_;
};

}  // namespace toolcomp::fast
