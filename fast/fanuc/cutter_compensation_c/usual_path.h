// SPDX-License-Identifier: Apache-2.0
// The usual paths of cutter compensation C where arcs are among them, one behind another: straight from the words of
// the block to the event, without the look-ahead machine. What it does is what CutterCompensationC::block() would do,
// bit for bit. Lines alone go a shorter way still (usual_line.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/arithmetic/trigonometry.h"
#include "fast/basis/event.h"
#include "fast/fanuc/control/control.h"
#include "fast/fanuc/control/usual_words.h"
#include "fast/fanuc/cutter_compensation_c/usual_corner.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::fast {

class CutterCompensationC;

// What cutter compensation C lends: the path that is held while the next one is awaited.
struct UsualLoan {
  Event* event = nullptr;  // of its block
  EventSink* sink = nullptr;
  UsualOffset offset;
  UsualPath path;
  UsualCorner start;  // the corner at its start
};

// What it gets back: another path, the one before it, and the corner between them.
struct UsualReturn {
  const UsualPath& before;
  const UsualPath& path;
  const UsualCorner& corner;
  const Event& corner_move;  // where that corner is, without vector
  WholePair at;              // the same in the plane, 10^-6
};

// Takes blocks as they are read, while cutter compensation C holds a line or an arc and they are usual: moves in the
// plane by words of few places, F, and the codes G01 G02 G03.
class UsualCutterPaths final : public BlockTaker {
 public:
  UsualCutterPaths(Control& control, CutterCompensationC& compensation)
      : control_(control), compensation_(compensation) {}

  // Behind a block that has been taken: the next ones come here, if they may be usual.
  void await();
  void block(const spec::Block& block) override;
  void end() override;

 private:
  // Of a block: what its words say.
  struct Command {
    Code motion = 10;
    bool has_feed = false;
    WholePair to{};
    WholePair to_center{};    // of an arc
    std::int64_t radius = 0;  // R; 0: it is about a centre
  };

  // False, and nothing is done: any other block.
  [[nodiscard]] bool take(const spec::Block& block);
  [[nodiscard]] bool read(const spec::Block& block, Command& command);
  // Of the most usual arcs, X Y I J with a code before or without. False: any other, and nothing is done.
  [[nodiscard]] bool read_usual_arc(const spec::Block& block, Command& command) const;
  [[nodiscard]] bool make_path(const Command& command);
  // The path that is held has an event for certain, with a vector at its end: it goes forward; its sweep and its radii
  // are those of an arc.
  [[nodiscard]] bool is_clear(DoublePair vector, double& sweep) const;
  void send_corner_moves();
  void send_path(DoublePair vector, double sweep);
  void hold(const spec::Block& block, const Command& command);
  void set_center(DoublePair center);
  void set_feed();
  // Before any other block.
  void leave();

  [[nodiscard]] Event& event_of(const UsualPath& path) { return path.is_arc() ? arc_ : line_; }

  Control& control_;
  CutterCompensationC& compensation_;
  BlockTaker* others_ = nullptr;  // who takes blocks that are no usual paths
  std::array<std::size_t, 2> axis_{};
  std::array<std::size_t, 2> letter_{};         // of positions
  std::array<std::size_t, 2> center_letter_{};  // I J K
  std::array<std::size_t, 4> arc_letter_{};     // both
  UsualWords words_;

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
