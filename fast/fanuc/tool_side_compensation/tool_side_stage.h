// SPDX-License-Identifier: Apache-2.0
// Tool side compensation as a stage: what its words say, and what it is told about each block.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fast/fanuc/control/stage.h"
#include "fast/fanuc/tool_side_compensation/tool_side_compensation.h"

namespace toolcomp::fast {

class ToolSideStage final : public Stage {
 public:
  // Throws spec::InputError for parameters no control could have.
  ToolSideStage(const spec::Setup& setup, Control& control, EventSink& sink)
      : Stage(control, true),
        compensation_(setup, control.kinematics, sink),
        refuses_arcs_(setup.series == spec::Series::series_30i && control.kinematics.type() == 21) {}

  void set_sink(EventSink& sink) override { compensation_.set_sink(sink); }
  void release() override;
  [[nodiscard]] Alarm plain_block(const Words& words) override;
  [[nodiscard]] std::size_t lines(const LineChunk& chunk) override;
  void read(const Words& words, const Command& command) override;
  [[nodiscard]] Alarm check(const Words& words, const Command& command) const override;
  [[nodiscard]] Alarm rotary_word() const override { return AlarmCause::rotary_word_in_compensation; }
  [[nodiscard]] bool makes_arc(const Words& /*words*/) const override { return on_before() || on_after(); }
  [[nodiscard]] bool replaces_move(bool extra) const override {
    return compensation_.type() == StartType::c && on_before() != on_after() && !extra;
  }
  [[nodiscard]] Alarm take(const Words& words, Command& command) override;
  [[nodiscard]] Alarm move(const Words& words, const OwnMove& own) override;
  void rename() override;

 private:
  // The words of an arc, or letters that would make one.
  [[nodiscard]] bool names_arc(const Words& words, Code motion, spec::Plane plane) const;
  // The block as the stage of vectors sees it, and its end of the run.
  [[nodiscard]] Alarm pass(const Words& words, bool extra, const BlockArc& arc);
  void set_arc(ToolSideBlock& block, const ArcWords& words) const;
  // A code is in force with a number, or a vector is not removed yet.
  [[nodiscard]] bool is_on() const { return wanted_ || compensation_.active(); }

  // lines_of_stage.cpp
  // Whether the blocks of a chunk may be usual lines, and where X Y Z stand before them.
  [[nodiscard]] bool may_be_lines(const LineChunk& chunk, Vector3<double>& at) const;
  // The last one that has been taken is held. They began `at` X Y Z.
  void hold_last(const LineChunk& chunk, const SideLineEnd& end, const Vector3<double>& at);

  ToolSideCompensation compensation_;
  bool refuses_arcs_;  // 30i, mixed machine
  BlockArc arc_;       // of a block under G02 or G03
  Event place_;        // where a block starts that changes the workpiece system
  bool renames_ = false;
  CutterSide word_ = CutterSide::off;
  int sign_ = 1;         // +1 left: by code and sign of the value
  bool wanted_ = false;  // a code is in force with a number
};

}  // namespace toolcomp::fast
