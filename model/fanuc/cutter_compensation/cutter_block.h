// What a block says to cutter compensation B and C, and what it does in the plane.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/fanuc/program/cutter_offset.h"
#include "model/fanuc/program/stage.h"
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
struct CutterBlock final : StageWords {
  // The words.
  std::optional<CutterSide> code;        // the G40, G41 or G42 word
  CutterSide before = CutterSide::none;  // group 07 in force before the block
  CutterSide side = CutterSide::none;    // and at its end
  OneShot one_shot = OneShot::none;      // G39, G92 …
  bool number_given = false;             // a D word, or with OFH = 1 an H word
  std::uint32_t number_before = 0;       // offset number in force before the block
  std::uint32_t number = 0;              // and at its end
  Rational offset;                       // its signed value; 0 while `side` is none
  std::optional<PlanePoint> direction;   // I J (K I, J K) that are no arc's centre, an absent letter 0; of G39 also X Y
  bool direction_letters = false;        // it was given by I J K
  spec::Plane plane = spec::Plane::xy;   // in force at the end of the block
  bool plane_changed = false;            // against the block before
  bool lacks_axis = false;               // the machine has no axis of a letter of the plane
  std::array<bool, 2> word{};            // an axis word of the first, of the second axis of the plane
  bool axis_word = false;                // of whatever axis
  bool axis_word_outside = false;        // of an axis outside the plane
  bool arc_words = false;                // an arc by its words: G02 or G03 in force, no other code of group 00, and an
                                         // axis word of the plane or I J K or R
  std::optional<Rational> radius;        // of such an arc, where R gives it
  bool other_compensation = false;       // G41.3, G41.2 …
  bool tip_control = false;              // G43.4, G43.5
  bool changes_workpiece_system = false;  // G54–G59
  bool is_block = true;                   // any word, N and O included

  // The movement.
  PlaneMotion motion = PlaneMotion::none;
  PlanePoint start;
  std::vector<PlanePoint> ends;  // one for each of the step's moves
  PlanePoint end;                // of the block
  // The programmed position of every axis where the block starts, if the workpiece system changes in it.
  std::optional<Position> position;
  Direction tool;  // there
  // With PlaneMotion::arc: sweep and radii as programmed; full circle: start and end alike, sweep 360.
  std::optional<ArcGeometry> arc;
  spec::ArcDirection arc_direction = spec::ArcDirection::cw;

  [[nodiscard]] bool has_plane_word() const { return word[0] || word[1]; }
  // A word G41 or G42 equal to the code in force before it.
  [[nodiscard]] bool repeats_code() const { return code && *code != CutterSide::none && *code == before; }
};

}  // namespace toolcomp::model
