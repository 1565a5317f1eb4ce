// SPDX-License-Identifier: Apache-2.0
#include "corpus/proofs/rows.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "spec/language/alarm.h"
#include "spec/language/axes.h"

namespace toolcomp::corpus {
namespace {

using spec::EventKind;
using spec::NumberText;
using spec::TextEvent;

// "-12.5e-3" as its digits and how many of them stand behind the point: "(-125) 4".
std::string decimal_term(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  int behind = 0;
  if (const std::size_t e = text.find('e'); e != std::string_view::npos) {
    behind = -std::stoi(std::string(text.substr(e + 1)));
    text = text.substr(0, e);
  }
  std::string digits;
  bool point = false;
  for (const char c : text) {
    if (c == '.') {
      point = true;
      continue;
    }
    digits += c;
    if (point) ++behind;
  }
  for (; behind < 0; ++behind) digits += '0';
  return fmt::format("({}{}) {}", negative ? "-" : "", digits, behind);
}

// Marks, one behind the other.
class Row {
 public:
  void opens() { mark("Opens"); }
  void closes() { mark("Closes"); }
  void whole(std::size_t value) { mark(fmt::format("SaidWhole {}", value)); }
  void flag(bool value) { whole(value ? 1 : 0); }
  void text(std::string_view value) { mark(fmt::format("SaidText \"{}\"", value)); }

  void number(const NumberText& value) {
    if (value.q.empty())
      return mark(fmt::format("Numbered (Within {} {})", decimal_term(value.v), decimal_term(value.r)));
    const std::size_t bar = value.q.find('/');
    mark(fmt::format("Numbered (Fraction ({}) {})", value.q.substr(0, bar), value.q.substr(bar + 1)));
  }

  // Opens, what `inside` writes, closes.
  template <class Inside>
  void several(const Inside& inside) {
    opens();
    inside();
    closes();
  }
  template <class Part, class Inside>
  void maybe(const std::optional<Part>& part, const Inside& inside) {
    several([&] {
      if (part) inside(*part);
    });
  }
  void vector(const std::array<NumberText, 3>& v) {
    several([&] {
      for (const NumberText& value : v) number(value);
    });
  }
  void axes(const spec::AxisValues<NumberText>& values, const spec::Axes& axes, bool linear_alone) {
    several([&] {
      for (std::size_t i = 0; i < axes.size(); ++i)
        if (values.has(i) && (!linear_alone || spec::is_linear_axis(axes.letter(i)))) number(values[i]);
    });
  }

  [[nodiscard]] std::string term() const { return '[' + text_ + ']'; }

