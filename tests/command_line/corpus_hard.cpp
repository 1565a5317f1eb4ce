// SPDX-License-Identifier: Apache-2.0
// `toolcomp corpus hard` as a user runs it.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;

const std::string kHard = TOOLCOMP_SOURCE_DIR "/corpus/hard";

TEST(CorpusHard, TheyHoldAndEveryVerbTakesThem) {
  const Outcome held = toolcomp("corpus hard --section fanuc/tool-offset");
  EXPECT_EQ(held.status, 0) << held.out << held.err;
  EXPECT_NE(held.out.find(" 0 failures"), std::string::npos) << held.out;
  const Folder folder;
  const std::string cases = read(kHard + "/fanuc/tool-offset.jsonl");
  const std::string one = folder.write("one.json", cases.substr(0, cases.find('\n')));
  EXPECT_EQ(toolcomp("diff " + one).status, 0);
}

TEST(CorpusHard, AWrongFigureFails) {
  const Folder folder;
  std::filesystem::copy(kHard, folder.path("hard"), std::filesystem::copy_options::recursive);
  std::string manifest = read(kHard + "/manifest.json");
  const std::size_t one = manifest.find("\"case\":\"fanuc.tool-offset.");
  const std::size_t at = manifest.rfind("\"margin\":\"", one) + 10;
  ASSERT_LT(at, one);
  manifest.insert(at, "9");
  static_cast<void>(folder.write("hard/manifest.json", manifest));
  const Outcome outcome = toolcomp("corpus hard --section fanuc/tool-offset --dir " + folder.path("hard"));
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_NE(outcome.out.find("the margin is"), std::string::npos) << outcome.out;
}

TEST(CorpusHard, BadUse) {
  const Folder folder;
  const Outcome outcome = toolcomp("corpus hard --dir " + folder.path("none"));
  EXPECT_EQ(outcome.status, 2) << outcome.out << outcome.err;
  EXPECT_NE(outcome.err.find("manifest.json"), std::string::npos) << outcome.err;
}

}  // namespace
