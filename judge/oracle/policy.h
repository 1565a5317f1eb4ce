// SPDX-License-Identifier: Apache-2.0
// The only policy table: how far a value may be from the exact one, and when a decision counts as a near tie.
//
//   output                                        rule
//   kinds and order of events, lines, n, types,   equal exactly
//   causes, planes, directions, alarm numbers,
//   names of settings, which axes are present
//   linear coordinates, centres, radii            inside the enclosure widened by
//                                                 k · (ulp(scale) + condition · ulp(|compensation vector|))
//   … where two conditions place the head         each coordinate so with the condition of the rest; or the head within
//   k · (offset lines and circles that cross at       their own error of both conditions and of their plane, and within
//   a small angle; head.h)                        the width above
//   rotary axes                                   … by k · ulp(value) (machine: value or axes, the larger); under tool
//                                                 center point control k · (ulp(value) + ulp(1) in degrees); or where
//                                                 they fit (pose_fit.h), and then what follows is judged from there
//   tool axis                                     … by k · (error of a direction: ulp(1), leant or inside a block more,
//                                                 pose_error.h)
//   … of 3D compensation (Heidenhain)             … and k · its error (space_scale.h); normals by k · ulp(1), contact
//                                                 angles by k · ulp(180); flat, reason and permitted equal
//   centre of an arc by R                         … and by k · (error of its height over the chord, height_error), and
//                                                 what is made of it: sweep, radii and samples of the arc, directions
//                                                 of its ends with the vectors made of them
//   samples: t                                    equal exactly
//   sweeps                                        … by k · (ulp(360) + error of each end of a compensated arc over
//                                                 its distance from the centre, in degrees); neither value nor
//                                                 presence where that is 90 degrees or more: a head so near the centre
//                                                 has no direction in double
//   whether an arc has two radii                  not judged where they differ by less than either may be off
//   feeds, values of settings                     … by nothing: one of the two doubles that enclose the exact value; a
//                                                 controller's text by 1.5 · ulp(value) where the value is no double:
//                                                 the shortest text of one of the two
//   any number of a controller of resolution r    … by r more, so that truncating, rounding up and to nearest all pass;
//   (of mm, inches, degrees, unit vectors)        where it says how it rounds, by r/2, or r on the side it rounds to
//   a decision by sign                            as the exact sign; the other outcomes are permitted where
//                                                 |quantity| <= band · scale and the model yields finite vectors for
//                                                 them
//   … of rotary positions                         … |quantity| <= band · scale · the larger error of the positions, at
//                                                 most kWidestBand; or what the controller's own lie off
//   … whose quantity is a square                  … |quantity| <= band² · scale
//   … where a clause compares sums of decimals    an exact tie goes as the clause says: no outcome but that one
//   (kExactComparisons)                           (numbers finer than a controller's resolution excepted)
//
// No other tolerance exists in the repository.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "spec/clauses/clauses.h"

