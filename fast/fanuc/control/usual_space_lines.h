// SPDX-License-Identifier: Apache-2.0
// Usual lines of a stage in space, without a detour: from the words of a block to where it ends, how the tool stands
// there, and the event of its move. For the short cuts of leading edge offset and of tool side compensation.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fast/arithmetic/trigonometry.h"
#include "fast/basis/event.h"
#include "fast/fanuc/control/control.h"
#include "fast/fanuc/control/event_in_space.h"
#include "fast/fanuc/control/read_words.h"
#include "fast/fanuc/control/usual_words.h"
#include "fast/geometry/vector3.h"
#include "fast/kinematics/direction.h"

namespace toolcomp::fast {

// One of them, in 10^-6 of a setup unit.
struct UsualSpaceLine {
  std::uint32_t letters = 0;  // as UsualWords reads them
  DoublePair xy{};            // where it ends; X and Y side by side: made so at once, and never apart in memory
  double z = 0;
  Vector3<double> way;  // whole numbers
  std::array<std::int64_t, 3> ijk{};
};

// Positions of few places, under G43.5 I J K, without it rotary words, F and G00 or G01 again; nothing of the modal
// state needs a look. X Y Z are the first three axes.
class UsualSpaceLines {
 public:
  explicit UsualSpaceLines(Control& control) : control_(control), handover_(control) {}

  // Behind a block that a stage has taken: whether usual lines may come. Then blocks go to `taker` until leave().
  [[nodiscard]] bool await(BlockTaker& taker);
  // Before any other block: where the lines have led to becomes the programmed position. Who takes that block.
  BlockTaker& leave();

  // False: not the words of a usual line.
  [[nodiscard]] bool read(const spec::Block& block, UsualSpaceLine& line);
  // The tool stands as the line says.
  void turn(const UsualSpaceLine& line);
  [[nodiscard]] static bool names_feed(const UsualSpaceLine& line) { return (line.letters & kFeed) != 0; }
  void take_feed() { control_.modal.set_feed(words_.feed()); }
  // The event of a line that ends there (10^-6), the tool being turned. `filled`: it has what is the same in the events
  // of all of them. Without point, axes and machine in X Y Z where these are_plain().
  void fill(Event& event, bool filled, std::uint64_t line, const std::optional<std::uint64_t>& n, DoublePair xy,
            double z);
  // The line has been taken.
  void go_to(const UsualSpaceLine& line) {
    store_pair(&at_.x, line.xy);
    at_.z = line.z;
  }

  // The axes are sent to the programmed position: point, axes and machine of an event are `programmed` in X Y Z.
  [[nodiscard]] bool are_plain() const { return sent_ == Sent::as_programmed; }
  // Where X Y Z stand, and where arrays of lines have led to, 10^-6.
  [[nodiscard]] const Vector3<double>& at() const { return at_; }
  void set_at(const Vector3<double>& at);
  // The letters that may come, as UsualWords has them.
  [[nodiscard]] bool permits(std::uint32_t letters) const { return words_.permits(letters); }

 private:
  static constexpr std::size_t kI = UsualWords::at('I');
  static constexpr std::size_t kX = UsualWords::at('X');
  static constexpr std::uint32_t kFeed = UsualWords::set('F');
  static constexpr std::uint32_t kDirection = UsualWords::set_of("IJK");
  static constexpr std::uint32_t kXyzF = UsualWords::set_of("XYZFG");

  // What X Y Z are sent to: the programmed position, with a length offset on axes, with the length along the tool; or
  // what takes a look at all axes.
  enum class Sent : std::uint8_t { as_programmed, with_offset, along_tool, otherwise };

  // usual_space_lines.cpp
  [[nodiscard]] bool may_come() const;
  [[nodiscard]] Sent sent() const;
  void place(double x, double y, double z);
  // Every field, as any block has it filled in.
  void fill_all(Event& event, std::uint64_t line, const std::optional<std::uint64_t>& n, double x, double y, double z);
  void fill_sent(Event& event, DoublePair xy, double z) const;

