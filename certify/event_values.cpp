// SPDX-License-Identifier: Apache-2.0
#include "certify/event_values.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>

#include "certify/event_numbers.h"

namespace toolcomp::certify {
namespace {

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
  std::vector<EventValue> values;
  for (std::size_t i = 0; i < events.size(); ++i)
    for_each_number(events[i], axes, [&](std::string_view field, char letter, double number) {
      values.push_back({i, field, letter, number});
    });
  return values;
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
