// SPDX-License-Identifier: Apache-2.0
// What a block is to the mode of cutter compensation C: by its own words and movement and by the blocks before it.
#pragma once

#include <cstdint>
#include <optional>

#include "model/fanuc/cutter_compensation/cutter_compensation.h"

namespace toolcomp::model {

// What a block does to the vector. Those with * make a corner with the block that ends there.
enum class CutterPart : std::uint8_t {
  free,        // the mode is off
  idle,        // does not move in the plane, keeps the vector
  lone_start,  // G41 or G42 of SUV = 1 that does not move in the plane: makes the vector if a block of the mode follows
  lone_cancel,
  start_up,
  moving,                 // * of the mode
  cancel,                 // *
  cancel_by_zero_travel,  // after a lone cancel, an axis word of the plane without travel
  corner_arc,             // G39
  outside_axes,           // G53, G28, G30, G30.1 or G29 of axes outside the plane alone
  vector_goes,            // the same in the plane: the vector vanishes in the first move
  way_to_intermediate,    // * a reference return: its first move is a block of the mode
  along_to_intermediate   // the same without travel in the plane: the vector goes after that move
};

struct CutterPlan {
  CutterPart part = CutterPart::free;
  CutterOffset offset;     // at its end: of the last block that moved
  OffsetPath path = {};    // of a start-up block, and of those with *
  int count = 0;           // idle: as how many blocks without motion
  bool to_check = true;    // for interference
  bool changes = false;    // lone_start, lone_cancel: the vector that is made or removed is not 0
  bool shifts = false;     // G52 or G92 of the plane takes the vector away before
  bool after_leg = false;  // shifts: a moving block waits for its corner
  bool stops = false;      // nothing is read beyond this block before it has run
  std::optional<PlanePoint> direction = std::nullopt;  // cancel: of the I J of its G40, not zero
};

// Follows the mode through the program. Clauses: fanuc.cutter-c.*.
class CutterMode : public CornerMode {
 public:
  CutterMode(const spec::Setup& setup, Recorder& recorder)
      : CornerMode(setup, recorder), idle_limit(blocks_read(setup) - 1) {}

  // So many blocks without motion end the look-ahead.
  const int idle_limit;

  // The block that waits for the next one that moves. The words of a block are read before its moves are made.
  struct Waiting {
    bool moves = false;  // it ends at a corner
    int count = 0;       // of the blocks without motion after it
  };
  // The next block. Throws Alarm PS0038 or DIR_CHANGE_AT_STARTUP, or LeftOpen.
  CutterPlan next(const Step& step, const std::optional<Waiting>& waiting);

 private:
  CutterPlan while_off(const CutterBlock& block);
  CutterPlan while_on(const CutterBlock& block, const Step& step);
  [[nodiscard]] CutterPlan of_part(CutterPart part) const { return {.part = part, .offset = last_}; }
  // A block that moves in the mode, or the way to an intermediate point.
  CutterPlan in_mode(CutterPart part, const CutterBlock& block, const Step& step);
  CutterPlan machine_move(const CutterBlock& block, const Step& step);
  CutterPlan without_motion(const CutterBlock& block);
  CutterPlan lone_cancel();
  CutterPlan cancel(const CutterBlock& block);
  // Whether a moving block waits for its corner. Throws LeftOpen.
  bool take_vector_away();
  // What waits makes no corner.
  void nothing_follows();

  std::optional<Waiting> waiting_;  // while a block is planned
};

}  // namespace toolcomp::model
