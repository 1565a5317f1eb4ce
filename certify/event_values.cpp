#include "certify/event_values.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

namespace toolcomp::certify {
namespace {

class Values {
 public:
  explicit Values(const spec::Axes& axes) : axes_(axes) {}

  void add(std::size_t index, const spec::Event<double>& event) {
    event_ = index;
    axis_values("programmed", event.programmed);
    axis_values("point", event.point);
    axis_values("axes", event.axes);
    axis_values("machine", event.machine);
    if (event.tool_axis) vector("tool_axis", *event.tool_axis);
    if (event.arc) {
      axis_values("center", event.arc->center);
      if (event.arc->sweep) number("sweep", *event.arc->sweep);
    }
    if (event.feed) number("feed", *event.feed);
    if (event.kind == spec::EventKind::setting) number("value", event.value);
    if (event.space) space(*event.space);
  }

  std::vector<EventValue> take() { return std::move(values_); }

 private:
  void number(std::string_view field, double value, char letter = 0) {
    values_.push_back({event_, field, letter, value});
  }
  void axis_values(std::string_view field, const spec::AxisValues<double>& values) {
    for (std::size_t i = 0; i < axes_.size(); ++i)
      if (values.has(i)) number(field, values[i], axes_.letter(i));
  }
  void vector(std::string_view field, const std::array<double, 3>& v) {
    for (std::size_t i = 0; i < v.size(); ++i) number(field, v.at(i), "XYZ"[i]);
  }
  void space(const spec::SpaceCompensation<double>& space) {
    vector("tool_center", space.tool_center);
    vector("shift", space.shift);
    vector("tool_shift", space.tool_shift);
    if (space.carrier) vector("carrier", *space.carrier);
    if (!space.contact) return;
    vector("contact", space.contact->point);
    vector("normal", space.contact->normal);
    if (space.contact->angle) number("angle", *space.contact->angle);
  }

  const spec::Axes& axes_;
  std::size_t event_ = 0;
  std::vector<EventValue> values_;
};

// Types and causes count where any move has another than an event has by itself: else they are not announced.
class SameWords {
 public:
  explicit SameWords(const Events& actual) {
    for (const spec::Event<double>& e : actual) {
      types_ = types_ || e.type != spec::MoveType::linear;
      causes_ = causes_ || e.cause != spec::Cause::programmed;
    }
  }
  bool operator()(const spec::Event<double>& a, const spec::Event<double>& b) const {
    const bool same = a.kind == b.kind && a.line == b.line && a.number == b.number && a.setting == b.setting;
    if (a.kind != spec::EventKind::move) return same;
    return same && (!types_ || a.type == b.type) && (!causes_ || a.cause == b.cause);
  }

 private:
  bool types_ = false;
  bool causes_ = false;
};

}  // namespace

std::vector<EventValue> values_of(const Events& events, const spec::Axes& axes) {
  Values values(axes);
  for (std::size_t i = 0; i < events.size(); ++i) values.add(i, events[i]);
  return values.take();
}

std::optional<std::vector<ValuePair>> pairs_of(const Events& expected, const spec::Axes& expected_axes,
                                               const Events& actual, const spec::Axes& axes) {
  if (!std::ranges::equal(expected, actual, SameWords(actual))) return std::nullopt;
  std::map<std::tuple<std::size_t, std::string_view, char>, double> came;
  std::set<std::string_view> announced;
  for (const EventValue& value : values_of(actual, axes)) {
    came[{value.event, value.field, value.letter}] = value.number;
    announced.insert(value.field);
  }
  std::vector<ValuePair> pairs;
  for (const EventValue& value : values_of(expected, expected_axes)) {
    if (!announced.contains(value.field) || (value.letter != 0 && value.letter < 'X' && !axes.has(value.letter)))
      continue;
    const auto found = came.find({value.event, value.field, value.letter});
    if (found == came.end()) return std::nullopt;
    pairs.push_back({value, found->second});
  }
  if (pairs.size() != came.size()) return std::nullopt;
  return pairs;
}

}  // namespace toolcomp::certify
