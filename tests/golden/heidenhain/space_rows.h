// SPDX-License-Identifier: Apache-2.0
// Worked examples of Heidenhain 3D compensation against rows of figures.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "spec/language/event_names.h"
#include "tests/golden/rows.h"

namespace toolcomp::corpus::space {

// "3 start-up tip=0,-0.1,0 axes=0,-0.1,0.5 B=90" is a move of line 3 with its cause, "3 rapid programmed ..." one with
// FMAX. Figures of a move, three numbers each unless said otherwise:
//   tip        tip of the effective tool (point)         center     its centre (tool_center)
//   shift      of the tip against the nominal tool       tool       of the real tool (tool_shift)
//   axes       X Y Z                                     carrier    the tool's carrier
//   contact    where the tool touches                    normal     unit normal
//   axis       unit direction of the tool                angle      between normal and tool (one number)
//   at         programmed end point                      A, B, C    rotary axes (one number)
//   feed       (one number)                              flat       the contact is on the axis (no number)
//   X, Y, Z    of axes (one number)                      unknown    others of them are not known (no number)
// "3 hole r=2 bottom=-5 return=50 axes=1,2,50 X=1 Y=2" is a hole of line 3, with all of these figures: X, Y and Z are
// then those of its position. Figures that are left out are not looked at, but contact, flat, unknown, angle, carrier
// and feed are in a row exactly where the event has them. The model's decimals are those of the row, every one; the
// fast engine's are near. "4 W_DIGITS" is a warning or an alarm, "5 OUT_OF_SCOPE" a block that is not modelled.
using worked::Rows;

template <class Number>
using Figures = std::optional<std::vector<Number>>;

template <class Number>
Figures<Number> list(const std::array<Number, 3>& vector) {
  return std::vector<Number>(vector.begin(), vector.end());
}

template <class Number>
Figures<Number> linear(const spec::AxisValues<Number>& values, const spec::Axes& axes) {
  std::vector<Number> three;
  for (const char letter : {'X', 'Y', 'Z'}) three.push_back(values[axes.index(letter)]);
  return three;
}

template <class Number>
Figures<Number> one(const std::optional<Number>& value) {
  return value ? Figures<Number>(std::vector<Number>{*value}) : std::nullopt;
}

// The figures of that name, or nothing where the event has none.
template <class Number>
Figures<Number> figures(const spec::Event<Number>& event, const std::string& name, const spec::Axes& axes) {
  if (name == "at") return linear(event.programmed, axes);
  if (name == "tip") return linear(event.point, axes);
  if (name == "axes") return linear(event.axes, axes);
  if (event.hole) {
    if (name == "r") return std::vector<Number>{event.hole->point_r};
    if (name == "bottom") return std::vector<Number>{event.hole->bottom};
    if (name == "return") return std::vector<Number>{event.hole->level};
    if (name.size() == 1 && axes.has(name[0]) && event.point.has(axes.index(name[0])))
      return std::vector<Number>{event.point[axes.index(name[0])]};
    return std::nullopt;
  }
  if (name == "feed") return one(event.feed);
  if (name == "axis") return event.tool_axis ? list(*event.tool_axis) : std::nullopt;
  if (name.size() == 1 && axes.has(name[0]) && event.axes.has(axes.index(name[0])))
    return std::vector<Number>{event.axes[axes.index(name[0])]};
  if (name == "unknown") return event.unknown != 0 ? Figures<Number>(std::vector<Number>()) : std::nullopt;
  if (!event.space) return std::nullopt;
  const spec::SpaceCompensation<Number>& space = *event.space;
  if (name == "center") return list(space.tool_center);
  if (name == "shift") return list(space.shift);
  if (name == "tool") return list(space.tool_shift);
  if (name == "carrier") return space.carrier ? list(*space.carrier) : std::nullopt;
  if (!space.contact) return std::nullopt;
  if (name == "contact") return list(space.contact->point);
  if (name == "normal") return list(space.contact->normal);
  if (name == "angle") return one(space.contact->angle);
  if (name == "flat") return space.contact->flat ? Figures<Number>(std::vector<Number>()) : std::nullopt;
  return std::nullopt;
}

template <class Number>
std::string head(const spec::Event<Number>& event) {
  const std::string line = std::to_string(event.line) + ' ';
  if (event.kind == spec::EventKind::undecided)
    return line + (event.out_of_scope ? "OUT_OF_SCOPE" : std::string(event.number.view()));
  if (event.kind != spec::EventKind::alarm && spec::ends_run(event.kind))
    return line + std::string(spec::name(event.kind)) + ' ' + std::string(event.number.view());
  if (event.kind == spec::EventKind::hole) return line + "hole";
  if (event.kind != spec::EventKind::move) return line + std::string(event.number.view());
  const std::string rapid = event.type == spec::MoveType::rapid ? "rapid " : "";
  switch (event.cause) {
    case spec::Cause::programmed:
      return line + rapid + "programmed";
    case spec::Cause::start_up:
      return line + rapid + "start-up";
    case spec::Cause::cancel:
      return line + rapid + "cancel";
    default:
      return line + "another cause";
  }
}

inline void expect_figure(const spec::NumberText& actual, const std::string& figure) { EXPECT_EQ(actual.v, figure); }

// The figure is rounded to 15 decimals.
inline void expect_figure(double actual, const std::string& figure) {
  constexpr double kRelative = 1e-13;
  const double expected = std::stod(figure);
  EXPECT_NEAR(actual, expected, kRelative * (1 + std::abs(expected)));
}

inline std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

template <class Number>
void expect_move(const spec::Event<Number>& event, const std::vector<std::string>& tokens, const spec::Axes& axes) {
  std::vector<std::string> named;
  for (const std::string& token : tokens) {
    const std::size_t equals = std::min(token.find('='), token.size());
    if (equals == token.size() && token != "flat" && token != "unknown") continue;  // of the head
    named.push_back(token.substr(0, equals));
    SCOPED_TRACE(token);
    const Figures<Number> actual = figures(event, named.back(), axes);
    ASSERT_TRUE(actual);
    const std::vector<std::string> expected = equals == token.size() ? Rows{} : split(token.substr(equals + 1));
    ASSERT_EQ(actual->size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) expect_figure((*actual)[i], expected[i]);
  }
  if (event.hole) {
    for (const char* name : {"r", "bottom", "return", "axes", "X", "Y", "Z"})
      EXPECT_EQ(figures(event, name, axes).has_value(), std::ranges::find(named, name) != named.end()) << name;
  }
  for (const char* name : {"contact", "flat", "angle", "carrier", "feed", "unknown", "A", "B", "C"})
    EXPECT_EQ(figures(event, name, axes).has_value(), std::ranges::find(named, name) != named.end()) << name;
}

template <class Number>
void expect_events(const std::vector<spec::Event<Number>>& events, const Rows& rows, const spec::Axes& axes) {
  EXPECT_EQ(events.size(), rows.size());
  for (std::size_t n = 0; n < std::min(events.size(), rows.size()); ++n) {
    SCOPED_TRACE(rows[n]);
    const std::string expected = head(events[n]);
    EXPECT_EQ(rows[n].substr(0, expected.size()), expected);
    if (events[n].kind == spec::EventKind::move || events[n].hole) expect_move(events[n], rows::tokens(rows[n]), axes);
  }
}

inline void expect(const std::string& section, const std::string& name, const std::vector<worked::Example>& table) {
  worked::expect(section, name, table, [](const auto& events, const Rows& rows, const spec::Case& c) {
    expect_events(events, rows, c.setup.axes);
  });
}

}  // namespace toolcomp::corpus::space
