// SPDX-License-Identifier: Apache-2.0
// What `toolcomp spec` prints. Expected texts are written by hand from the clause file of the leading edge.
#include "spec/coverage/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "spec/language/input_error.h"

namespace toolcomp::spec {
namespace {

constexpr std::string_view kSign = "fanuc.leading-edge.sign";

TEST(SpecReport, ListNamesEveryClauseOnALine) {
  const std::string text = list_clauses(ReportFormat::text);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(text, '\n')), kClauseCount);
  const auto json = nlohmann::json::parse(list_clauses(ReportFormat::json));
  ASSERT_EQ(json.size(), kClauseCount);
  for (std::size_t i = 0; i < kClauseCount; ++i) EXPECT_EQ(json[i]["id"], clauses()[i].id);
}

TEST(SpecReport, ShowOneClause) {
  const std::string text = show_clause(kSign, ReportFormat::text);
  EXPECT_TRUE(
      text.starts_with("fanuc.leading-edge.sign\n  section       fanuc/leading-edge-offset\n"
                       "  kind          normative\n  source        manual: A-78438E, page 23\n"))
      << text;
  EXPECT_NE(text.find("\n  formula       quantity: VM . VT\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n  negative      the tool leans back (over 90 degrees)\n"), std::string::npos) << text;
  const auto json = nlohmann::json::parse(show_clause(kSign, ReportFormat::json));
  EXPECT_EQ(json["source"]["page"], "23");
  EXPECT_EQ(json["source"]["known"], "manual");
  EXPECT_EQ(json["outcomes"], "sign");
  EXPECT_EQ(json["outcome_text"]["negative"], "the tool leans back (over 90 degrees)");
  EXPECT_EQ(json["testable"], true);
}

TEST(SpecReport, UnknownIdNamesTheNearest) {
  try {
    show_clause("fanuc.leading-edge.sing", ReportFormat::text);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean fanuc.leading-edge.sign"), std::string::npos)
        << error.what();
  }
}

TEST(SpecReport, SectionsAddUp) {
  const auto json = nlohmann::json::parse(list_sections(ReportFormat::json));
  std::size_t sum = 0;
  for (const auto& row : json)
    for (const char* kind : {"normative", "parameter", "alarm", "open", "note"}) sum += row[kind].get<std::size_t>();
  EXPECT_EQ(sum, kClauseCount);
  std::size_t known = 0;
  for (const auto& row : json)
    for (const char* name : {"manual", "sister", "recollection", "ours"})
      known += row["known"][name].get<std::size_t>();
  EXPECT_EQ(known, kClauseCount);
  EXPECT_NE(list_sections(ReportFormat::text).find("\nfanuc/leading-edge-offset "), std::string::npos);
}

std::vector<OutcomeCounts> all_reached() { return std::vector<OutcomeCounts>(kClauseCount, {4, 1, 1, 2}); }

TEST(SpecReport, CoverageCountsOutcomes) {
  auto counts = all_reached();
  EXPECT_TRUE(missing_outcomes(counts).empty());
  const std::size_t all = required_outcomes(counts).size();
  counts[static_cast<std::size_t>(*find_clause(kSign))].tie = 0;
  const auto missing = missing_outcomes(counts);
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_EQ(missing[0].name, "tie");
  EXPECT_EQ(missing[0].text, "the tool stands exactly at right angles to the movement");
  const std::vector<ProofCount> proofs{{"fanuc/tool-offset", 225, 169}};
  const std::string text = show_coverage(counts, 7, proofs, ReportFormat::text);
  EXPECT_TRUE(
      text.starts_with("7 runs; " + std::to_string(all - 1) + " of " + std::to_string(all) + " outcomes reached\n"));
  EXPECT_NE(text.find("    NEVER  fanuc.leading-edge.sign"), std::string::npos);
  const auto json = nlohmann::json::parse(show_coverage(counts, 7, proofs, ReportFormat::json));
  EXPECT_EQ(json["reached"], all - 1);
  EXPECT_EQ(json["clauses"].size(), all);
  EXPECT_NE(text.find(" 169 of  225  fanuc/tool-offset\n"), std::string::npos);
  EXPECT_EQ(json["proofs"][0]["proven"], 169);
}

TEST(SpecReport, WhatIsNotTestableIsNotRequired) {
  const std::vector<OutcomeCounts> none(kClauseCount);
  for (const ClauseOutcome& outcome : required_outcomes(none)) EXPECT_TRUE(info(outcome.clause).testable);
  EXPECT_FALSE(find_clause("fanuc.leading-edge.fluctuation") == std::nullopt);
}

TEST(SpecReport, TraceTextAndJson) {
  std::vector<ClauseTrace> table(kClauseCount);
  ClauseTrace& row = table[static_cast<std::size_t>(*find_clause(kSign))];
  row.model = {{"model/a.cpp", 3}, {"model/b.cpp", 5}};
  row.theorems = {"LeadingEdgeOffset.VC_forward"};
  row.vectors = {"v.1", "v.2", "v.3", "v.4", "v.5"};
  const std::string text = show_trace(table, ReportFormat::text);
  EXPECT_NE(text.find("fanuc.leading-edge.sign (normative)\n"
                      "  model         model/a.cpp:3, model/b.cpp:5\n"
                      "  theorems      LeadingEdgeOffset.VC_forward\n"
                      "  vectors       v.1, v.2, v.3 and 2 more\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("fanuc.leading-edge.vector (normative)\n  model         NOT MARKED\n"), std::string::npos);
  const auto json = nlohmann::json::parse(show_trace(table, ReportFormat::json));
  ASSERT_EQ(json.size(), kClauseCount);
  const auto& sign = json[static_cast<std::size_t>(*find_clause(kSign))];
  EXPECT_EQ(sign["model"][1]["line"], 5);
  EXPECT_EQ(sign["vectors"].size(), 5U);
}

}  // namespace
}  // namespace toolcomp::spec
