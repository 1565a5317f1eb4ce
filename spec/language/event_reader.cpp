// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

#include "spec/language/alarm.h"
#include "spec/language/event_document.h"
#include "spec/language/event_names.h"
#include "spec/language/number_text.h"

namespace toolcomp::spec {
namespace {

using document::in_quotes;
using document::Kind;
using document::Member;
using document::Node;
using document::Reader;

constexpr std::uint64_t kAnyInteger = 999'999'999'999'999'999;

class EventReader {
 public:
  EventReader(const Reader& read, const Axes& axes, Strictness strictness)
      : read_(read), axes_(axes), strict_(strictness == Strictness::of_cases) {}

  EventWithFields event(const Node& node) {
    read_.expect(node, Kind::table, "event");
    const Node* const kind = node.find("kind");
    of_alarm_ = kind != nullptr && kind->text == name(EventKind::alarm);
    for (const Member& member : node.members) {
      const std::optional<Field> field = find_field(member.name);
      if (field) {
        result_.fields.add(*field);
        read_field(*field, member.value);
      } else if (strict_) {
        read_.fail(member.at, "event: unknown field " + in_quotes(member.name));
      }
    }
    demand(node, Field::kind);
    demand(node, Field::line);
    if (result_.event.hole) result_.event.hole->axis = drilling_axis();
    if (strict_) complete(node);
    return std::move(result_);
  }

 private:
  void demand(const Node& node, Field field) const {
    if (!result_.fields.has(field)) read_.fail(node.at, "event: without " + std::string(field_name(field)));
  }

  // The linear axis that the position of a hole lacks; where it lacks none, as the text of a controller may, the last.
  [[nodiscard]] std::size_t drilling_axis() const {
    std::size_t last = 0;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      if (!is_linear_axis(axes_.letter(i))) continue;
      if (!result_.event.point.has(i)) return i;
      last = i;
    }
    return last;
  }

  // What a kind of event must have, in a case, and what it may have.
  struct Shape {
    FieldSet required;
    FieldSet optional;
  };
  static const Shape& shape(EventKind kind) {
    using F = Field;
    static const std::array<Shape, kNames<EventKind>.size()> shapes{{
        {{F::kind, F::line, F::type, F::cause},
         {F::n,          F::programmed, F::point, F::axes,   F::machine,     F::unknown, F::tool_axis, F::center,
          F::plane,      F::direction,  F::sweep, F::radius, F::tool_center, F::contact, F::normal,    F::shift,
          F::tool_shift, F::carrier,    F::angle, F::flat,   F::feed,        F::clauses}},
        {{F::kind, F::line, F::t}, {F::n, F::point, F::axes, F::machine, F::tool_axis, F::clauses}},
        {{F::kind, F::line, F::number}, {F::n, F::cause, F::message, F::clauses}},
        {{F::kind, F::line, F::number}, {F::n, F::message, F::clauses}},
        {{F::kind, F::line, F::name, F::value}, {F::n, F::clauses}},
        {{F::kind, F::line, F::clause}, {F::n, F::permitted, F::reason, F::clauses}},
        {{F::kind, F::line, F::code}, {F::n, F::message, F::clauses}},
        {{F::kind, F::line, F::code}, {F::n, F::message, F::clauses}},
        {{F::kind, F::line, F::point, F::r, F::bottom, F::level, F::axes}, {F::n, F::clauses}},
    }};
    return shapes[static_cast<std::size_t>(kind)];
  }

  void complete(const Node& node) const {
    const Shape& expected = shape(result_.event.kind);
    for (std::size_t i = 0; i < kFieldNames.size(); ++i)
      if (expected.required.has(static_cast<Field>(i))) demand(node, static_cast<Field>(i));
    if (result_.event.arc)
      for (const Field field : {Field::center, Field::plane, Field::direction}) demand(node, field);
    if (result_.event.space)
      for (const Field field : {Field::tool_center, Field::shift, Field::tool_shift}) demand(node, field);
    if (result_.event.space && result_.event.space->contact)
      for (const Field field : {Field::contact, Field::normal}) demand(node, field);
    for (const Member& member : node.members) {
      const Field field = *find_field(member.name);
      if (!expected.required.has(field) && !expected.optional.has(field))
        read_.fail(member.at, "event: " + in_quotes(member.name) + " does not belong to " +
                                  std::string(name(result_.event.kind)) + " events");
    }
  }

