// SPDX-License-Identifier: Apache-2.0
// The linter on our own clause files, and on files with one fault each: the expected line, column and words are those
// of the text below, by hand.
#include "spec/coverage/lint.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "spec/language/input_error.h"

namespace toolcomp::spec {
namespace {

namespace fs = std::filesystem;

TEST(ClauseLinter, OurClausesAreClean) {
  const fs::path source = TOOLCOMP_SOURCE_DIR;
  for (const std::string& breach : lint_clauses(source / "spec/clauses", source / "spec/coverage/published.txt"))
    ADD_FAILURE() << breach;
}

class LinterFaults : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name() /
              std::to_string(::getpid());
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "fanuc");
    std::ofstream(folder_ / "published.txt") << published_;
  }
  void TearDown() override { fs::remove_all(folder_); }

  // One clause with these lines behind a good beginning.
  static std::string clause(const std::string& id, const std::string& more = "",
                            const std::string& source = R"({ document = "D", page = "24", known = "manual" })",
                            const std::string& kind = "normative") {
    return "[[clause]]\nid = \"" + id + "\"\nkind = \"" + kind + "\"\nsource = " + source +
           "\ntext = \"One sentence.\"\n" + more + "\n";
  }

  std::vector<std::string> lint(const std::string& clauses) {
    std::ofstream(folder_ / "fanuc" / "x.toml") << "section = \"fanuc/x\"\n" + clauses;
    return lint_clauses(folder_, folder_ / "published.txt");
  }
  // Exactly one breach, at line 2 (the first clause), that ends with `what`.
  void expect_one(const std::string& clauses, const std::string& what) {
    const std::vector<std::string> breaches = lint(clauses);
    ASSERT_EQ(breaches.size(), 1U) << (breaches.empty() ? "" : breaches[1 % breaches.size()]);
    EXPECT_TRUE(breaches[0].ends_with(": " + what)) << breaches[0];
    EXPECT_NE(breaches[0].find("x.toml:2:1: "), std::string::npos) << breaches[0];
  }

  fs::path folder_;
  std::string published_;
};

TEST_F(LinterFaults, GoodClauseIsClean) { EXPECT_TRUE(lint(clause("fanuc.x.good")).empty()); }

TEST_F(LinterFaults, Ids) {
  expect_one(clause("fanuc.two"), "an id must be three or more slugs, joined by points");
  expect_one(clause("fanuc.x.two--hyphens"), "an id must be three or more slugs, joined by points");
  expect_one(clause("fanuc.x.Upper"), "an id must be three or more slugs, joined by points");
  expect_one(clause("other.x.good"), "an id must begin with the name of its folder");
  expect_one(clause("fanuc.x.rule-24"), "an id must not name a page");
  expect_one(clause("fanuc.x.page"), "an id must not name a page");
}

TEST_F(LinterFaults, NumbersThatAreNoPageMayStandInIds) { EXPECT_TRUE(lint(clause("fanuc.x.near-90")).empty()); }

TEST_F(LinterFaults, IdsAreUnique) {
  const std::vector<std::string> breaches = lint(clause("fanuc.x.twice") + clause("fanuc.x.twice"));
  ASSERT_EQ(breaches.size(), 1U);
  EXPECT_TRUE(breaches[0].ends_with("x.toml:8:1: fanuc.x.twice: this id is used twice")) << breaches[0];
}

TEST_F(LinterFaults, Kind) { expect_one(clause("fanuc.x.a", "", R"({ known = "ours" })", "rule"), "unknown kind"); }

TEST_F(LinterFaults, Text) {
  expect_one("[[clause]]\nid = \"fanuc.x.a\"\nkind = \"note\"\nsource = { known = \"ours\" }\ntext = \"no end\"\n",
             "the text must end with a full stop");
}

