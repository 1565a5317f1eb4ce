// SPDX-License-Identifier: Apache-2.0
// The matcher against a second computation: the whole free-space diagram, cell by cell, written from the definition of
// the Fréchet distance (H. Alt, M. Godau: Computing the Fréchet distance between two polygonal curves, 1995). And
// recordings made from a path, honest ones and spoiled ones, whose findings are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "certify/trace/matcher.h"
#include "certify/trace/time_steps.h"
#include "tests/effort.h"

namespace toolcomp::certify {
namespace {

using Real = long double;
// X, Y and C, of a setup with axes XYC.
using Point = std::array<double, 3>;
using Line = std::vector<Point>;
using Random = std::mt19937_64;

// Each test has numbers of its own, the same in every run.
Random numbers_of(std::uint64_t test) { return Random(test); }

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
std::size_t below(Random& random, std::size_t n) {
  return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
}

// --- The definition -------------------------------------------------------------------------------------------------

struct Interval {
  Real low = 1;
  Real high = 0;
  [[nodiscard]] bool empty() const { return !(low <= high); }
};

// Where the line from a to b is within both tolerances of p.
Interval free_interval(const Point& a, const Point& b, const Point& p, Real linear, Real rotary) {
  const auto square_equation = [](Real second, Real first, Real constant) -> Interval {
    // second·t² + first·t + constant ≤ 0
    if (second == 0) return constant <= 0 ? Interval{0, 1} : Interval{};
    const Real discriminant = first * first - 4 * second * constant;
    if (discriminant < 0) return {};
    const Real root = std::sqrt(discriminant);
    return {(-first - root) / (2 * second), (-first + root) / (2 * second)};
  };
  Real second = 0;
  Real first = 0;
  Real constant = -linear * linear;
  for (const std::size_t axis : {0U, 1U}) {
    const Real d = Real(b[axis]) - a[axis];
    const Real from = Real(a[axis]) - p[axis];
    second += d * d;
    first += 2 * d * from;
    constant += from * from;
  }
  const Interval xy = square_equation(second, first, constant);
  const Real turn = Real(b[2]) - a[2];
  const Real off = Real(a[2]) - p[2];
  const Interval c = square_equation(turn * turn, 2 * turn * off, off * off - rotary * rotary);
  return {std::max({Real(0), xy.low, c.low}), std::min({Real(1), xy.high, c.high})};
}

// Whether p is within both tolerances of the box from a to b.
bool in_box(const Point& a, const Point& b, const Point& p, Real linear, Real rotary) {
  const auto off = [&](std::size_t axis) {
    const Real low = std::min(a[axis], b[axis]);
    const Real high = std::max(a[axis], b[axis]);
    return p[axis] < low ? low - p[axis] : p[axis] > high ? p[axis] - high : 0;
  };
  return off(0) * off(0) + off(1) * off(1) <= linear * linear && off(2) <= rotary;
}

// Whether the recording is within the tolerances of the path. It may begin anywhere on the first `first_pieces` of it.
// On the pieces in `free` each axis may be anywhere between both ends.
bool within(const Line& path, const Line& recording, std::size_t first_pieces, Real linear, Real rotary,
            const std::vector<bool>& free = {}) {
  const std::size_t n = recording.size();
  const std::size_t m = path.size() - 1;
  // left[i][k]: reached on piece k at sample i; bottom[i][k]: reached at vertex k on the line from sample i to i + 1.
  std::vector<std::vector<Interval>> left(n, std::vector<Interval>(m));
  std::vector<std::vector<Interval>> bottom(n, std::vector<Interval>(m + 1));
  const auto on_path = [&](std::size_t k, std::size_t i) -> Interval {
    if (free.empty() || !free[k]) return free_interval(path[k], path[k + 1], recording[i], linear, rotary);
    if (!in_box(path[k], path[k + 1], recording[i], linear, rotary)) return {};
    // Anywhere inside, or at its end.
    return {0, free_interval(path[k + 1], path[k + 1], recording[i], linear, rotary).empty() ? 0.5L : 1};
  };
  for (std::size_t k = 0; k < m; ++k) {
    const Interval f = on_path(k, 0);
    const bool on = k > 0 && !left[0][k - 1].empty() && left[0][k - 1].high >= 1 && !f.empty() && f.low <= 0;
    if (k < first_pieces || on) left[0][k] = f;
  }
  for (std::size_t i = 0; i + 1 < n; ++i)
    for (std::size_t k = 0; k < m; ++k) {
      const Interval& l = left[i][k];
      const Interval& b = bottom[i][k];
      if (l.empty() && b.empty()) continue;
      Interval right = on_path(k, i + 1);
      if (b.empty() && (free.empty() || !free[k])) right.low = std::max(right.low, l.low);
      left[i + 1][k] = right;
      Interval top = free_interval(recording[i], recording[i + 1], path[k + 1], linear, rotary);
      if (l.empty()) top.low = std::max(top.low, b.low);
      bottom[i][k + 1] = top;
    }
  return !left[n - 1][m - 1].empty() && left[n - 1][m - 1].high >= 1;
}

// --- Paths and recordings -------------------------------------------------------------------------------------------

class Pieces : public PathSource {
 public:
  std::vector<PathPiece> pieces;
  bool next(PathPiece& piece) override {
    if (next_ == pieces.size()) return false;
    piece = pieces[next_++];
    return true;
  }