namespace toolcomp::judge::policy {

// From what a section's compensation vectors are made, which decides the condition numbers that widen them
// (condition.h).
enum class VectorFrom : std::uint8_t {
  none,          // there are no vectors
  corner,        // two paths of the plane (corner.h)
  tool_corner,   // two paths in the plane across the tool (tool_plane.h)
  tool_and_way,  // tool and movement
};

// Multiples of an ulp granted to a section's outputs. Each is the number of roundings of a straightforward evaluation
// in double precision, not a fit to one engine. Every campaign prints the worst value seen, which is far below.
//
// For some formulas this number is proved, for the way in which the fast engine computes them: by scripts of
// spec/formal/rounding, whose bounds, divided by u = 2^-53 times the argument of ulp() here, are below the k of the row
// (ulp(x) > u |x|). A row keeps the counted width: it is granted to every controller, which may multiply and add in
// another order, and it covers formulas without a script. The comment of a row names these.
struct Budget {
  std::string_view section;
  double coordinate;  // sums of programmed position, vector, length offset and workpiece origin
  double rotary;      // sums of programmed positions; positions out of inverse kinematics
  double tool_axis;   // two rotations and a normalisation
  double sweep;       // a difference of two arc tangents in degrees
  VectorFrom vectors = VectorFrom::none;
  const char* proved = "";  // scripts of spec/formal/rounding, separated by blanks
};
inline constexpr Budget kBudgets[] = {
    {"fanuc/tool-length-offset", 8, 8, 16, 16},
    // Sums of decimals, like the length offset.
    {"fanuc/tool-length-measurement", 8, 8, 16, 16},
    {"fanuc/tool-offset", 8, 8, 16, 16},
    // Sums of decimals. Contours between the cycles are cutter compensation, and have its row.
    {"fanuc/canned-cycle", 32, 32, 16, 32, VectorFrom::corner, "corner_ahead corner_back"},
    // A normalised normal times the offset (two squares, sum, root, quotient, product), the programmed position and the
    // length offset; the end of an arc twice that, for its sweep. Proved: the vector of straight blocks and of
    // G39, 7.1. Not proved: that of arcs, and their sweep.
    {"fanuc/cutter-compensation-b", 16, 16, 16, 16, VectorFrom::corner, "perpendicular"},
    // Two such normals, their product, sum and quotient; with arcs the distance of the centre, two squares, a root, the
    // same again for a second circle: 28 roundings in the longest chain. Proved: the intersection of two lines, 14 and
    // 16, without a condition. Not proved: arcs, prolonged vectors, changes of the side.
    {"fanuc/cutter-compensation-c", 32, 32, 16, 32, VectorFrom::corner, "corner_ahead corner_back"},
    // The tool direction (two turns of three products each, and their sines), its product with the movement, a norm;
    // the same again for the second block, their product, sum and quotient; with arcs as cutter compensation C, in the
    // projection. The condition of a corner (tool_plane.h) counts one unit of error a direction. Proved: the tool
    // direction, in ulp(1) 6.6 of axes along X Y Z, 12 of nutating ones, 1.8 of words; the vector at right angles to a
    // line, 10.3 with a direction by words, 34.1 by axes along X Y Z. Not proved: other vectors, other machines, and
    // nearer to the tool than 30 degrees.
    {"fanuc/tool-side-compensation", 40, 64, 16, 40, VectorFrom::tool_corner,
     "direction_one_term direction_nutating direction_by_words SideNormal"},
    // Two cross products with the tool direction, a norm, a quotient and a product. Proved: the direction, as above;
    // the vector, with a direction by words, 12.7. Not proved: with a direction by rotary axes (the bound is 58), and
    // nearer to the tool than 30 degrees.
    {"fanuc/leading-edge-offset", 16, 64, 16, 16, VectorFrom::tool_and_way,
     "direction_one_term direction_nutating direction_by_words LeadingEdge"},
    // A direction of three words (squares, sum, root, quotient: 6), seen from the table (two turns of three products
    // and sums each with their sines and cosines: 14), its height and the root beside it (8), arc cosine or tangent and
    // sum (4), the tilted direction for the azimuth (7), a cross and a scalar product (8), arc tangent, difference and
    // whole turns (4): 51, and in degrees. X Y Z: the turns of both axes with these angles, length and offsets (32),
    // and the table turned there and back. Proved: the direction by the rotary axes, as above. Not proved: the inverse,
    // and the points.
    {"fanuc/tool-center-point-control", 64, 64, 32, 64, VectorFrom::none, "direction_one_term direction_nutating"},
    // The angle of both directions (squares, products, root, arc tangent: 14), two sines over a third (6), two products
    // and a sum before that. With tool side compensation its 40 for the point are added.
    {"fanuc/tool-posture-control", 80, 80, 40, 64},
    // Two vectors of three words (squares, sum, root, quotient: 7 each), their double product (14) and its norm (5), a
    // radius out of deltas and a table (6), four terms: 46. Proved: axes 20.3, contact 42.5, tool axis in ulp(1) 1.4 of
    // words and 7.5 of rotary words. Not proved: words of more than 8 decimals or not normalized, tables of deviations,
    // deltas above a quarter of the largest length, the carrier.
    {"heidenhain/face-milling", 48, 8, 16, 16, VectorFrom::none, "face_points unit_by_series direction_spatial"},
    // A tool direction of up to three turns (9 products and sums with their sines), a cross product and its norm (8),
    // the same for the next block, their product, sum and quotient (10), tip, deltas and length (8). Proved: the tool
    // axis, as above. Not proved: the mitre, and the points.
    {"heidenhain/peripheral-milling", 48, 8, 24, 16, VectorFrom::none, "unit_by_series direction_spatial"},
    {"heidenhain/programmed-contour", 48, 8, 24, 16, VectorFrom::none, "unit_by_series direction_spatial"},
};
// For a program that belongs to no section: the widest row.
inline constexpr Budget kAnySection = {"", 80, 80, 40, 64};

constexpr const Budget& budget(std::string_view section) {
  for (const Budget& row : kBudgets)
    if (row.section == section) return row;
  return kAnySection;
}

// Micrometres. A value that is granted more than this in addition to the announced resolution (or more than the
// resolution, if that is larger) was not judged. An angle, or a component of a unit vector, counts as its effect at a
// distance of one metre. Such values are counted separately, and if their share is larger than this one, the verdict is
// not simply "conforms".
inline constexpr double kCap = 1;
inline constexpr double kMostWide = 0.01;
inline constexpr double kMicrometresAtOneMetre = 1e6;  // of a radian

// Two numbers whose difference is below this share of the larger one, or of 1, count as equal in the search for a
// mistake that explains a finding (certify/causes/shared_cause.h). No verdict rests on it.
inline constexpr double kSameForCause = 1e-10;

// Setup units, without k. If more than this would be granted to the head of a vector that two conditions place, it is
// judged by these conditions (head.h).
inline constexpr double kByConditions = 0x1p-34;

// Degrees: a sweep with an error of this size is not judged.
inline constexpr double kUnknownSweep = 90;

// The shortest decimal text of a double is at most half an ulp away from the double, and the double is at most one ulp
// away from the exact value.
inline constexpr double kConvertedText = 1.5;

// Relative half width of a near tie for an engine in double precision. Decisions are signs of polynomials of degree
// four or less, of fewer than 32 terms, in inputs that carry a few roundings each (decimals, sines and cosines). Their
// error is below 32 · 4 · 4 roundings of 2^-53 of the scale, 2^-44; 2^-40 leaves a factor of 16 for less careful
// orders.
inline constexpr double kDoubleBand = 0x1p-40;

// The same for a controller that computes with lengths of resolution r (setup units) and angles of resolution a
// degrees: the direction of the shortest move next to the decision is known to 2·r/length, a tool direction to
// a·pi/180, and a predicate of degree four multiplies either by four.
inline double controller_band(double resolution, double degrees, double shortest_move) {
  constexpr double radians_per_degree = 0.017453292519943295;
  const double direction = shortest_move > 0 ? 2 * resolution / shortest_move : 1;
  return std::fmin(1.0, kDoubleBand + 4 * (direction + degrees * radians_per_degree));
}

// For the same, in lines: a move counts as next to a decision if it is at most this number of lines away.
inline constexpr std::uint64_t kNeighbourhood = 4;

// Clauses whose two sides are sums of decimals of the program and the setup, without product, root or trigonometry. A
// control compares them in whole numbers of its least increment, so nothing is rounded, and an exact tie is not a near
// tie: the manual says whether the ends of a zone belong to it. Three exceptions: lengths that no decimal writes
// (millimetres given in a setup in inches), angles at which a table of deviations is read, and a controller that
// announces a resolution: the numbers of a case may be finer than it, and are rounded before they are compared.
struct ExactComparison {
  spec::Clause clause;
  bool only_at_scale_one = false;  // at any other scale the clause compares angles, which are not exact
};
inline constexpr ExactComparison kExactComparisons[] = {
    // Coordinate commanded, start, signal, offsets in force, and the lengths of 6251 and 6254.
    {spec::Clause::fanuc_length_measurement_rapid_part},
    {spec::Clause::fanuc_length_measurement_signal_from_the_start},
    {spec::Clause::fanuc_length_measurement_too_early},
    {spec::Clause::fanuc_length_measurement_too_late},
    // I, J or K and once or twice the value of D.
    {spec::Clause::fanuc_tool_offset_arc_radius},
    // Radii of the tool table and sums of deltas; the sign of the corner radius inside a segment of a table of
    // deviations is that of an angle.
    {spec::Clause::heidenhain_tool_table_radius},
    {spec::Clause::heidenhain_tool_table_corner_radius},
    {spec::Clause::heidenhain_tool_table_shape},
    {spec::Clause::heidenhain_tool_effective_radius},
    {spec::Clause::heidenhain_tool_effective_corner_radius, true},
    {spec::Clause::heidenhain_tool_oversize_radius},
    {spec::Clause::heidenhain_tool_oversize_corner},
    {spec::Clause::heidenhain_tool_corner_beyond_radius},
    {spec::Clause::heidenhain_tool_effective_flat},
    {spec::Clause::heidenhain_tool_ring_change},
};

constexpr bool compares_exactly(spec::Clause clause, bool scale_is_one) {
  const auto* const row = std::ranges::find(kExactComparisons, clause, &ExactComparison::clause);
  return row != std::end(kExactComparisons) && (scale_is_one || !row->only_at_scale_one);
}

// An undecided event leaves a case open if it names an open clause: an engine must report this too, and of a controller
// the events after it are not judged. There are two exceptions. Open clauses of these sections define what happens, so
// that an undecided event is a decision that was not certified, and gives no verdict.
inline constexpr std::string_view kDefinedWhereOpen[] = {"fanuc/tool-center-point-control",
                                                         "fanuc/tool-posture-control"};

// An open clause that is decided by sign is named if its tie was not certified. For these clauses the tie itself is
// open: an arc seen on edge.
inline constexpr spec::Clause kOpenTies[] = {spec::Clause::fanuc_tool_side_arc_plane};

inline bool leaves_open(spec::Clause clause) {
  const spec::ClauseInfo& info = spec::info(clause);
  if (info.kind != spec::ClauseKind::open) return false;
  if (std::ranges::find(kDefinedWhereOpen, info.section) != std::end(kDefinedWhereOpen)) return false;
  return info.outcomes != spec::ClauseOutcomes::sign || std::ranges::find(kOpenTies, clause) != std::end(kOpenTies);
}

// Clauses whose quantity is the square of a distance or of a sine. If that is off by a share of the scale, the quantity
// is off by the square of this share.
inline constexpr spec::Clause kSquares[] = {
    spec::Clause::fanuc_tool_center_point_lean_along_the_travel,
    spec::Clause::fanuc_tool_center_point_parallel_to_the_work_side,
    spec::Clause::fanuc_tool_posture_no_plane,
    spec::Clause::fanuc_tool_posture_at_start,
    spec::Clause::fanuc_tool_posture_at_end,
    spec::Clause::heidenhain_face_along_the_tool,
    spec::Clause::heidenhain_peripheral_direction,
};

constexpr bool is_square(spec::Clause clause) {
  return std::find(std::begin(kSquares), std::end(kSquares), clause) != std::end(kSquares);
}

// Clauses that compare rotary positions. Positions from inverse kinematics are off by more than an ulp near singular
// postures and edges of reach.
inline constexpr spec::Clause kPositions[] = {
    spec::Clause::fanuc_tool_center_point_choice_first_move,
    spec::Clause::fanuc_tool_center_point_choice_second_move,
    spec::Clause::fanuc_tool_center_point_choice_first_near_zero,
    spec::Clause::fanuc_tool_center_point_choice_second_near_zero,
    spec::Clause::fanuc_tool_center_point_range,
    spec::Clause::fanuc_tool_posture_pre_turn,
    spec::Clause::fanuc_tool_posture_post_turn,
    spec::Clause::fanuc_tool_posture_branch,
    spec::Clause::fanuc_tool_posture_veto,
};

constexpr bool compares_positions(spec::Clause clause) {
  return std::find(std::begin(kPositions), std::end(kPositions), clause) != std::end(kPositions);
}

// The error of the centre of an arc by R, in addition to that of its position and without k: an error of its height h
// above the chord,
//
//   h = √(R² - c²), c half the chord.
//
// R and the ends of the chord that carry a unit u each, and the squares rounded, leave k roundings of 2·R·u in h²:
// E = k · 2·R·u at most. With h'² = h² ± E, |h' - h| = E / (h' + h). Well above the chord that is k · R/h · u: the
// condition is R/h. It grows as the centre comes nearer the chord, but not without limit: h' is no less than 0, so
// h' + h is no less than √E from h = √E down, and h is off by √E at most, the square root of what R² is rounded by.
//
// In the half circle itself, h = 0, the radicand may come out as ±E as well: negative it is no arc, or a half circle
// (the decision is a near tie), positive it leaves the centre √E away from the chord. Numbers that are exact doubles
// give it exactly.
inline double height_error(double radius, double height, double unit, double k) {
  const double e = k * 2 * radius * unit;
  const double least = std::sqrt(std::fmax(0.0, height * height - e));
  return e / std::fmax(std::sqrt(e), height + least) / k;
}

// The clauses of an event by which the oracle sees how its block was run.
inline constexpr spec::Clause kByRadius = spec::Clause::fanuc_program_arc_radius;
inline constexpr spec::Clause kHasASide = spec::Clause::fanuc_cutter_side;
inline constexpr spec::Clause kLeant = spec::Clause::fanuc_tool_center_point_lean;
inline constexpr spec::Clause kOnAGreatCircle = spec::Clause::fanuc_tool_posture_great_circle;
inline constexpr spec::Clause kBeginsTipControl = spec::Clause::fanuc_tool_center_point_block;

// Radians: decisions on rotary positions take the controller's own positions into account if these are off by at least
// this much.
inline constexpr double kDeviation = 1e-9;

// No decision is a near tie for its position alone beyond this band.
inline constexpr double kWidestBand = 0x1p-12;

// The oracle estimates condition numbers in double. Its estimates are widened by this share, which is far above their
// rounding.
inline constexpr double kSlack = 0x1p-30;

// A value with an available enclosure of this width, relative to its size, is known well enough for such estimates:
// some ulps.
inline constexpr double kWellKnown = 0x1p-47;

// The size of an estimate in double of a value that is exactly zero, relative to its terms: a few roundings.
inline constexpr double kEstimateNoise = 0x1p-44;

// Below this sine a tool is along the work-side axis, by the exact positions of an event (its middle, 2^-100 wide).
inline constexpr double kExactlyParallel = 0x1p-90;

// A step counts as a whole number of increments if it differs from that by at most this share of one increment.
inline constexpr double kWholeStep = 1e-6;

// Radians: two directions that are closer than this to being parallel or opposite span a plane that doubles hardly
// determine.
inline constexpr double kHardly = 1e-7;

// Below this sine two paths count as parallel in an estimate: their crossing is outside the range of any control.
inline constexpr double kParallel = 0x1p-46;

// As a share of a radius, and in degrees: an arc that starts farther than this from the head before it does not start
// at that head (arc_fit.h).
inline constexpr double kSameStart = 1e-6;

// A compensation vector smaller than this share of the noise of its two ends does not count as a vector.
inline constexpr double kNoVector = 0x1p-16;

// Limits before a verdict on a case is "could not decide": the number of combinations of forced outcomes that are
// followed because they explain something new (judge.cpp; a wrong value between two near singular postures needs 117),
// and the number of events of the model's runs for all of them. Up to this limit a program of 350 events is run 60
// times, in two seconds, and a program of ten events 2,000 times.
inline constexpr std::size_t kMaxForks = 256;
inline constexpr std::size_t kMaxForkedEvents = 20'000;
// After an event that is left out: the number of events of the other side that are searched for the next event of the
// model.
inline constexpr std::size_t kMostSought = 64;
// The largest number of passes over a streamed program.
inline constexpr std::size_t kMaxPasses = 64;

// The distance of neighbouring doubles at |x|; of the smallest normal number at 0.
inline double ulp(double x) {
  constexpr double smallest = 0x1p-1022;
  return std::ldexp(1.0, std::ilogb(std::fmax(std::fabs(x), smallest)) - 52);
}

}  // namespace toolcomp::judge::policy
