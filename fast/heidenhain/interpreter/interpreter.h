// SPDX-License-Identifier: Apache-2.0
// The state machine of a Klartext program (heidenhain.program.*): blocks to motions.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "fast/heidenhain/face_milling/face_milling.h"
#include "fast/heidenhain/peripheral_milling/peripheral_milling.h"
#include "fast/heidenhain/program/effective_tool.h"
#include "fast/heidenhain/program/event_writer.h"
#include "fast/heidenhain/program/parameters.h"
#include "fast/heidenhain/programmed_contour/programmed_contour.h"
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::fast::klartext {

class Interpreter {
 public:
  Interpreter(spec::Setup setup, EventSink& sink);

  void block(const spec::klartext::Block& block);
  // As Engine.
  [[nodiscard]] std::size_t lines(const LineChunk& chunk);
  void end();
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  using Block = spec::klartext::Block;
  // M functions of a block that mean something here, as bits.
  enum Function : std::uint8_t {
    kEnd = 1U << 0U,          // M2, M30
    kMachine = 1U << 1U,      // M91, M92
    kOversize = 1U << 2U,     // M107
    kOversizeEnd = 1U << 3U,  // M108
    kTcpm = 1U << 4U,         // M128
    kTcpmEnd = 1U << 5U,      // M129
  };
  using Functions = unsigned;
  static constexpr std::size_t kSlots = spec::klartext::kAxisLetters.size();
  static constexpr unsigned kMainSlots = 0b111U;  // X, Y, Z

  void start(const Block& block);
  [[nodiscard]] static Functions functions(const Block& block);
  void start_acting(Functions functions);
  void end_acting(Functions functions);
  [[nodiscard]] Alarm execute(const Block& block, Functions functions);
  void raise(const Alarm& alarm);
  void raise(AlarmCause cause, const char* more);
  void raise_at_held(const Alarm& alarm);

  [[nodiscard]] Alarm tool_call(const Block& block);
  [[nodiscard]] Alarm datum_shift(const Block& block);
  [[nodiscard]] Alarm assign(const spec::klartext::Parameter& target, const spec::klartext::Value& word);
  void switch_tcpm_on();
  void switch_tcpm_off();
  // The rotary positions turn the tool from its axis.
  void turn_by_positions();
  // Of a vector under TCPM.
  [[nodiscard]] ToolVector& new_direction() {
    by_vector_ = true;
    direction_ = direction_ == direction_of_.data() ? &direction_of_[1] : direction_of_.data();
    return *direction_;
  }
  [[nodiscard]] Alarm feed(const Block& block, bool call);

  // L and LN.
  void modal_words(const Block& block);
  [[nodiscard]] Alarm line(const Block& block, Functions functions);
  [[nodiscard]] Alarm line_with_vectors(const Block& block, Functions functions);
  [[gnu::always_inline]] [[nodiscard]] Alarm line_with_normal(const Block& block, Functions functions,
                                                              unsigned warnings, bool turned);
  // The words of the block become the programmed position; peripheral_.next() gets its travel, where that is wanted.
  [[gnu::always_inline]] [[nodiscard]] Alarm place(const Block& block, Functions functions);
  [[gnu::always_inline]] [[nodiscard]] bool place_xyz(const Block& block);
  void depart();
  void arrive(Displacement& travel);
  [[nodiscard]] Alarm place_word(const Block& block, std::size_t slot, bool shifted);
  void set_position(std::size_t slot, const Count& value);
  void write_position(std::size_t slot, double nearest);
  [[nodiscard]] bool compensates() const { return tcpm_ && side_ != 0; }
  // What is held is sent before a motion without peripheral compensation; false after an alarm.
  [[nodiscard]] bool release_before_motion();
  [[nodiscard]] spec::Cause cause() const { return head_.cancels ? spec::Cause::cancel : spec::Cause::programmed; }
  [[nodiscard]] ProgrammedPoint programmed_point() const { return {contour_, center_ && tcpm_}; }
  void peripheral_motion();
  void plain_motion();
  void out_of_scope();

  // retraction.cpp: blocks that move without axis words, and positions that nobody knows.
  [[nodiscard]] static bool moves_without_words(const Block& block);
  [[nodiscard]] Alarm place_without_words(const Block& block);
  [[nodiscard]] Alarm retract(const Block& block, std::array<Count, 3>& way, double& slack);
  // What the words of a block, placed, leave of positions that are unknown or rounded; not_judged where it needs one
  // that is unknown.
  [[nodiscard]] Alarm settle(const Block& block);
  [[nodiscard]] bool needs_unknown(const Block& block, unsigned before) const;
  void set_unknown(unsigned slots);

  // drilling.cpp: drilling cycles. Coordinates of a hole along the tool axis, from the preset.
  struct DrillingLevels {
    Count point_r, bottom;
    Count level;  // to which the tool returns
  };
  // CYCL DEF of a drilling cycle: its parameters have their values from here on.
  [[nodiscard]] Alarm define_cycle(const Block& block);
  // A hole at hand would need a position that nobody knows.
  [[nodiscard]] bool hole_needs_unknown() const;
  // CYCL CALL or M99, behind the motion of its block: one hole where the linear axes stand, or nothing with depth 0.
  [[nodiscard]] Alarm call_cycle();
  // By the parameters as they are now.
  [[nodiscard]] Alarm find_levels(DrillingLevels& levels) const;
  // The tool axis goes to `level`, which becomes its programmed position.
  void stand_at(const Count& level);

  // lines.cpp
  [[nodiscard]] bool may_be_face_lines(const LineChunk& chunk) const;
  void fill(LineMoves& made) const;

  const spec::Setup setup_;
  EventWriter writer_;
  EffectiveTool tool_;
  FaceMilling face_;
  PeripheralMilling peripheral_;
  Parameters parameters_;
  std::array<std::size_t, kSlots> axis_{};  // of a slot; spec::Axes::kNone where the setup has none
  std::uint16_t parallel_axes_ = 0;         // U, V, W: bit by axis
  bool started_ = false;
  bool stopped_ = false;
  bool inch_ = false;

  // Modal state.
  bool tcpm_ = false;
  bool by_vector_ = false;  // a vector turned the tool, and no rotary word came after it
  ToolVector left_;         // where TCPM was switched off and by_vector_: where the tool stands
  bool center_ = false;     // REFPNT CNT-CNT
  bool contour_ = false;    // PROG PATH IS CONTOUR
  bool oversize_ = false;   // M107
  int side_ = 0;            // RL 1, RR −1, R0 0
  std::size_t tool_axis_ = 2;
  // Of the tool now; along the tool axis while TCPM is off. LN blocks write it to two places in turn: face milling
  // looks back at the one before.
  std::array<ToolVector, 2> direction_of_;
  ToolVector* direction_ = direction_of_.data();
  std::optional<double> feed_, call_feed_;

  // Positions by slot, in units of the program and degrees: programmed, preset coordinates.
  std::array<Count, kSlots> position_;
  std::array<Count, kSlots> shift_;  // datum shift of cycle 7
  bool shifted_ = false;
  // Of X, Y, Z, bit by slot: nobody knows where it stands; behind M140 it is not a decimal and has been rounded to a
  // count, by `slack_` units at most.
  std::uint16_t unknown_ = 0;
  std::uint16_t rounded_ = 0;
  double slack_ = 0;
  // X, Y, Z before the block, where travel is wanted: small_from_ if all three are small and exact, else from_, off by
  // from_slack_.
  bool from_small_ = false;
  double from_slack_ = 0;
  std::array<std::int64_t, 3> small_from_{};
  std::array<Count, 3> from_;

  MoveHead head_;  // of the block that is run
};

inline void Interpreter::write_position(std::size_t slot, double nearest) {
  if (slot > 2)
    head_.position[axis_[slot]] = nearest;
  else if (slot == 2)
    head_.xyz.z = nearest;
  else
    head_.xyz.xy[slot] = nearest;
}

}  // namespace toolcomp::fast::klartext
