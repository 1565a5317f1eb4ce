// SPDX-License-Identifier: Apache-2.0
// The numbers of events in a row: each actual number with the expected one.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "spec/language/event.h"

namespace toolcomp::certify {

using Events = std::vector<spec::Event<double>>;

// One number of an event.
struct EventValue {
  std::size_t event = 0;
  std::string_view field;
  char letter = 0;  // of an axis or a component; 0: the field is one number
  double number = 0;
};
std::vector<EventValue> values_of(const Events& events, const spec::Axes& axes);

// The expected and the actual value of one number.
struct ValuePair {
  EventValue expected;
  double actual = 0;
};
// All pairs; std::nullopt if the events differ in number, kind, words or fields. A field that is in no event counts as
// not announced, and an axis that is in no actual event counts as not read.
std::optional<std::vector<ValuePair>> pairs_of(const Events& expected, const spec::Axes& expected_axes,
                                               const Events& actual, const spec::Axes& axes);
inline std::optional<std::vector<ValuePair>> pairs_of(const Events& expected, const Events& actual,
                                                      const spec::Axes& axes) {
  return pairs_of(expected, axes, actual, axes);
}

}  // namespace toolcomp::certify