 private:
  std::size_t next_ = 0;
};

AxisPoint axes(const Point& p) {
  AxisPoint out{};
  std::copy(p.begin(), p.end(), out.begin());
  return out;
}

// Every piece is a move; the first has line 1.
Pieces straight(const Line& path) {
  Pieces pieces;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    PathPiece piece;
    piece.begin = axes(path[k]);
    piece.end = axes(path[k + 1]);
    piece.line = k + 1;
    pieces.pieces.push_back(piece);
  }
  return pieces;
}

TraceResult match(Pieces path, const Line& recording, double linear, double rotary) {
  const spec::Axes letters("XYC");
  const Metric metric({{0, 1}, {2}}, {linear, rotary});
  TraceResult result;
  Findings findings(result, 100);
  Matcher matcher(path, metric, letters, result, findings);
  std::uint64_t line = 2;
  for (const Point& p : recording) matcher.take(axes(p), line++);
  matcher.end();
  findings.sort();
  return result;
}

std::string words(const Line& line) {
  std::string out;
  for (const Point& p : line)
    out += "(" + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + ") ";
  return out;
}

std::string words(const TraceResult& r) {
  std::string out;
  for (const TraceFinding& f : r.findings)
    out += f.kind + " sample " + std::to_string(f.sample) + " (" + std::to_string(f.samples) + ") line " +
           std::to_string(f.line) + "-" + std::to_string(f.last_line) + " by " + std::to_string(f.distance.lower) +
           ".." + std::to_string(f.distance.upper) + "\n";
  return out;
}

// Corners on a small grid: reversals on one line, crossings, corners met twice.
Line grid_path(Random& random, bool turns) {
  Line path{{0, 0, 0}};
  for (std::size_t moves = 1 + below(random, 7); path.size() <= moves;) {
    Point next = path.back();
    next[below(random, 2)] = static_cast<double>(below(random, 4));
    if (below(random, 3) == 0) next[0] = static_cast<double>(below(random, 4));
    if (turns && below(random, 2) == 0) next[2] = 10 * static_cast<double>(below(random, 4));
    if (next != path.back()) path.push_back(next);
  }
  return path;
}

Point between(const Point& a, const Point& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

// Samples along the path, some of them with noise around the tolerance, some doubled, left out or exchanged.
Line grid_recording(Random& random, const Line& path, double linear, double rotary) {
  Line recording;
  const double noise = uniform(random, 0, 1.1);
  const std::size_t spoil = below(random, 12);
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    if (spoil == 0 && below(random, 4) == 0) continue;
    const std::size_t steps = 1 + below(random, 4);
    for (std::size_t i = k == 0 ? 0 : 1; i <= steps; ++i) {
      Point p = between(path[k], path[k + 1], static_cast<double>(i) / static_cast<double>(steps));
      const double angle = uniform(random, 0, 2 * std::numbers::pi);
      // At the tolerance itself now and then.
      const double radius = linear * noise * (below(random, 3) == 0 ? 1 : uniform(random, 0, 1));
      p[0] += radius * std::cos(angle);
      p[1] += radius * std::sin(angle);
      p[2] += rotary * noise * uniform(random, -1, 1);
      recording.push_back(p);
      if (below(random, 6) == 0) recording.push_back(p);
    }
  }
  if (recording.empty()) recording.push_back(path[0]);
  if (spoil == 1) std::swap(recording[below(random, recording.size())], recording[below(random, recording.size())]);
  if (spoil == 2) recording.erase(recording.begin() + static_cast<std::ptrdiff_t>(below(random, recording.size())));
  if (spoil == 3) recording.pop_back();
  if (recording.empty()) recording.push_back(path[0]);
  return recording;
}

TEST(TraceMatch, DecidesAsTheWholeFreeSpaceDoes) {
  Random random = numbers_of(1);
  std::size_t accepted = 0;
  std::size_t refused = 0;
  for (std::uint64_t i = 0; i < test::random_cases(20000); ++i) {
    const double linear = std::array{0.01, 0.3, 0.8, 1.5}.at(below(random, 4));
    const double rotary = std::array{0.01, 2.0, 12.0}.at(below(random, 3));
    const Line path = grid_path(random, below(random, 2) == 0);
    const Line recording = grid_recording(random, path, linear, rotary);
    constexpr Real kHair = 1e-9L;
    // Some moves are not judged inside.
    std::vector<bool> free(path.size() - 1, false);
    Pieces pieces = straight(path);
    if (below(random, 3) == 0)
      for (std::size_t k = 0; k < free.size(); ++k) pieces.pieces[k].free = free[k] = below(random, 3) == 0;
    const bool below_it = within(path, recording, 1, linear * (1 - kHair), rotary * (1 - kHair), free);
    const bool above_it = within(path, recording, 1, linear * (1 + kHair), rotary * (1 + kHair), free);
    if (below_it != above_it) continue;
    const TraceResult r = match(pieces, recording, linear, rotary);
    ASSERT_EQ(r.findings_total == 0, above_it) << i << ": path " << words(path) << "\nrecording " << words(recording)
                                               << "\ntolerances " << linear << " " << rotary << "\n"
                                               << words(r);
    (above_it ? accepted : refused) += 1;
  }
  EXPECT_GT(accepted, test::random_cases(5000));
  EXPECT_GT(refused, test::random_cases(4000));
}

// Coordinates on the grid and noise on the axes: many distances are the tolerance itself, which is accepted.
TEST(TraceMatch, AcceptsTheToleranceItself) {
  Random random = numbers_of(2);
  for (std::uint64_t i = 0; i < test::random_cases(5000); ++i) {
    const double linear = 0.1 * static_cast<double>(1 + below(random, 3));
    const Line path = grid_path(random, false);
    Line recording;
    const double side = below(random, 2) == 0 ? linear : -linear;
    const std::size_t axis = below(random, 2);
    for (const Point& p : path) {
      recording.push_back(p);
      recording.back()[axis] += side;
    }
    // The path moved as a whole by the tolerance is the tolerance away from it.
    EXPECT_EQ(match(straight(path), recording, linear, 1).findings_total, 0U) << words(path);
  }
}

// --- Curves ---------------------------------------------------------------------------------------------------------

// Arcs of random turns behind each other, tangential or not, as chords with their sagitta as error.
struct Curve {
  Pieces pieces;
  Line fine;
  std::size_t first_pieces = 0;  // of `fine`
  double error = 0;
};

Curve random_curve(Random& random, double tolerance) {
  Curve curve;
  Point at{0, 0, 0};
  curve.fine.push_back(at);
  const std::size_t moves = 1 + below(random, 3);
  for (std::size_t move = 0; move < moves; ++move) {
    const double radius = uniform(random, 1, 5);
    const double begin = uniform(random, 0, 2 * std::numbers::pi);
    const double sweep = uniform(random, -2, 2) * std::numbers::pi;
    const Point center{at[0] - radius * std::cos(begin), at[1] - radius * std::sin(begin), 0};
    const double turn = uniform(random, -20, 20);
    const auto place = [&](double t) -> Point {
      return {center[0] + radius * std::cos(begin + t * sweep), center[1] + radius * std::sin(begin + t * sweep),
              at[2] + t * turn};
    };
    const double error = tolerance / 100;
    const int chords = static_cast<int>(std::ceil(std::fabs(sweep) / (2 * std::acos(1 - error / radius))));
    curve.error = error;
    for (int i = 0; i < chords; ++i) {
      PathPiece piece;
      piece.begin = axes(place(static_cast<double>(i) / chords));
      piece.end = axes(place(static_cast<double>(i + 1) / chords));
      piece.error = {error, 0};
      piece.corner = i + 1 == chords;
      piece.curved = true;
      piece.line = move + 1;
      curve.pieces.pieces.push_back(piece);
    }
    constexpr int kFiner = 8;  // chords within a 64th of the error of the arc
    for (int i = 1; i <= kFiner * chords; ++i) curve.fine.push_back(place(static_cast<double>(i) / (kFiner * chords)));
    if (move == 0) curve.first_pieces = curve.fine.size() - 1;
    at = place(1);
  }
  return curve;
}

// A straight line behind a curve whose pieces are off by up to half a millimetre: their joint is a place of both paths,
// so a recording has to pass it within 1, not within 1.5.
TEST(TraceMatch, AJointIsHeldToTheSmallerError) {
  Pieces pieces = straight({{0, 0, 0}, {10, 0, 0}, {20, 0, 0}});
  pieces.pieces[0].error = {0.5, 0};
  const auto conforms = [&](double x) {
    return match(pieces, {{0, 1.2, 0}, {x, 1.2, 0}, {x, 0.9, 0}, {20, 0.9, 0}}, 1, 1).findings_total == 0;
  };
  EXPECT_TRUE(conforms(10));
  EXPECT_TRUE(conforms(10.4));   // passes (10, 0) by √0.97
  EXPECT_FALSE(conforms(10.5));  // by √1.06
}

TEST(TraceMatch, DecidesOnCurvesWithinTheirErrors) {
  Random random = numbers_of(3);
  std::size_t accepted = 0;
  std::size_t refused = 0;
  for (std::uint64_t i = 0; i < test::random_cases(400); ++i) {
    constexpr double kTolerance = 0.2;
    constexpr double kRotary = 3;
    Curve curve = random_curve(random, kTolerance);
    Line recording;
    const std::size_t every = 1 + below(random, 100);
    const double noise = uniform(random, 0, 1.2);
    for (std::size_t k = 0; k < curve.fine.size();
         k = k + 1 < curve.fine.size() ? std::min(k + every, curve.fine.size() - 1) : k + 1) {
      Point p = curve.fine[k];
      const double angle = uniform(random, 0, 2 * std::numbers::pi);
      p[0] += kTolerance * noise * std::cos(angle) * uniform(random, 0, 1);
      p[1] += kTolerance * noise * std::sin(angle) * uniform(random, 0, 1);
      recording.push_back(p);
    }
    const Real fine_error = curve.error / 64;
    const bool surely = within(curve.fine, recording, curve.first_pieces, kTolerance - fine_error, kRotary);
    const bool perhaps =
        within(curve.fine, recording, curve.first_pieces, kTolerance + 2 * curve.error + fine_error, kRotary);
    const bool verdict = match(curve.pieces, recording, kTolerance, kRotary).findings_total == 0;
    if (surely) {
      EXPECT_TRUE(verdict) << i;
      ++accepted;
    }
    if (!perhaps) {
      EXPECT_FALSE(verdict) << i;
      ++refused;
    }
  }
  EXPECT_GT(accepted, test::random_cases(50));
  EXPECT_GT(refused, test::random_cases(50));
}

// --- Recordings with a known fault ----------------------------------------------------------------------------------

constexpr double kTolerance = 0.01;

// Legs of 2 to 6, corners of 35 to 145 degrees.
Line long_path(Random& random, bool turns = true) {
  Line path{{0, 0, 0}};
  double heading = uniform(random, 0, 2 * std::numbers::pi);
  for (int k = 0; k < 10; ++k) {
    const double length = uniform(random, 2, 6);
    Point next = path.back();
    next[0] += length * std::cos(heading);
    next[1] += length * std::sin(heading);
    if (turns) next[2] += uniform(random, -5, 5);
    path.push_back(next);
    const double bend = uniform(random, 35, 145) * std::numbers::pi / 180;
    heading += below(random, 2) == 0 ? bend : -bend;
  }
  return path;
}

void noise(Random& random, Point& p, double most) {
  const double angle = uniform(random, 0, 2 * std::numbers::pi);
  p[0] += most * std::cos(angle);
  p[1] += most * std::sin(angle);
  p[2] += uniform(random, -most, most);
}

// Evenly, with every corner.
void add_leg(Random& random, Line& recording, const Point& a, const Point& b, double step) {
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  const int steps = std::max(1, static_cast<int>(std::ceil(length / step)));
  for (int i = 1; i <= steps; ++i) {
    recording.push_back(between(a, b, static_cast<double>(i) / steps));
    // It stands still now and then.
    for (std::size_t dwell = below(random, 200) == 0 ? below(random, 50) : 0; dwell > 0; --dwell)
      recording.push_back(recording.back());
  }
}

Line honest(Random& random, const Line& path, double step) {
  Line recording{path[0]};
  for (std::size_t k = 0; k + 1 < path.size(); ++k) add_leg(random, recording, path[k], path[k + 1], step);
  return recording;
}

double distance(const Point& a, const Point& b, const Point& p) {
  const double dx = b[0] - a[0];
  const double dy = b[1] - a[1];
  const double square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}

TEST(TraceMatch, HonestRecordingsHaveNoFinding) {
  Random random = numbers_of(4);
  for (std::uint64_t i = 0; i < test::random_cases(100); ++i) {
    const Line path = long_path(random);
    const double step = uniform(random, 0.004, 0.3);
    Line recording = honest(random, path, step);
    for (Point& p : recording) noise(random, p, 0.95 * kTolerance);
    const TraceResult r = match(straight(path), recording, kTolerance, kTolerance);
    ASSERT_EQ(r.findings_total, 0U) << i << '\n' << words(r);
    EXPECT_NEAR(r.worst.upper, 0.95 * kTolerance, 0.1 * kTolerance);
    EXPECT_NEAR(r.covered, r.length, 2 * kTolerance);
  }
}

TEST(TraceMatch, ACornerCut) {
  Random random = numbers_of(5);
  for (std::uint64_t i = 0; i < test::random_cases(300); ++i) {
    const bool turns = below(random, 2) == 0;
    const Line path = long_path(random, turns);
    const std::size_t corner = 1 + below(random, path.size() - 2);
    const Point& c = path[corner];
    // The line between both sides, twice the tolerance away from the corner.
    const auto side = [&](const Point& end, double length) {
      return between(c, end, length / std::hypot(end[0] - c[0], end[1] - c[1]));
    };
    const Point one = side(path[corner - 1], 1);
    const Point other = side(path[corner + 1], 1);
    const double across = std::hypot(one[0] - other[0], one[1] - other[1]) / 2;
    const double length = 2 * kTolerance / std::sqrt(1 - across * across);
    Line recording{path[0]};
    std::size_t first = 0;
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
      const Point begin = k == corner ? side(path[corner + 1], length) : path[k];
      if (k == corner) {
        first = recording.size();
        recording.push_back(begin);
      }
      add_leg(random, recording, begin, k + 1 == corner ? side(path[k], length) : path[k + 1], 0.05);
    }
    for (Point& p : recording) noise(random, p, 0.1 * kTolerance);
    const TraceResult r = match(straight(path), recording, kTolerance, kTolerance);
    ASSERT_EQ(r.findings_total, 1U) << i << '\n' << words(r);
    const TraceFinding& f = r.findings[0];
    EXPECT_EQ(f.kind, "corner not reached") << i;
    EXPECT_EQ(f.line, corner) << i;
    EXPECT_EQ(r.corners_missed, 1U);
    const double truth = distance(recording[first - 1], recording[first], c);
    EXPECT_LE(f.distance.lower, truth + 1e-12);
    EXPECT_GE(f.distance.upper, truth - 1e-12);
    // Nearest by all axes may be farther by X and Y.
    EXPECT_LE(f.distance.upper - f.distance.lower, turns ? 10 * kTolerance : 0.01 * kTolerance);
    EXPECT_EQ(f.sample, first + 2) << i;
  }
}

