// SPDX-License-Identifier: Apache-2.0
// From words to movements: modal groups, absolute positions, planes, arcs, workpiece offsets.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/basis/number.h"
#include "model/basis/recorder.h"
#include "model/fanuc/program/codes.h"
#include "model/fanuc/program/step.h"
#include "model/fanuc/program/work_coordinates.h"
#include "model/kinematics/coordinate.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// What a block is to the drilling mode, as its codes leave it.
struct CycleBlock {
  bool on = false;       // in the drilling mode: the words of the block move nothing
  bool drills = false;   // it has data of a hole
  AxisMask axes = 0;     // the axis words of the hole, that of the drilling axis included
  Rational repeats = 1;  // 0: data alone

  [[nodiscard]] bool makes_holes() const { return drills && repeats != 0; }
};

// A block with the modal words in force in it. Points into the block it was made of.
struct Command {
  Words words;
  Codes codes;
  Motion motion = Motion::rapid;
  spec::Plane plane = spec::Plane::xy;
  bool incremental = false;
  AxisMask axes = 0;       // axes commanded; none where the letters mean something else (G04, G10)
  bool direction = false;  // I, J or K
  CycleBlock cycle = {};   // in the drilling mode the block names no axis: the words are those of a hole
  [[nodiscard]] bool is_arc_motion() const { return motion == Motion::arc_cw || motion == Motion::arc_ccw; }
  // An axis word stands in the block, and is no data of a code; no other way to ask for one is right.
  [[nodiscard]] bool names(std::size_t axis) const { return in(axes, axis); }
  [[nodiscard]] bool names(const spec::Axes& controlled, char letter) const { return names(controlled.index(letter)); }
};

// Interprets blocks one after the other and keeps the programmed position. Clauses: fanuc.program.*.
class Interpreter {
 public:
  Interpreter(const spec::Setup& setup, Recorder& recorder);

  // Reads the words and updates the modal groups. Throws Alarm for a block that cannot be read, PS0010, PS0030.
  Command read(const spec::Block& block);
  // Throws Alarm PS0011 where the block moves by G01 to G03, or drills, without an F.
  void require_feed(const Command& command) const;

  // G54 to G59, G54.1: the position is called by the new system from here on.
  void select_workpiece_system(const Command& command);
  // G10 L2, L20: from here on it is called by the new origins. Throws Alarm PS0031.
  void write_origins(const Command& command);
  // Where the block goes. `directed`: G43.5 is in force in it, I J K are a tool direction and alone make a move;
  // `always`: it makes a move even without; `compensated`: by cutter compensation; C refuses an arc about its start,
  // here one without a sweep. Throws Alarm. The position stays until arrive().
  std::vector<Leg> legs(const Command& command, bool directed, bool always, bool compensated);
  // A leg that stays where the block starts, or after arrive() where it ended.
  [[nodiscard]] Leg stay(const Command& command) const;
  // The straight leg to where the axis words of the block point, moving or not.
  [[nodiscard]] Leg toward(const Command& command) const;
  // After the block: its end, and what G52 and G92 redefine.
  void arrive(const Command& command, const std::vector<Leg>& legs);

  // An axis stands elsewhere than its word said: where G37 has stopped it.
  void stand(std::size_t axis, const Coordinate& at) { position_.at(axis) = at; }
  void stand(const Position& at) { position_ = at; }
  // X Y Z are called otherwise from here on: where G49 leaves the axes, or in another coordinate system.
  void shift_position(const Vector& by);
  void stand_in_space(const Vector& at);

  [[nodiscard]] const Position& position() const { return position_; }
  [[nodiscard]] const WorkCoordinates& work() const { return work_; }
  [[nodiscard]] const Numbers& numbers() const { return numbers_; }
  [[nodiscard]] const std::optional<Rational>& feed() const { return feed_; }

 private:
  void read_feed(const Command& command);
  [[nodiscard]] Rational word(const Command& command, std::size_t axis) const;
  // A leg that stays where the block starts.
  [[nodiscard]] Leg standing(spec::MoveType type) const;
  [[nodiscard]] Leg ordinary(const Command& command, spec::MoveType type) const;
  // Ends an axis of the leg at `to`, `travel` away from where the block starts.
  void go(Leg& leg, std::size_t axis, const Coordinate& to, const Real& travel) const;
  void go(Leg& leg, std::size_t axis, const Coordinate& to) const;
  [[nodiscard]] std::optional<spec::Arc<Real>> arc(const Command& command, const Leg& leg, bool directed,
                                                   bool compensated);
  [[nodiscard]] Leg machine_leg(const Command& command) const;
  [[nodiscard]] std::vector<Leg> reference_legs(const Command& command);
  [[nodiscard]] std::vector<Leg> return_legs(const Command& command) const;
  [[nodiscard]] std::size_t reference_number(const Command& command) const;

  const spec::Setup& setup_;
  Recorder& recorder_;
  Numbers numbers_;
  WorkCoordinates work_;
  Position position_;
  std::array<std::optional<Coordinate>, spec::kMaxAxes> intermediate_;  // of the last G28 or G30
  std::optional<Rational> feed_;
  bool feed_per_minute_ = true;
  Motion motion_ = Motion::rapid;
  spec::Plane plane_ = spec::Plane::xy;
  bool incremental_ = false;
};

}  // namespace toolcomp::model
