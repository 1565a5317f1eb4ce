// SPDX-License-Identifier: Apache-2.0
// Usual lines under tool center point control, without a detour: from the words of a block to the pose of the machine
// at its end, and the event of its move.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/fanuc/control/control.h"
#include "fast/fanuc/control/usual_words.h"

namespace toolcomp::fast {

// Takes blocks while no stage of compensation is on: positions of few places, rotary words or I J K as the mode has
// them, F and G00 or G01 again.
class UsualTipLines final : public BlockTaker {
 public:
  explicit UsualTipLines(Control& control) : control_(control), handover_(control) {}

  // Behind a block under G43.4 or G43.5 that no stage has taken: blocks come here where usual lines may follow.
  void await();

  void block(const spec::Block& block) override;
  void end() override { leave().end(); }

 private:
  static constexpr std::size_t kI = UsualWords::at('I');
  static constexpr std::size_t kX = UsualWords::at('X');
  static constexpr std::uint32_t kDirection = UsualWords::set_of("IJK");
  static constexpr std::uint32_t kXyz = UsualWords::set_of("XYZ");

  [[nodiscard]] bool may_come() const;
  // False: no usual line, and nothing is done.
  [[nodiscard]] bool take(const spec::Block& block);
  // The words are those of a line: the axes go there. Those of them that turn the tool.
  Mask place(std::uint32_t letters);
  // The move of a line, in the way of any: a warning or a turn belongs to it.
  [[gnu::noinline]] void send_with_turns(const spec::Block& block);
  // Before any other block. Who takes that.
  BlockTaker& leave();

  Control& control_;
  UsualWords words_;
  Handover handover_;
};

}  // namespace toolcomp::fast