TEST(TraceMatch, ABump) {
  Random random = numbers_of(6);
  for (std::uint64_t i = 0; i < test::random_cases(300); ++i) {
    const Line path = long_path(random);
    const std::size_t leg = below(random, path.size() - 1);
    Line recording{path[0]};
    std::size_t leg_begin = 0;
    std::size_t leg_end = 0;
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
      if (k == leg) leg_begin = recording.size();
      add_leg(random, recording, path[k], path[k + 1], 0.02);
      if (k == leg) leg_end = recording.size();
    }
    const Point& a = path[leg];
    const Point& b = path[leg + 1];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const double height = kTolerance * uniform(random, 2, 40);
    for (Point& p : recording) noise(random, p, 0.2 * kTolerance);
    double truth = 0;
    std::uint64_t first = 0;
    std::uint64_t count = 0;
    for (std::size_t s = leg_begin; s < leg_end; ++s) {
      Point& p = recording[s];
      const double along = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / (length * length);
      if (along < 0.3 || along > 0.5) continue;
      p[0] -= (b[1] - a[1]) / length * height;
      p[1] += (b[0] - a[0]) / length * height;
      truth = std::max(truth, distance(a, b, p));
      if (count++ == 0) first = s + 2;
    }
    const TraceResult r = match(straight(path), recording, kTolerance, kTolerance);
    ASSERT_GE(r.findings_total, 1U) << i;
    const TraceFinding& f = r.findings[0];
    EXPECT_EQ(f.kind, "off the path") << i << words(r);
    EXPECT_EQ(f.line, leg + 1) << i << words(r);
    EXPECT_EQ(f.sample, first) << i;
    // The path may cross itself beside the bump: no more samples are off, and none farther than the bump.
    EXPECT_LE(f.samples, count);
    EXPECT_LE(f.distance.lower, truth + 1e-12) << i;
    if (r.findings_total == 1 && f.samples == count) {
      EXPECT_GE(f.distance.upper, truth - 1e-12) << i;
    }
  }
}

