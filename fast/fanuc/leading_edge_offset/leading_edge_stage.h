// SPDX-License-Identifier: Apache-2.0
// Leading edge offset as a stage: what its words say, and what its moves are.
#pragma once

#include <cstdint>

#include "fast/fanuc/control/stage.h"
#include "fast/fanuc/leading_edge_offset/leading_edge_offset.h"

namespace toolcomp::fast {

class LeadingEdgeStage final : public Stage {
 public:
  // Throws spec::InputError for parameters no control could have.
  LeadingEdgeStage(const spec::Setup& setup, Control& control, EventSink& sink)
      : Stage(control, true), offset_(setup, control.kinematics, sink) {}

  void set_sink(EventSink& sink) override { offset_.set_sink(sink); }
  void release() override;
  [[nodiscard]] Alarm plain_block(const Words& words) override;
  void read(const Words& words, const Command& command) override;
  [[nodiscard]] Alarm check(const Words& words, const Command& command) const override;
  [[nodiscard]] bool replaces_move(bool /*extra*/) const override { return on_before() != on_after(); }
  [[nodiscard]] Alarm take(const Words& words, Command& command) override;
  [[nodiscard]] Alarm move(const Words& words, const OwnMove& own) override;

 private:
  // A block in the mode; without `own` its words move nothing.
  [[nodiscard]] Alarm follow(const Words& words, bool own, bool extra);
  // The move that starts or ends the mode.
  [[nodiscard]] Alarm start();
  [[nodiscard]] Alarm cancel();
  void end_at_start(Alarm alarm) { control_.end({alarm, nullptr, offset_.start_line(), offset_.start_n()}); }

  LeadingEdgeOffset offset_;
  std::uint32_t d_ = 0;
  std::uint32_t d_read_ = 0;  // of the block read
  double radius_ = 0;         // of D, when it was applied
};

}  // namespace toolcomp::fast
