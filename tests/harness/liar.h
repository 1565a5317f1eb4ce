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
#include "fuzz/oracle/verdict.h"

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

// One number of an answer.
struct Place {
  std::size_t event = 0;
  std::string field;                // "axes.B", "normal"
  std::function<void(double)> add;  // makes a lie of it
};

// Every number of the events, in order; events behind one that is undecided are not judged, so they are left out.
template <class Number>
std::vector<Place> places(std::vector<spec::Event<Number>>& events, const spec::Axes& axes) {
  std::vector<Place> all;
  for (std::size_t i = 0; i < events.size(); ++i) {
    spec::Event<Number>& e = events[i];
    if (e.kind == spec::EventKind::undecided) break;
    const auto one = [&](std::string field, Number& value) {
      all.push_back({i, std::move(field), [&value](double by) { lie(value, by); }});
    };
    const auto vector = [&](const std::string& field, std::array<Number, 3>& v) {
      for (Number& component : v) one(field, component);
    };
    const auto table = [&](const std::string& field, spec::AxisValues<Number>& values) {
      for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        if (!values.has(axis)) continue;
        const bool rotary = spec::is_rotary_axis(axes.letter(axis));
        all.push_back(
            {i, field + (rotary ? ", rotary" : ""), [&values, axis](double by) { lie_in_axis(values, axis, by); }});
      }
    };
    const std::string sample = e.kind == spec::EventKind::sample ? "sample " : "";
    table(sample + "programmed", e.programmed);
    table(sample + "point", e.point);
    table(sample + "axes", e.axes);
    table(sample + "machine", e.machine);
    if (e.tool_axis) vector(sample + "tool_axis", *e.tool_axis);
    if (e.arc) {
      table("center", e.arc->center);
      if (e.arc->sweep) one("sweep", *e.arc->sweep);
      if (e.arc->radius) {
        one("radius", e.arc->radius->first);
        one("radius", e.arc->radius->second);
      }
    }
    if (e.space) {
      vector("tool_center", e.space->tool_center);
      vector("shift", e.space->shift);
      vector("tool_shift", e.space->tool_shift);
      if (e.space->carrier) vector("carrier", *e.space->carrier);
      if (e.space->contact) {
        vector("contact", e.space->contact->point);
        vector("normal", e.space->contact->normal);
        if (e.space->contact->angle) one("angle", *e.space->contact->angle);
      }
    }
    if (e.feed) one("feed", *e.feed);
    if (e.kind == spec::EventKind::setting) one("value", e.value);
  }
  return all;
}

inline std::vector<spec::Event<double>> in_doubles(const fuzz::ModelRun& run) {
  std::vector<spec::Event<double>> events;
  for (const model::Event& event : run.events) events.push_back(certify::in_double(event));
  return events;
}

inline std::vector<spec::TextEvent> in_texts(const fuzz::ModelRun& run) {
  constexpr int kDigits = 40;  // as toolcomp serve --engine model has them
  std::vector<spec::TextEvent> events;
  for (const model::Event& event : run.events) events.push_back(certify::in_text(event, kDigits));
  return events;
}

}  // namespace toolcomp::test
