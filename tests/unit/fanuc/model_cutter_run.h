// SPDX-License-Identifier: Apache-2.0
// Runs a program in the exact engine and looks at the heads of its compensation vectors, so that a test reads like a
// table of them.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "tests/unit/model_run.h"

namespace toolcomp::test {

using Point = std::pair<double, double>;
using Points = std::vector<Point>;

inline double value(const exact::Real& number) { return std::strtod(number.decimal(17).c_str(), nullptr); }

// D1 = 10 with its relatives; `parameters` are lines such as "\"5003#0\" = 1".
inline std::string cutter_setup(const std::string& parameters = "", const std::string& more = "") {
  return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n" + parameters +
         "\n[offsets.D]\n1 = 10\n2 = 5\n3 = -10\n4 = 0\n5 = 20\n6 = \"17.5\"\n7 = 2\n8 = -5\n9 = 15\n[offsets.H]\n1 = "
         "50\n" +
         more;
}

// Where the moves of a run end, X and Y, from the first one at or behind `line` on.
inline Points points_from(const Run& run, std::uint64_t line = 1) {
  Points points;
  for (const model::Event& event : run.events())
    if (event.kind == spec::EventKind::move && event.line >= line)
      points.emplace_back(value(event.point[0]), value(event.point[1]));
  return points;
}

// The heads at a corner: the points of the moves programmed there, in order.
inline Points heads_at(const Run& run, Point corner) {
  Points points;
  for (const model::Event& event : run.events())
    if (event.kind == spec::EventKind::move && Point(value(event.programmed[0]), value(event.programmed[1])) == corner)
      points.emplace_back(value(event.point[0]), value(event.point[1]));
  return points;
}

// Figures typed in have 16 digits: twelve decimals or more.
inline void expect_points(const Points& expected, const Points& actual, const std::string& what) {
  std::string seen;
  for (const Point& point : actual)
    seen += '(' + std::to_string(point.first) + ", " + std::to_string(point.second) + ')';
  ASSERT_EQ(expected.size(), actual.size()) << what << ": " << seen;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(expected[i].first, actual[i].first, 1e-12) << what << ": " << seen;
    EXPECT_NEAR(expected[i].second, actual[i].second, 1e-12) << what << ": " << seen;
  }
}

// "7 PS0041" or "" where the run ends without an alarm.
inline std::string alarm(const Run& run) {
  const model::Event& last = run.events().back();
  if (last.kind == spec::EventKind::move || last.kind == spec::EventKind::setting) return "";
  return std::to_string(last.line) + ' ' + std::string(last.number.view());
}

}  // namespace toolcomp::test
