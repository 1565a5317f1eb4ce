// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <limits>

#include "certify/convert.h"
#include "spec/language/event_map.h"

namespace toolcomp::certify {

spec::Event<double> in_double(const spec::TextEvent& event) {
  return spec::map_numbers<double>(event, [](const spec::NumberText& text) {
    double value = 0;
    const char* end = text.v.data() + text.v.size();
    const auto [rest, error] = std::from_chars(text.v.data(), end, value);
    return error == std::errc() && rest == end ? value : std::numeric_limits<double>::quiet_NaN();
  });
}

}  // namespace toolcomp::certify
