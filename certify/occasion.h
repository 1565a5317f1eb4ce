// SPDX-License-Identifier: Apache-2.0
// When, by whom and on what a report was made.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "certify/page.h"

namespace toolcomp::certify {

// These values are as the user gave them. toolcomp does not check them.
struct Occasion {
  std::string date;       // ISO 8601, UTC
  std::string operated;   // --operator
  std::string serial;     // --serial: of the controller
  std::string arguments;  // the command line
};

nlohmann::ordered_json to_json(const Occasion& occasion);
// Names and values for facts() of a page. Empty values become "not stated".
std::vector<Row> rows(const Occasion& occasion);

}  // namespace toolcomp::certify
