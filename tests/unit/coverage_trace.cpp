// SPDX-License-Identifier: Apache-2.0
// The trace table: rules that the source tree must keep, and a small tree whose mentions are counted by hand.
#include "spec/coverage/trace.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "spec/language/input_error.h"

namespace toolcomp::spec {
namespace {

namespace fs = std::filesystem;

const std::vector<ClauseTrace>& our_trace() {
  static const std::vector<ClauseTrace> table = trace(TOOLCOMP_SOURCE_DIR);
  return table;
}

TEST(Trace, TheModelMarksEveryClauseThatCanBeTested) {
  for (std::size_t i = 0; i < kClauseCount; ++i)
    if (needs_mark(clauses()[i])) {
      EXPECT_FALSE(our_trace()[i].model.empty()) << clauses()[i].id;
    }
}

TEST(Trace, AVectorNamesEveryClauseThatCanBeTested) {
  for (std::size_t i = 0; i < kClauseCount; ++i)
    if (needs_mark(clauses()[i]) && clauses()[i].outcomes != ClauseOutcomes::fact) {
      EXPECT_FALSE(our_trace()[i].vectors.empty()) << clauses()[i].id;
    }
}

// Every docstring of a theorem begins with an id (spec/formal/check); here: of a clause that exists.
TEST(Trace, EveryTheoremCitesAClause) {
  std::set<std::string> cited;
  for (const ClauseTrace& row : our_trace()) cited.insert(row.theorems.begin(), row.theorems.end());
  std::size_t theorems = 0;
  for (const auto& file : fs::recursive_directory_iterator(fs::path(TOOLCOMP_SOURCE_DIR) / "spec/formal")) {
    if (file.path().extension() != ".v") continue;
    std::ifstream in(file.path());
    for (std::string line; std::getline(in, line);) {
      if (!line.starts_with("Theorem ")) continue;
      ++theorems;
      const std::string name = line.substr(8, line.find_first_of(" :", 8) - 8);
      EXPECT_TRUE(cited.contains(file.path().stem().string() + "." + name)) << line;
    }
  }
  EXPECT_GT(theorems, 30U);
}

class SmallTree : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(testing::TempDir()) / ("trace_small_tree_" + std::to_string(::getpid()));
    fs::remove_all(root_);
    write("spec/clauses/fanuc/x.toml", "");
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& text) {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << text;
  }
  ClauseTrace row() { return trace(root_)[static_cast<std::size_t>(Clause::fanuc_leading_edge_vector)]; }

  fs::path root_;
};

TEST_F(SmallTree, EmptyTreeNamesNothing) {
  const ClauseTrace found = row();
  EXPECT_TRUE(found.model.empty() && found.tests.empty() && found.theorems.empty() && found.vectors.empty());
}

TEST_F(SmallTree, FirstMentionOfEachFile) {
  write("model/b.cpp", "\nreach(Clause::fanuc_leading_edge_vector);\nreach(Clause::fanuc_leading_edge_vector);\n");
  write("model/a.h", "reach(Clause::fanuc_leading_edge_vector_of_another);\n");
  write("tests/unit/t.cpp", "// fanuc.leading-edge.vector.\n");
  const ClauseTrace found = row();
  ASSERT_EQ(found.model.size(), 1U);
  EXPECT_EQ(found.model[0].file, "model/b.cpp");
  EXPECT_EQ(found.model[0].line, 2U);
  ASSERT_EQ(found.tests.size(), 1U);
  EXPECT_EQ(found.tests[0].file, "tests/unit/t.cpp");
}

TEST_F(SmallTree, ADocstringBelongsToTheNextTheorem) {
  write("spec/formal/A.v", "(** fanuc.leading-edge.vector: one. *)\nTheorem one : True.\nTheorem two : True.\n");
  EXPECT_EQ(row().theorems, std::vector<std::string>{"A.one"});
}

TEST_F(SmallTree, VectorsByTheirClausesAndTheirEvents) {
  const std::string head = R"("section":"fanuc/leading-edge-offset","dialect":"fanuc","setup":{"control":"fanuc"},)";
  write(
      "corpus/golden/fanuc/leading-edge-offset/x.jsonl",
      R"({"case":1,"id":"stated",)" + head + R"("clauses":["fanuc.leading-edge.vector"],"program":"G40"})" + "\n" +
          R"({"case":1,"id":"other",)" + head + R"("program":"G40"})" + "\n" + R"({"case":1,"id":"event",)" + head +
          R"("program":"G40","expect":[{"kind":"alarm","number":"PS0010","line":1,"clauses":["fanuc.leading-edge.vector"]}]})" +
          "\n");
  EXPECT_EQ(row().vectors, (std::vector<std::string>{"stated", "event"}));
}

TEST_F(SmallTree, NoSourceTree) {
  fs::remove_all(root_ / "spec");
  EXPECT_THROW(trace(root_), InputError);
  try {
    trace(root_ / "gone");
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("is not a source tree of toolcomp; name one with --dir"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace toolcomp::spec
