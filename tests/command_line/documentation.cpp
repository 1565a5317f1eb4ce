// SPDX-License-Identifier: Apache-2.0
// The README's generated table is what the command prints.
#include <gtest/gtest.h>

#include <string>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::read;
using toolcomp::test::toolcomp;

TEST(Documentation, TheTableOfSectionsIsCurrent) {
  const std::string readme = read(TOOLCOMP_SOURCE_DIR "/README.md");
  const std::string begin = "<!-- sections -->\n```\n";
  const std::size_t from = readme.find(begin);
  ASSERT_NE(from, std::string::npos);
  const std::size_t to = readme.find("```\n<!-- /sections -->", from);
  ASSERT_NE(to, std::string::npos);
  EXPECT_EQ(readme.substr(from + begin.size(), to - from - begin.size()), toolcomp("spec sections").out)
      << "put the output of `toolcomp spec sections` there";
}

TEST(Documentation, HowWellTheClausesAreKnownIsCurrent) {
  const std::string readme = read(TOOLCOMP_SOURCE_DIR "/README.md");
  const std::string begin = "<!-- known -->";
  const std::size_t from = readme.find(begin);
  ASSERT_NE(from, std::string::npos);
  const std::size_t to = readme.find("<!-- /known -->", from);
  ASSERT_NE(to, std::string::npos);
  const std::string words = readme.substr(from + begin.size(), to - from - begin.size());
  EXPECT_TRUE(toolcomp("spec sections").out.ends_with("\n" + words + "\n"))
      << "put the last line of `toolcomp spec sections` there";
}

TEST(Documentation, TheTablesOfKeysAndParametersAreCurrent) {
  const std::string readme = read(TOOLCOMP_SOURCE_DIR "/spec/parameters/README.md");
  for (const std::string name : {"keys", "parameters", "alarms"}) {
    const std::string begin = "<!-- " + name + " -->\n";
    const std::size_t from = readme.find(begin);
    ASSERT_NE(from, std::string::npos);
    const std::size_t to = readme.find("<!-- /" + name + " -->", from);
    ASSERT_NE(to, std::string::npos);
    EXPECT_EQ(readme.substr(from + begin.size(), to - from - begin.size()), toolcomp("spec " + name).out)
        << "put the output of `toolcomp spec " << name << "` there";
  }
}

TEST(Documentation, TheExampleOfASetupIsValid) {
  const toolcomp::test::Folder folder;
  const std::string example = toolcomp("config example --control fanuc").out;
  ASSERT_FALSE(example.empty());
  EXPECT_EQ(toolcomp("config check " + folder.write("setup.toml", example)).status, 0);
}

}  // namespace