TEST(TraceMatch, ABlockLeftOut) {
  Random random = numbers_of(7);
  for (std::uint64_t i = 0; i < test::random_cases(300); ++i) {
    const Line path = long_path(random, false);
    const std::size_t left_out = 1 + below(random, path.size() - 2);  // its end
    Line without = path;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(left_out));
    Line recording = honest(random, without, 0.05);
    for (Point& p : recording) noise(random, p, 0.1 * kTolerance);
    const TraceResult r = match(straight(path), recording, kTolerance, kTolerance);
    // The straight line past the corner lies off the path; the corner is farther from it than it is from the path.
    ASSERT_GE(r.findings_total, 1U) << i;
    const auto missed =
        std::ranges::find_if(r.findings, [](const TraceFinding& f) { return f.kind != "off the path"; });
    ASSERT_NE(missed, r.findings.end()) << i << words(r);
    // The line past the corner may run beside the move that leads there for a while: then that one was left.
    const Point past = between(path[left_out - 1], path[left_out + 1],
                               0.05 / std::hypot(path[left_out + 1][0] - path[left_out - 1][0],
                                                 path[left_out + 1][1] - path[left_out - 1][1]));
    if (distance(path[left_out - 1], path[left_out], past) > 1.2 * kTolerance) {
      EXPECT_EQ(missed->kind, "move left out") << i << '\n' << words(r);
    }
    EXPECT_EQ(missed->line, left_out) << i << '\n' << words(r);
    const double truth = distance(path[left_out - 1], path[left_out + 1], path[left_out]);
    EXPECT_NEAR(missed->distance.lower, truth, 0.15 * kTolerance) << i;
    EXPECT_NEAR(missed->distance.upper, truth, 0.15 * kTolerance + 1e-3 * truth) << i;
  }
}

