// SPDX-License-Identifier: Apache-2.0
// The README's generated table is what the command prints.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::read;
using toolcomp::test::toolcomp;

// What stands between two marks of a page, neither with it; throws where the page lacks one.
std::string between(const std::string& page, const std::string& begin, const std::string& end) {
  const std::size_t from = page.find(begin);
  if (from == std::string::npos) throw std::runtime_error("the page has no " + begin);
  const std::size_t to = page.find(end, from);
  if (to == std::string::npos) throw std::runtime_error("the page has no " + end);
  return page.substr(from + begin.size(), to - from - begin.size());
}

TEST(Documentation, TheTableOfSectionsIsCurrent) {
  const std::string readme = read(TOOLCOMP_SOURCE_DIR "/README.md");
  EXPECT_EQ(between(readme, "<!-- sections -->\n```\n", "```\n<!-- /sections -->"), toolcomp("spec sections").out)
      << "put the output of `toolcomp spec sections` there";
}

TEST(Documentation, HowWellTheClausesAreKnownIsCurrent) {
  const std::string words = between(read(TOOLCOMP_SOURCE_DIR "/README.md"), "<!-- known -->", "<!-- /known -->");
  EXPECT_TRUE(toolcomp("spec sections").out.ends_with("\n" + words + "\n"))
      << "put the last line of `toolcomp spec sections` there";
}

TEST(Documentation, TheTablesOfKeysAndParametersAreCurrent) {
  const std::string readme = read(TOOLCOMP_SOURCE_DIR "/spec/parameters/README.md");
  for (const std::string name : {"keys", "parameters", "alarms"})
    EXPECT_EQ(between(readme, "<!-- " + name + " -->\n", "<!-- /" + name + " -->"), toolcomp("spec " + name).out)
        << "put the output of `toolcomp spec " << name << "` there";
}

TEST(Documentation, TheExampleOfASetupIsValid) {
  const toolcomp::test::Folder folder;
  const std::string example = toolcomp("config example --control fanuc").out;
  ASSERT_FALSE(example.empty());
  EXPECT_EQ(toolcomp("config check " + folder.write("setup.toml", example)).status, 0);
}

}  // namespace
