// SPDX-License-Identifier: Apache-2.0
// A corner of tool side compensation and the vectors at it (clauses fanuc.tool-side).
#pragma once

#include <array>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/fanuc/tool_side_compensation/tool_plane.h"
#include "fast/geometry/corner.h"
#include "fast/geometry/path.h"
#include "spec/language/event.h"

namespace toolcomp::fast {

// One block that moves: a line, or an arc in the selected plane.
struct SidePath {
  Travel travel;
  bool arc = false;
  // Arcs only.
  PlanePath flat;                   // in the selected plane, as programmed
  std::array<std::size_t, 2> in{};  // its axes (0 X, 1 Y, 2 Z)
  std::size_t normal = 2;           // and the third one
  const Direction* tool = nullptr;  // at the end of the block
  SeenTravel seen;                  // by that tool, of a line
  int side = 1;                     // +1: the tool is left of the path
  Amount offset;
  std::uint32_t offset_change = 0;  // which change of the value it is from
  [[nodiscard]] bool is_arc() const { return arc; }
};

// Two blocks and the plane they are seen in; `second` is nullptr at the end of a path without a next block.
struct SideCorner {
  const SidePath* first = nullptr;
  const SidePath* second = nullptr;
  const Direction* tool = nullptr;
  int first_side = 1;
  int second_side = 1;
  const Amount* offset = nullptr;  // r
  SpaceTurn turn;                  // of lines
  // With an arc: the corner in plane coordinates, where `across` and `up` span the plane, `up` to the left of `across`
  // seen from the tool.
  bool flat = false;
  // The tool stands along the normal of the arc's plane: `across` and `up` are its axes. Where the tool looks on it
  // from behind (facing -1) left and right are exchanged.
  bool aligned = false;
  int facing = 1;
  std::array<PlanePath, 2> path;   // of lines, and of arcs not aligned
  std::array<Heading, 2> heading;  // not aligned
  Corner plane;
  Vector3<double> across;
  Vector3<double> up;
};

class SideGeometry {
 public:
  explicit SideGeometry(const Kinematics& kinematics) : kinematics_(kinematics) {}

  // Sets the turn of a corner whose blocks, tool and sides are set. False where an arc of it has the tool in its plane.
  [[nodiscard]] bool set_turn(SideCorner& corner) const;
  // The signs of sine and cosine of the turn, counted to the left seen from the tool.
  static int cross(const SideCorner& corner) {
    return corner.flat ? corner.facing * sign_of(corner.plane.turn.c) : corner.turn.cross;
  }
  static int along(const SideCorner& corner) { return corner.flat ? sign_of(corner.plane.turn.k) : corner.turn.dot; }

  // The vector, from the corner, setup units; with an arc, of kinds other than paths_meet and paths_cross.
  void set_vector(const SideCorner& corner, HeadKind kind, Vector3<double>& vector) const;
  // The vector of those kinds, with an arc; false where the offset paths have no common point.
  static bool paths_meet(const SideCorner& corner, HeadKind kind, Vector3<double>& vector);
  // The same to about 90 bits, of any kind.
  [[nodiscard]] Vector3<DoubleDouble> fine_vector(const SideCorner& corner, HeadKind kind) const;

  // A sign of (radius of the offset circle of an arc at one end) in the plane of `tool`; 1 for a line.
  [[nodiscard]] int offset_radius_sign(const SidePath& path, bool at_end, const Direction& tool, int side,
                                       const Amount& offset) const;
  // Of two lines: whether an acute corner is under 1 degree.
  [[nodiscard]] bool is_under_one_degree(const SideCorner& corner) const;
  [[nodiscard]] ToolPlane plane(const Direction& tool) const { return {kinematics_, tool}; }
  [[nodiscard]] const Kinematics& kinematics() const { return kinematics_; }

 private:
  // One block at a corner, in the plane of the tool there: unit tangent, its left normal, and the radius of an arc.
  struct FineLeg {
    Vector3<DoubleDouble> ahead;
    Vector3<DoubleDouble> left;
    DoubleDouble radius;
    int sigma = 0;  // of an arc, seen from the tool
  };
  [[nodiscard]] FineLeg fine_leg(const SidePath& path, bool at_end, const ToolPlane& plane) const;
  static void set_turn_of_lines(SideCorner& corner, const ToolPlane& plane);
  static void set_aligned(SideCorner& corner, const SidePath& arc);
  void set_tilted(SideCorner& corner, const ToolPlane& plane) const;

  const Kinematics& kinematics_;
};

}  // namespace toolcomp::fast
