// SPDX-License-Identifier: Apache-2.0
// Paths of lines and arcs under cutter compensation and, the same with a tool along Z, tool side compensation, written
// as programs in several ways, and comparison of runs that must be the same up to a motion of the plane.
#pragma once

#include <fmt/format.h>

#include <array>
#include <vector>

#include "fuzz/gen/fanuc/contour.h"
#include "tests/property/support.h"

namespace toolcomp::laws {

using fuzz::PlaneCounts;
using fuzz::Segment;
using fuzz::Segments;

constexpr std::int64_t kOne = 1000;  // counts of a millimetre

inline std::string number(std::int64_t thousandths) {
  const std::int64_t magnitude = thousandths < 0 ? -thousandths : thousandths;
  return fmt::format("{}{}.{:03}", thousandths < 0 ? "-" : "", magnitude / kOne, magnitude % kOne);
}

// A path: the start-up line, then segments, in counts.
struct Path {
  std::int64_t offset = 0;
  PlaneCounts lead;
  Segments segments;
};

inline Path any_path(std::size_t least = 2, std::size_t most = 6) {
  RapidCheckSource source;
  fuzz::Choices choose(source);
  fuzz::Contour contour(choose, kOne);
  Path path;
  path.offset = choose.between(1, 12 * kOne);
  if (choose.chance(50)) path.offset = choose.between(1, 12) * kOne;
  contour.offset(path.offset);
  path.lead = contour.line().travel;
  const auto count =
      static_cast<std::size_t>(choose.between(static_cast<std::int64_t>(least), static_cast<std::int64_t>(most)));
  while (path.segments.size() < count) {
    if (choose.chance(30)) {
      for (Segment& segment : contour.shape()) path.segments.push_back(segment);
    } else {
      path.segments.push_back(contour.movement());
    }
  }
  return path;
}

struct Letters {
  std::string_view plane;  // the G code
  std::array<char, 2> axis;
  std::array<char, 2> center;
};
constexpr Letters kXY{"G17", {'X', 'Y'}, {'I', 'J'}};
constexpr Letters kZX{"G18", {'Z', 'X'}, {'K', 'I'}};
constexpr Letters kYZ{"G19", {'Y', 'Z'}, {'J', 'K'}};

struct Writing {
  Letters letters = kXY;
  bool absolute = false;
  bool right = false;            // G42
  bool cancel = true;            // a G40 line at the end, along the lead
  std::string_view suffix = {};  // of G41 and G42
};

// One block a line: plane and mode, start-up, the segments, cancel.
constexpr std::uint64_t kFirstSegmentLine = 3;
inline std::string program(const Path& path, const Writing& how = {}) {
  std::string text = fmt::format("{} {} G01 F1000\n", how.letters.plane, how.absolute ? "G90" : "G91");
  PlaneCounts at{};
  const auto to = [&](PlaneCounts travel) {
    at = at + travel;
    const PlaneCounts p = how.absolute ? at : travel;
    return fmt::format("{}{} {}{}", how.letters.axis[0], number(p.x), how.letters.axis[1], number(p.y));
  };
  text += fmt::format("G01 {}{} D1 {}\n", how.right ? "G42" : "G41", how.suffix, to(path.lead));
  for (const Segment& s : path.segments) {
    if (s.kind == Segment::Kind::line) {
      text += fmt::format("G01 {}\n", to(s.travel));
      continue;
    }
    text += fmt::format("{} {} ", s.clockwise ? "G02" : "G03", to(s.travel));
    if (s.kind == Segment::Kind::radius_arc)
      text += fmt::format("R{}\n", number(s.radius));
    else
      text += fmt::format("{}{} {}{}\n", how.letters.center[0], number(s.to_center.x), how.letters.center[1],
                          number(s.to_center.y));
  }
  if (how.cancel) text += fmt::format("G01 G40 {}\n", to(path.lead));
  return text;
}

const std::string kToolSide = "fanuc/tool-side-compensation";

// The section decides between B, C and the side of a tool along Z.
inline spec::Case make(const std::string& section, const Path& path, Writing how = {}) {
  if (section == kToolSide) how.suffix = ".2";
  spec::Case c;
  c.section = section;
  c.setup.cutter_compensation =
      section.ends_with('b') ? spec::CutterCompensationType::b : spec::CutterCompensationType::c;
  c.setup.d[1].geometry = *spec::parse_decimal(number(path.offset));
  c.program = program(path, how);
  return c;
}

// Every vector of the path through `map`; R and the offset by `scale`; `flip` turns arcs and sides round.
template <class Map>
Path changed(const Path& path, const Map& map, std::int64_t scale = 1, bool flip = false) {
  Path result = path;
  result.offset *= scale;
  result.lead = map(path.lead);
  for (Segment& s : result.segments) {
    s.travel = map(s.travel);
    s.to_center = map(s.to_center);
    s.radius *= scale;
    s.clockwise = s.clockwise != flip;
  }
  return result;
}

// What a law makes of a run.
struct Motion {
  Map map;
  Real scale = 1;                    // of radii
  bool flips = false;                // clockwise and counter-clockwise
  std::optional<spec::Plane> plane;  // another plane
};
inline Table unchanged(const spec::Axes&, const Table& t) { return t; }

inline bool same(const std::optional<Real>& a, const std::optional<Real>& b) {
  return a.has_value() == b.has_value() && (!a || equal(*a, *b));
}

inline void same_arc(const spec::Axes& axes, const spec::Arc<Real>& a, const spec::Arc<Real>& b, const Motion& motion) {
  RC_ASSERT((a.direction == b.direction) != motion.flips);
  RC_ASSERT(b.plane == motion.plane.value_or(a.plane));
  RC_ASSERT(same(motion.map(axes, a.center), b.center));
  RC_ASSERT(same(a.sweep, b.sweep));
  RC_ASSERT(a.radius.has_value() == b.radius.has_value());
  if (!a.radius) return;
  RC_ASSERT(equal(a.radius->first * motion.scale, b.radius->first));
  RC_ASSERT(equal(a.radius->second * motion.scale, b.radius->second));
}

// The run of `changed` is that of `original` moved, event by event, arcs included; lines shifted by `shift`. The fast
// engine must agree with the model on the changed case.
inline void moved(const spec::Case& original, const spec::Case& changed, const Motion& motion,
                  std::uint64_t shift = 0) {
  mapped(original, changed, motion.map, shift);
  const auto a = model_run(original);
  const auto b = model_run(changed);
  for (std::size_t i = 0; i < a->events.size(); ++i) {
    const model::Event& e = a->events[i];
    const model::Event& f = b->events[i];
    RC_ASSERT(e.arc.has_value() == f.arc.has_value());
    if (e.arc) same_arc(original.setup.axes, *e.arc, *f.arc, motion);
  }
}

// Values of X and Y through `map`, which takes and gives a pair of Reals.
template <class Map2>
Map in_plane(const Map2& map) {
  return [map](const spec::Axes& axes, const Table& t) {
    Table result = t;
    const std::size_t x = axes.index('X');
    const std::size_t y = axes.index('Y');
    if (!t.has(x) || !t.has(y)) return result;
    const std::pair<Real, Real> p = map(t[x], t[y]);
    result.set(x, p.first);
    result.set(y, p.second);
    return result;
  };
}

// X → Z → Y → X: what G17 has, G18 has.
inline Table next_plane(const spec::Axes& axes, const Table& t) {
  Table result = t;
  for (const auto& [from, to] : {std::pair{'X', 'Z'}, {'Y', 'X'}, {'Z', 'Y'}}) {
    const std::size_t i = axes.index(from);
    const std::size_t j = axes.index(to);
    if (t.has(i))
      result.set(j, t[i]);
    else
      result.clear(j);
  }
  return result;
}

// The laws that hold for B, C and the side of a tool along Z alike; `section` is one of them.

inline void mirror_exchanges_sides(const std::string& section, const Writing& how = {}) {
  const Path path = any_path();
  const Path other = changed(path, [](PlaneCounts p) { return PlaneCounts{p.x, -p.y}; }, 1, true);
  Writing right = how;
  right.right = !how.right;
  moved(make(section, path, how), make(section, other, right),
        {in_plane([](const Real& x, const Real& y) { return std::pair(x, -y); }), 1, true, {}});
}

inline void quarter_turn(const std::string& section) {
  const Path path = any_path();
  const Path other = changed(path, [](PlaneCounts p) { return PlaneCounts{-p.y, p.x}; });
  moved(make(section, path), make(section, other),
        {in_plane([](const Real& x, const Real& y) { return std::pair(-y, x); }), 1, false, {}});
}

// A turn whose cosine and sine are 3/5 and 4/5, all five times as long, is exact in decimals.
inline void pythagorean_turn(const std::string& section) {
  const Path path = any_path();
  const Path other = changed(path, [](PlaneCounts p) { return PlaneCounts{3 * p.x - 4 * p.y, 4 * p.x + 3 * p.y}; }, 5);
  moved(make(section, path), make(section, other),
        {in_plane([](const Real& x, const Real& y) { return std::pair(3 * x - 4 * y, 4 * x + 3 * y); }), 5, false, {}});
}

inline void inches(const std::string& section) {
  const Path path = any_path();
  const spec::Case c = make(section, path);
  spec::Case inch = c;
  spec::Decimal& value = inch.setup.d[1].geometry;
  value.digits *= 254;
  ++value.decimals;
  inch.program = "G20\n" + c.program;
  const auto scale = [](const spec::Axes&, const Table& t) {
    Table result = t;
    for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
      if (t.has(i)) result.set(i, t[i] * Real(Rational(127, 5)));
    return result;
  };
  moved(c, inch, {scale, Real(Rational(127, 5)), false, {}}, 1);
}

inline void negative_value_exchanges_sides(const std::string& section) {
  const Path path = any_path();
  Path negative = path;
  negative.offset = -path.offset;
  Writing right;
  right.right = true;
  moved(make(section, path), make(section, negative, right), {unchanged, 1, false, {}});
}

inline void absolute_is_incremental(const std::string& section) {
  const Path path = any_path();
  Writing absolute;
  absolute.absolute = true;
  moved(make(section, path), make(section, path, absolute), {unchanged, 1, false, {}});
}

inline void planes_by_cyclic_renaming(const std::string& section) {
  const Path path = any_path();
  const spec::Case xy = make(section, path);
  Writing in_zx;
  in_zx.letters = kZX;
  const spec::Case zx = make(section, path, in_zx);
  Writing in_yz;
  in_yz.letters = kYZ;
  const spec::Case yz = make(section, path, in_yz);
  moved(xy, zx, {next_plane, 1, false, spec::Plane::zx});
  moved(zx, yz, {next_plane, 1, false, spec::Plane::yz});
}

// With the value 0 the point is the programmed one, and nothing is inserted.
inline void value_zero_is_the_identity(const std::string& section) {
  Path path = any_path();
  spec::Case c = make(section, path);
  c.setup.d[1].geometry = spec::decimal(0);
  const auto run = model_run(c);
  RC_LOG() << fuzz::encode(c);
  RC_ASSERT(run.has_value());
  for (const model::Event& e : run->events) {
    if (e.kind != EventKind::move) continue;
    RC_ASSERT(e.cause != spec::Cause::corner);
    RC_ASSERT(same(e.programmed, e.point));
  }
  fast_agrees(c, *run);
}

}  // namespace toolcomp::laws
