// Vectors written by hand against rows of figures: each number is compared to as many decimals as the row prints.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "corpus/golden.h"

namespace toolcomp::corpus::rows {

// "1 s G0 22 46" is a move of line 1: cause (p programmed, s start-up, c corner, e cancel, r reference, m measure),
// kind (G0 rapid, G1 linear, G2 G3 arcs), then the point's X Y, and Z where the row has a third number. An arc goes on
// with "O" and its centre, "r" and two radii where they differ, "w" and its sweep: "3 p G2 70 -40 O 10 -40 w 90". An
// alarm is "2 PS0033", a setting "4 H1.wear=-2".
using Rows = std::vector<std::string>;

struct Expected {
  const char* comment;  // how the vector's comment begins
  Rows rows;
};

// A decimal rounded to `places`, ties up or down; -0 is 0.
inline std::string rounded(const std::string& value, std::size_t places, bool ties_up = true) {
  const bool negative = value.starts_with('-');
  const std::size_t point = value.find('.');
  std::string whole = value.substr(negative ? 1 : 0, point - (negative ? 1 : 0));
  std::string part = point == std::string::npos ? "" : value.substr(point + 1);
  part.resize(std::max(part.size(), places + 1), '0');
  const bool tie = part[places] == '5' && part.find_first_not_of('0', places + 1) == std::string::npos;
  const bool up = part[places] >= '5' && (ties_up || !tie);
  std::string all = "0" + whole + part.substr(0, places);
  for (std::size_t i = all.size(); up && i > 0; --i) {
    if (all[i - 1] != '9') {
      ++all[i - 1];
      break;
    }
    all[i - 1] = '0';
  }
  whole = all.substr(0, all.size() - places);
  part = all.substr(all.size() - places);
  whole.erase(0, std::min(whole.find_first_not_of('0'), whole.size() - 1));
  while (part.ends_with('0')) part.pop_back();
  const std::string text = part.empty() ? whole : whole + '.' + part;
  return (negative && text != "0" ? "-" : "") + text;
}

inline std::vector<std::string> tokens(const std::string& row) {
  std::istringstream in(row);
  std::vector<std::string> list;
  for (std::string token; in >> token;) list.push_back(token);
  return list;
}

// The actual value printed as the token expected in its place is; a token with few decimals means itself exactly. The
// actual value is itself rounded to 15 places, so that what looks like a tie may have been either side of it.
inline std::string as(const std::string& actual, const std::vector<std::string>& row, std::size_t place) {
  constexpr std::size_t kAll = 15;
  constexpr std::size_t kRounded = 9;  // a token with as many decimals is a rounded number
  const std::size_t point = place < row.size() ? row[place].find('.') : std::string::npos;
  const std::size_t places = point == std::string::npos ? 0 : row[place].size() - point - 1;
  if (places < kRounded) return rounded(actual, kAll);
  const std::string down = rounded(actual, places, false);
  return down == row[place] ? down : rounded(actual, places);
}

inline char cause_letter(spec::Cause cause) {
  switch (cause) {
    case spec::Cause::start_up:
      return 's';
    case spec::Cause::corner:
      return 'c';
    case spec::Cause::cancel:
      return 'e';
    case spec::Cause::reference:
      return 'r';
    case spec::Cause::measure:
      return 'm';
    default:
      return 'p';
  }
}

inline std::string kind(const spec::TextEvent& event) {
  if (event.type == spec::MoveType::rapid) return "G0";
  if (event.type == spec::MoveType::linear || !event.arc) return "G1";
  return event.arc->direction == spec::ArcDirection::cw ? "G2" : "G3";
}

// The event in the form of the row expected of it, numbers with that row's decimals.
inline std::string shown(const spec::TextEvent& event, const std::string& expected, const spec::Axes& axes) {
  const std::vector<std::string> row = tokens(expected);
  std::string line = std::to_string(event.line);
  if (event.kind == spec::EventKind::setting)
    return line + ' ' + std::string(event.setting.view()) + '=' + event.value.v;
  if (event.kind != spec::EventKind::move) return line + ' ' + std::string(event.number.view());
  line += std::string(" ") + cause_letter(event.cause) + ' ' + kind(event);
  std::size_t place = 3;
  const auto add = [&](const std::string& value) { line += ' ' + as(value, row, place++); };
  const auto has = [&](const char* letter) { return place < row.size() && row[place] == letter; };
  for (const char letter : {'X', 'Y', 'Z'})
    if (letter != 'Z' || (place < row.size() && !has("O"))) add(event.point[axes.index(letter)].v);
  if (!event.arc) return line;
  line += " O";
  ++place;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (event.arc->center.has(i)) add(event.arc->center[i].v);
  if (event.arc->radius) {
    line += " r";
    ++place;
    add(event.arc->radius->first.v);
    add(event.arc->radius->second.v);
  }
  if (has("w")) {
    line += " w";
    ++place;
    add(event.arc->sweep ? event.arc->sweep->v : "0");
  }
  return line;
}

inline Rows shown(const spec::Case& c, const Rows& expected) {
  Rows rows;
  for (std::size_t i = 0; i < c.expect.size(); ++i)
    rows.push_back(shown(c.expect[i], i < expected.size() ? expected[i] : "", c.setup.axes));
  return rows;
}

// The vectors of one file, golden/SECTION/NAME.jsonl.
inline const std::vector<spec::Case>& file(const std::string& section, const std::string& name) {
  static std::map<std::string, std::vector<spec::Case>> files;
  auto [found, fresh] = files.try_emplace(section + '/' + name);
  if (fresh) found->second = read_cases(default_folder() / section / (name + ".jsonl"));
  return found->second;
}

// Every row of the table holds one vector of the file, and every vector is held.
inline void expect(const std::string& section, const std::string& name, const std::vector<Expected>& table) {
  const std::vector<spec::Case>& vectors = file(section, name);
  EXPECT_EQ(vectors.size(), table.size()) << section << '/' << name;
  for (const Expected& row : table) {
    SCOPED_TRACE(row.comment);
    const auto begins = [&](const spec::Case& c) { return c.comment.starts_with(row.comment); };
    ASSERT_EQ(std::ranges::count_if(vectors, begins), 1);
    EXPECT_EQ(shown(*std::ranges::find_if(vectors, begins), row.rows), row.rows);
  }
}

}  // namespace toolcomp::corpus::rows