  Control& control_;
  UsualWords words_;
  Vector3<double> at_;
  Vector3<double> offset_;  // on axes, 10^-6
  Sent sent_ = Sent::as_programmed;
  Handover handover_;
};

[[gnu::always_inline]] inline bool UsualSpaceLines::read(const spec::Block& block, UsualSpaceLine& line) {
  if (block.alarm) [[unlikely]]
    return false;
  const bool incremental = control_.modal.incremental();
  for (std::size_t i = 0; i < 3; ++i) words_[kI + i] = 0;
  if (incremental) [[unlikely]]
    for (std::size_t i = 0; i < 3; ++i) words_[kX + i] = 0;
  if (!words_.read(block, control_.modal.motion(), line.letters)) [[unlikely]]
    return false;
  line.xy = DoublePair{static_cast<double>(words_[kX]), static_cast<double>(words_[kX + 1])};
  line.z = static_cast<double>(words_[kX + 2]);
  line.ijk = {words_[kI], words_[kI + 1], words_[kI + 2]};
  if ((line.letters & kDirection) != 0 && (line.ijk[0] | line.ijk[1] | line.ijk[2]) == 0) [[unlikely]]
    return false;
  if (incremental) [[unlikely]] {
    if ((line.letters & ~kXyzF) != 0 && (line.letters & kDirection) == 0) return false;
    line.xy += load_pair(&at_.x);
    line.z += at_.z;
    constexpr auto kLimit = static_cast<double>(std::int64_t{1} << 52U);
    if (std::abs(line.xy[0]) > kLimit || std::abs(line.xy[1]) > kLimit || std::abs(line.z) > kLimit) return false;
  }
  const DoublePair way_xy = line.xy - load_pair(&at_.x);
  line.way = {way_xy[0], way_xy[1], line.z - at_.z};
  return true;
}

[[gnu::always_inline]] inline void UsualSpaceLines::turn(const UsualSpaceLine& line) {
  if ((line.letters & ~kXyzF) == 0) return;
  if ((line.letters & kDirection) != 0) {
    set_small_direction(control_.attitude.directions().next(), line.ijk[0], line.ijk[1], line.ijk[2]);
    return;
  }
  // Of those at a new place: a tool that stands still is not turned.
  unsigned turned = 0;
  for (unsigned rest = control_.axes.letters.positions(line.letters >> 1U) & ~0b111U; rest != 0; rest &= rest - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(rest));
    const std::int64_t small = words_[control_.axes.letters.index[axis] + 1U];
    const Count& place = control_.positions.programmed()[axis];
    if (place.is_small() && place.small() == small) continue;
    turned |= bit(axis);
    control_.positions.place_small(axis, small);
    if ((control_.positions.length().live() & bit(axis)) != 0) [[unlikely]]
      control_.positions.add_offset(axis);
  }
  if ((turned & control_.axes.turning) != 0) control_.attitude.turn();
}

[[gnu::always_inline]] inline void UsualSpaceLines::fill(Event& event, bool filled, std::uint64_t line,
                                                         const std::optional<std::uint64_t>& n, DoublePair xy,
                                                         double z) {
  if (!filled || sent_ == Sent::otherwise) [[unlikely]] {
    fill_all(event, line, n, xy[0], xy[1], z);
    return;
  }
  event.line = line;
  event.n = n;
  constexpr auto kPerOne = static_cast<double>(Count::kSmallPerOne);
  set_xyz(event.programmed, xy / kPerOne, z / kPerOne);
  if (control_.axes.count > 3) {
    // Two on most machines: the one that is not there is not looked at.
    for (std::size_t axis = 3; axis < 5; ++axis) event.axes.value[axis] = control_.positions.sent_to(axis);
    for (std::size_t axis = 5; axis < control_.axes.count; ++axis)
      event.axes.value[axis] = control_.positions.sent_to(axis);
  }
  if (event.tool_axis) {
    const Eigen::Vector3d& unit = control_.attitude.directions().now().unit;
    for (std::size_t i = 0; i < 3; ++i) (*event.tool_axis)[i] = unit[static_cast<Eigen::Index>(i)] + 0.0;  // never -0
  }
  if (sent_ != Sent::as_programmed) fill_sent(event, xy, z);
}

// As AxisPositions::add_offset() and ToolAttitude::fill() make them.
[[gnu::always_inline]] inline void UsualSpaceLines::fill_sent(Event& event, DoublePair xy, double z) const {
  constexpr auto kPerOne = static_cast<double>(Count::kSmallPerOne);
  const DoublePair programmed_xy = xy / kPerOne;
  const double programmed_z = z / kPerOne;
  set_xyz(event.point, programmed_xy, programmed_z);
  if (sent_ == Sent::with_offset) {
    set_xyz(event.axes, (xy + DoublePair{offset_.x, offset_.y}) / kPerOne, (z + offset_.z) / kPerOne);
    return;
  }
  const double length = control_.attitude.along_length();
  const Eigen::Vector3d& unit = control_.attitude.directions().now().unit;
  const DoublePair axes_xy = programmed_xy + DoublePair{length * unit[0], length * unit[1]};
  const double axes_z = programmed_z + length * unit[2];
  set_xyz(event.axes, axes_xy, axes_z);
  set_xyz(event.machine, axes_xy, axes_z);
}

}  // namespace toolcomp::fast
