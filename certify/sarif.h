// SPDX-License-Identifier: Apache-2.0
// SARIF 2.1.0: the common parts of the logs of all reports.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "certify/trace/trace.h"

namespace toolcomp::certify::sarif {

using Json = nlohmann::ordered_json;

// A message.
Json text(std::string_view words);
// "note", "warning" or "error".
Json notification(std::string_view level, const std::string& message);
// A log of one run of this tool.
std::string log(Json rules, Json invocation, Json results);

// Results of recorded runs, with their rules.
class TraceResults {
 public:
  // Adds a finding at its sample in the file of the recording.
  void add(const TraceFinding& finding, const std::string& file);
  // Adds a fault of a whole run, at the first line of a file.
  void add(const std::string& kind, const std::string& message, const std::string& file);
  [[nodiscard]] std::string log(Json invocation) const { return sarif::log(rules_, std::move(invocation), results_); }

 private:
  void add(const std::string& kind, const std::string& message, const std::string& file, std::uint64_t line,
           const std::string& place, const std::string& fingerprint);

  std::vector<std::string> ids_;
  Json rules_ = Json::array();
  Json results_ = Json::array();
};

}  // namespace toolcomp::certify::sarif
