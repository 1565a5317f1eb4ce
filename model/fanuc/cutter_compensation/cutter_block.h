// SPDX-License-Identifier: Apache-2.0
// What a block says to cutter compensation B and C, and what it does in the plane.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "model/fanuc/corner/corner_block.h"

namespace toolcomp::model {

// What a block does in the plane of cutter compensation.
enum class PlaneMotion : std::uint8_t {
  none,         // no axis word of the plane; G39
  zero_travel,  // an axis word of the plane, and no travel in it
  line,
  arc,        // G02, G03; a full circle too
  reference,  // G28, G30, G30.1, whatever axes they name: two moves
  machine     // G53, and G29 with its two moves, whatever axes they name
};
constexpr bool is_machine_move(PlaneMotion motion) { return motion >= PlaneMotion::reference; }

// What a block says to cutter compensation B and C. Plane coordinates (first and second axis of the block's plane,
// setup units), tool offset G45–G48 included, before compensation.
struct CutterBlock : CornerBlock {
  // The words.
  OneShot one_shot = OneShot::none;     // G39, G92 …
  std::optional<PlanePoint> direction;  // I J (K I, J K) that are no arc's centre, an absent letter 0; of G39 also X Y
  bool direction_letters = false;       // it was given by I J K
  spec::Plane plane = spec::Plane::xy;  // in force at the end of the block
  std::array<bool, 2> word{};           // an axis word of the first, of the second axis of the plane
  bool axis_word = false;               // of whatever axis

  // The movement.
  PlaneMotion motion = PlaneMotion::none;
  PlanePoint start;
  PlanePoint first_end;        // of the first of the step's moves
  PlanePoint end;              // of the block
  std::optional<ArcEnds> arc;  // with PlaneMotion::arc

  [[nodiscard]] bool has_plane_word() const { return word[0] || word[1]; }
};

}  // namespace toolcomp::model