TEST(TraceMatch, APieceRecordedTwice) {
  Random random = numbers_of(8);
  for (std::uint64_t i = 0; i < test::random_cases(200); ++i) {
    const Line path = long_path(random);
    Line recording = honest(random, path, 0.05);
    for (Point& p : recording) noise(random, p, 0.2 * kTolerance);
    const std::size_t last = 20 + below(random, recording.size() - 20);
    const std::size_t length = 5 + below(random, 15);
    const Line again(recording.begin() + static_cast<std::ptrdiff_t>(last - length),
                     recording.begin() + static_cast<std::ptrdiff_t>(last));
    recording.insert(recording.begin() + static_cast<std::ptrdiff_t>(last), again.begin(), again.end());
    const double back = std::hypot(again.front()[0] - again.back()[0], again.front()[1] - again.back()[1]);
    const TraceResult r = match(straight(path), recording, kTolerance, kTolerance);
    if (back < 4 * kTolerance) continue;  // it stood still
    ASSERT_EQ(r.findings_total, 1U) << i << words(r);
    EXPECT_EQ(r.findings[0].kind, "out of order") << i;
    EXPECT_EQ(r.findings[0].sample, last + 2) << i;
    EXPECT_GE(r.findings[0].distance.upper, back - 2 * kTolerance) << i;
  }
}

