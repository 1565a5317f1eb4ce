// SPDX-License-Identifier: Apache-2.0
// `toolcomp corpus mine` and `hard` as a user runs them.
#include <gtest/gtest.h>

#include <string>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;

TEST(CorpusHard, MinedCasesHoldAndEveryVerbTakesThem) {
  const Folder folder;
  const std::string into = folder.path("hard");
  const std::string mine = "corpus mine --section fanuc/tool-offset --runs 300 --findings " + folder.path("findings");
  const Outcome mined = toolcomp(mine + " --into " + into);
  EXPECT_EQ(mined.status, 0) << mined.out << mined.err;
  EXPECT_NE(mined.out.find("seed 1; "), std::string::npos) << mined.out;
  const Outcome held = toolcomp("corpus hard --dir " + into);
  EXPECT_EQ(held.status, 0) << held.out << held.err;
  EXPECT_NE(held.out.find(" 0 failures"), std::string::npos) << held.out;
  EXPECT_NE(read(into + "/README.md").find("`fanuc.tool-offset.arc-radius`"), std::string::npos);

  const std::string cases = read(into + "/fanuc/tool-offset.jsonl");
  const std::string one = folder.write("one.json", cases.substr(0, cases.find('\n')));
  EXPECT_EQ(toolcomp("diff " + one).status, 0);

  EXPECT_EQ(toolcomp(mine + " --into " + folder.path("again")).status, 0);
  EXPECT_EQ(read(folder.path("again") + "/manifest.json"), read(into + "/manifest.json"));
  EXPECT_EQ(read(folder.path("again") + "/fanuc/tool-offset.jsonl"), cases);
}

TEST(CorpusHard, AWrongFigureFails) {
  const Folder folder;
  const std::string into = folder.path("hard");
  ASSERT_EQ(toolcomp("corpus mine --section fanuc/tool-offset --runs 200 --into " + into).status, 0);
  std::string manifest = read(into + "/manifest.json");
  const std::size_t at = manifest.find("\"margin\":\"") + 10;
  ASSERT_LT(at, manifest.size());
  manifest.insert(at, "9");
  static_cast<void>(folder.write("hard/manifest.json", manifest));
  const Outcome outcome = toolcomp("corpus hard --dir " + into);
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_NE(outcome.out.find("the margin is"), std::string::npos) << outcome.out;
}

TEST(CorpusHard, BadUse) {
  const Folder folder;
  const auto refused = [](const std::string& arguments, const std::string& words) {
    const Outcome outcome = toolcomp(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  };
  refused("corpus mine --runs 10", "--into");
  refused("corpus mine --runs 10 --for 10s --into " + folder.path("x"), "not both");
  refused("corpus mine --for soon --into " + folder.path("x"), "--for");
  refused("corpus mine --section fanuc/none --runs 10 --into " + folder.path("x"), "fanuc/none");
  refused("corpus hard --dir " + folder.path("none"), "manifest.json");
}

}  // namespace
