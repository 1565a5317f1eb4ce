// SPDX-License-Identifier: Apache-2.0
// Controllers made of the model's own answers with one lie in them.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/convert.h"
#include "judge/oracle/verdict.h"

namespace toolcomp::test {

inline void lie(double& value, double by) { value += by; }

// In decimals, as the shortest lie has them.
inline void lie(spec::NumberText& value, double by) {
  const long double told = std::strtold(value.v.c_str(), nullptr) + static_cast<long double>(by);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.12Lf", told);
  value.v = text.data();
}

template <class Number>
void lie_in_axis(spec::AxisValues<Number>& values, std::size_t axis, double by) {
  Number value = values[axis];
  lie(value, by);
  values.set(axis, value);
}

// What a value measures, and so how much a lie in it is.
enum class Measure : std::uint8_t { length, angle, direction, exact };

// One value of an answer.
struct Place {
  std::size_t event = 0;
  std::string field;  // as the protocol has it
  Measure measure = Measure::exact;
  bool rotary = false;
  bool sample = false;
  std::function<void(double)> add;  // makes a lie of it; what is no number has another value then, whatever is added

  [[nodiscard]] std::string name() const { return (sample ? "sample " : "") + field + (rotary ? ", rotary" : ""); }
};

// The next of an enumeration with so many.
template <class Enumeration>
void lie_in_name(Enumeration& value, std::size_t count) {
  value = static_cast<Enumeration>((static_cast<std::size_t>(value) + 1) % count);
}

// Every value of the events, in order; of a controller's not those behind one that is undecided, for they are not
// judged.
template <class Number>
std::vector<Place> places(std::vector<spec::Event<Number>>& events, const spec::Axes& axes) {
  constexpr bool controller = !std::is_same_v<Number, double>;
  std::vector<Place> all;
  for (std::size_t i = 0; i < events.size(); ++i) {
    spec::Event<Number>& e = events[i];
    const bool open = e.kind == spec::EventKind::undecided;
    if (open && controller) break;
    const bool sample = e.kind == spec::EventKind::sample;
    const auto one = [&](std::string field, Measure measure, Number& value) {
      all.push_back({i, std::move(field), measure, false, sample, [&value](double by) { lie(value, by); }});
    };
    const auto vector = [&](const std::string& field, Measure measure, std::array<Number, 3>& v) {
      for (Number& component : v) one(field, measure, component);
    };
    const auto table = [&](const std::string& field, spec::AxisValues<Number>& values) {
      for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        if (!values.has(axis)) continue;
        const bool rotary = spec::is_rotary_axis(axes.letter(axis));
        all.push_back({i, field, rotary ? Measure::angle : Measure::length, rotary, sample,
                       [&values, axis](double by) { lie_in_axis(values, axis, by); }});
      }
    };
    const auto other = [&](const std::string& field, auto change) {
      all.push_back({i, field, Measure::exact, false, sample, [change](double) { change(); }});
    };

    other("kind", [&e] { lie_in_name(e.kind, 3); });
    other("line", [&e] { ++e.line; });
    other("n", [&e] { e.n = e.n.value_or(0) + 1; });
    if (i + 1 < events.size() && e.line != events[i + 1].line)
      other("order", [&e, &next = events[i + 1]] { std::swap(e, next); });
    other("number of events", [&events, i] { events.erase(events.begin() + static_cast<std::ptrdiff_t>(i)); });
    if (e.kind == spec::EventKind::alarm || e.kind == spec::EventKind::warning || open)
      other("number", [&e] {
        e.alarm = spec::AlarmCause::none;  // where a controller names the cause, that counts
        e.number = e.number.view() == "PS0041" ? "PS0042" : "PS0041";
      });
    if (open) {
      other("permitted", [&e] { e.permitted.tie = !e.permitted.tie; });
      other("reason", [&e] { e.out_of_scope = !e.out_of_scope; });
    }
    if (e.kind == spec::EventKind::setting) {
      other("name", [&e] { e.setting = "H1.lie"; });
      one("value", Measure::exact, e.value);
    }
    if (sample) other("t", [&e] { ++e.t_denominator; });
    if (e.kind == spec::EventKind::move) {
      other("cause", [&e] { lie_in_name(e.cause, 8); });
      other("type", [&e] { lie_in_name(e.type, 2); });
    }
    table("programmed", e.programmed);
    table("point", e.point);
    table("axes", e.axes);
    table("machine", e.machine);
    if (e.tool_axis) vector("tool_axis", Measure::direction, *e.tool_axis);
    if (e.arc) {
      other("plane", [&e] { lie_in_name(e.arc->plane, 3); });
      other("direction", [&e] { lie_in_name(e.arc->direction, 2); });
      table("center", e.arc->center);
      if (e.arc->sweep) one("sweep", Measure::angle, *e.arc->sweep);
      if (e.arc->radius) {
        one("radius", Measure::length, e.arc->radius->first);
        one("radius", Measure::length, e.arc->radius->second);
      }
    }
    if (e.space) {
      vector("tool_center", Measure::length, e.space->tool_center);
      vector("shift", Measure::length, e.space->shift);
      vector("tool_shift", Measure::length, e.space->tool_shift);
      if (e.space->carrier) vector("carrier", Measure::length, *e.space->carrier);
      if (e.space->contact) {
        vector("contact", Measure::length, e.space->contact->point);
        vector("normal", Measure::direction, e.space->contact->normal);
        if (e.space->contact->angle) one("angle", Measure::angle, *e.space->contact->angle);
        other("flat", [&e] { e.space->contact->flat = !e.space->contact->flat; });
      }
    }
    if (e.hole) {
      one("r", Measure::length, e.hole->point_r);
      one("bottom", Measure::length, e.hole->bottom);
      one("return", Measure::length, e.hole->level);
    }
    if (e.unknown != 0) other("unknown", [&e] { e.unknown = 0; });
    if (e.feed) one("feed", Measure::exact, *e.feed);
  }
  return all;
}

inline std::vector<spec::Event<double>> in_doubles(const judge::ModelRun& run) {
  std::vector<spec::Event<double>> events;
  for (const model::Event& event : run.events) events.push_back(certify::in_double(event));
  return events;
}

inline std::vector<spec::TextEvent> in_texts(const judge::ModelRun& run) {
  constexpr int kDigits = 40;  // as toolcomp serve --engine model has them
  std::vector<spec::TextEvent> events;
  for (const model::Event& event : run.events) events.push_back(certify::in_text(event, kDigits));
  return events;
}

}  // namespace toolcomp::test