TEST(TraceMatch, SamplesMissingOnACurve) {
  Random random = numbers_of(9);
  for (std::uint64_t i = 0; i < test::random_cases(300); ++i) {
    const double radius = uniform(random, 1, 5);
    const double missing = uniform(random, 0.3, 3);
    const double from = uniform(random, 0.1, 3);
    const auto place = [&](double angle) -> Point {
      return {radius * std::sin(angle), radius * (1 - std::cos(angle)), 0};
    };
    const double error = kTolerance / 100;
    const int chords = static_cast<int>(std::ceil(2 * std::numbers::pi / (2 * std::acos(1 - error / radius))));
    Pieces pieces = straight({{-5, 0, 0}, {0, 0, 0}});
    for (int k = 0; k < chords; ++k) {
      PathPiece piece;
      piece.begin = axes(place(2 * std::numbers::pi * k / chords));
      piece.end = axes(place(2 * std::numbers::pi * (k + 1) / chords));
      piece.error = {error, 0};
      piece.corner = k + 1 == chords;
      piece.curved = true;
      piece.line = 2;
      pieces.pieces.push_back(piece);
    }
    Line recording{{-5, 0, 0}, {0, 0, 0}};
    std::uint64_t behind = 0;
    for (int step = 1; step <= 628; ++step) {
      const double angle = 0.01 * step;
      if (angle > from && angle < from + missing) continue;
      if (angle >= from + missing && behind == 0) behind = recording.size() + 2;
      recording.push_back(place(angle));
    }
    recording.push_back(place(0));
    const Point& a = recording[behind - 3];
    const Point& b = recording[behind - 2];
    const double half = std::hypot(a[0] - b[0], a[1] - b[1]) / 2;
    const double sagitta = radius - (missing < std::numbers::pi ? 1 : -1) * std::sqrt(radius * radius - half * half);
    const TraceResult r = match(pieces, recording, kTolerance, kTolerance);
    ASSERT_EQ(r.findings_total, 1U) << i << words(r);
    EXPECT_EQ(r.findings[0].kind, "gap");
    EXPECT_EQ(r.findings[0].line, 2U);
    EXPECT_EQ(r.findings[0].sample, behind);
    EXPECT_LE(r.findings[0].distance.lower, sagitta + 1e-12) << i;
    EXPECT_GE(r.findings[0].distance.upper, sagitta - 1e-12) << i;
    EXPECT_LE(r.findings[0].distance.upper - r.findings[0].distance.lower, 0.1 * kTolerance + 2e-3 * sagitta) << i;
  }
}

