// SPDX-License-Identifier: Apache-2.0
// Programs of 3D tool compensation (Heidenhain) made of exact numbers, and what the model says of them as vectors.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "fuzz/gen/heidenhain/space_vectors.h"
#include "tests/property/support.h"

namespace toolcomp::laws {

using Point = std::array<Rational, 3>;
using Vec = std::array<Real, 3>;

inline Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec operator*(const Real& k, const Vec& a) { return {k * a[0], k * a[1], k * a[2]}; }
inline Real dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec exact_vector(const Point& p) { return {Real(p[0]), Real(p[1]), Real(p[2])}; }
inline bool same(const Vec& a, const Vec& b) { return equal(a[0], b[0]) && equal(a[1], b[1]) && equal(a[2], b[2]); }

inline Rational dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Point operator*(const Rational& k, const Point& p) { return {k * p[0], k * p[1], k * p[2]}; }
inline Point sum(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

// The decimal that is exactly this number; it must be one.
inline std::string decimal_text(Rational value) {
  std::string sign = value < 0 ? "-" : "+";
  if (value < 0) value = -value;
  int decimals = 0;
  for (; denominator(value) != 1; value *= 10) RC_ASSERT(++decimals <= 17);
  std::string digits = numerator(value).str();
  if (decimals == 0) return sign + digits;
  const auto places = static_cast<std::size_t>(decimals);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  return sign + digits.insert(digits.size() - places, ".");
}

inline std::string words(std::string_view prefix, const Point& p) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) text += fmt::format(" {}{}{}", prefix, "XYZ"[i], decimal_text(p[i]));
  return text;
}

// mm
struct Cutter {
  Rational r, r2;
  Rational dl, dr, dr2;
  [[nodiscard]] Rational flat() const { return r - r2; }
  [[nodiscard]] Rational effective_flat() const { return std::max(Rational(0), Rational(r + dr - r2 - dr2)); }
};

struct Mode {
  bool tcpm = true;
  bool center = false;
  bool contour = false;
  bool permitted = true;  // M107
};

inline spec::Case make(const char* section, const Cutter& cutter, const Mode& mode, const std::string& motions) {
  spec::Case c;
  c.section = section;
  c.dialect = "klartext";
  c.setup.control = spec::Control::heidenhain;
  c.setup.axes = spec::Axes("XYZABC");
  spec::ToolRow tool;
  tool.number = 10;
  tool.r = *spec::parse_decimal(decimal_text(cutter.r));
  tool.r2 = *spec::parse_decimal(decimal_text(cutter.r2));
  c.setup.tools = {tool};
  c.program = fmt::format("TOOL CALL 1 Z DL{} DR{} DR2{}\n", decimal_text(cutter.dl), decimal_text(cutter.dr),
                          decimal_text(cutter.dr2));
  if (mode.permitted) c.program += "M107\n";
  if (mode.tcpm)
    c.program +=
        fmt::format("FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS REFPNT {}\n", mode.center ? "CNT-CNT" : "TIP-TIP");
  if (mode.contour) c.program += "FUNCTION PROG PATH IS CONTOUR\n";
  c.program += motions;
  return c;
}

inline std::string face(const Point& p, const Point& n, const Point& t) {
  return "LN" + words("", p) + words("N", n) + words("T", t) + " R0\n";
}
inline std::string face(const Point& p, const Point& n) { return "LN" + words("", p) + words("N", n) + " R0\n"; }

// A move as vectors.
struct Moved {
  Vec programmed, tip, center, shift, tool_shift, axes, tool;
  Vec contact{}, normal{};  // blocks with a normal
};

// The moves of the model, in order; no alarm. The fast engine agrees.
inline std::vector<Moved> moved(const spec::Case& c) {
  const judge::ModelRun run = judge::run_model(c);
  RC_LOG() << fuzz::encode(c);
  const auto place = [](const Table& values) { return Vec{values[0], values[1], values[2]}; };
  std::vector<Moved> moves;
  for (const model::Event& e : run.events) {
    RC_LOG() << "line " << e.line << ' ' << e.number.view() << '\n';
    RC_ASSERT(e.kind == EventKind::move || e.kind == EventKind::warning);
    if (e.kind != EventKind::move) continue;
    RC_ASSERT(e.space.has_value());
    RC_ASSERT(e.tool_axis.has_value());
    Moved m;
    m.programmed = place(e.programmed);
    m.tip = place(e.point);
    m.axes = place(e.axes);
    m.tool = *e.tool_axis;
    m.center = e.space->tool_center;
    m.shift = e.space->shift;
    m.tool_shift = e.space->tool_shift;
    if (e.space->contact) {
      m.contact = e.space->contact->point;
      m.normal = e.space->contact->normal;
    }
    moves.push_back(std::move(m));
  }
  fast_agrees(c, run);
  return moves;
}

