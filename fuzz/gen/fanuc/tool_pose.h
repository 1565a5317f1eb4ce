// SPDX-License-Identifier: Apache-2.0
// How a program turns its tool: by rotary words, or by I J K under G43.5.
#pragma once

#include <optional>
#include <string>

#include "fuzz/gen/fanuc/program_writer.h"
#include "fuzz/gen/fanuc/tool_direction.h"

namespace toolcomp::fuzz {

// Where the tool points: roughly, and exactly where whole numbers say it.
struct ToolAim {
  Direction direction{0, 0, 1};
  std::optional<SpaceCounts> whole;
};

class ToolPose {
 public:
  ToolPose(Choices& choose, ProgramWriter& write, const spec::Setup& setup);

  // From the block being written on I J K give the direction (G43.5), or rotary words again (G49).
  void by_words(bool on) { by_words_ = on; }
  [[nodiscard]] bool by_words() const { return by_words_; }
  // Whether anything turns the tool.
  [[nodiscard]] bool turns() const { return by_words_ || (kinematic_ && !rotary_.empty()); }
  [[nodiscard]] ToolAim aim() const;

  // Each writes the words of a turn and ends no block. Where nothing turns the tool they write nothing.
  void turn();
  // By an angle of `counts` thousandths of a degree, as nearly as words can say: exactly for a rotary axis at right
  // angles to the tool.
  void turn_by(std::int64_t counts);
  // To a coordinate axis, where the machine reaches one at quarter turns.
  void align();
  void direction(const SpaceCounts& whole);

 private:
  void rotary();
  void any_direction();
  [[nodiscard]] std::int64_t thousandths(std::int64_t counts) const;

  Choices& choose_;
  ProgramWriter& write_;
  const spec::Setup& setup_;
  std::string rotary_;  // the axes of the kinematics
  bool kinematic_ = false;
  bool by_words_ = false;
  std::optional<SpaceCounts> words_;  // I J K as last written
};

}  // namespace toolcomp::fuzz