 private:
  void mark(std::string_view said) {
    if (!text_.empty()) text_ += "; ";
    text_ += said;
  }
  std::string text_;
};

void write_arc(Row& row, const TextEvent& event, const spec::Axes& axes) {
  constexpr std::array<std::string_view, 3> kAxes{"XY", "ZX", "YZ"};
  row.maybe(event.arc, [&](const spec::Arc<NumberText>& arc) {
    const auto plane = static_cast<std::size_t>(arc.plane);
    row.several([&] {
      row.several([&] {
        for (const char letter : kAxes.at(plane))
          if (const std::size_t axis = axes.index(letter); axis != spec::Axes::kNone) row.number(arc.center[axis]);
      });
      row.whole(plane);
      row.maybe(arc.sweep, [&](const NumberText& sweep) { row.number(sweep); });
      row.maybe(arc.radius, [&](const std::pair<NumberText, NumberText>& radii) {
        row.several([&] {
          row.number(radii.first);
          row.number(radii.second);
        });
      });
    });
  });
}

void write_feed(Row& row, const TextEvent& event) {
  row.maybe(event.feed, [&](const NumberText& feed) { row.number(feed); });
}

// As tell_move of FanucCase.v.
void write_fanuc_move(Row& row, const TextEvent& event, const spec::Axes& axes) {
  const bool clockwise = event.arc && event.arc->direction == spec::ArcDirection::cw;
  constexpr std::size_t kClockwise = 2;
  constexpr std::size_t kCounterclockwise = 3;
  const std::size_t arc = clockwise ? kClockwise : kCounterclockwise;
  row.whole(event.type == spec::MoveType::rapid ? 0 : event.type == spec::MoveType::linear ? 1 : arc);
  row.whole(static_cast<std::size_t>(event.cause));
  row.axes(event.programmed, axes, true);
  row.axes(event.point, axes, true);
  row.axes(event.axes, axes, false);
  row.several([&] {
    if (event.machine.has(0)) row.axes(event.machine, axes, false);
  });
  write_arc(row, event, axes);
  write_feed(row, event);
  row.maybe(event.tool_axis, [&](const std::array<NumberText, 3>& axis) { row.vector(axis); });
}

// What 3D compensation makes of the tool: five fields of a move.
void write_space(Row& row, const spec::SpaceCompensation<NumberText>& space) {
  row.vector(space.tool_center);
  row.vector(space.shift);
  row.vector(space.tool_shift);
  row.maybe(space.carrier, [&](const auto& carrier) { row.vector(carrier); });
  row.maybe(space.contact, [&](const spec::Contact<NumberText>& contact) {
    row.several([&] {
      row.vector(contact.point);
      row.vector(contact.normal);
      row.flag(contact.flat);
      row.maybe(contact.angle, [&](const NumberText& angle) { row.number(angle); });
    });
  });
}

// As tell_klartext_move of KlartextCase.v: no coordinate of an axis that is not known, and then no vector of the tool.
void write_klartext_move(Row& row, const TextEvent& event, const spec::Axes& axes) {
  row.flag(event.type == spec::MoveType::rapid);
  row.whole(static_cast<std::size_t>(event.cause));
  row.axes(event.programmed, axes, true);
  row.axes(event.point, axes, true);
  row.several([&] {
    for (std::size_t i = 0; i < axes.size(); ++i)
      row.several([&] {
        if (event.axes.has(i)) row.number(event.axes[i]);
      });
  });
  row.vector(event.tool_axis.value());
  if (event.unknown == 0) {
    write_space(row, event.space.value());
  } else {
    constexpr std::size_t kFields = 5;
    for (std::size_t i = 0; i < kFields; ++i) row.several([] {});
  }
  write_feed(row, event);
  row.several([&] {
    for (std::size_t i = 0; i < axes.size(); ++i) row.flag((event.unknown >> i & 1U) != 0);
  });
}

// As tell_hole of Data.v; Klartext tells the linear axes alone. The drilling axis is the linear one that `point` lacks.
void write_hole(Row& row, const TextEvent& event, const spec::Axes& axes) {
  const spec::Hole<NumberText>& hole = event.hole.value();
  std::size_t drilled = 0;
  while (drilled < axes.size() && (!spec::is_linear_axis(axes.letter(drilled)) || event.point.has(drilled))) ++drilled;
  row.axes(event.point, axes, true);
  row.number(hole.point_r);
  row.number(hole.bottom);
  row.number(hole.level);
  row.axes(event.axes, axes, false);
  row.whole(drilled);
}

// The kinds of both dialects, by their places.
void write_event(Row& row, const TextEvent& event, const spec::Case& c) {
  enum Kind : std::size_t { kMove, kSettingOrWarning, kAlarm, kUndecided, kOther, kSample, kHole };
  const bool fanuc = c.dialect == "fanuc";
  switch (event.kind) {
    case EventKind::move:
      row.whole(kMove);
      fanuc ? write_fanuc_move(row, event, c.setup.axes) : write_klartext_move(row, event, c.setup.axes);
      break;
    case EventKind::sample:
      row.whole(kSample);
      row.whole(event.t_numerator);
      row.whole(event.t_denominator);
      row.axes(event.point, c.setup.axes, true);
      row.axes(event.axes, c.setup.axes, false);
      row.vector(event.tool_axis.value());
      break;
    case EventKind::hole:
      row.whole(kHole);
      write_hole(row, event, c.setup.axes);
      break;
    case EventKind::setting:
      row.whole(kSettingOrWarning);
      row.text(event.setting.view());
      row.number(event.value);
      break;
    case EventKind::warning:
      row.whole(fanuc ? kOther : kSettingOrWarning);
      row.text(event.number.view());
      break;
    case EventKind::alarm:
      row.whole(kAlarm);
      row.text(event.alarm == spec::AlarmCause::none ? event.number.view() : info(event.alarm).name);
      break;
    case EventKind::not_supported:
    case EventKind::not_judged:
      row.whole(kAlarm);
      row.text(event.kind == EventKind::not_judged ? "not-judged" : "not-supported");
      break;
    default:
      if (event.out_of_scope) return row.whole(kOther);
      row.whole(kUndecided);
      row.text(event.number.view());
  }
}

}  // namespace

std::string data_term(const spec_engine::Data& data) {
  return std::visit(
      [](const auto& value) -> std::string {
        using Kind = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Kind, std::int64_t>) {
          return fmt::format("Whole ({})", value);
        } else if constexpr (std::is_same_v<Kind, std::string>) {
          return fmt::format("Text \"{}\"", value);
        } else if constexpr (std::is_same_v<Kind, spec_engine::List>) {
          std::string entries;
          for (const spec_engine::Data& entry : value) entries += (entries.empty() ? "" : "; ") + data_term(entry);
          return "Tree [" + entries + ']';
        } else {
          return {};  // no case has a number that is no decimal
        }
      },
      data.value);
}

std::string row_term(const spec::Case& c, const std::vector<spec_engine::Place>& places) {
  Row row;
  std::size_t place = 0;
  row.several([&] {
    for (const TextEvent& event : c.expect) {
      while (place < places.size() && places[place].line != event.line) ++place;
      row.several([&] {
        row.whole(place);
        write_event(row, event, c);
      });
    }
  });
  return row.term();
}

}  // namespace toolcomp::corpus
