// SPDX-License-Identifier: Apache-2.0
// The compensated path as a plain program: G00 G01 G02 G03 with axis words that contain all compensation. Writing a
// move allocates only the text itself.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "spec/language/event.h"
#include "spec/language/event_names.h"
#include "spec/language/json_text.h"
#include "spec/language/setup.h"

namespace toolcomp::spec {

// The text that a program needs before the first event, and after the last event.
void append_gcode_begin(std::string& out, Units units);
void append_gcode_end(std::string& out);

// The state of the writer between events: the tool point, from which I J K of an arc are counted. Begin with the start
// position of the program, or empty. If it is empty, an arc as the first move has no I J K for axes whose start is
// unknown.
template <class Number>
struct GcodeState {
  AxisValues<Number> point;
};

// Writes one event as one line, a hole as four.
template <class Text, class Number, class AppendNumber>
class EventGcode {
 public:
  EventGcode(Text& out, const Axes& axes, const AppendNumber& append_number, GcodeState<Number>& state)
      : out_(out), axes_(axes), append_number_(append_number), state_(state) {}

  void write(const Event<Number>& event) {
    switch (event.kind) {
      case EventKind::move:
        move(event);
        break;
      case EventKind::alarm:
      case EventKind::warning:
        open_comment(event, event.number.view());
        if (*event.message != '\0') out_ += ": ";
        comment_text(event.message);
        out_ += ")\n";
        break;
      case EventKind::setting:
        open_comment(event, event.setting.view());
        out_ += " = ";
        append_number_(out_, event.value);
        out_ += ")\n";
        break;
      case EventKind::undecided:
        open_comment(event, "undecided");
        out_ += ": ";
        comment_text(event.number.view());
        if (event.out_of_scope) {
          out_ += ", ";
          out_ += kOutOfScope;
        }
        out_ += ")\n";
        break;
      case EventKind::not_supported:
      case EventKind::not_judged:
        open_comment(event, name(event.kind));
        out_ += ": ";
        comment_text(event.message);
        out_ += ")\n";
        break;
      case EventKind::hole:
        hole(event);
        break;
      case EventKind::sample:
        break;
    }
  }

 private:
  void word(char address, const Number& value) {
    out_ += ' ';
    out_ += address;
    append_number_(out_, value);
  }

  void move(const Event<Number>& event) {
    if (event.n) {
      out_ += 'N';
      append_integer(out_, *event.n);
      out_ += ' ';
    }
    const bool arc = event.type == MoveType::arc && event.arc;
    out_ += arc ? arc_code(*event.arc) : event.type == MoveType::rapid ? "G00" : "G01";
    for (std::size_t axis = 0; axis < axes_.size(); ++axis)
      if (event.axes.has(axis)) word(axes_.letter(axis), event.axes[axis]);
    if (arc) center(*event.arc);
    if (event.feed && event.type != MoveType::rapid) word('F', *event.feed);
    if (event.unknown != 0) out_ += " (the others are not known)";
    out_ += '\n';
    for (std::size_t axis = 0; axis < axes_.size(); ++axis)
      if (event.point.has(axis)) state_.point.set(axis, event.point[axis]);
  }

  // The drilling axis moves alone, and last. The way to point R, to the bottom and back is the same for all cycles.
  void hole(const Event<Number>& event) {
    if (!event.hole || !event.axes.has(event.hole->axis)) return;
    const Hole<Number>& hole = *event.hole;
    const Number length = event.axes[hole.axis] - hole.level;
    out_ += "G00";
    for (std::size_t axis = 0; axis < axes_.size(); ++axis)
      if (event.axes.has(axis) && axis != hole.axis) word(axes_.letter(axis), event.axes[axis]);
    const char letter = axes_.letter(hole.axis);
    const auto along = [&](std::string_view code, const Number& to) {
      out_ += '\n';
      out_ += code;
      word(letter, to + length);
    };
    along("G00", hole.point_r);
    along("G01", hole.bottom);
    along("G00", hole.level);
    out_ += '\n';
    state_.point = event.point;
    state_.point.set(hole.axis, hole.level);
  }

  // The centre belongs to `point`, and so does the start from which I J K are counted. Their difference is the same for
  // the axes.
  void center(const Arc<Number>& arc) {
    constexpr std::string_view kLetters = "XYZ";
    constexpr std::string_view kAddresses = "IJK";
    const std::size_t normal = 2 - static_cast<std::size_t>(arc.plane);  // of XY, ZX, YZ
    for (std::size_t i = 0; i < kLetters.size(); ++i) {
      const std::size_t axis = axes_.index(kLetters[i]);
      if (i != normal && axis != Axes::kNone && arc.center.has(axis) && state_.point.has(axis))
        word(kAddresses[i], arc.center[axis] - state_.point[axis]);
    }
  }

  static std::string_view arc_code(const Arc<Number>& arc) {
    constexpr std::array<std::string_view, 3> kClockwise{"G17 G02", "G18 G02", "G19 G02"};
    constexpr std::array<std::string_view, 3> kCounterClockwise{"G17 G03", "G18 G03", "G19 G03"};
    const auto plane = static_cast<std::size_t>(arc.plane);
    return arc.direction == ArcDirection::cw ? kClockwise[plane] : kCounterClockwise[plane];
  }

  void open_comment(const Event<Number>& event, std::string_view what) {
    out_ += "(line ";
    append_integer(out_, event.line);
    out_ += ": ";
    comment_text(what);
  }
  // Brackets, so that the text cannot end the comment.
  void comment_text(std::string_view text) {
    std::string bracketed;
    for (const char c : text) bracketed += c == '(' ? '[' : c == ')' ? ']' : c;
    out_.append(bracketed);
  }

  Text& out_;
  const Axes& axes_;
  const AppendNumber& append_number_;
  GcodeState<Number>& state_;
};

// Appends the event to a std::string or TextCursor as one line. A move goes to its `axes`, absolute, in the workpiece
// coordinate system in which it was made (events do not say when G54 to G59 change). A hole is the way to point R, to
// its bottom and back. Alarms, warnings and settings are comments. A sample gives nothing (straight_to makes a move of
// it). append_number(out, value) appends one number without exponent. Number needs an operator -, for I J K.
template <class Text, class Number, class AppendNumber>
void append_event_gcode(Text& out, const Event<Number>& event, const Axes& axes, const AppendNumber& append_number,
                        GcodeState<Number>& state) {
  EventGcode<Text, Number, AppendNumber>(out, axes, append_number, state).write(event);
}

// The move as a straight move to other `axes`, such as those of a sample inside it.
template <class Number>
[[nodiscard]] Event<Number> straight_to(const AxisValues<Number>& axes, const Event<Number>& move) {
  Event<Number> result = move;
  result.axes = axes;
  result.arc.reset();
  if (result.type == MoveType::arc) result.type = MoveType::linear;
  return result;
}

}  // namespace toolcomp::spec
