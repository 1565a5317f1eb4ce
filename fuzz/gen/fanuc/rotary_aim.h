// SPDX-License-Identifier: Apache-2.0
// Turns of the tool under tool center point control, by rotary words or by I J K, aimed at what the sections decide.
#pragma once

#include <optional>

#include "fuzz/gen/fanuc/program_writer.h"
#include "fuzz/gen/fanuc/tool_pose.h"
#include "judge/oracle/rotary.h"

namespace toolcomp::fuzz {

// Follows the tool roughly, in double: where a rule chooses another pair than thought, the next aim is only less sharp.
class RotaryAim {
 public:
  // `posture`: more turns through and around singular postures.
  RotaryAim(Choices& choose, ProgramWriter& write, const spec::Setup& setup, bool posture);

  // From the block just written on: the programming coordinate system is that of the pose reached.
  void start(bool by_words);
  void end();
  [[nodiscard]] bool by_words() const { return by_words_; }
  [[nodiscard]] bool rotary() const { return machine_.has_value(); }
  // A head: I J K may stand in the block of G43.5.
  [[nodiscard]] bool head() const { return machine_ && machine_->type == judge::RotaryMachine::Type::head; }
  // Both axes can be moved.
  [[nodiscard]] bool complete() const;
  // Directions and movements are in the programming coordinate system.
  [[nodiscard]] ToolAim aim() const;

  // Writes the words of a turn and ends no block; by rotary words outside the mode.
  void turn();
  // Any positions of the rotary axes, whole or quarter turns mostly.
  void position();

 private:
  // Of a direction seen from the table: the angle from the work-side axis, and the turn about it, in degrees.
  struct Polar {
    double polar = 0;
    double azimuth = 0;
  };

  void turn_axes();
  void turn_by_words();
  void move_to(std::int64_t tool, std::int64_t work);
  void write_direction(const Direction& frame_direction, bool whole_if_possible);
  void write_words(const SpaceCounts& whole);
  [[nodiscard]] Direction direction_at(const Polar& p) const;
  [[nodiscard]] Polar polar_of(const Direction& table_direction) const;
  [[nodiscard]] Direction to_frame(const Direction& table_direction) const;
  [[nodiscard]] Direction to_table(const Direction& frame_direction) const;
  [[nodiscard]] std::int64_t at(std::size_t axis) const;
  [[nodiscard]] double degrees(std::int64_t counts) const;
  [[nodiscard]] std::int64_t counts(double degrees) const;
  [[nodiscard]] double parameter(std::uint32_t number) const;
  SpaceCounts rational();
  bool cross_exactly();
  bool at_45_degrees();

  Choices& choose_;
  ProgramWriter& write_;
  const spec::Setup& setup_;
  bool posture_;
  std::optional<judge::RotaryMachine> machine_;
  bool by_words_ = false;
  std::int64_t foot_ = 0;  // counts: the tool-side position nearest to the work-side axis; half a turn on the farthest
  double least_ = 0;       // angles from the work-side axis that can be reached
  double most_ = 180;
  double frozen_tool_ = 0;  // degrees
  double frozen_work_ = 0;
  Direction direction_{0, 0, 1};  // under G43.5, in the frame
  std::optional<SpaceCounts> words_;
};

}  // namespace toolcomp::fuzz
