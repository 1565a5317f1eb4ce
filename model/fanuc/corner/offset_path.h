// SPDX-License-Identifier: Apache-2.0
// The path of one block in the compensation plane, line or arc, as its two ends see it.
//
// Directions stay as long as the program makes them, so that everything decided by them is rational wherever the
// program is; a root appears where a coordinate is made. Nothing here knows where in the plane a block lies: an end is
// the origin, and the centre of an arc follows from its direction there.
#pragma once

#include <optional>

#include "model/basis/recorder.h"
#include "model/geometry/plane_vector.h"

namespace toolcomp::model {

// A direction in the plane, not normalised and not zero.
struct Heading {
  PlanePoint along;
  Real length2;
  Real length;
};
Heading heading(const PlanePoint& along);

// One end of a block: the direction of travel there, and for an arc the circle about its centre through that end,
// imaginary where the end lies off the arc. The centre lies at turn · left(along) from the end and |along| is the
// radius R.
struct PathEnd {
  Heading heading;
  int turn = 0;     // 0 a line, 1 an arc counter-clockwise, -1 clockwise
  Rational offset;  // signed distance of the tool to the left of the path at this end, setup units

  [[nodiscard]] bool is_arc() const { return turn != 0; }
  // From this end to the centre; arcs only.
  [[nodiscard]] PlanePoint to_center() const { return Real(turn) * left(heading.along); }
  // The radius R' = R - turn · offset of the offset circle, and its square; arcs only.
  [[nodiscard]] Real radius() const { return heading.length - Rational(turn * offset); }
  [[nodiscard]] Real radius2() const {
    return heading.length2 + (Rational(offset * offset) - Rational(2 * turn * offset) * heading.length);
  }
};

// A block of which at least the travel or the arc is not zero.
struct OffsetPath {
  PlanePoint travel;  // programmed, from start to end
  PathEnd start;
  PathEnd end;
  bool one_radius = true;  // arcs: programmed start and end radius are the same

  [[nodiscard]] bool is_arc() const { return start.is_arc(); }
};

// A straight block, with the offset in force at its start and at its end.
OffsetPath line_path(const PlanePoint& travel, const Rational& offset_at_start, const Rational& offset_at_end);

// An arc from `start` to `end`, both seen from the centre.
struct ArcEnds {
  PlanePoint start;
  PlanePoint end;
  int turn = 1;
  std::optional<Rational> radius;  // where R gives it: it stays rational where the centre is not
  bool one_radius = true;
};
OffsetPath arc_path(const ArcEnds& arc, const Rational& offset_at_start, const Rational& offset_at_end);
// One end of it; `from_center` is that end as seen from the centre.
PathEnd arc_end(const PlanePoint& from_center, int turn, const std::optional<Rational>& radius, const Rational& offset);

// The sign of the offset circle's radius R', decided under the clause; arcs only.
Sign decide_offset_radius(Recorder& recorder, Clause clause, const PathEnd& end);
// The same without a decision.
Sign offset_radius(const PathEnd& end);

}  // namespace toolcomp::model
