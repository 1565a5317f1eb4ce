// SPDX-License-Identifier: Apache-2.0
// Events as CSV (RFC 4180, lines end with a line feed): one row for each event, one column for each number. Writing a
// move allocates only the text itself.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "spec/language/alarm.h"
#include "spec/language/event.h"
#include "spec/language/event_names.h"
#include "spec/language/json_text.h"
#include "spec/language/setup.h"

namespace toolcomp::spec {

// Appends `text`, in quotes if it contains a comma, a quote or a line feed.
void append_csv_text(std::string& out, std::string_view text);

// The names of the columns for a setup with these axes: kind, line, n, type, cause, programmed.X, … With
// Control::heidenhain the columns of 3D tool compensation come before feed, and `reason` comes before clauses.
void append_csv_header(std::string& out, const Axes& axes, Control control = Control::fanuc);

// Writes the columns of one event.
template <class Text, class Number, class AppendNumber>
class EventCsv {
 public:
  EventCsv(Text& out, const Axes& axes, const AppendNumber& append_number, Control control)
      : out_(out), axes_(axes), append_number_(append_number), space_(control == Control::heidenhain) {}

  void write(const Event<Number>& event) {
    const bool move = event.kind == EventKind::move;
    out_ += name(event.kind);
    next();
    append_integer(out_, event.line);
    next();
    if (event.n) append_integer(out_, *event.n);
    next();
    if (move) out_ += name(event.type);
    next();
    if (move) out_ += name(event.cause);
    if (event.alarm != AlarmCause::none) out_ += info(event.alarm).name;
    next();
    values(event.programmed, true);
    values(event.point, true);
    values(event.axes, false);
    values(event.machine, false);
    vector(event.tool_axis ? &*event.tool_axis : nullptr);
    arc(event.arc);
    if (space_) space(event.space ? &*event.space : nullptr);
    if (event.feed) append_number_(out_, *event.feed);
    next();
    if (space_) unknown(event.unknown);
    text(event.number.view());
    next();
    text(event.message);
    next();
    text(event.setting.view());
    next();
    if (event.kind == EventKind::setting) append_number_(out_, event.value);
    next();
    hole(event.hole ? &*event.hole : nullptr);
    if (event.kind == EventKind::sample) {
      append_integer(out_, event.t_numerator);
      out_ += '/';
      append_integer(out_, event.t_denominator);
    }
    next();
    if (space_) {
      if (event.out_of_scope) out_ += kOutOfScope;
      next();
    }
    clauses(event.clauses);
    out_ += '\n';
  }

 private:
  void next() { out_ += ','; }

  template <class List>
  void clauses(const List& list) {
    if (list.empty()) return;
    std::string ids;
    for (const Clause clause : list) {
      if (!ids.empty()) ids += ' ';
      ids += info(clause).id;
    }
    out_.append(ids);
  }

  void text(std::string_view value) {
    if (value.empty()) return;
    std::string quoted;
    append_csv_text(quoted, value);
    out_.append(quoted);
  }

  void values(const AxisValues<Number>& values, bool linear_only) {
    for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
      if (linear_only && !is_linear_axis(axes_.letter(axis))) continue;
      if (values.has(axis)) append_number_(out_, values[axis]);
      next();
    }
  }

  // Three columns. They are empty without a vector.
  void vector(const std::array<Number, 3>* vector) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (vector != nullptr) append_number_(out_, (*vector)[i]);
      next();
    }
  }

  void unknown(std::uint16_t axes) {
    for (std::size_t axis = 0; axis < axes_.size(); ++axis)
      if ((axes >> axis & 1U) != 0) out_ += axes_.letter(axis);
    next();
  }

  void hole(const Hole<Number>* hole) {
    for (const auto member : {&Hole<Number>::point_r, &Hole<Number>::bottom, &Hole<Number>::level}) {
      if (hole != nullptr) append_number_(out_, hole->*member);
      next();
    }
  }

  void space(const SpaceCompensation<Number>* space) {
    const Contact<Number>* const contact = space != nullptr && space->contact ? &*space->contact : nullptr;
    vector(space != nullptr ? &space->tool_center : nullptr);
    vector(contact != nullptr ? &contact->point : nullptr);
    vector(contact != nullptr ? &contact->normal : nullptr);
    vector(space != nullptr ? &space->shift : nullptr);
    vector(space != nullptr ? &space->tool_shift : nullptr);
    vector(space != nullptr && space->carrier ? &*space->carrier : nullptr);
    if (contact != nullptr && contact->angle) append_number_(out_, *contact->angle);
    next();
    if (contact != nullptr && contact->flat) out_ += "true";
    next();
  }

  void arc(const std::optional<Arc<Number>>& arc) {
    values(arc ? arc->center : AxisValues<Number>{}, true);
    if (arc) out_ += name(arc->plane);
    next();
    if (arc) out_ += name(arc->direction);
    next();
    if (arc && arc->sweep) append_number_(out_, *arc->sweep);
    next();
    if (arc && arc->radius) append_number_(out_, arc->radius->first);
    next();
    if (arc && arc->radius) append_number_(out_, arc->radius->second);
    next();
  }

  Text& out_;
  const Axes& axes_;
  const AppendNumber& append_number_;
  bool space_;  // with the columns of 3D tool compensation
};

// Appends the event to a std::string or TextCursor as one row with its line feed; append_number(out, value) appends one
// number. `control` is that of the header.
template <class Text, class Number, class AppendNumber>
void append_event_csv(Text& out, const Event<Number>& event, const Axes& axes, const AppendNumber& append_number,
                      Control control = Control::fanuc) {
  EventCsv<Text, Number, AppendNumber>(out, axes, append_number, control).write(event);
}

}  // namespace toolcomp::spec
