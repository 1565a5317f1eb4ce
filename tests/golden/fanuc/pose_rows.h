// SPDX-License-Identifier: Apache-2.0
// Worked examples of tool center point control against rows of figures.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "tests/golden/rows.h"

namespace toolcomp::corpus::poses {

// "2 programmed C=135 B=35.2643896827547 x=20 k=0.816496580927726" is a move of line 2 with its cause; upper case are
// axes, x y z the point, i j k the tool axis. "2 t=1/4 ..." is a sample; "2 PS5459" an alarm, "2 posture-branch" a
// warning. Figures that are left out are not looked at; those given hold to their last digit, and exactly where they
// have fewer than nine decimals. "~" in a row: the program's own numbers are rounded, only twelve decimals hold.
using worked::Rows;

inline double number(const spec::NumberText& value) { return std::stod(value.v); }
inline double number(double value) { return value; }

inline std::string cause_name(spec::Cause cause) {
  switch (cause) {
    case spec::Cause::programmed:
      return "programmed";
    case spec::Cause::start_up:
      return "start-up";
    case spec::Cause::corner:
      return "corner";
    case spec::Cause::cancel:
      return "cancel";
    case spec::Cause::pre_turn:
      return "pre-turn";
    case spec::Cause::post_turn:
      return "post-turn";
    default:
      return "other";
  }
}

template <class Number>
std::string head(const spec::Event<Number>& event) {
  const std::string line = std::to_string(event.line) + ' ';
  if (event.kind == spec::EventKind::move) return line + cause_name(event.cause);
  if (event.kind == spec::EventKind::sample)
    return line + "t=" + std::to_string(event.t_numerator) + '/' + std::to_string(event.t_denominator);
  return line + std::string(event.number.view());
}

template <class Number>
std::optional<double> value(const spec::Event<Number>& event, char key, const spec::Axes& axes) {
  if (axes.has(key)) return number(event.axes[axes.index(key)]);
  if (key >= 'x' && key <= 'z') return number(event.point[axes.index(static_cast<char>(key - 'x' + 'X'))]);
  if (key >= 'i' && key <= 'k' && event.tool_axis)
    return number(event.tool_axis->at(static_cast<std::size_t>(key - 'i')));
  return std::nullopt;
}

// How far from the printed figure the value may be.
inline double allowed(const std::string& figure, bool rounded_input, double least) {
  const std::size_t point = figure.find('.');
  const std::size_t decimals = point == std::string::npos ? 0 : figure.size() - point - 1;
  constexpr std::size_t kRounded = 9;
  const double last_digit = decimals < kRounded ? 0 : 0.6 * std::pow(10.0, -static_cast<double>(decimals));
  constexpr double kTwelve = 1e-12;
  const double scale = 1 + std::abs(std::stod(figure));
  return std::max(last_digit, (rounded_input ? 5 * kTwelve : least) * scale);
}

template <class Number>
void expect_events(const std::vector<spec::Event<Number>>& events, const Rows& rows, const spec::Axes& axes) {
  constexpr double kFast = 1e-13;
  constexpr double kModel = 2e-15;
  constexpr double least = std::is_same_v<Number, double> ? kFast : kModel;
  ASSERT_EQ(events.size(), rows.size());
  for (std::size_t n = 0; n < rows.size(); ++n) {
    SCOPED_TRACE(rows[n]);
    const std::vector<std::string> tokens = rows::tokens(rows[n]);
    EXPECT_EQ(head(events[n]), tokens.at(0) + ' ' + tokens.at(1));
    const bool rounded_input = tokens.back() == "~";
    for (std::size_t i = 2; i < tokens.size() - (rounded_input ? 1 : 0); ++i) {
      const auto actual = value(events[n], tokens[i].at(0), axes);
      ASSERT_TRUE(actual) << tokens[i];
      const std::string figure = tokens[i].substr(2);
      EXPECT_NEAR(*actual, std::stod(figure), allowed(figure, rounded_input, least)) << tokens[i];
    }
  }
}

inline void expect(const std::string& section, const std::string& name, const std::vector<worked::Example>& table) {
  worked::expect(section, name, table, [](const auto& events, const Rows& rows, const spec::Case& c) {
    expect_events(events, rows, c.setup.axes);
  });
}

}  // namespace toolcomp::corpus::poses