// Steps that vary by 30 percent, a period that changes: no gap. Left out samples: exactly those, wherever three
// periods are missing.
TEST(TraceTime, StepsOfAnUnsteadyClock) {
  Random random = numbers_of(10);
  for (std::uint64_t i = 0; i < test::random_cases(200); ++i) {
    std::vector<std::uint64_t> found;
    TimeSteps steps([&](const TimeStep& step) { found.push_back(step.line); });
    std::vector<std::uint64_t> missing;
    double period = uniform(random, 0.001, 0.1);
    std::uint64_t line = 0;
    std::uint64_t quiet = 0;  // steps since the last change or gap
    for (int k = 0; k < 1000; ++k, ++line, ++quiet) {
      if (quiet > 100 && k < 950 && below(random, 200) == 0) {
        period *= uniform(random, 0.3, 3);
        quiet = 0;
      }
      double seconds = period * uniform(random, 0.85, 1.15);
      if (quiet > 40 && k < 950 && below(random, 100) == 0) {
        seconds += 3 * period;
        missing.push_back(line);
      }
      steps.take({seconds, period / 1000, line, {}, {}});
    }
    steps.end();
    // A gap beside a change of the period may be within the longer one.
    EXPECT_TRUE(std::ranges::includes(missing, found)) << i;
    EXPECT_GE(found.size() + 3, missing.size()) << i;
  }
}

