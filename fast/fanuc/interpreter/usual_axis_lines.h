// SPDX-License-Identifier: Apache-2.0
// Usual lines without compensation, without a detour: the axes go to their words, with their length offsets.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/basis/event.h"
#include "fast/fanuc/control/control.h"
#include "fast/fanuc/control/usual_words.h"
#include "spec/language/axes.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::fast {

// Takes blocks while no stage is on and the length is not along the tool: positions of few places of axes that do not
// turn the tool, F and G00 or G01 again.
class UsualAxisLines final : public BlockTaker {
 public:
  explicit UsualAxisLines(Control& control) : control_(control), handover_(control) {}

  // Behind such a line; `move`: its event, where the next ones are made; `sink`: where they go.
  void await(Event& move, EventSink& sink);

  void block(const spec::Block& block) override;
  [[nodiscard]] std::size_t lines(const LineChunk& chunk) override { return handover_.back().lines(chunk); }
  void end() override { handover_.back().end(); }

 private:
  // False: no usual line, and nothing is done.
  [[nodiscard]] bool take(const spec::Block& block);
  void place(std::size_t axis, std::int64_t to, std::int64_t offset);
  void set_feed();

  Control& control_;
  UsualWords words_;
  Handover handover_;
  Event* move_ = nullptr;
  EventSink* sink_ = nullptr;
  std::array<std::size_t, 3> letter_{};                // of the first three axes
  bool permits_first_ = false;                         // these may come
  std::array<std::int64_t, spec::kMaxAxes> offset_{};  // of those that may, 10^-6
};

}  // namespace toolcomp::fast
