// SPDX-License-Identifier: Apache-2.0
// What the control knows while it runs a program, in parts, and the run: moves, settings and alarms sent.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fast/arithmetic/count.h"
#include "fast/basis/alarm.h"
#include "fast/basis/event.h"
#include "fast/fanuc/control/axes.h"
#include "fast/fanuc/control/axis_positions.h"
#include "fast/fanuc/control/cutter_value.h"
#include "fast/fanuc/control/modal_state.h"
#include "fast/fanuc/control/read_words.h"
#include "fast/fanuc/control/tool_attitude.h"
#include "fast/fanuc/control/word_units.h"
#include "fast/fanuc/program/arc.h"
#include "fast/fanuc/program/cutter_block.h"
#include "fast/fanuc/program/words.h"
#include "fast/fanuc/tool_length_offset/offset_memory.h"
#include "fast/kinematics/kinematics.h"
#include "spec/language/alarm.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// The arc of a block, if it is one: its words, and centre, plane and direction as the event has them.
struct BlockArc {
  std::optional<spec::Arc<double>> event;
  ArcWords words;
};

// The interpreter and all stages see it. Positions are exact, in workpiece coordinates without offsets, lengths in
// setup units, angles in degrees.
struct Control {
  // Throws spec::InputError for a setup the control could not have.
  Control(const spec::Setup& setup, EventSink& sink, std::uint32_t samples);
  // Goes to the positions of the setup, before the first block. Throws as the constructor.
  void begin(const spec::Setup& setup);
  Control(const Control&) = delete;
  Control& operator=(const Control&) = delete;

  Kinematics kinematics;
  const ControlAxes axes;
  const StopCodes stop_codes;
  WordUnits units;
  ModalState modal;
  AxisPositions positions;
  ToolAttitude attitude;
  OffsetMemory memory;
  CutterValue cutter_value;
  const bool refuses_repeats;  // 3403#6: an address twice in a block
  // The block.
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;

  // Whether usual lines may come after the last block: words count as they are written, nothing of the modal state
  // needs a look, and no value waits to come into force.
  [[nodiscard]] bool awaits_lines() const {
    return !refuses_repeats && modal.motion() <= (modal.lacks_feed() ? kG00 : kG01) && !modal.incremental() &&
           units.plain() && !cutter_value.takes_edited() && !attitude.plans_tool() && !positions.length().pending() &&
           positions.rounded() == 0 && positions.tool_offset().live() == 0 && positions.stale() == 0;
  }

  // --- own moves of blocks ---
  // The positions of these axes and what follows from them: the tool direction, and what the axes are sent to.
  [[nodiscard]] Alarm place_words(const Words& words, Mask axes_named);
  // The event of a move; of an arc everything but event.arc.
  void fill(Event& event, spec::MoveType type, spec::Cause cause);
  // The same in place, for the path that every block takes.
  void fill_here(Event& event, spec::MoveType type, spec::Cause cause);
  // How the place where the axes stand is called now, without vectors: behind a change of the workpiece system nothing
  // else of an event changes.
  void name_place(Event& event);
  [[nodiscard]] Count target(const Words& words, std::size_t axis) const {
    return positions.target(words, axis, units, modal.incremental());
  }
  [[nodiscard]] Count travel(const Words& words, std::size_t axis) const {
    return positions.travel(words, axis, units, modal.incremental());
  }
  // Of an arc about a centre: its radii may differ by no more than 3410.
  [[nodiscard]] Alarm check_radii(const std::array<Count, 2>& start, const std::array<Count, 2>& end,
                                  const std::array<Count, 2>& to_center) const {
    return limits_radii() ? fast::check_radii(start, end, to_center, radii_apart_) : AlarmCause::none;
  }
  [[nodiscard]] bool limits_radii() const { return !radii_apart_.is_zero(); }
  // The alarms of an arc, and what its event has; a block that is none has no event. Without `geometry` it has its
  // centre, but neither sweep nor radii. `about_start`: an arc about its start is for the stage to refuse.
  [[nodiscard]] Alarm plan_arc(const Words& words, BlockArc& arc, bool geometry, bool about_start) const;
  // G52, G92: the positions of the axes of the block are called otherwise.
  [[nodiscard]] Alarm shift_coordinates(const Words& words);

  // --- G10 ---
  // Stores a plan without alarm: the name and the value of what was set.
  void store_offset(const OffsetMemory::Write& write, spec::Name& name, double& stored);
  void write_offset(const OffsetMemory::Write& write);

  // --- the end of the run ---
  bool stopped = false;
  void end(const StageEnd& end);
  // By an alarm of the block itself.
  // `more`: a text that says more than the table of alarms; nullptr: none does.
  void end(AlarmCause cause, const char* more = nullptr) { send_alarm(cause, more, line, n); }

 private:
  void send_alarm(AlarmCause cause, const char* more, std::uint64_t at, const std::optional<std::uint64_t>& n_at);
  void send_end(spec::EventKind kind, std::uint64_t at, const std::optional<std::uint64_t>& n_at);

  Count radii_apart_;  // 3410; 0: by anything
  spec::AlarmNumbers numbers_;
  EventSink& sink_;
  Event notice_;  // alarms and settings
};

[[gnu::always_inline]] inline void Control::fill_here(Event& event, spec::MoveType type, spec::Cause cause) {
  event.line = line;
  event.n = n;
  event.type = type;
  event.cause = cause;
  positions.fill(event);
  event.t_numerator = 0;
  if (type != spec::MoveType::arc) event.arc.reset();
  if (type == spec::MoveType::rapid)
    event.feed.reset();
  else
    event.feed = modal.feed();
  if (!positions.along_tool() && !kinematics.defined())
    event.tool_axis.reset();
  else
    attitude.fill(event);
}

[[gnu::always_inline]] inline Alarm Control::place_words(const Words& words, Mask axes_named) {
  if (attitude.plans_tool()) [[unlikely]]
    return attitude.place(words, axes_named);
  if (const Alarm a = positions.place_words(words, axes_named, units, modal.incremental())) return a;
  if ((axes_named & axes.turning) != 0) attitude.turn();
  if (positions.stale() != 0)
    if (const Alarm a = positions.refresh()) return a;
  return AlarmCause::none;
}

}  // namespace toolcomp::fast
