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
#include "fast/program/words.h"
#include "fast/tool_length_offset/offset_memory.h"
#include "fast/tool_length_offset/tool_length_offset.h"
#include "spec/language/block.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Everything the control knows while it runs a program. Positions are exact, in workpiece coordinates without offsets,
// lengths in setup units, angles in degrees.
class Interpreter {  // NOLINT(clang-analyzer-optin.performance.Padding): grouped by meaning
 public:
  // Throws spec::InputError for a setup the control could not have.
  Interpreter(const spec::Setup& setup, EventSink& sink);

  void block(const spec::Block& block);
  void end();
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  using Positions = std::array<Count, spec::kMaxAxes>;
  using Mask = std::uint16_t;  // bit i: axis i
  // What a block does to leading edge offset.
  enum class Compensation : std::uint8_t { off, starts, stays, cancels };
  // What the words of a block say about it, before anything is changed.
  struct Plan {
    Compensation compensation = Compensation::off;
    std::uint32_t d = 0;
    Code motion = 0;
    bool along = false;       // G43.5 is in force after the block
    bool ends_along = false;  // G49 ends it
    OffsetMemory::Write write;
    bool writes = false;
  };

  // interpreter.cpp: one block, step by step.
  void read_positions(const spec::AxisTable& table, const char* key, Positions& to) const;
  [[nodiscard]] Alarm run(const Words& words);
  [[nodiscard]] Alarm apply(const Words& words, const Plan& plan);
  void set_feed(const Words& words);
  [[nodiscard]] Alarm write_offset(const OffsetMemory::Write& write);
  void raise(const Alarm& alarm);
  void raise_at_start(const Alarm& alarm);
  void send_alarm(const spec::Name& number, const char* message, std::uint64_t line,
                  const std::optional<std::uint64_t>& n);

  // check.cpp: the alarms of commands, in their order.
  [[nodiscard]] Alarm check(const Words& words, Plan& plan) const;
  [[nodiscard]] Alarm check_tool_direction(const Words& words, const Plan& plan) const;
  [[nodiscard]] Alarm check_leading_edge(const Words& words, const Plan& plan) const;
  [[nodiscard]] std::uint32_t reference_point(const Words& words) const;

  // motion.cpp: own moves and their events. `own` words are positions; `extra`: a move even without them.
  [[nodiscard]] Alarm motion(const Words& words, Compensation compensation, bool own, bool extra,
                             const std::optional<spec::Arc<double>>& arc);
  [[nodiscard]] Alarm place(std::size_t axis, const Count& position);
  [[nodiscard]] Alarm place_word(const Words& words, std::size_t axis);
  [[nodiscard]] Alarm refresh();
  void fill(Event& event, spec::MoveType type, spec::Cause cause);
  void fill_machine(Event& event) const;
  [[nodiscard]] Count value(const spec::Decimal& word, bool linear, bool inch_program) const;
  [[nodiscard]] Count target(const Words& words, std::size_t axis) const;
  [[nodiscard]] Factor factor(bool inch_program) const;
  [[nodiscard]] spec::MoveType straight() const {
    return motion_ == 0 ? spec::MoveType::rapid : spec::MoveType::linear;
  }

  // arc_words.cpp
  [[nodiscard]] Alarm plan_arc(const Words& words, std::optional<spec::Arc<double>>& arc) const;
  [[nodiscard]] std::size_t normal_axis() const;

  // machine_moves.cpp: G53, G28, G30, G30.1, G29, G92, G54 to G59.
  [[nodiscard]] Alarm to_machine_position(const Words& words);
  [[nodiscard]] Alarm to_reference(const Words& words);
  [[nodiscard]] Alarm from_reference(const Words& words);
  [[nodiscard]] Alarm place_at_machine(std::size_t axis, const Count& machine);
  [[nodiscard]] Alarm send_rapid(spec::Cause cause, bool with_machine);
  [[nodiscard]] Alarm shift_coordinates(const Words& words);
  void select_workpiece(Code code);
  [[nodiscard]] Count machine_origin(std::size_t axis) const { return origin_[workpiece_][axis] + shift_[axis]; }

  // tool_direction.cpp: rotary axes and G43.5.
  void turn();
  void direct(const Words& words);
  void end_tool_direction();
  [[nodiscard]] Direction& new_direction();
  [[nodiscard]] bool along_tool() const { return length_.mode() == ToolLengthOffset::Mode::along_tool; }

  // Setup.
  spec::Axes axes_;
  std::size_t count_;
  Mask linear_ = 0;
  Mask rotary_ = 0;
  Mask all_ = 0;
  Mask turning_ = 0;  // axes that turn the tool
  std::array<std::size_t, 3> xyz_;
  bool inch_setup_;
  bool counts_increments_;  // 3401#0 = 0
  int increment_places_;
  bool head_offsets_ = false;  // 19666, 19709 to 19714
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
  bool plain_words_ = true;  // a word counts as written: no conversion, no least increments
  std::size_t workpiece_ = 0;
  std::uint32_t d_ = 0;
  double radius_ = 0;  // of D, when it was applied
  std::optional<double> feed_;

  // Positions.
  Positions programmed_;
  Positions shift_;  // G92
  Positions intermediate_;
  Mask has_intermediate_ = 0;
  // Axes whose programmed position (shift, intermediate point) was rounded to 1 / (127 * 10^18): a G49 ended G43.5 at
  // an irrational position.
  Mask rounded_ = 0;
  Mask shift_rounded_ = 0;
  Mask intermediate_rounded_ = 0;
  std::array<double, spec::kMaxAxes> programmed_value_{};  // nearest doubles
  std::array<double, spec::kMaxAxes> axes_value_{};        // with the length offset
  Mask stale_ = 0;                                         // axes whose axes_value_ is to be made again

  // Directions live in a ring because held moves refer to theirs: at most three blocks have one at a time.
  std::array<Direction, 4> directions_;
  std::uint8_t direction_ = 0;

  // The block.
  std::uint64_t line_ = 0;
  std::optional<std::uint64_t> n_;
  bool stopped_ = false;
  Event notice_;  // alarms and settings
};

// Calls f(axis) for each bit of the mask, lowest first; stops at an alarm and returns it.
template <class Function>
Alarm for_each_axis(std::uint16_t mask, Function f) {
  for (unsigned rest = mask; rest != 0; rest &= rest - 1)
    if (const Alarm a = f(static_cast<std::size_t>(__builtin_ctz(rest)))) return a;
  return alarm::kNone;
}

// The mask of one axis.
constexpr std::uint16_t bit(std::size_t axis) { return static_cast<std::uint16_t>(1U << axis); }

}  // namespace toolcomp::fast