  template <class Enum>
  Enum choice(const Node& node, Field field) const {
    const std::string& text = read_.string(node, field_name(field));
    if (const std::optional<Enum> value = from_name<Enum>(text)) return *value;
    std::string known;
    for (const std::string_view each : kNames<Enum>) known.append(known.empty() ? "" : ", ").append(each);
    read_.fail(node.at,
               std::string(field_name(field)) + ": unknown value " + in_quotes(text) + "; expected one of " + known);
  }

  Name short_text(const Node& node, Field field) const {
    const std::string& text = read_.string(node, field_name(field));
    if (text.size() > Name::kCapacity)
      read_.fail(node.at,
                 std::string(field_name(field)) + ": longer than " + std::to_string(Name::kCapacity) + " characters");
    return {text};
  }

  std::string number_part(const Node& node, Field field) const {
    const bool number = node.kind == Kind::number || node.kind == Kind::string;
    if (!number || !is_number_text(node.text)) not_a_number(node, field);
    return node.text;
  }

  [[noreturn]] void not_a_number(const Node& node, Field field) const {
    const std::string found =
        node.kind == Kind::string ? in_quotes(node.text) : std::string(document::describe(node.kind));
    read_.fail(node.at, std::string(field_name(field)) + ": expected a number, found " + found);
  }

  NumberText number(const Node& node, Field field) const {
    NumberText value;
    if (node.kind != Kind::table) {
      value.v = number_part(node, field);
      return value;
    }
    if (strict_) read_.keys(node, field_name(field), {"v", "r", "q"});
    const Node* v = node.find("v");
    if (v == nullptr) read_.fail(node.at, std::string(field_name(field)) + ": the number has no \"v\"");
    value.v = number_part(*v, field);
    if (const Node* r = node.find("r")) {
      value.r = number_part(*r, field);
      if (value.r.front() == '-') read_.fail(r->at, std::string(field_name(field)) + ": r must not be negative");
    }
    if (const Node* q = node.find("q")) {
      value.q = read_.string(*q, field_name(field));
      if (!is_fraction(value.q))
        read_.fail(q->at, std::string(field_name(field)) + ": q must be a fraction such as \"-3/4\"");
    }
    return value;
  }

  // [-]digits[/digits], the denominator not 0.
  static bool is_fraction(std::string_view text) {
    if (text.starts_with('-')) text.remove_prefix(1);
    const auto digits = [](std::string_view part) {
      return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
    };
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return digits(text);
    const std::string_view denominator = text.substr(slash + 1);
    return digits(text.substr(0, slash)) && digits(denominator) &&
           denominator.find_first_not_of('0') != std::string_view::npos;
  }

  AxisValues<NumberText> values(const Node& node, Field field) const {
    read_.expect(node, Kind::table, field_name(field));
    AxisValues<NumberText> result;
    for (const Member& member : node.members) {
      const std::size_t axis = member.name.size() == 1 ? axes_.index(member.name[0]) : Axes::kNone;
      if (axis != Axes::kNone)
        result.set(axis, number(member.value, field));
      else if (strict_)
        read_.fail(member.at,
                   std::string(field_name(field)) + ": " + in_quotes(member.name) + " is not an axis of the setup");
    }
    return result;
  }

  template <std::size_t N>
  std::array<NumberText, N> numbers(const Node& node, Field field) const {
    read_.expect(node, Kind::array, field_name(field));
    if (node.items.size() != N)
      read_.fail(node.at, std::string(field_name(field)) + ": expected " + std::to_string(N) + " numbers");
    std::array<NumberText, N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = number(node.items[i], field);
    return result;
  }

