// SPDX-License-Identifier: Apache-2.0
#include "certify/convert.h"

#include "spec/language/event_map.h"

namespace toolcomp::certify {

spec::Event<double> in_double(const model::Event& event) {
  return spec::map_numbers<double>(event, [](const exact::Real& value) {
    const exact::DoubleEnclosure bounds = value.double_enclosure();
    return bounds.lower + (bounds.upper - bounds.lower) / 2;
  });
}

spec::TextEvent in_text(const model::Event& event, int digits) {
  return spec::map_numbers<spec::NumberText>(
      event, [digits](const exact::Real& value) { return spec::NumberText{value.decimal(digits), {}, {}}; });
}

}  // namespace toolcomp::certify
