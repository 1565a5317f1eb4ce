// SPDX-License-Identifier: Apache-2.0
// Cutter compensation C: G40, G41, G42 and G39. One stage with a look-ahead of one moving block and
// some others.
//
// A block that moves in the plane is held (corner/look_ahead.h) until the next one is known: one corner at most is
// open.
#pragma once

#include <cstdint>

#include "model/fanuc/corner/look_ahead.h"
#include "model/fanuc/cutter_compensation/cutter_compensation.h"
#include "model/fanuc/cutter_compensation_c/held_cutter_path.h"
#include "model/fanuc/cutter_compensation_c/rules.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Clauses: fanuc.cutter-c.*.
class CutterCompensationC final : public CutterCompensation, private CornerSection {
 public:
  explicit CutterCompensationC(const Place& place);

  [[nodiscard]] int look_ahead() const override { return ahead_.limit(); }
  [[nodiscard]] bool on() const override { return ahead_.mode != CornerMode::off; }
  // In the mode: it is then an arc without a sweep, and PS0038.
  [[nodiscard]] bool takes_arc_about_its_start(const Command& command) const override { return on_after(command); }
  void take(const Step& step) override;
  void finish() override;

 private:
  // cutter_compensation_c.cpp: which block is what.
  [[nodiscard]] bool wanted(CutterSide side, std::uint32_t number) const override;
  using CutterCompensation::wanted;
  void check(const CutterBlock& words) const override;
  void check_corner_arc(const CutterBlock& words) const;
  void take_while_off(Step& now, bool wanted, bool moves);
  void take_while_on(Step& now, bool wanted, bool moves);
  void take_moving(Step& now);
  void hold_moving(Step& now, Held::Kind kind, const OffsetPath& path, const CutterOffset& offset);
  void take_without_motion(Step& now);
  void take_cancel(Step& now);
  // G52 or G92 of the plane, before what else the block does.
  void take_vector_for_a_time(Step& now);
  void cancel_alone(Step& now);
  void cancel_by_zero_travel(Step& now);
  void drop_lone_start();
  // A block of the mode or a cancel block moves at the corner before it; `path`, with its offset.
  void meet_corner(Step& now, const OffsetPath& path, const CutterOffset& offset);
  // Of a code that makes or removes the vector without motion in the plane.
  void see_move_alone(Step& step, bool changes) const;
  void end_standing(Clause why) override;
  void released(const Held& held) override;

  // machine_moves.cpp: G53, G28, G30, G29.
  void take_machine_move(Step& now, bool wanted);
  void take_reference_with_intersection(Step& now);
  void decide_axes(const CutterBlock& block) const;
  // There is no vector from here on, and the mode stays on.
  void go_on_without_vector();

  // corner_arc.cpp: G39.
  void take_corner_arc(Step& now);
  // The vector behind it; the step gets its arc.
  [[nodiscard]] SpaceGroup turn(Step& arc, const Heading& to, bool next_is_square);

  // corner_groups.cpp: the vectors at the end of a block held.
  [[nodiscard]] SpaceGroup without_corner(const Held& held) override;
  [[nodiscard]] SpaceGroup vector_of_start(Held& held, const PathEnd& next);
  [[nodiscard]] SpaceGroup group_before(const Held& held, const CutterBlock& next, const OffsetPath& path,
                                        const CutterOffset& offset);

  CutterRules rules_;
  spec::Axes axes_;
  bool at_once_;         // 5003#1, SUV
  bool keeps_the_mode_;  // 5003#2, CCN

  LookAhead ahead_;
  Heading here_heading_;       // the vector is square to this, where it can be that of G39
  bool made_by_move_ = false;  // the vector was made by a moving block
  bool unchecked_ = false;     // the next moving block is not checked for interference
};

}  // namespace toolcomp::model
