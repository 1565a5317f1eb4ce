// One block on its way through the stages: where it goes and with what tool.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "model/basis/alarm.h"
#include "model/fanuc/program/codes.h"
#include "model/fanuc/program/offset_memory.h"
#include "model/geometry/arc.h"
#include "model/geometry/vector.h"
#include "model/kinematics/coordinate.h"
#include "model/kinematics/tool_direction.h"
#include "model/kinematics/tool_pose.h"
#include "spec/language/event.h"

namespace toolcomp::model {

// Where a move goes, before compensation; a stage of compensation may change type, cause and arc.
struct Leg {
  spec::MoveType type = spec::MoveType::linear;
  spec::Cause cause = spec::Cause::programmed;
  Position end;   // programmed, workpiece coordinates
  Vector travel;  // X Y Z, from where the block starts, tool offset included
  // Arcs: centre in actual coordinates (programmed + shift), sweep and radii of the tool's own arc.
  std::optional<spec::Arc<Real>> arc;
  // By axis, actual minus programmed position at the end: tool offset G45–G48, or where a measuring move stopped.
  std::optional<std::array<Rational, spec::kMaxAxes>> shift;

  // Where the tool is at the end, before compensation and length offset.
  [[nodiscard]] Coordinate actual(std::size_t axis) const {
    return shift ? end.at(axis) + Coordinate(shift->at(axis)) : end.at(axis);
  }
};

// A leg with everything that length offset, tool direction and compensation say about its end.
struct Move {
  Leg leg;
  Vector offset;                            // compensation vector at the end, X Y Z
  std::array<Real, spec::kMaxAxes> length;  // length offset, by axis
  Direction tool;                           // at the end
  std::optional<std::array<Real, spec::kMaxAxes>>
      zero;  // machine coordinate of the workpiece zero, where it is reported
  std::optional<Real> feed;
  std::optional<ToolPose> tip;              // under tool center point control, which then makes the axes of it
  std::shared_ptr<const OwnMotion> inside;  // of the own move of a block run under it
};

// What a block says to the leading edge offset.
enum class EdgeCommand : std::uint8_t { none, start, cancel };

// G40, G41, G42: where the tool runs, seen in the direction of travel.
enum class CutterSide : std::uint8_t { none, left, right };

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
struct CutterBlock {
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
  bool three_dimensional = false;        // all of I, J and K
  spec::Plane plane = spec::Plane::xy;   // in force at the end of the block
  bool plane_changed = false;            // against the block before
  bool lacks_axis = false;               // the machine has no axis of a letter of the plane
  std::array<bool, 2> word{};            // an axis word of the first, of the second axis of the plane
  bool axis_word = false;                // of whatever axis
  bool axis_word_outside = false;        // of an axis outside the plane
  bool arc_mode = false;                 // G02 or G03 in force
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

// What a block says to tool side compensation: its words.
struct ToolSideBlock {
  std::optional<CutterSide> code;        // the G40, G41.2, G42.2, G41.6 or G42.6 word
  CutterSide before = CutterSide::none;  // side in force before the block
  CutterSide side = CutterSide::none;    // and at its end
  bool number_given = false;             // a D word, or with OFH = 1 an H word
  std::uint32_t number = 0;              // offset number in force at its end
  Rational offset;                       // its signed value; 0 while `side` is none
  std::optional<int> treatment;          // Q: 1, 2 or 3; 0 where it is none of them
  std::optional<Rational> radius;        // of an arc, where R gives it
  bool wrong_mode = false;               // G41.2 under G43.5, or G41.6 without it
  bool other_compensation = false;       // G41, G42, G41.3
  bool plane_changed = false;            // against the block before
  bool leaves_the_path = false;          // a code of group 00
  bool changes_coordinates = false;      // G54–G59, G20, G21
  bool auxiliary = false;                // an M, S or T word
  bool stops_look_ahead = false;         // M00 M01 M02 M30
  bool moves = false;                    // an axis word, I J K under G43.5 included
  bool arc_mode = false;                 // G02 or G03 in force
  bool arc_words = false;                // an arc by its words
  bool is_block = true;                  // any word, N and O included

  // A word equal to the code in force before it.
  [[nodiscard]] bool repeats_code() const { return code && *code != CutterSide::none && *code == before; }
  // The compensation is on after the block.
  [[nodiscard]] bool wanted() const { return side != CutterSide::none && number != 0; }
};

// What a stage of compensation says before the moves of a block.
struct Warning {
  spec::Name number;
  const char* message = "";  // static text
  spec::ClauseList clauses;
};

// A block ready to be compensated.
struct Step {
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;
  // In order: none, one, or the two of a reference return or of a measurement. Behind a stage of compensation also the
  // moves it inserts.
  std::vector<Move> moves;
  // The place where the block ends, for a move inserted there; its type is that of group 01. Present where the leading
  // edge offset is on, and with `cutter` and `side`.
  Move rest;
  bool has_word = false;  // a word other than N and O
  bool travels = false;   // a linear movement, X Y Z
  bool stops_look_ahead = false;
  EdgeCommand edge = EdgeCommand::none;
  Rational radius;  // offset of the D number in force at the end of the block, where the leading edge offset is active
  std::optional<CutterBlock> cutter;  // from the first G41, G42 or G39 of a program on
  std::optional<ToolSideBlock> side;  // from its first G41.2, G42.2, G41.6 or G42.6 on
  std::optional<Warning> warning;
  std::optional<OffsetSetting> setting;  // written at the end of the block
  std::optional<Alarm> alarm;            // that shows by its motion, once its moves are made
  spec::ClauseList clauses;
};

}  // namespace toolcomp::model
