// SPDX-License-Identifier: Apache-2.0
// The usual paths of cutter compensation C and tool side compensation where arcs are among them, one behind another:
// straight from the words of the block to the event, without the look-ahead machine. What it does is what block() of
// the section would do, bit for bit. Lines alone go a shorter way still.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "fast/arithmetic/trigonometry.h"
#include "fast/basis/event.h"
#include "fast/fanuc/control/control.h"
#include "fast/fanuc/control/usual_moves.h"
#include "fast/fanuc/corner/usual_corner.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::fast {

// What a section lends: the path that is held while the next one is awaited.
struct UsualLoan {
  std::array<std::size_t, 2> in{};  // which of X Y Z the plane has: said by who asks
  Event* event = nullptr;           // of its block
  EventSink* sink = nullptr;
  UsualOffset offset;
  UsualPath path;
  UsualCorner start;                   // the corner at its start
  const Event* corner_move = nullptr;  // of a corner of more than one vector
  // Tool side compensation: moves up to the stop point belong to the block before the corner, and corners of lines are
  // as ToolPlane sees them.
  bool in_space = false;
  double shortest = 0;  // longer lines move for certain (No. 19630), 10^-6
};

// What it gets back: another path, the one before it, and the corner between them.
struct UsualReturn {
  const UsualPath& before;
  const UsualPath& path;
  const UsualCorner& corner;
  const Event& corner_move;  // where that corner is, without vector
  WholePair at;              // the same in the plane, 10^-6
  std::array<std::size_t, 2> in;
};

// A section that holds a path. While it is lent nothing else is asked.
class UsualPathLender {
 public:
  // False: this one is not to be lent.
  [[nodiscard]] virtual bool lend(UsualLoan& loan) = 0;
  virtual void take_back(const UsualReturn& usual) = 0;

 protected:
  ~UsualPathLender() = default;
};

// Takes blocks as they are read, while the section holds a line or an arc and they are usual: moves in the plane by
// words of few places, F, and the codes G01 G02 G03.
class UsualPaths final : public BlockTaker {
 public:
  UsualPaths(Control& control, UsualPathLender& lender)
      : control_(control), lender_(lender), handover_(control), words_(control) {}

  // Behind a block that has been taken: the next ones come here, if they may be usual. False: they do not.
  bool await();
  void block(const spec::Block& block) override;
  void end() override { leave().end(); }

 private:
  // False, and nothing is done: any other block.
  [[nodiscard]] bool take(const spec::Block& block);
  [[nodiscard]] bool make_path(const UsualMove& move);
  [[nodiscard]] bool make_corner();
  // Of the tool's arc along the path that is held.
  struct ToolArc {
    double sweep = 0;
    std::pair<double, double> radius;  // of a spiral
  };
  // The path that is held has an event for certain, with a vector at its end: it goes forward, or is an arc.
  [[nodiscard]] bool is_clear(DoublePair vector, ToolArc& arc) const;
  void own_corner_move(const Event& owner);
  void send_corner_moves();
  void send_path(DoublePair vector, const ToolArc& tool);
  void hold(const spec::Block& block, const UsualMove& move);
  void set_center(DoublePair center);
  void set_feed();
  // Before any other block. Who takes that.
  BlockTaker& leave();

  [[nodiscard]] Event& event_of(const UsualPath& path) { return path.is_arc() ? arc_ : line_; }

  Control& control_;
  UsualPathLender& lender_;
  Handover handover_;
  std::array<std::size_t, 2> axis_{};
  UsualMoveWords words_;

  UsualLoan loan_;
  bool lent_ = true;    // the path that is held is the one that has been lent
  unsigned lines_ = 0;  // behind one another, up to it
  std::array<UsualPath, 3> paths_;
  UsualPath* before_ = paths_.data();
  UsualPath* held_ = before_ + 1;
  UsualPath* next_ = before_ + 2;
  std::array<UsualCorner, 2> corners_;
  UsualCorner* start_ = corners_.data();  // of the path that is held
  UsualCorner* end_ = start_ + 1;
  WholePair at_{};  // its programmed end, 10^-6
  DoublePair at_value_{};
  DoublePair start_value_{};  // its start
  // Events, in the plane not filled in: of a line, of an arc, from vector to vector at a corner.
  Event line_;
  Event arc_;
  Event corner_move_;
};

}  // namespace toolcomp::fast
