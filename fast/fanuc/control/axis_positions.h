// SPDX-License-Identifier: Apache-2.0
// Where the axes are: programmed positions, exact, what shifts them, and what the axes are sent to.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "fast/arithmetic/count.h"
#include "fast/basis/alarm.h"
#include "fast/basis/event.h"
#include "fast/fanuc/control/axes.h"
#include "fast/fanuc/control/word_units.h"
#include "fast/fanuc/tool_length_offset/tool_length_offset.h"
#include "fast/fanuc/tool_offset/tool_offset.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Lengths in setup units, angles in degrees. Positions are of the workpiece system, without offsets, where nothing else
// is said; machine coordinates are those plus machine_origin().
class AxisPositions {
 public:
  AxisPositions(const spec::Setup& setup, ControlAxes axes)
      : axes_(std::move(axes)), length_(setup), tool_offset_(setup) {
    for (std::size_t i = 0; i < 3; ++i) xyz_[i] = &programmed(axes_.xyz[i]);
  }
  AxisPositions(const AxisPositions&) = delete;
  AxisPositions& operator=(const AxisPositions&) = delete;
  // The positions of the setup. Throws spec::InputError for those no control could have. Every axis is stale.
  void read(const spec::Setup& setup);

  // The offsets on axes: G43 G44 H, and the shift of G45 to G48.
  [[nodiscard]] ToolLengthOffset& length() { return length_; }
  [[nodiscard]] const ToolLengthOffset& length() const { return length_; }
  [[nodiscard]] ToolOffset& tool_offset() { return tool_offset_; }
  [[nodiscard]] const ToolOffset& tool_offset() const { return tool_offset_; }

  // Under G43.4 or G43.5: the length is along the tool.
  [[nodiscard]] bool along_tool() const { return length_.mode() == ToolLengthOffset::Mode::along_tool; }

  // --- programmed positions ---
  [[nodiscard]] const Positions& programmed() const { return programmed_; }
  // An axis that is not there stands at 0.
  [[nodiscard]] const Count& programmed(std::size_t axis) const {
    static constexpr Count kNowhere;
    return axis == spec::Axes::kNone ? kNowhere : programmed_[axis];
  }
  [[nodiscard]] double programmed_value(std::size_t axis) const { return programmed_value_[axis]; }
  // With the shift of G45 to G48; 0 for an axis that is not there.
  [[nodiscard]] Count actual(std::size_t axis) const {
    return axis == spec::Axes::kNone ? Count() : programmed_[axis] + tool_offset_[axis];
  }
  // The programmed position of X, Y or Z (0, 1, 2).
  [[nodiscard]] const Count& xyz(std::size_t i) const { return *xyz_[i]; }
  [[nodiscard]] std::array<Count, 3> programmed_xyz() const { return {xyz(0), xyz(1), xyz(2)}; }
  [[nodiscard]] std::array<Count, 3> shift_xyz() const;  // of G45 to G48

  // A new position, if it is in range; the axis is stale.
  [[nodiscard]] Alarm place(std::size_t axis, const Count& position);
  // Where the word of an axis commands it to.
  [[nodiscard]] Count target(const Words& words, std::size_t axis, const WordUnits& units, bool incremental) const;
  // How far it commands it.
  [[nodiscard]] Count travel(const Words& words, std::size_t axis, const WordUnits& units, bool incremental) const;
  // The positions of these axes, by their words (read_words.h).
  [[nodiscard]] Alarm place_words(const Words& words, Mask axes, const WordUnits& units, bool incremental);
  // As place(), unchecked, and nothing is stale.
  void set(std::size_t axis, const Count& position) {
    programmed_[axis] = position;
    programmed_value_[axis] = position.nearest();
  }
  // The exact position alone: its value stays.
  void set_exact(std::size_t axis, const Count& position) { programmed_[axis] = position; }
  // What events show of a rotary axis that follows the tool: its exact position is made later.
  void show(std::size_t axis, double degrees) { programmed_value_[axis] = axes_value_[axis] = degrees; }
  // A position of at most six places, as it is written; false, and nothing is done: any other (read_words.h).
  [[nodiscard]] bool place_usual(const spec::Decimal& word, std::size_t axis);
  // A position in 10^-6, small.
  void place_small(std::size_t axis, std::int64_t small);
  // The length offset of an axis placed by it, 10^-6; the sum is small.
  void add_small_offset(std::size_t axis, std::int64_t offset) {
    axes_value_[axis] = Count::nearest_small(programmed_[axis].small() + offset);
  }
  // The offsets of an axis placed by one of the two (read_words.h).
  void add_offset(std::size_t axis);

  // Axes whose programmed position was rounded to 1 / (127 * 10^18): a G49 ended G43.5 at an irrational position.
  [[nodiscard]] Mask rounded() const { return rounded_; }
  void set_rounded(Mask axes) { rounded_ = static_cast<Mask>(rounded_ | axes); }
  void clear_rounded(Mask axes) { rounded_ = static_cast<Mask>(rounded_ & ~axes); }
  // The same of the zero of machine coordinates.
  [[nodiscard]] Mask rounded_zeros() const { return shift_rounded_; }

  // --- what the axes are sent to: with offsets, nearest doubles ---
  [[nodiscard]] double sent_to(std::size_t axis) const { return axes_value_[axis]; }
  // Axes of which it is to be made again, by refresh().
  [[nodiscard]] Mask stale() const { return stale_; }
  void make_stale() { stale_ = axes_.all; }
  [[nodiscard]] Alarm refresh();
  // programmed, point and axes of a move; machine too.
  void fill(Event& event) const;
  void fill_machine(Event& event) const;

