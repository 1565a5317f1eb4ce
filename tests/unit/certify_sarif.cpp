// SPDX-License-Identifier: Apache-2.0
// The SARIF report has what SARIF 2.1.0 (OASIS, 2020) requires, and says what was found.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "certify/report.h"
#include "host/sha256.h"

namespace toolcomp::certify {
namespace {

using Json = nlohmann::json;

Finding finding(const std::string& clause, const std::string& kind, const std::string& program) {
  Finding f;
  f.key = {"fanuc/tool-length-offset", clause, kind};
  f.smallest.section = f.key.section;
  f.smallest.program = program;
  f.difference.line = 2;
  f.difference.field = "axes.Z";
  f.difference.expected = "120";
  f.difference.actual = "-120";
  f.occurrences = 7;
  f.first_case = "fanuc.tool-length-offset.seed-17.3";
  return f;
}

Certificate example() {
  Certificate c;
  c.subject.name = "CNC <3000> & \"Co\" \xff";
  c.clauses.resize(spec::kClauseCount);
  c.sections.push_back({});
  c.sections.back().section = "fanuc/tool-length-offset";
  c.sections.back().results = {3, 1, 0, 0, 0, 5, 0};
  c.findings = {finding("fanuc.length-offset.one-number", "coordinate", "G43 H1\nZ0\n"), finding("", "crash", "G49\n"),
                finding("fanuc.length-offset.one-number", "missing event", "Z1\n")};
  c.causes = {{"axes.Z has the wrong sign", {2, 0}, 14}, {"crash", {1}, 7}};
  c.findings[1].not_settled = "no time was left";
  c.settling = std::chrono::seconds(30);
  c.unsettled = {{"a.case", "fanuc/tool-length-offset", Result::undecided, "why \xff"}};
  c.interrupted = "interrupted (SIGINT)";
  return c;
}

bool is_level(const Json& level) {
  return std::set<std::string>{"none", "note", "warning", "error"}.contains(level.get<std::string>());
}

void expect_message(const Json& message) { EXPECT_FALSE(message.at("text").get<std::string>().empty()); }

// Sections of the standard in brackets.
void expect_location(const Json& location) {
  const Json& physical = location.at("physicalLocation");                              // [3.28.3]
  EXPECT_FALSE(physical.at("artifactLocation").at("uri").get<std::string>().empty());  // [3.29.3]
  EXPECT_GE(physical.at("region").at("startLine").get<int>(), 1);                      // [3.30.5]
  for (const Json& logical : location.at("logicalLocations")) EXPECT_TRUE(logical.contains("name"));
}

void expect_sarif(const Json& log) {
  EXPECT_EQ(log.at("version"), "2.1.0");  // [3.13.2]
  EXPECT_TRUE(log.at("$schema").get<std::string>().ends_with("sarif-2.1.0.json"));
  ASSERT_EQ(log.at("runs").size(), 1U);  // [3.13.4]
  const Json& run = log.at("runs").at(0);
  const Json& driver = run.at("tool").at("driver");  // [3.14.6, 3.18.2]
  EXPECT_EQ(driver.at("name"), "toolcomp");          // [3.19.8]
  EXPECT_FALSE(driver.at("version").get<std::string>().empty());
  std::set<std::string> ids;
  for (const Json& rule : driver.at("rules")) {                           // [3.19.23]
    EXPECT_TRUE(ids.insert(rule.at("id")).second) << "[3.19.23] unique";  // [3.49.3]
    expect_message(rule.at("shortDescription"));
  }
  for (const Json& invocation : run.at("invocations")) {                    // [3.14.11]
    EXPECT_TRUE(invocation.at("executionSuccessful").is_boolean());         // [3.20.14]
    for (const Json& note : invocation.at("toolExecutionNotifications")) {  // [3.20.21]
      expect_message(note.at("message"));                                   // [3.58.5]
      EXPECT_TRUE(is_level(note.at("level")));                              // [3.58.6]
    }
  }
  for (const Json& result : run.at("results")) {                            // [3.14.23]
    expect_message(result.at("message"));                                   // [3.27.11]
    EXPECT_TRUE(is_level(result.at("level")));                              // [3.27.10]
    const auto index = result.at("ruleIndex").get<std::size_t>();           // [3.27.6]
    EXPECT_EQ(driver.at("rules").at(index).at("id"), result.at("ruleId"));  // [3.27.5]
    EXPECT_GE(result.at("occurrenceCount").get<int>(), 1);                  // [3.27.18]
    EXPECT_FALSE(result.at("locations").empty());
    for (const Json& location : result.at("locations")) expect_location(location);  // [3.27.12]
    if (result.contains("relatedLocations"))
      for (const Json& location : result.at("relatedLocations")) expect_location(location);
    for (const auto& [name, value] : result.at("partialFingerprints").items())  // [3.27.17]
      EXPECT_TRUE(value.is_string()) << name;
  }
}

TEST(Sarif, HasWhatTheStandardRequires) {
  expect_sarif(Json::parse(sarif_report(example())));
  Certificate nothing;
  nothing.clauses.resize(spec::kClauseCount);
  expect_sarif(Json::parse(sarif_report(nothing)));
}

TEST(Sarif, AGroupOfFindingsIsOneResult) {
  const Json run = Json::parse(sarif_report(example())).at("runs").at(0);
  ASSERT_EQ(run.at("results").size(), 2U);
  const Json& cause = run.at("results").at(0);
  EXPECT_EQ(cause.at("ruleId"), "fanuc.length-offset.one-number");
  EXPECT_EQ(cause.at("level"), "error");
  EXPECT_EQ(cause.at("occurrenceCount"), 14);
  EXPECT_NE(cause.at("message").at("text").get<std::string>().find("axes.Z has the wrong sign (2 findings)"),
            std::string::npos);
  EXPECT_EQ(cause.at("locations").at(0).at("physicalLocation").at("artifactLocation").at("uri"),
            "findings/03-missing-event.json");
  EXPECT_EQ(cause.at("relatedLocations").at(0).at("physicalLocation").at("artifactLocation").at("uri"),
            "findings/01-coordinate.json");
  EXPECT_EQ(cause.at("partialFingerprints").at("finding/v1"),
            host::sha256("fanuc/tool-length-offset\nfanuc.length-offset.one-number\nmissing event"));
  const Json& crash = run.at("results").at(1);
  EXPECT_EQ(crash.at("ruleId"), "no-clause.crash");
  EXPECT_EQ(crash.at("properties").at("settled"), false);
  EXPECT_NE(crash.at("message").at("text").get<std::string>().find("Not settled: no time was left"), std::string::npos);
  const Json& rule = run.at("tool").at("driver").at("rules").at(0);
  EXPECT_EQ(rule.at("id"), "fanuc.length-offset.one-number");
  const auto clause = spec::find_clause("fanuc.length-offset.one-number");
  EXPECT_EQ(rule.at("shortDescription").at("text"), spec::info(*clause).text);
  EXPECT_NE(rule.at("help").at("text").get<std::string>().find("toolcomp spec show fanuc.length-offset.one-number"),
            std::string::npos);
}

TEST(Sarif, OfARecordedRunPointsIntoTheRecording) {
  TraceReport report;
  report.file = "runs/part 1.csv";
  TraceFinding finding;
  finding.kind = "off the path";
  finding.sample = 17;
  finding.line = 3;
  report.result.findings = {finding, finding};
  const Json log = Json::parse(sarif_report(report));
  expect_sarif(log);
  const Json& run = log.at("runs").at(0);
  ASSERT_EQ(run.at("results").size(), 2U);
  EXPECT_EQ(run.at("tool").at("driver").at("rules").size(), 1U);
  EXPECT_EQ(run.at("results").at(0).at("ruleId"), "trace.off-the-path");
  const Json& place = run.at("results").at(0).at("locations").at(0).at("physicalLocation");
  EXPECT_EQ(place.at("artifactLocation").at("uri"), "runs/part%201.csv");
  EXPECT_EQ(place.at("region").at("startLine"), 17);
}

// The line a result names is that of the case in the finding's file.
TEST(Sarif, AResultPointsIntoTheFindingsFile) {
  const Certificate c = example();
  const Json run = Json::parse(sarif_report(c)).at("runs").at(0);
  const Json& region = run.at("results").at(1).at("locations").at(0).at("physicalLocation").at("region");
  EXPECT_EQ(region.at("snippet").at("text"), "G49\n");
  std::string text = write_finding(c.findings[1]);
  for (int line = 1; line < region.at("startLine").get<int>(); ++line) text.erase(0, text.find('\n') + 1);
  EXPECT_TRUE(text.starts_with(" \"case\": {")) << text;
}

TEST(Sarif, SaysWhatWasNotJudged) {
  const Json invocation = Json::parse(sarif_report(example())).at("runs").at(0).at("invocations").at(0);
  EXPECT_EQ(invocation.at("exitCode"), 1);
  EXPECT_EQ(invocation.at("executionSuccessful"), true);
  std::string all;
  for (const Json& note : invocation.at("toolExecutionNotifications"))
    all += note.at("message").at("text").get<std::string>() + "\n";
  for (const char* part : {"does not conform", "1 of 2 groups settled, within 30 s", "interrupted (SIGINT)",
                           "5 cases not run", "a.case: undecided, why"})
    EXPECT_NE(all.find(part), std::string::npos) << part << all;
  Certificate interrupted = example();
  interrupted.findings.clear();
  interrupted.causes.clear();
  EXPECT_EQ(Json::parse(sarif_report(interrupted)).at("runs").at(0).at("invocations").at(0).at("executionSuccessful"),
            false);
}

}  // namespace
}  // namespace toolcomp::certify