// --- Long paths -----------------------------------------------------------------------------------------------------

// A zigzag of short blocks, made as it is asked for: rows of 100, 1 apart.
class Zigzag : public PathSource {
 public:
  explicit Zigzag(std::size_t pieces) : pieces_(pieces) {}
  static Point place(std::size_t number) {
    const std::size_t row = number / 101;
    const std::size_t column = number % 101;
    const double along = 0.1 * static_cast<double>(column);
    return {row % 2 == 0 ? along : 10 - along, static_cast<double>(row), 0};
  }
  bool next(PathPiece& piece) override {
    if (next_ == pieces_) return false;
    piece = {};
    piece.begin = axes(place(next_));
    piece.end = axes(place(++next_));
    piece.line = next_;
    return true;
  }

 private:
  std::size_t pieces_;
  std::size_t next_ = 0;
};

template <class Place>
TraceResult match_zigzag(std::size_t pieces, Place place) {
  const spec::Axes letters("XYC");
  const Metric metric({{0, 1}, {}}, {kTolerance, kTolerance});
  TraceResult result;
  Findings findings(result, 100);
  Zigzag path(pieces);
  Matcher matcher(path, metric, letters, result, findings);
  std::uint64_t line = 2;
  for (std::size_t number = 0; number <= pieces; ++number)
    if (const std::optional<Point> p = place(number)) matcher.take(axes(*p), line++);
  matcher.end();
  return result;
}

// Blocks left out are found again as far ahead as is searched, and named.
TEST(TraceMatch, AHundredThousandBlocksLeftOut) {
  const TraceResult r = match_zigzag(200000, [](std::size_t number) -> std::optional<Point> {
    // From the end of row 49, (0, 49), to the begin of row 1050, (0, 1050).
    if (number > 5049 && number < 5050 + 1000 * 101) return {};
    return Zigzag::place(number);
  });
  ASSERT_EQ(r.findings_total, 1U) << words(r);
  EXPECT_EQ(r.findings[0].kind, "move left out");
  // The line between passes (0, 50), where block 5050 ends, and (0, 1049), where block 106049 ends.
  EXPECT_EQ(r.findings[0].line, 5051U);
  EXPECT_EQ(r.findings[0].last_line, 106048U);
  EXPECT_EQ(r.findings[0].sample, 5052U);
  // The other ends of the rows are 10 away.
  EXPECT_NEAR(r.findings[0].distance.lower, 10, 0.01);
  EXPECT_NEAR(r.findings[0].distance.upper, 10, 0.02);
}

// Twice the tolerance beside the path for longer than what is held of it: the distance is that of the path beside it.
TEST(TraceMatch, LostForLongerThanTheWindow) {
  constexpr std::size_t kPieces = 300000;
  const TraceResult r = match_zigzag(kPieces, [](std::size_t number) -> std::optional<Point> {
    Point p = Zigzag::place(number);
    if (number > 1000 && number < kPieces) p[1] += 2 * kTolerance;
    return p;
  });
  ASSERT_EQ(r.findings_total, 1U) << words(r);
  EXPECT_EQ(r.findings[0].kind, "off the path");
  EXPECT_EQ(r.findings[0].sample, 1003U);
  // At the ends of rows the recording lies on the way to the next one.
  EXPECT_GT(r.findings[0].samples, (kPieces - 1000) / 101 * 99);
  EXPECT_LE(r.findings[0].distance.lower, 2 * kTolerance);
  EXPECT_GE(r.findings[0].distance.upper, 2 * kTolerance);
  EXPECT_LE(r.findings[0].distance.upper, 2.5 * kTolerance);
}

}  // namespace
}  // namespace toolcomp::certify
