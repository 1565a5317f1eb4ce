// SPDX-License-Identifier: Apache-2.0
// Events as JSON lines (docs/events.md). Writing a move allocates only the text itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "spec/language/alarm.h"
#include "spec/language/event.h"
#include "spec/language/event_names.h"
#include "spec/language/json_text.h"

namespace toolcomp::spec {

// Writes the fields of one event in the order of golden vectors.
template <class Text, class Number, class AppendNumber>
class EventJson {
 public:
  EventJson(Text& out, const Axes& axes, const AppendNumber& append_number)
      : out_(out), axes_(axes), append_number_(append_number) {}

  void write(const Event<Number>& event) {
    out_ += R"({"kind":)";
    quoted(name(event.kind));
    switch (event.kind) {
      case EventKind::move:
        place(event);
        move(event);
        break;
      case EventKind::sample:
        place(event);
        sample(event);
        break;
      case EventKind::hole:
        place(event);
        hole(event);
        break;
      case EventKind::alarm:
      case EventKind::warning:
        text("number", event.number.view());
        if (event.alarm != AlarmCause::none) word("cause", info(event.alarm).name);
        place(event);
        if (*event.message != '\0') text("message", event.message);
        break;
      case EventKind::not_supported:
      case EventKind::not_judged:
        place(event);
        text("code", event.number.view());
        if (*event.message != '\0') text("message", event.message);
        break;
      case EventKind::setting:
        text("name", event.setting.view());
        number("value", event.value);
        place(event);
        break;
      case EventKind::undecided:
        place(event);
        text("clause", event.number.view());
        permitted(event.permitted);
        if (event.out_of_scope) word("reason", kOutOfScope);
        break;
    }
    clauses(event.clauses);
    out_ += '}';
  }

 private:
  void key(std::string_view field) {
    out_ += ",\"";
    out_ += field;
    out_ += "\":";
  }
  void text(std::string_view field, std::string_view value) {
    key(field);
    std::string quoted;
    append_json_string(quoted, value);
    out_.append(quoted);
  }
  // A name of event_names.h. It needs no escapes.
  void word(std::string_view field, std::string_view name) {
    key(field);
    quoted(name);
  }
  void quoted(std::string_view name) {
    out_ += '"';
    out_ += name;
    out_ += '"';
  }
  void number(std::string_view field, const Number& value) {
    key(field);
    append_number_(out_, value);
  }

  void place(const Event<Number>& event) {
    key("line");
    append_integer(out_, event.line);
    if (!event.n) return;
    key("n");
    append_integer(out_, *event.n);
  }

  void values(std::string_view field, const AxisValues<Number>& values) {
    if (values.empty()) return;
    key(field);
    char separator = '{';
    for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
      if (!values.has(axis)) continue;
      out_ += separator;
      out_ += '"';
      out_ += axes_.letter(axis);
      out_ += "\":";
      append_number_(out_, values[axis]);
      separator = ',';
    }
    out_ += '}';
  }

  void hole(const Event<Number>& event) {
    values("point", event.point);
    if (event.hole) {
      number("r", event.hole->point_r);
      number("bottom", event.hole->bottom);
      number("return", event.hole->level);
    }
    values("axes", event.axes);
  }

  void unknown(std::uint16_t axes) {
    if (axes == 0) return;
    key("unknown");
    char separator = '[';
    for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
      if ((axes >> axis & 1U) == 0) continue;
      out_ += separator;
      out_ += '"';
      out_ += axes_.letter(axis);
      out_ += '"';
      separator = ',';
    }
    out_ += ']';
  }

  void tool_axis(const Event<Number>& event) {
    if (event.tool_axis) direction("tool_axis", *event.tool_axis);
  }

  void direction(std::string_view field, const std::array<Number, 3>& vector) {
    key(field);
    char separator = '[';
    for (const Number& component : vector) {
      out_ += separator;
      append_number_(out_, component);
      separator = ',';
    }
    out_ += ']';
  }

  void vector(std::string_view field, const std::array<Number, 3>& vector) {
    key(field);
    constexpr std::array<std::string_view, 3> kKeys{R"({"X":)", R"(,"Y":)", R"(,"Z":)"};
    for (std::size_t i = 0; i < vector.size(); ++i) {
      out_ += kKeys[i];
      append_number_(out_, vector[i]);
    }
    out_ += '}';
  }

  void space(const SpaceCompensation<Number>& space) {
    vector("tool_center", space.tool_center);
    if (space.contact) {
      vector("contact", space.contact->point);
      direction("normal", space.contact->normal);
    }
    vector("shift", space.shift);
    vector("tool_shift", space.tool_shift);
    if (space.carrier) vector("carrier", *space.carrier);
    if (!space.contact) return;
    if (space.contact->angle) number("angle", *space.contact->angle);
    if (!space.contact->flat) return;
    key("flat");
    out_ += "true";
  }

  void arc(const Arc<Number>& arc) {
    values("center", arc.center);
    word("plane", name(arc.plane));
    word("direction", name(arc.direction));
    if (arc.sweep) number("sweep", *arc.sweep);
    if (!arc.radius) return;
    key("radius");
    out_ += '[';
    append_number_(out_, arc.radius->first);
    out_ += ',';
    append_number_(out_, arc.radius->second);
    out_ += ']';
  }

  void move(const Event<Number>& event) {
    word("type", name(event.type));
    word("cause", name(event.cause));
    values("programmed", event.programmed);
    values("point", event.point);
    values("axes", event.axes);
    values("machine", event.machine);
    unknown(event.unknown);
    tool_axis(event);
    if (event.arc) arc(*event.arc);
    if (event.space) space(*event.space);
    if (event.feed) number("feed", *event.feed);
  }

  void sample(const Event<Number>& event) {
    key("t");
    out_ += '"';
    append_integer(out_, event.t_numerator);
    out_ += '/';
    append_integer(out_, event.t_denominator);
    out_ += '"';
    values("point", event.point);
    values("axes", event.axes);
    values("machine", event.machine);
    tool_axis(event);
  }

  void permitted(const PermittedOutcomes& outcomes) {
    key("permitted");
    char separator = '[';
    const auto add = [&](bool is_permitted, std::string_view outcome) {
      if (!is_permitted) return;
      out_ += separator;
      quoted(outcome);
      separator = ',';
    };
    add(outcomes.positive, "positive");
    add(outcomes.negative, "negative");
    add(outcomes.tie, "tie");
    if (separator == '[') out_ += '[';
    out_ += ']';
  }

  template <class List>
  void clauses(const List& list) {
    if (list.empty()) return;
    key("clauses");
    std::string ids;
    for (const Clause clause : list) {
      ids += ids.empty() ? "[\"" : ",\"";
      ids += info(clause).id;
      ids += '"';
    }
    out_.append(ids);
    out_ += ']';
  }

  Text& out_;
  const Axes& axes_;
  const AppendNumber& append_number_;
};

// Appends the event to a std::string or TextCursor as one JSON object without a line feed; append_number(out, value)
// appends one number as a JSON value. Empty maps and an empty clause list are left out.
template <class Text, class Number, class AppendNumber>
void append_event_json(Text& out, const Event<Number>& event, const Axes& axes, const AppendNumber& append_number) {
  EventJson<Text, Number, AppendNumber>(out, axes, append_number).write(event);
}

}  // namespace toolcomp::spec