TEST_F(LinterFaults, Source) {
  expect_one("[[clause]]\nid = \"fanuc.x.a\"\nkind = \"note\"\ntext = \"One.\"\n", "the source is missing");
  expect_one(clause("fanuc.x.a", "", R"({ document = "D" })"),
             "the source must say how well the clause is known: manual, sister, recollection or ours");
  expect_one(clause("fanuc.x.a", "", R"({ document = "D", known = "manual" })"),
             "a manual must be named with document and page");
  expect_one(clause("fanuc.x.a", "", R"({ page = "24", known = "sister" })"),
             "a manual must be named with document and page");
  expect_one(clause("fanuc.x.a", "", R"({ document = "D", known = "ours" })", "note"),
             "a definition of ours must not name a document or page");
  EXPECT_TRUE(lint(clause("fanuc.x.a", "", R"({ known = "ours", words = "geometry: it follows" })")).empty());
  expect_one(clause("fanuc.x.a", "", R"({ known = "ours" })"),
             "a definition of ours must not be normative, unless it is geometry");
}

TEST_F(LinterFaults, OpenClausesListAlternatives) {
  const std::string ours = R"({ known = "ours" })";
  expect_one(clause("fanuc.x.a", "", ours, "open"), "an open clause must list its alternatives");
  EXPECT_TRUE(lint(clause("fanuc.x.a", "alternatives = [\"The other way.\"]", ours, "open")).empty());
  EXPECT_TRUE(lint(clause("fanuc.x.a", "testable = false\nreason = \"A frame.\"", ours, "open")).empty());
}

TEST_F(LinterFaults, Testable) {
  expect_one(clause("fanuc.x.a", "testable = false"), "testable = false needs a reason");
  expect_one(clause("fanuc.x.a", "reason = \"None.\""), "a reason is given without testable = false");
}

TEST_F(LinterFaults, Outcomes) {
  expect_one(clause("fanuc.x.a", "outcomes = \"coin\""), "outcomes must be sign, fact or reach");
  expect_one(clause("fanuc.x.a", "outcomes = \"fact\"\noutcome_text = { true = \"yes\" }"),
             "no outcome text for false");
  expect_one(clause("fanuc.x.a", "outcome_text = { true = \"yes\" }"), "true is no outcome");
  const std::string sign = "outcomes = \"sign\"\noutcome_text = { positive = \"a\", negative = \"b\", tie = \"c\" }\n";
  EXPECT_TRUE(lint(clause("fanuc.x.a", sign)).empty());
  expect_one(clause("fanuc.x.a", sign + "unreachable = [\"tie\"]"),
             "unreachable outcomes need a reason, and a reason needs unreachable outcomes");
  expect_one(clause("fanuc.x.a", sign + "unreachable = [\"never\"]\nunreachable_reason = \"So.\""),
             "never is no outcome");
  expect_one(clause("fanuc.x." + std::string(64, 'a'), sign), "the id is too long for an `undecided` event");
}

TEST_F(LinterFaults, Parameters) {
  EXPECT_TRUE(lint(clause("fanuc.x.a", "parameters = [\"5001#2\", \"19631\"]")).empty());
  expect_one(clause("fanuc.x.a", "parameters = [\"5001#8\"]"), "5001#8 is not a parameter number");
}

TEST_F(LinterFaults, Replacement) {
  expect_one(clause("fanuc.x.a", "replaced_by = \"fanuc.x.b\""), "replaced by fanuc.x.b, which does not exist");
  EXPECT_TRUE(lint(clause("fanuc.x.a", "replaced_by = \"fanuc.x.b\"") + clause("fanuc.x.b")).empty());
  expect_one(clause("fanuc.x.a", "replaced_by = \"fanuc.x.b\"") + clause("fanuc.x.b", "replaced_by = \"fanuc.x.c\"") +
                 clause("fanuc.x.c"),
             "replaced by fanuc.x.b, which is itself replaced");
}

TEST_F(LinterFaults, PublishedIdsStay) {
  std::ofstream(folder_ / "published.txt") << "fanuc.x.a\nfanuc.x.gone\n";
  const std::vector<std::string> breaches = lint(clause("fanuc.x.a"));
  ASSERT_EQ(breaches.size(), 1U);
  EXPECT_TRUE(
      breaches[0].ends_with("published.txt:2:1: fanuc.x.gone: was published and is missing; keep it with replaced_by"))
      << breaches[0];
}

TEST_F(LinterFaults, NotToml) {
  EXPECT_THROW(lint("[[clause"), InputError);
  EXPECT_THROW(lint_clauses(folder_ / "missing", folder_ / "published.txt"), InputError);
  EXPECT_THROW(lint_clauses(folder_, folder_ / "missing.txt"), InputError);
}

}  // namespace
}  // namespace toolcomp::spec
