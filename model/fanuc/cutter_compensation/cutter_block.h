// SPDX-License-Identifier: Apache-2.0
// What a block says to cutter compensation B and C, and what it does in the plane.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/fanuc/corner/corner_block.h"
#include "model/geometry/arc.h"

namespace toolcomp::model {

// What a block does in the plane of cutter compensation.
enum class PlaneMotion : std::uint8_t {
  none,         // no axis word of the plane; G39
  zero_travel,  // an axis word of the plane, and no travel in it
  line,
  arc,                  // G02, G03; a full circle too
  machine_coordinates,  // G53, whatever axes it names
  reference,            // G28, G30, G30.1, whatever axes they name: two moves
  from_reference        // G29, whatever axes it names: two moves
};

// What a block says to cutter compensation B and C. Plane coordinates (first and second axis of the block's plane,
// setup units), tool offset G45–G48 included, before compensation.
struct CutterBlock : CornerBlock {
  // The words.
  OneShot one_shot = OneShot::none;     // G39, G92 …
  std::uint32_t number_before = 0;      // offset number in force before the block
  std::optional<PlanePoint> direction;  // I J (K I, J K) that are no arc's centre, an absent letter 0; of G39 also X Y
  bool direction_letters = false;       // it was given by I J K
  spec::Plane plane = spec::Plane::xy;  // in force at the end of the block
  bool lacks_axis = false;              // the machine has no axis of a letter of the plane
  std::array<bool, 2> word{};           // an axis word of the first, of the second axis of the plane
  bool axis_word = false;               // of whatever axis
  bool axis_word_outside = false;       // of an axis outside the plane
  bool tip_control = false;             // G43.4, G43.5

  // The movement.
  PlaneMotion motion = PlaneMotion::none;
  PlanePoint start;
  std::vector<PlanePoint> ends;  // one for each of the step's moves
  PlanePoint end;                // of the block
  // With PlaneMotion::arc: sweep and radii as programmed; full circle: start and end alike, sweep 360.
  std::optional<ArcGeometry> arc;
  spec::ArcDirection arc_direction = spec::ArcDirection::cw;

  [[nodiscard]] bool has_plane_word() const { return word[0] || word[1]; }
};

}  // namespace toolcomp::model
