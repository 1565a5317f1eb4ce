// The compensated path as a plain program: G00 G01 G02 G03 with axis words, all compensation worked in.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "spec/language/event.h"
#include "spec/language/event_names.h"
#include "spec/language/json_text.h"
#include "spec/language/setup.h"

namespace toolcomp::spec {

// Writes the `axes` of every move, absolute, in the workpiece coordinate system the move was made in (events do not say
// when G54 to G59 change: a program that changes them needs its own origins set). Alarms, warnings and settings become
// comments; samples are left out. Number needs a binary minus, for the I J K of arcs.
template <class Number, class AppendNumber>
class GcodeWriter {
 public:
  // `start` is where the first move starts, for the I J K of an arc that comes first.
  GcodeWriter(const Setup& setup, const AxisValues<Number>& start, AppendNumber append_number)
      : axes_(setup.axes), units_(setup.units), at_(start), append_number_(std::move(append_number)) {}

  void begin(std::string& out) const { out += units_ == Units::mm ? "%\nG90 G94 G21\n" : "%\nG90 G94 G20\n"; }
  void end(std::string& out) const { out += "M30\n%\n"; }

  void write(std::string& out, const Event<Number>& event) {
    switch (event.kind) {
      case EventKind::move:
        move(out, event);
        break;
      case EventKind::alarm:
      case EventKind::warning:
        open_comment(out, event, event.number.view());
        if (*event.message != '\0') out += ": ";
        comment_text(out, event.message);
        out += ")\n";
        break;
      case EventKind::setting:
        open_comment(out, event, event.setting.view());
        out += " = ";
        append_number_(out, event.value);
        out += ")\n";
        break;
      case EventKind::undecided:
        open_comment(out, event, "undecided");
        out += ": ";
        comment_text(out, event.number.view());
        out += ")\n";
        break;
      case EventKind::sample:
        break;
    }
  }

 private:
  void word(std::string& out, char address, const Number& value) const {
    out += ' ';
    out += address;
    append_number_(out, value);
  }

  void move(std::string& out, const Event<Number>& event) {
    if (event.n) {
      out += 'N';
      append_integer(out, *event.n);
      out += ' ';
    }
    const bool arc = event.type == MoveType::arc && event.arc;
    out += arc ? arc_code(*event.arc) : event.type == MoveType::rapid ? "G00" : "G01";
    for (std::size_t axis = 0; axis < axes_.size(); ++axis)
      if (event.axes.has(axis)) word(out, axes_.letter(axis), event.axes[axis]);
    if (arc) center(out, *event.arc);
    if (event.feed && event.type != MoveType::rapid) word(out, 'F', *event.feed);
    out += '\n';
    for (std::size_t axis = 0; axis < axes_.size(); ++axis)
      if (event.point.has(axis)) at_.set(axis, event.point[axis]);
  }

  // The centre belongs to `point`; so does the start it is counted from.
  void center(std::string& out, const Arc<Number>& arc) const {
    constexpr std::string_view kLetters = "XYZ";
    constexpr std::string_view kAddresses = "IJK";
    for (std::size_t i = 0; i < kLetters.size(); ++i) {
      const std::size_t axis = axes_.index(kLetters[i]);
      const bool in_plane = name(arc.plane).find(kLetters[i]) != std::string_view::npos;
      if (in_plane && axis < axes_.size() && arc.center.has(axis) && at_.has(axis))
        word(out, kAddresses[i], arc.center[axis] - at_[axis]);
    }
  }

  static std::string_view arc_code(const Arc<Number>& arc) {
    constexpr std::string_view kCodes[2][3] = {{"G17 G02", "G18 G02", "G19 G02"}, {"G17 G03", "G18 G03", "G19 G03"}};
    return kCodes[static_cast<std::size_t>(arc.direction)][static_cast<std::size_t>(arc.plane)];
  }

  void open_comment(std::string& out, const Event<Number>& event, std::string_view what) const {
    out += "(line ";
    append_integer(out, event.line);
    out += ": ";
    comment_text(out, what);
  }
  // Text that cannot end the comment.
  static void comment_text(std::string& out, std::string_view text) {
    for (const char c : text) out += c == '(' ? '[' : c == ')' ? ']' : c;
  }

  Axes axes_;
  Units units_;
  AxisValues<Number> at_;  // of the tool point
  AppendNumber append_number_;
};

}  // namespace toolcomp::spec
