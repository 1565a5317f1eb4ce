// SPDX-License-Identifier: Apache-2.0
// SARIF 2.1.0: findings for tools that collect those of others.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "certify/report.h"
#include "certify/sarif.h"
#include "host/sha256.h"
#include "spec/language/known.h"

namespace toolcomp::certify {
namespace {

using sarif::Json;
using sarif::notification;
using sarif::text;

// The rule of a finding that rests on no clause.
std::string rule_of(const FailureKey& key) { return key.clause.empty() ? "no-clause." + key.kind : key.clause; }

Json rule(const std::string& id) {
  Json json{{"id", id}};
  const auto clause = spec::find_clause(id);
  if (!clause) {
    json["shortDescription"] = text("A difference that cannot be attributed to a clause.");
    return json;
  }
  const spec::ClauseInfo& info = spec::info(*clause);
  json["shortDescription"] = text(info.text);
  std::string help(info.text);
  if (!info.formula.empty()) help += fmt::format("\n\n{}", info.formula);
  json["help"] = text(help + fmt::format("\n\ntoolcomp spec show {}", id));
  json["properties"] = {{"section", info.section}, {"kind", kind_name(info.kind)}, {"known", spec::cited(info)}};
  return json;
}

// A line of a text in which `part` begins, from 1.
std::size_t line_of(const std::string& all, std::string_view part) {
  const std::size_t at = all.find(part);
  return at == std::string::npos ? 1
                                 : 1 + static_cast<std::size_t>(std::count(
                                           all.begin(), all.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

// The finding's file, where its case stands in it; and the line of the program, which stands in the case.
Json location(const Finding& f, std::size_t index) {
  Json region{{"startLine", line_of(write_finding(f), "\n \"case\": ") + 1}, {"snippet", text(f.smallest.program)}};
  Json json;
  json["physicalLocation"] = {
      {"artifactLocation", {{"uri", "findings/" + file_name(f, index)}, {"uriBaseId", "REPORT"}}},
      {"region", std::move(region)}};
  json["logicalLocations"] = Json::array(
      {{{"name", fmt::format("line {}", f.difference.line)},
        {"fullyQualifiedName",
         fmt::format("{}/line {}", f.first_case.empty() ? f.key.section : f.first_case, f.difference.line)}}});
  return json;
}

std::string fingerprint(const FailureKey& key) {
  return host::sha256(key.section + '\n' + key.clause + '\n' + key.kind);
}

Json result(const Certificate& c, const SharedCause& group, const std::vector<std::string>& rules) {
  const Finding& first = c.findings[group.findings.front()];
  const std::string id = rule_of(first.key);
  Json json{{"ruleId", id}, {"ruleIndex", std::ranges::find(rules, id) - rules.begin()}, {"level", "error"}};
  const std::string message =
      fmt::format("{} ({} findings). The first: {}{}", group.words, group.findings.size(), accusation(first),
                  first.not_settled.empty() ? "" : " Not settled: " + first.not_settled + ".");
  json["message"] = text(message);
  json["locations"] = Json::array({location(first, group.findings.front())});
  for (std::size_t i = 1; i < group.findings.size(); ++i)
    json["relatedLocations"].push_back(location(c.findings[group.findings[i]], group.findings[i]));
  json["partialFingerprints"] = {{"finding/v1", fingerprint(first.key)}};
  json["occurrenceCount"] = std::max<std::uint64_t>(group.cases, 1);
  json["properties"] = {
      {"section", first.key.section}, {"kind", first.key.kind}, {"settled", first.not_settled.empty()}};
  return json;
}

Json invocation(const Certificate& c) {
  Json json{{"executionSuccessful", exit_status(c) <= 1}, {"exitCode", exit_status(c)}};
  Json notes = Json::array({notification("note", verdict(c)), notification("note", words_on_known(c))});
  if (const std::string left_out = words_on_left_out(c); !left_out.empty())
    notes.push_back(notification("warning", left_out));
  if (!c.causes.empty()) notes.push_back(notification("note", words_on_settling(c)));
  if (!c.self_check.empty()) notes.push_back(notification("error", "self-check failed: " + c.self_check));
  if (!c.interrupted.empty()) notes.push_back(notification("warning", c.interrupted));
  if (const std::uint64_t not_run = cases_not_run(c); not_run > 0)
    notes.push_back(notification("warning", fmt::format("{} cases not run", not_run)));
  for (const Unsettled& u : c.unsettled)
    notes.push_back(
        notification("warning", fmt::format("{}: {}{}{}", u.id, name(u.result), u.why.empty() ? "" : ", ", u.why)));
  json["toolExecutionNotifications"] = std::move(notes);
  return json;
}

}  // namespace

std::string sarif_report(const Certificate& c) {
  std::vector<std::string> ids;
  for (const SharedCause& group : c.causes)
    if (std::string id = rule_of(c.findings[group.findings.front()].key); std::ranges::find(ids, id) == ids.end())
      ids.push_back(std::move(id));
  Json rules = Json::array();
  for (const std::string& id : ids) rules.push_back(rule(id));
  Json results = Json::array();
  for (const SharedCause& group : c.causes) results.push_back(result(c, group, ids));
  return sarif::log(std::move(rules), invocation(c), std::move(results));
}

std::string sarif_report(const TraceReport& report) {
  sarif::TraceResults results;
  for (const TraceFinding& f : report.result.findings) results.add(f, report.file);
  const int status = exit_status(report.result);
  Json notes = Json::array();
  if (!report.result.undecided.empty()) notes.push_back(notification("warning", report.result.undecided));
  if (report.result.cause) notes.push_back(notification("note", "explains everything found: " + *report.result.cause));
  return results.log(
      {{"executionSuccessful", status <= 1}, {"exitCode", status}, {"toolExecutionNotifications", notes}});
}

}  // namespace toolcomp::certify
