// SPDX-License-Identifier: Apache-2.0
// Worked examples against rows of figures: each number is compared to as many decimals as the row prints.
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "fast/basis/print.h"
#include "spec/language/event_names.h"
#include "tests/golden/worked_examples.h"

namespace toolcomp::corpus::rows {

using worked::Rows;

// "1 s G0 22 46" is a move of line 1: cause (p programmed, s start-up, c corner, e cancel, r reference, m measure),
// kind (G0 rapid, G1 linear, G2 G3 arcs), then the point's X Y, and Z where the row has a third number. With letters,
// "1 p G0 X22 Y46 Z120", the numbers are what the axes are sent to; cause, or cause and kind, may be left out of such a
// row and are not looked at: "2 G0 X22 Y46 Z120", "2 X22 Y46 Z120". An arc goes on with "O" and its centre, "r" and two
// radii where they differ, "w" and its sweep: "3 p G2 70 -40 O 10 -40 w 90". An alarm is "2 PS0033", a setting
// "4 H1.wear=-2". A hole is "5 hole 10 20 r 3 b -15 t 50 X10 Y20 Z150": position, point R, bottom, level of return,
// axes.

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

inline std::string as(const spec::NumberText& actual, const std::vector<std::string>& row, std::size_t place) {
  return as(actual.v, row, place);
}

// A double within rounding of the token is the token: some operations on numbers of the size of the coordinates.
inline std::string as(double actual, const std::vector<std::string>& row, std::size_t place) {
  constexpr double kRelative = 1e-13;
  constexpr double kSize = 10;
  if (place < row.size() && !row[place].empty()) {
    const double expected = std::strtod(row[place].c_str(), nullptr);
    const std::size_t point = row[place].find('.');
    const double last_digit =
        point == std::string::npos ? 0 : std::pow(10.0, -static_cast<double>(row[place].size() - point - 1));
    constexpr double kRounded = 1e-9;  // a token with as many decimals is a rounded number
    const double allowed = kRelative * (kSize + std::abs(expected)) + (last_digit <= kRounded ? last_digit / 2 : 0);
    if (std::abs(actual - expected) <= allowed) return rounded(row[place], row[place].size());
  }
  std::string text;
  fast::append_number(text, actual);
  return text;
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

template <class Number>
std::string kind(const spec::Event<Number>& event) {
  if (event.type == spec::MoveType::rapid) return "G0";
  if (event.type == spec::MoveType::linear || !event.arc) return "G1";
  return event.arc->direction == spec::ArcDirection::cw ? "G2" : "G3";
}

// Whether a token of a row is what one axis is sent to: "X120".
inline bool is_axis(const std::string& token, const spec::Axes& axes) {
  return token.size() > 1 && axes.has(token[0]) && token.find_first_not_of("-.0123456789", 1) == std::string::npos;
}

// The event in the form of the row expected of it, numbers with that row's decimals.
template <class Number>
class Shown {
 public:
  Shown(const spec::Event<Number>& event, const std::string& expected, const spec::Axes& axes)
      : event_(event), axes_(axes), row_(tokens(expected)) {}

  std::string text() {
    line_ = std::to_string(event_.line);
    if (event_.kind == spec::EventKind::setting) {
      const std::size_t equals = row_.size() > 1 ? row_[1].find('=') : std::string::npos;
      const std::vector<std::string> value{equals == std::string::npos ? "" : row_[1].substr(equals + 1)};
      return line_ + ' ' + std::string(event_.setting.view()) + '=' + as(event_.value, value, 0);
    }
    if (event_.kind != spec::EventKind::alarm && spec::ends_run(event_.kind))
      return line_ + ' ' + std::string(spec::name(event_.kind)) + ' ' + std::string(event_.number.view());
    if (event_.hole) return hole();
    if (event_.kind != spec::EventKind::move) return line_ + ' ' + std::string(event_.number.view());
    const bool by_axes = head();
    by_axes ? axes() : point();
    if (event_.arc && (!by_axes || has("O"))) arc();
    return line_;
  }

 private:
  [[nodiscard]] bool has(const std::string& token) const { return place_ < row_.size() && row_[place_] == token; }
  [[nodiscard]] bool has_axis() const { return place_ < row_.size() && is_axis(row_[place_], axes_); }
  void add(const std::string& token) {
    line_ += ' ' + token;
    ++place_;
  }
  void add(const Number& value) { add(as(value, row_, place_)); }

  // Cause and kind, as far as the row has them. True if it goes on with axes.
  bool head() {
    std::size_t first = 1;
    while (first < row_.size() && first < 3 && !is_axis(row_[first], axes_)) ++first;
    const bool by_axes = first < row_.size() && is_axis(row_[first], axes_);
    if (!by_axes || first == 3) add(std::string(1, cause_letter(event_.cause)));
    if (!by_axes || first >= 2) add(kind(event_));
    return by_axes;
  }
  void axes() {
    while (has_axis()) {
      const char letter = row_[place_][0];
      const std::vector<std::string> figure{row_[place_].substr(1)};
      add(letter + as(event_.axes[axes_.index(letter)], figure, 0));
    }
  }
  std::string hole() {
    add("hole");
    for (std::size_t i = 0; i < axes_.size(); ++i)
      if (event_.point.has(i)) add(event_.point[i]);
    add("r");
    add(event_.hole->point_r);
    add("b");
    add(event_.hole->bottom);
    add("t");
    add(event_.hole->level);
    axes();
    return line_;
  }
  void point() {
    for (const char letter : {'X', 'Y', 'Z'})
      if (letter != 'Z' || (place_ < row_.size() && !has("O"))) add(event_.point[axes_.index(letter)]);
  }
  void arc() {
    add("O");
    for (std::size_t i = 0; i < axes_.size(); ++i)
      if (event_.arc->center.has(i)) add(event_.arc->center[i]);
    if (event_.arc->radius) {
      add("r");
      add(event_.arc->radius->first);
      add(event_.arc->radius->second);
    }
    if (!has("w")) return;
    add("w");
    event_.arc->sweep ? add(*event_.arc->sweep) : add("0");
  }

  const spec::Event<Number>& event_;
  const spec::Axes& axes_;
  std::vector<std::string> row_;
  std::string line_;
  std::size_t place_ = 1;
};

template <class Number>
Rows shown(const std::vector<spec::Event<Number>>& events, const Rows& expected, const spec::Axes& axes) {
  Rows rows;
  for (std::size_t i = 0; i < events.size(); ++i)
    rows.push_back(Shown(events[i], i < expected.size() ? expected[i] : "", axes).text());
  return rows;
}

inline void expect(const std::string& section, const std::string& name, const std::vector<worked::Example>& table) {
  worked::expect(section, name, table, [](const auto& events, const Rows& rows, const spec::Case& c) {
    EXPECT_EQ(shown(events, rows, c.setup.axes), rows);
  });
}

}  // namespace toolcomp::corpus::rows
