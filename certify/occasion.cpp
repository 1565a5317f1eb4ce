// SPDX-License-Identifier: Apache-2.0
#include "certify/occasion.h"

#include <nlohmann/json.hpp>

#include "certify/markup.h"

namespace toolcomp::certify {

nlohmann::ordered_json to_json(const Occasion& o) {
  return {{"date", o.date}, {"operator", o.operated}, {"serial", o.serial}, {"arguments", o.arguments}};
}

std::vector<Row> rows(const Occasion& o) {
  const auto told = [](const std::string& text) { return text.empty() ? "not stated" : escape(text); };
  return {{"serial number of the controller", told(o.serial)},
          {"date", told(o.date)},
          {"operator", told(o.operated)},
          {"command line", o.arguments.empty() ? "not stated" : "<code>" + escape(o.arguments) + "</code>"}};
}

}  // namespace toolcomp::certify
