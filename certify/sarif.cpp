// SPDX-License-Identifier: Apache-2.0
#include "certify/sarif.h"

#include <fmt/format.h>

#include <algorithm>

#include "certify/report.h"
#include "host/sha256.h"

namespace toolcomp::certify::sarif {
namespace {

// A path as a relative or absolute reference (RFC 3986).
std::string uri_of(const std::string& path) {
  std::string uri;
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("/.-_~").find(c) != std::string_view::npos;
    uri += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

}  // namespace

Json text(std::string_view words) { return {{"text", words}}; }

Json notification(std::string_view level, const std::string& message) {
  return {{"level", level}, {"message", text(message)}};
}

std::string log(Json rules, Json invocation, Json results) {
  Json driver{{"name", "toolcomp"}, {"version", TOOLCOMP_VERSION}, {"semanticVersion", TOOLCOMP_VERSION}};
  driver["rules"] = std::move(rules);
  Json run{{"tool", {{"driver", std::move(driver)}}}};
  run["invocations"] = Json::array({std::move(invocation)});
  run["originalUriBaseIds"] = {{"REPORT", {{"description", text("The folder of the report.")}}}};
  run["results"] = std::move(results);
  Json json{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"}, {"version", "2.1.0"}};
  json["runs"] = Json::array({std::move(run)});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void TraceResults::add(const TraceFinding& f, const std::string& file) {
  add(f.kind, fmt::format("{} of line {} by {}", f.kind, f.line, extent(f)), file, f.sample,
      fmt::format("line {}", f.line), fmt::format("{}\n{}\n{}", f.kind, f.line, f.last_line));
}

void TraceResults::add(const std::string& kind, const std::string& message, const std::string& file) {
  add(kind, message, file, 1, "program", kind + "\n" + message);
}

void TraceResults::add(const std::string& kind, const std::string& message, const std::string& file, std::uint64_t line,
                       const std::string& place, const std::string& fingerprint) {
  std::string id = "trace." + kind;
  std::ranges::replace(id, ' ', '-');
  const auto known = std::ranges::find(ids_, id);
  const auto index = known - ids_.begin();
  if (known == ids_.end()) {
    ids_.push_back(id);
    rules_.push_back(Json{{"id", id}, {"shortDescription", text("A recorded run: " + kind)}});
  }
  Json result{{"ruleId", id}, {"ruleIndex", index}, {"level", "error"}};
  result["message"] = text(message);
  result["locations"] = Json::array({{{"physicalLocation",
                                       {{"artifactLocation", {{"uri", uri_of(file)}}},
                                        {"region", {{"startLine", std::max<std::uint64_t>(line, 1)}}}}},
                                      {"logicalLocations", Json::array({{{"name", place}}})}}});
  result["partialFingerprints"] = {{"trace/v1", host::sha256(fingerprint)}};
  result["occurrenceCount"] = 1;
  results_.push_back(std::move(result));
}

}  // namespace toolcomp::certify::sarif