inline Moved moved_once(const spec::Case& c) {
  const std::vector<Moved> moves = moved(c);
  RC_ASSERT(moves.size() == 1);
  return moves[0];
}

// Numbers of the laws.
inline Rational count_of(std::int64_t low, std::int64_t high, std::int64_t denominator) {
  return Rational(*rc::gen::inRange<std::int64_t>(low, high + 1), denominator);
}
inline Point any_place() {
  Point p;
  for (Rational& x : p) x = *rc::gen::arbitrary<bool>() ? count_of(-50, 50, 1) : count_of(-900'000, 900'000, 10'000);
  return p;
}
inline Point any_direction() {
  RapidCheckSource source;
  fuzz::Choices choose(source);
  const fuzz::VectorWords v = fuzz::any_vector(choose);
  Rational one = 1;
  for (int i = 0; i < v.decimals; ++i) one *= 10;
  return {Rational(v.count[0]) / one, Rational(v.count[1]) / one, Rational(v.count[2]) / one};
}

// End mills, toroid cutters and balls whose effective tool exists; `clamped`: the corner radius may outgrow the radius.
inline Cutter any_cutter(bool clamped = false) {
  Cutter c;
  c.r = count_of(10, 200, 10);
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      c.r2 = 0;
      break;
    case 1:
      c.r2 = c.r;
      break;
    default:
      c.r2 = c.r * count_of(1, 9, 10);
      break;
  }
  c.dl = count_of(-300, 300, 1000);
  c.dr = count_of(-300, 300, 1000);
  c.dr2 = count_of(-300, 300, 1000);
  if (*rc::gen::inRange(0, 3) == 0) c.dl = c.dr2 = c.dr;
  if (c.r2 + c.dr2 < 0) c.dr2 = -c.r2;
  if (!clamped && c.r + c.dr < c.r2 + c.dr2) c.dr = c.r2 + c.dr2 - c.r;
  return c;
}

// u of heidenhain.face.ring-direction: the part of n across t, as a unit vector; 0 along the tool.
inline Vec ring_direction(const Point& n, const Point& t) {
  const Point w = sum(dot(t, t) * n, Rational(-dot(n, t)) * t);
  const Rational square = dot(w, w);
  if (square == 0) return {Real(0), Real(0), Real(0)};
  return (Real(1) / sqrt(Real(square))) * exact_vector(w);
}

inline Vec unit(const Point& v) { return (Real(1) / sqrt(Real(dot(v, v)))) * exact_vector(v); }

// A rotation whose matrix has finite decimals: turns of 3-4-5 about two axes.
struct Rotation {
  std::array<Point, 3> row;
  [[nodiscard]] Point operator()(const Point& p) const { return {dot(row[0], p), dot(row[1], p), dot(row[2], p)}; }
  [[nodiscard]] Vec operator()(const Vec& v) const {
    return {dot(exact_vector(row[0]), v), dot(exact_vector(row[1]), v), dot(exact_vector(row[2]), v)};
  }
};
inline Rotation any_rotation() {
  const Rational c(3, 5);
  const Rational s(4, 5);
  const std::array<Rotation, 4> turns = {Rotation{{Point{c, -s, 0}, Point{s, c, 0}, Point{0, 0, 1}}},
                                         Rotation{{Point{1, 0, 0}, Point{0, c, -s}, Point{0, s, c}}},
                                         Rotation{{Point{s, 0, c}, Point{0, 1, 0}, Point{-c, 0, s}}},
                                         Rotation{{Point{0, 0, 1}, Point{1, 0, 0}, Point{0, 1, 0}}}};
  const Rotation first = turns[*rc::gen::inRange<std::size_t>(0, 4)];
  const Rotation second = turns[*rc::gen::inRange<std::size_t>(0, 4)];
  Rotation both;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      both.row[i][j] = 0;
      for (std::size_t k = 0; k < 3; ++k) both.row[i][j] += second.row[i][k] * first.row[k][j];
    }
  return both;
}

}  // namespace toolcomp::laws