  // By the letters X, Y and Z.
  std::array<NumberText, 3> vector(const Node& node, Field field) const {
    read_.expect(node, Kind::table, field_name(field));
    if (strict_) read_.keys(node, field_name(field), {"X", "Y", "Z"});
    constexpr std::array<std::string_view, 3> kLetters{"X", "Y", "Z"};
    std::array<NumberText, 3> result;
    for (std::size_t i = 0; i < kLetters.size(); ++i) {
      const Node* component = node.find(kLetters[i]);
      if (component == nullptr)
        read_.fail(node.at, std::string(field_name(field)) + ": without " + std::string(kLetters[i]));
      result[i] = number(*component, field);
    }
    return result;
  }

  ClauseList clauses(const Node& node) const {
    ClauseList list;
    read_.expect(node, Kind::array, "clauses");
    for (const Node& item : node.items) {
      const std::optional<Clause> clause = find_clause(read_.string(item, "clauses"));
      if (clause)
        list.add(*clause);
      else if (strict_)
        read_.fail(item.at, "clauses: unknown clause " + in_quotes(item.text));
    }
    return list;
  }

  std::uint16_t letters(const Node& node) const {
    std::uint16_t axes = 0;
    read_.expect(node, Kind::array, "unknown");
    for (const Node& item : node.items) {
      const std::string& letter = read_.string(item, "unknown");
      const std::size_t axis = letter.size() == 1 ? axes_.index(letter[0]) : Axes::kNone;
      if (axis != Axes::kNone)
        axes = static_cast<std::uint16_t>(axes | 1U << axis);
      else if (strict_)
        read_.fail(item.at, "unknown: " + in_quotes(letter) + " is not an axis of the setup");
    }
    return axes;
  }

  AlarmCause alarm_cause(const Node& node) const {
    const std::optional<AlarmCause> cause = find_alarm(read_.string(node, "cause"));
    if (!cause)
      read_.fail(node.at, "cause: " + in_quotes(node.text) +
                              " is not the cause of an alarm (`toolcomp spec alarms` lists them)");
    return *cause;
  }

  PermittedOutcomes permitted(const Node& node) const {
    PermittedOutcomes outcomes;
    read_.expect(node, Kind::array, "permitted");
    for (const Node& item : node.items) {
      const std::size_t outcome = read_.choice(item, "permitted", {"positive", "negative", "tie"});
      (outcome == 0 ? outcomes.positive : outcome == 1 ? outcomes.negative : outcomes.tie) = true;
    }
    return outcomes;
  }

  void read_t(const Node& node) {
    const std::string& text = read_.string(node, "t");
    const std::size_t slash = std::min(text.find('/'), text.size());
    const std::optional<Decimal> numerator = parse_decimal(std::string_view(text).substr(0, slash));
    const std::optional<Decimal> denominator =
        slash == text.size() ? std::optional(decimal(1)) : parse_decimal(std::string_view(text).substr(slash + 1));
    const auto part = [](const std::optional<Decimal>& value) {
      return value && !value->point && !value->negative && value->digits <= std::numeric_limits<std::uint32_t>::max();
    };
    if (!part(numerator) || !part(denominator) || denominator->is_zero())
      read_.fail(node.at, "t: expected a fraction such as \"1/4\"");
    result_.event.t_numerator = static_cast<std::uint32_t>(numerator->digits);
    result_.event.t_denominator = static_cast<std::uint32_t>(denominator->digits);
  }

  Arc<NumberText>& arc() {
    if (!result_.event.arc) result_.event.arc.emplace();
    return *result_.event.arc;
  }

