// SPDX-License-Identifier: Apache-2.0
// Converts events of the model and of controllers to numbers that can be drawn and compared.
#pragma once

#include <vector>

#include "model/basis/event.h"
#include "spec/language/case.h"
#include "spec/language/event.h"

namespace toolcomp::certify {

// For pictures and distances: the middle of the enclosure, the text as a double (NaN if it is not a number).
spec::Event<double> in_double(const model::Event& event);
spec::Event<double> in_double(const spec::TextEvent& event);
template <class Number>
std::vector<spec::Event<double>> in_doubles(const std::vector<spec::Event<Number>>& events) {
  std::vector<spec::Event<double>> doubles;
  doubles.reserve(events.size());
  for (const spec::Event<Number>& event : events) doubles.push_back(in_double(event));
  return doubles;
}
// As a controller would report it: decimals of `digits` places.
spec::TextEvent in_text(const model::Event& event, int digits);

}  // namespace toolcomp::certify
