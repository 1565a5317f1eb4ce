// SPDX-License-Identifier: Apache-2.0
// What a block is to the mode of tool side compensation: by its own words and movement and by the blocks before it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/basis/alarm.h"
#include "model/basis/recorder.h"
#include "model/fanuc/program/step.h"
#include "model/fanuc/tool_side_compensation/side_path.h"
#include "model/fanuc/tool_side_compensation/tool_side_block.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// What a block does to the vector.
enum class SidePart : std::uint8_t {
  free,        // the mode is off
  idle,        // makes no vector
  lone_start,  // of type C: makes the vector of the next block
  lone_cancel,
  start_up,
  moving,  // of the mode
  cancel
};

struct SidePlan {
  // How it leaves the corner at the end of a block before it.
  struct Start {
    std::uint64_t at = 0;  // the number of that block
    SideEnd end;
  };

  SidePart part = SidePart::free;
  std::uint64_t number = 0;  // of a block that makes a vector, counted from 1
  CutterOffset offset;       // at its end: of the last block that moved
  Rational distance_before;  // and before it
  SidePath path;
  CompensationPlane plane;     // at its end
  std::vector<Start> starts;   // where it moves in the plane of an earlier corner
  std::optional<SideEnd> end;  // how it reaches its own end, if it moves in the plane there
  bool at_corner = false;      // the block right before it makes a corner with it
  bool leaves_corner = false;  // idle: the vector at its end is one of no corner
  bool cancels = false;        // G40 or number 0 in force
  bool changes = false;        // lone_start, lone_cancel: the vector that is made or removed is not 0
  std::optional<Warning> warning;

  [[nodiscard]] const SideEnd* start_at(std::uint64_t block) const;
  [[nodiscard]] bool moves_behind() const { return !starts.empty(); }
};

// Follows the mode through the program. Clauses: fanuc.tool-side.*.
class SideMode {
 public:
  SideMode(const spec::Setup& setup, Recorder& recorder, int limit);

  // The next block. Throws Alarm PS0038 or DIR_CHANGE_AT_STARTUP, or LeftOpen.
  SidePlan next(const ToolSideBlock& block, const Step& step);

  // There is a vector, or a block that makes one.
  [[nodiscard]] bool is_on() const { return phase_ > Phase::pending; }
  // Or a code asks for one.
  [[nodiscard]] bool is_on_or_asked_for() const { return is_on() || asked_; }
  [[nodiscard]] bool is_pending() const { return phase_ == Phase::pending; }

 private:
  enum class Phase : std::uint8_t {
    off,
    pending,  // a lone start waits for the next block
    running,
    ending  // after a lone cancel the vector waits for its removal
  };
  // A block that makes a vector, until its corner and those before it are known.
  struct Waiting {
    std::uint64_t number = 0;
    CompensationPlane plane;
    CutterOffset offset;
    bool starts = false;  // the mode
    int count = 0;        // of the blocks without movement after it
    bool met = false;     // by the block it makes its corner with
  };

  void while_off(const ToolSideBlock& block, bool asked, SidePlan& plan);
  void in_mode(const ToolSideBlock& block, const Step& step, SidePlan& plan);
  void cancel(SidePlan& plan);
  void lone_cancel(SidePlan& plan);
  // How the block moves at the corners before it and at its own end.
  void find_movement(const ToolSideBlock& block, const Step& step, SidePlan& plan);
  [[nodiscard]] bool crosses_tool(const CompensationPlane& plane, const SideEnd& line) const;
  void look_at_arc(SidePlan& plan);
  [[nodiscard]] int sense(const Direction& tool, spec::Plane plane) const;
  [[nodiscard]] bool leans(const Direction& tool, spec::Plane plane) const;
  [[nodiscard]] CutterOffset next_offset(const ToolSideBlock& block, bool meets_first) const;
  // The block makes a vector at its end.
  void wait(SidePlan& plan, bool starts);
  // What it does to those that wait.
  void meet(const SidePlan& plan);
  [[noreturn]] void leave_open_here(Clause clause, const char* message) const;
  [[nodiscard]] Waiting& waiting(std::uint64_t number);

  Recorder& recorder_;
  spec::Axes axes_;
  int limit_;
  Rational shortest_;  // 19630, setup units
  bool type_c_;        // 5003#1, SUV

  Phase phase_ = Phase::off;
  bool asked_ = false;          // by the last block: a side and a number other than 0 in force
  CutterOffset last_;           // of the last block that moved anywhere, or of a lone start
  std::optional<int> started_;  // its side, if that was a start and no block has moved after it
  bool has_vector_ = false;     // the vector made last is not 0
  std::vector<Waiting> waiting_;
  std::uint64_t made_ = 0;  // blocks that make a vector
  Direction before_;        // tool at the end of the block before
};

}  // namespace toolcomp::model
