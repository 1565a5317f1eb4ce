// SPDX-License-Identifier: Apache-2.0
// Codes and values that stay in force: groups 01, 02, 03, G43.5, F. Group 09 is CannedCycle's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fast/fanuc/control/axes.h"
#include "fast/fanuc/control/word_units.h"
#include "fast/fanuc/program/words.h"
#include "spec/language/event.h"

namespace toolcomp::fast {

// Letters that make an arc of a block under G02 or G03.
inline constexpr std::uint32_t kArcLetters = Words::set_of("IJKR");

// G17 G18 G19.
constexpr spec::Plane plane_of(Code code) {
  return code == kG17 ? spec::Plane::xy : (code == kG18 ? spec::Plane::zx : spec::Plane::yz);
}

// Which of X Y Z (0, 1, 2) is axis i (0, 1) of a plane: XY, ZX, YZ.
constexpr std::size_t in_plane(spec::Plane plane, std::size_t i) {
  const std::size_t first = plane == spec::Plane::xy ? 0 : (plane == spec::Plane::zx ? 2 : 1);
  return (first + i) % 3;
}

// The letter I J K of that axis.
constexpr char direction_letter(spec::Plane plane, std::size_t i) {
  return static_cast<char>('I' + static_cast<int>(in_plane(plane, i)));
}

class ModalState {
 public:
  // G00, G17, G90, no feed.
  // `line_without_center`: 3403#5 = 0.
  ModalState(const std::array<std::size_t, 3>& xyz, bool line_without_center)
      : xyz_(xyz), line_without_center_(line_without_center) {
    select_plane(plane_);
  }

  // Group 01, in tenths.
  [[nodiscard]] Code motion() const { return motion_; }
  void set_motion(Code code) { motion_ = code; }
  [[nodiscard]] spec::MoveType straight() const {
    return motion_ == kG00 ? spec::MoveType::rapid : spec::MoveType::linear;
  }
  // G02 or G03 in force, and an axis word of the plane or a letter of an arc: anything else is straight. A block with a
  // code of group 00 but G45 to G48, a dwell say, is no arc, whatever its words.
  [[nodiscard]] bool is_arc(const Words& words) const {
    return motion_ > kG01 && ((words.axes() & plane_axes_) != 0 || words.has_any(arc_letters_)) &&
           (words.code(Words::kOneShot) == kNone || words.is_tool_offset());
  }

  // Whether a block that is an arc by its words runs one: R with the end in the start is an arc of 0 degrees, and
  // without R and I J K CIR may make it a line.
  [[nodiscard]] bool runs_arc(const Words& words, const std::array<Count, 2>& start,
                              const std::array<Count, 2>& end) const {
    if (words.has('R')) return !(start == end);
    return !line_without_center_ || words.has_any(Words::set_of("IJK"));
  }

  // The words of an arc into an ArcWords or a CutterBlock (read_words.h).
  template <class Arc>
  void read_arc(const Words& words, const WordUnits& units, Arc& arc) const;

  // Group 02.
  [[nodiscard]] spec::Plane plane() const { return plane_; }
  void select_plane(spec::Plane plane);
  // Of X Y Z the two of the selected plane.
  [[nodiscard]] std::array<Count, 2> in_selected_plane(const std::array<Count, 3>& xyz) const {
    return {xyz[in_plane(plane_, 0)], xyz[in_plane(plane_, 1)]};
  }
  // The axes of the selected plane; spec::Axes::kNone: not there.
  [[nodiscard]] const std::array<std::size_t, 2>& plane_axis() const { return plane_axis_; }
  [[nodiscard]] std::array<std::size_t, 2> axes_of(spec::Plane plane) const {
    return {xyz_[in_plane(plane, 0)], xyz_[in_plane(plane, 1)]};
  }
  // The axis at right angles to it, or to another.
  [[nodiscard]] std::size_t normal_axis() const { return normal_axis(plane_); }
  [[nodiscard]] std::size_t normal_axis(spec::Plane plane) const;

  // G91.
  [[nodiscard]] bool incremental() const { return incremental_; }
  void set_incremental(bool incremental) { incremental_ = incremental; }

  // G43.5: I J K are the direction of the tool.
  [[nodiscard]] bool by_vector() const { return by_vector_; }
  void set_by_vector(bool by_vector) {
    by_vector_ = by_vector;
    arc_letters_ = by_vector ? Words::set_of("R") : kArcLetters;
  }

  [[nodiscard]] const std::optional<double>& feed() const { return feed_; }
  // A cutting move would have no F (clause fanuc.program.no-feed).
  [[nodiscard]] bool lacks_feed() const { return per_minute_ && (!feed_ || *feed_ == 0); }
  [[nodiscard]] bool feed_per_minute() const { return per_minute_; }
  // Under G93 and G95 F is no feed per minute: moves have none.
  void set_feed(double feed) {
    if (per_minute_) feed_ = feed;
  }
  void set_feed_mode(bool per_minute) {
    if (per_minute_ != per_minute) feed_.reset();
    per_minute_ = per_minute;
  }

 private:
  std::array<std::size_t, 3> xyz_;
  bool line_without_center_;
  Code motion_ = kG00;
  spec::Plane plane_ = spec::Plane::xy;
  std::array<std::size_t, 2> plane_axis_{};
  Mask plane_axes_ = 0;  // those of them that are there
  std::array<char, 2> plane_letter_{};
  bool incremental_ = false;
  bool by_vector_ = false;
  std::uint32_t arc_letters_ = kArcLetters;
  bool per_minute_ = true;
  std::optional<double> feed_;
};

}  // namespace toolcomp::fast
