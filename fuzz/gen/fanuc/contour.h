// SPDX-License-Identifier: Apache-2.0
// Contours in a plane: lines and arcs that meet at corners of every kind.
#pragma once

#include <optional>
#include <vector>

#include "fuzz/gen/choices.h"

namespace toolcomp::fuzz {

// A point or a vector of a plane, in counts of the least increment.
struct PlaneCounts {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const PlaneCounts&, const PlaneCounts&) = default;
  friend PlaneCounts operator+(PlaneCounts a, PlaneCounts b) { return {a.x + b.x, a.y + b.y}; }
  friend PlaneCounts operator-(PlaneCounts a, PlaneCounts b) { return {a.x - b.x, a.y - b.y}; }
  friend PlaneCounts operator-(PlaneCounts a) { return {-a.x, -a.y}; }
  friend PlaneCounts operator*(std::int64_t k, PlaneCounts a) { return {k * a.x, k * a.y}; }
};

// The movement of one block in the plane.
struct Segment {
  enum class Kind : std::uint8_t { line, arc, radius_arc };
  Kind kind = Kind::line;
  bool clockwise = false;
  PlaneCounts travel;       // from start to end
  PlaneCounts to_center;    // arc: from start to centre
  std::int64_t radius = 0;  // radius_arc: the word R, negative for the larger arc
};

using Segments = std::vector<Segment>;

// Makes movements one after the other. Lines and arcs have mostly exact lengths, radii and tangents: directions on the
// lattice circle of radius 325, which has 60 points.
class Contour {
 public:
  // `one`: counts of a millimetre, inch or degree.
  Contour(Choices& choose, std::int64_t one) : choose_(choose), one_(one), direction_{one, 0} {}

  // The offset that compensates the contour: signed, + for left. Shapes are degenerate for it.
  void offset(std::int64_t counts) { offset_ = counts; }
  [[nodiscard]] std::int64_t offset() const { return offset_; }
  // Direction of the path at its end, any length but zero.
  [[nodiscard]] PlaneCounts direction() const { return direction_; }

  Segment line();
  Segment arc();
  // A line in about two of three cases.
  Segment movement();
  // Several movements: grooves, steps, tight arcs, tangent intersections, concentric arcs, whole circles.
  Segments shape();
  // A line and a corner of two vectors after it, before a line or an arc; the distance between them along the first and
  // the second axis, the larger of the two, is what the limit of parameter 5010 would have to be to drop one.
  struct OmissionCorner {
    Segments segments;
    std::int64_t distance = 0;
  };
  OmissionCorner omission_corner();

  // Any direction of rational length, of a length about `length`.
  PlaneCounts any_direction(std::int64_t length);
  // A length for a line or a radius: mostly beyond the offset, sometimes about it, seldom tiny or huge.
  std::int64_t length();
  // A multiple of the shortest vector along `v`, about `length` long.
  [[nodiscard]] PlaneCounts parallel(PlaneCounts v, std::int64_t length) const;
  // Goes on from a movement made elsewhere.
  void follow(const Segment& segment);

 private:
  [[nodiscard]] std::int64_t reach() const { return offset_ < 0 ? -offset_ : offset_; }
  [[nodiscard]] bool left() const { return offset_ >= 0; }
  // Adds to one of the two coordinates.
  void nudge(PlaneCounts& v, std::int64_t counts);
  PlaneCounts one_degree_back();
  PlaneCounts line_travel();
  PlaneCounts to_center(bool clockwise);
  PlaneCounts arc_end(PlaneCounts start);
  std::int64_t radius();
  Segment by_radius(const Segment& arc) const;
  Segment any_radius_arc();
  Segment huge_arc(PlaneCounts along, std::int64_t length);
  Segment line_along(PlaneCounts v);
  Segment arc_about(PlaneCounts to_center, PlaneCounts end, bool clockwise);
  PlaneCounts axis_direction();

  Segments groove();
  Segments step();
  Segments notch();
  Segments tight_arc();
  Segments tangent_line_arc();
  Segments tangent_arcs();
  Segments radial_arc();
  Segments concentric();
  Segments circle();
  Segments huge_arcs();

  Choices& choose_;
  std::int64_t one_;
  std::int64_t offset_ = 0;
  PlaneCounts direction_;
};

// A quarter turn to the left, and to the right.
constexpr PlaneCounts left_of(PlaneCounts v) { return {-v.y, v.x}; }
constexpr PlaneCounts right_of(PlaneCounts v) { return {v.y, -v.x}; }

}  // namespace toolcomp::fuzz