  // --- machine coordinates: G53, G54 to G59, G54.1, G52, G92, G10 L2 L20, G28 to G30 ---
  [[nodiscard]] Count machine_origin(std::size_t axis) const { return zero_[axis]; }
  // Axes with a workpiece origin in force or a shift.
  [[nodiscard]] Mask displaced() const { return displaced_; }
  // The position as workpiece system `system` (G54: 0) calls it.
  [[nodiscard]] Count in_system(std::size_t axis, std::size_t system) const {
    return programmed_[axis] + origin_[workpiece_][axis] - origin_[system][axis];
  }
  [[nodiscard]] std::size_t system() const { return workpiece_; }
  // The machine stays where it is: the programmed position shifts by the difference of the origins.
  void select_system(std::size_t system);
  // Origins: 0 to 5 of G54 to G59, of G54.1 P1 …, and the one that is added to all.
  static constexpr std::size_t kFirstAdditional = 6;
  static constexpr std::size_t kExternal = kFirstAdditional + spec::kAdditionalWorkpieces;
  [[nodiscard]] const Count& origin(std::size_t number, std::size_t axis) const { return origin_[number][axis]; }
  // G10 writes one, G52 puts that of the local system of an axis there; end_origins() behind the last axis.
  void set_origin(std::size_t number, std::size_t axis, const Count& value);
  [[nodiscard]] Alarm set_local(std::size_t axis, const Count& origin);
  void end_origins();
  // G92 calls the position of an axis otherwise, and ends its local system; end_shift() behind the last one.
  [[nodiscard]] Alarm shift(std::size_t axis, const Count& position);
  void end_shift(Mask axes);
  // An axis at a machine position: its offsets are taken away, its workpiece position is what is left.
  [[nodiscard]] Alarm place_at_machine(std::size_t axis, const Count& machine);
  // The intermediate point of G28 and G30.
  [[nodiscard]] Alarm to_intermediate(std::size_t axis, const Count& position);
  void end_intermediate(Mask axes);
  // Whether all of these axes have one.
  [[nodiscard]] bool has_intermediate(Mask axes) const { return (axes & ~has_intermediate_) == 0; }
  // Back to it, for those of the axes that have one.
  [[nodiscard]] Alarm from_intermediate(Mask axes);
  // The reference positions, machine coordinates: 0 floating, 1 to 4.
  [[nodiscard]] const Positions& reference(std::size_t number) const { return reference_[number]; }

 private:
  void add_zeros();
  void fill_displaced_machine(Event& event) const;

  ControlAxes axes_;  // a copy at hand: every block asks
  ToolLengthOffset length_;
  ToolOffset tool_offset_;
  std::vector<Positions> origin_ = std::vector<Positions>(kExternal + 1);
  std::array<Positions, 5> reference_;
  std::size_t workpiece_ = 0;
  Positions programmed_;
  Positions local_;  // G52
  Positions shift_;  // G92
  Positions zero_;   // of all of them, in force
  Mask displaced_ = 0;
  Positions intermediate_;
  Mask has_intermediate_ = 0;
  Mask rounded_ = 0;
  Mask shift_rounded_ = 0;
  Mask intermediate_rounded_ = 0;
  std::array<double, spec::kMaxAxes> programmed_value_{};  // nearest doubles
  std::array<double, spec::kMaxAxes> axes_value_{};
  Mask stale_ = 0;
  std::array<const Count*, 3> xyz_{};  // of programmed_
};

// X Y Z by themselves: a loop would count for nothing on most machines. What is not present is not looked at.
[[gnu::always_inline]] inline void AxisPositions::fill(Event& event) const {
  event.programmed.present = axes_.linear;
  event.point.present = axes_.linear;
  event.axes.present = axes_.all;
  event.machine.present = 0;
  const auto fill_axis = [&](std::size_t axis) {
    const double programmed = programmed_value_[axis];
    event.programmed.value[axis] = programmed;
    event.point.value[axis] = programmed;
    event.axes.value[axis] = axes_value_[axis];
  };
  fill_axis(0);
  fill_axis(1);
  fill_axis(2);
  for (std::size_t axis = 3; axis < axes_.count; ++axis) event.axes.value[axis] = axes_value_[axis];
  constexpr Mask kXyz = 0b111;
  if ((axes_.linear & ~kXyz) != 0) [[unlikely]]
    for (std::size_t axis = 3; axis < axes_.count; ++axis) fill_axis(axis);
  if (tool_offset_.live() != 0) [[unlikely]]
    for (unsigned rest = tool_offset_.live(); rest != 0; rest &= rest - 1) {
      const auto axis = static_cast<std::size_t>(__builtin_ctz(rest));
      event.point.value[axis] = actual(axis).nearest();
    }
}

[[gnu::always_inline]] inline void AxisPositions::fill_machine(Event& event) const {
  event.machine.present = axes_.all;
  if ((displaced_ | stale_) != 0) [[unlikely]] {
    fill_displaced_machine(event);
    return;
  }
  event.machine.value[0] = axes_value_[0];
  event.machine.value[1] = axes_value_[1];
  event.machine.value[2] = axes_value_[2];
  for (std::size_t axis = 3; axis < axes_.count; ++axis) event.machine.value[axis] = axes_value_[axis];
}

[[gnu::always_inline]] inline void AxisPositions::place_small(std::size_t axis, std::int64_t small) {
  programmed_[axis].set_small(small);
  const double position = Count::nearest_small(small);
  programmed_value_[axis] = position;
  axes_value_[axis] = position;
}

}  // namespace toolcomp::fast
