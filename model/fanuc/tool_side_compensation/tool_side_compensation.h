// SPDX-License-Identifier: Apache-2.0
// Tool side compensation: G41.2 G42.2, under G43.5 G41.6 G42.6, and G40. One stage with a look-ahead of some blocks.
//
// A block that moves in the plane at its own end is held (corner/look_ahead.h) until the next one that moves in that
// plane is known. Whether a block moves is asked at each corner by itself, so several of them may be open.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "model/fanuc/corner/look_ahead.h"
#include "model/fanuc/program/stage.h"
#include "model/fanuc/tool_side_compensation/held_side_path.h"
#include "model/fanuc/tool_side_compensation/plane_change.h"
#include "model/fanuc/tool_side_compensation/rules.h"
#include "model/fanuc/tool_side_compensation/tool_side_block.h"
#include "model/fanuc/tool_side_compensation/tool_side_words.h"

namespace toolcomp::model {

// Hands on every move with its compensation vector (Move::offset), the moves that belong to a block but are inserted
// beside its own, arcs as the tool runs them. Clauses: fanuc.tool-side.*, and those of fanuc.cutter-c.* that they name;
// on(), on_after(): fanuc.tool-side.on.
class ToolSideCompensation final : public StageOf<ToolSideBlock>, private CornerSection {
 public:
  // Throws spec::InputError for a parameter that makes no sense.
  explicit ToolSideCompensation(const Place& place);

  [[nodiscard]] Extent extent() const override { return Extent::space; }
  [[nodiscard]] int look_ahead() const override { return 2 * ahead_.limit(); }
  [[nodiscard]] bool on() const override { return ahead_.mode != CornerMode::off; }
  [[nodiscard]] bool on_after(const Command& command) const override { return words_.wanted(command); }
  // Throws Alarm PS5460.
  void refuse_rotary_word(const Command& command) const override;
  // From the first G41.2, G42.2, G41.6 or G42.6 of a program on. Throws Alarm TOOL_SIDE_MODE, PS0037,
  // FORBIDDEN_IN_3D_COMPENSATION, Q_FORMAT, TYPE_C_FORMAT, PS0034 or PS0029.
  std::shared_ptr<StageWords> read(const StageCommand& now) override;
  void add_way(StageWords& words, const BlockWay& way) const override {
    static_cast<ToolSideBlock&>(words).add_place(way);
  }
  void take(const Step& step) override;
  void finish() override;

 private:
  // How a block moves: asked at each corner by itself (fanuc.tool-side.moving-block).
  struct Movement {
    SidePath path;
    CompensationPlane own;  // at its end
    // How it leaves the corners at the ends of the blocks held, in order; nothing where it does not move in the plane
    // there, or the corner is known. Of an arc once the tool's view of it is known.
    std::vector<std::optional<SideEnd>> starts;
    std::optional<SideEnd> end;  // how it reaches its own end; nothing where it does not move in the plane there

    [[nodiscard]] std::vector<bool> corners() const;  // at which it moves
    [[nodiscard]] bool moves_behind() const { return std::ranges::count(corners(), true) > 0; }
    [[nodiscard]] bool moves() const { return end || moves_behind(); }
  };

  // tool_side_compensation.cpp: which block is what.
  void check(const ToolSideBlock& words) const;
  void forbid(const ToolSideBlock& words) const;
  void check_type_c(const ToolSideBlock& words, bool starts, bool cancels) const;
  void take_while_off(Step& now, bool wanted, Movement& movement);
  void start(Step& now, Held::Kind kind, Movement& movement);
  void take_in_mode(Step& now, Movement& movement);
  void take_cancel(Step& now, Movement& movement);
  void meet_corners(Step& now, const Movement& movement, const CutterOffset& offset);
  // `cuts_corner`: the block makes no vector at its own end, and was the outgoing leg of a corner before it.
  void cancel_alone(Step& now, bool cuts_corner);
  void hold(Step& now, Held::Kind kind, const CutterOffset& offset, const Movement& movement);
  void end_standing(Clause why) override;
  void released(const Held& held) override;

  // moving.cpp: how a block moves at the corners before it.
  [[nodiscard]] Movement movement_of(const Step& now) const;
  [[nodiscard]] bool crosses_tool(const CompensationPlane& plane, const SideEnd& line) const;
  void look_at_movement(Step& now, Movement& movement, const CutterOffset& offset);
  void look_at_arc(Step& now, Movement& movement);
  [[nodiscard]] int sense(const Direction& tool, spec::Plane plane) const;
  [[nodiscard]] bool leans(const Direction& tool, spec::Plane plane) const;

  // corner_groups.cpp: the vectors at the end of a block held.
  [[nodiscard]] SpaceGroup without_corner(const Held& held) override;
  [[nodiscard]] SpaceGroup vector_of_start(const Held& held, const SideEnd& start);
  // Block B of a corner.
  struct NextBlock {
    bool cancels;
    const Direction& tool;  // at its end
    const SidePath& path;
    const SideEnd& start;
    const CutterOffset& offset;
  };
  [[nodiscard]] SpaceGroup group_before(const Held& held, const NextBlock& next);

  ToolSideWords words_;
  SideRules rules_;
  PlaneChangeCheck plane_change_;
  spec::Axes axes_;
  Rational limit_;         // 19630, setup units
  bool type_c_;            // 5003#1, SUV
  bool on_mixed_machine_;  // 19680 = 21
  bool series_30i_;

  LookAhead ahead_;
  CompensationPlane corner_plane_;  // in which the group was made at which the tool is
  Direction before_;                // tool at the end of the block before
};

}  // namespace toolcomp::model