  // What a controller leaves out reads 0.
  Hole<NumberText>& hole() {
    const NumberText zero{"0", {}, {}};
    if (!result_.event.hole) result_.event.hole = {0, zero, zero, zero};
    return *result_.event.hole;
  }
  SpaceCompensation<NumberText>& space() {
    const NumberText zero{"0", {}, {}};
    if (!result_.event.space)
      result_.event.space.emplace(
          SpaceCompensation<NumberText>{{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}, {}, {}});
    return *result_.event.space;
  }
  Contact<NumberText>& contact() {
    const NumberText zero{"0", {}, {}};
    if (!space().contact)
      space().contact.emplace(Contact<NumberText>{{zero, zero, zero}, {zero, zero, zero}, false, {}});
    return *space().contact;
  }

  void read_field(Field field, const Node& node) {
    TextEvent& event = result_.event;
    switch (field) {
      case Field::kind:
        event.kind = choice<EventKind>(node, field);
        break;
      case Field::line:
        event.line = read_.integer(node, "line", 0, kAnyInteger);
        break;
      case Field::n:
        event.n = read_.integer(node, "n", 0, kAnyInteger);
        break;
      case Field::type:
        event.type = choice<MoveType>(node, field);
        break;
      case Field::cause:
        if (of_alarm_)
          event.alarm = alarm_cause(node);
        else
          event.cause = choice<Cause>(node, field);
        break;
      case Field::programmed:
        event.programmed = values(node, field);
        break;
      case Field::point:
        event.point = values(node, field);
        break;
      case Field::axes:
        event.axes = values(node, field);
        break;
      case Field::machine:
        event.machine = values(node, field);
        break;
      case Field::unknown:
        event.unknown = letters(node);
        break;
      case Field::tool_axis:
        event.tool_axis = numbers<3>(node, field);
        break;
      case Field::center:
        arc().center = values(node, field);
        break;
      case Field::plane:
        arc().plane = choice<Plane>(node, field);
        break;
      case Field::direction:
        arc().direction = choice<ArcDirection>(node, field);
        break;
      case Field::sweep:
        arc().sweep = number(node, field);
        break;
      case Field::radius: {
        auto [start, end] = numbers<2>(node, field);
        arc().radius.emplace(std::move(start), std::move(end));
        break;
      }
      case Field::tool_center:
        space().tool_center = vector(node, field);
        break;
      case Field::contact:
        contact().point = vector(node, field);
        break;
      case Field::normal:
        contact().normal = numbers<3>(node, field);
        break;
      case Field::shift:
        space().shift = vector(node, field);
        break;
      case Field::tool_shift:
        space().tool_shift = vector(node, field);
        break;
      case Field::carrier:
        space().carrier = vector(node, field);
        break;
      case Field::angle:
        contact().angle = number(node, field);
        break;
      case Field::flat:
        contact().flat = read_.boolean(node, "flat");
        break;
      case Field::feed:
        event.feed = number(node, field);
        break;
      case Field::r:
        hole().point_r = number(node, field);
        break;
      case Field::bottom:
        hole().bottom = number(node, field);
        break;
      case Field::level:
        hole().level = number(node, field);
        break;
      case Field::number:
      case Field::clause:
      case Field::code:
        event.number = short_text(node, field);
        break;
      case Field::message:
        (void)read_.string(node, "message");
        break;
      case Field::name:
        event.setting = short_text(node, field);
        break;
      case Field::value:
        event.value = number(node, field);
        break;
      case Field::t:
        read_t(node);
        break;
      case Field::permitted:
        event.permitted = permitted(node);
        break;
      case Field::reason:
        (void)read_.choice(node, "reason", {kOutOfScope});
        event.out_of_scope = true;
        break;
      case Field::clauses:
        event.clauses = clauses(node);
        break;
    }
  }

  const Reader& read_;
  const Axes& axes_;
  bool strict_;
  bool of_alarm_ = false;
  EventWithFields result_;
};

}  // namespace

EventWithFields event_from(const Node& node, const Reader& read, const Axes& axes, Strictness strictness) {
  return EventReader(read, axes, strictness).event(node);
}

}  // namespace toolcomp::spec
