// SPDX-License-Identifier: Apache-2.0
// What the pages show of the command's output is what it prints.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>

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

// The last line of `toolcomp spec sections`, "of 624 clauses, 156 from the manual, …", as the README has it.
TEST(Documentation, HowWellTheClausesAreKnownIsCurrent) {
  const std::string readme = read(TOOLCOMP_SOURCE_DIR "/README.md");
  std::string said = "of " + between(readme, "Of ", " clauses") + " clauses";
  for (const auto& [known, words] :
       {std::pair{"manual", " from the manual"}, std::pair{"sister", " from a sister manual"},
        std::pair{"recollection", " from recollection"}, std::pair{"ours", " ours"}}) {
    const std::string row = between(readme, std::string("\n| ") + known + " | ", " |\n");
    said += ", " + row.substr(row.rfind(' ') + 1) + words;
  }
  EXPECT_TRUE(toolcomp("spec sections").out.ends_with("\n" + said + "\n")) << said;
}

TEST(Documentation, ThePictureOfTheReadmeIsCurrent) {
  const std::string program = TOOLCOMP_SOURCE_DIR "/examples/fanuc/arc-figure-cutter-compensation-c/arc-figure.nc";
  EXPECT_TRUE(toolcomp("run " + program + " --format svg").out == read(TOOLCOMP_SOURCE_DIR "/docs/picture.svg"))
      << "toolcomp run " << program << " --format svg > docs/picture.svg";
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
