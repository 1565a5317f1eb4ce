// Interprets blocks: modal state, positions, tool direction; sends moves through the compensation stages.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "fast/arithmetic/count.h"
#include "fast/engine.h"
#include "fast/kinematics/kinematics.h"
#include "fast/leading_edge_offset/leading_edge_offset.h"
#include "fast/program/alarm.h"
#include "fast/program/arc.h"
#include "fast/program/words.h"
#include "fast/tool_length_offset/offset_memory.h"
#include "fast/tool_length_offset/tool_length_offset.h"
#include "spec/language/block.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Everything the control knows while it runs a program. Positions are exact, in workpiece coordinates without offsets.
class Interpreter {
 public:
  // Throws spec::InputError for a setup the control could not have.
  Interpreter(const spec::Setup& setup, EventSink& sink);

  void block(const spec::Block& block);
  void end();
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  using Positions = std::array<Count, spec::kMaxAxes>;
  using Mask = std::uint16_t;

  // What a block does to the compensation stage.
  enum class Compensation : std::uint8_t { off, starts, stays, cancels };

  // Setup.
  void read_positions(const spec::AxisTable& table, const char* key, Positions& to) const;

  // Block, step by step.
  [[nodiscard]] Alarm run(const Words& words);
  [[nodiscard]] Alarm check(const Words& words, Compensation compensation) const;
  [[nodiscard]] Compensation compensation_after(const Words& words, std::uint32_t d) const;
  [[nodiscard]] Alarm tool_direction_words(const Words& words, ToolLengthOffset::Mode before);
  void end_tool_direction();
  void select_workpiece(Code code);
  [[nodiscard]] Alarm write_offset(const Words& words);
  [[nodiscard]] Alarm motion(const Words& words, Compensation compensation, bool own, bool extra);
  [[nodiscard]] Alarm plan_arc(const Words& words, std::optional<spec::Arc<double>>& arc) const;
  [[nodiscard]] Alarm to_machine_position(const Words& words);
  [[nodiscard]] Alarm to_reference(const Words& words);
  [[nodiscard]] Alarm from_reference(const Words& words);
  [[nodiscard]] Alarm shift_coordinates(const Words& words);

  // Numbers.
  [[nodiscard]] Count value(const spec::Decimal& word, bool linear) const;
  [[nodiscard]] Count axis_value(const Words& words, std::size_t axis) const {
    return value(words.axis(axis), (linear_ >> axis & 1U) != 0);
  }
  [[nodiscard]] Count target(const Words& words, std::size_t axis) const;
  [[nodiscard]] Count machine_origin(std::size_t axis) const { return origin_[workpiece_][axis] + shift_[axis]; }

  // Positions.
  [[nodiscard]] Alarm place(std::size_t axis, const Count& position);
  [[nodiscard]] Alarm refresh();
  [[nodiscard]] const Direction& direction() const;
  [[nodiscard]] std::size_t normal_axis() const;

  // Events.
  void fill(Event& event, spec::MoveType type, spec::Cause cause);
  void fill_machine(Event& event) const;
  [[nodiscard]] Alarm send_rapid(spec::Cause cause);
  [[nodiscard]] Alarm send_machine_move(spec::Cause cause);
  [[nodiscard]] spec::MoveType straight() const;
  void raise(const Alarm& alarm);
  void raise_at(const Alarm& alarm, std::uint64_t line, const std::optional<std::uint64_t>& n);

  // Setup.
  spec::Axes axes_;
  std::size_t count_;
  Mask linear_ = 0;
  Mask rotary_ = 0;
  std::array<std::size_t, 3> xyz_;
  bool inch_setup_;
  bool counts_increments_;  // 3401#0 = 0
  int increment_places_;
  bool head_offsets_ = false;  // 19666, 19709–19714
  std::array<Positions, 6> origin_;
  std::array<Positions, 5> reference_;  // 0: floating, 1 to 4

  // Stages.
  Kinematics kinematics_;
  OffsetMemory memory_;
  ToolLengthOffset length_;
  EventSink& sink_;
  LeadingEdgeOffset leading_edge_;

  // Modal state.
  Code motion_ = 0;
  spec::Plane plane_ = spec::Plane::xy;
  bool incremental_ = false;
  bool inch_program_;
  std::size_t workpiece_ = 0;
  std::uint32_t d_ = 0;
  double radius_ = 0;
  std::optional<double> feed_;
  Mask shifted_rounded_ = 0;

  // Positions.
  Positions programmed_;
  Positions shift_;  // G92
  Positions intermediate_;
  Mask has_intermediate_ = 0;
  // Axes whose programmed position was rounded to 1 / (127 * 10^18): a G49 ended G43.5 at an irrational position.
  Mask rounded_ = 0;
  std::array<double, spec::kMaxAxes> programmed_value_{};
  std::array<double, spec::kMaxAxes> axes_value_{};
  Mask stale_ = 0;  // axes whose axes_value_ is to be made again
  Direction pose_;  // of the rotary axes
  Direction tool_;  // of I J K under G43.5

  // The block.
  std::uint64_t line_ = 0;
  std::optional<std::uint64_t> n_;
  bool stopped_ = false;
  Event alarm_event_;
  Event setting_event_;
};

}  // namespace toolcomp::fast
