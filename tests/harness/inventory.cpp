// SPDX-License-Identifier: Apache-2.0
// Nothing is forgotten: every section has its twin targets, every target has seeds, the seeds are cases that are
// judged.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include "fuzz/campaign/target.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/policy.h"
#include "judge/oracle/trial.h"

namespace toolcomp::fuzz {
namespace {

namespace fs = std::filesystem;

fs::path root() { return TOOLCOMP_SOURCE_DIR; }

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// What fuzz/CMakeLists.txt builds: one target a file, by the name of the file; and its folder, which is that of its
// seeds: a dialect, or none.
std::map<std::string, fs::path> targets_of_the_tree() {
  std::map<std::string, fs::path> names;
  const fs::path all = root() / "fuzz/targets";
  for (const auto& entry : fs::recursive_directory_iterator(all))
    if (entry.path().extension() == ".cpp") {
      const fs::path folder = fs::relative(entry.path(), all).replace_extension();
      EXPECT_TRUE(names.emplace(entry.path().stem(), folder).second) << entry.path();
    }
  // Its readers are of the room that knows them.
  EXPECT_TRUE(fs::exists(root() / "certify/read_outside.cc"));
  names.emplace("read_outside", "read_outside");
  return names;
}

std::string dialect(std::string_view section) { return std::string(section.substr(0, section.find('/'))); }

std::string twin(std::string_view section, Mode mode) {
  std::string name(section.substr(section.find('/') + 1));
  std::replace(name.begin(), name.end(), '-', '_');
  return name + (mode == Mode::directed ? "_directed" : "_unrestricted");
}

TEST(Inventory, EverySectionHasItsTwinTargetsAndARowOfThePolicy) {
  for (const std::string_view section : sections()) {
    for (const Mode mode : {Mode::directed, Mode::unrestricted}) {
      const std::string name = twin(section, mode);
      EXPECT_TRUE(targets_of_the_tree().contains(name)) << name;
      const std::string source = contents(root() / "fuzz/targets" / dialect(section) / (name + ".cpp"));
      EXPECT_NE(source.find("\"" + std::string(section) + "\""), std::string::npos) << name;
      EXPECT_NE(source.find(mode == Mode::directed ? "Mode::directed" : "Mode::unrestricted"), std::string::npos)
          << name;
    }
    EXPECT_EQ(judge::policy::budget(section).section, section);
  }
}

TEST(Inventory, EveryTargetHasSeedsAndEverySeedFolderATarget) {
  const fs::path seeds = root() / "corpus/seeds";
  std::set<fs::path> folders;
  for (const auto& [name, folder] : targets_of_the_tree()) {
    ASSERT_TRUE(fs::is_directory(seeds / folder)) << folder;
    EXPECT_GT(std::distance(fs::directory_iterator(seeds / folder), fs::directory_iterator()), 0) << folder;
    folders.insert(folder);
  }
  for (const auto& entry : fs::recursive_directory_iterator(seeds))
    if (entry.is_regular_file()) {
      EXPECT_TRUE(folders.contains(fs::relative(entry.path().parent_path(), seeds))) << entry.path();
    }
}

TEST(Inventory, EverySeedOfASectionIsACaseOnWhichTheEnginesAgree) {
  for (const std::string_view section : sections())
    for (const Mode mode : {Mode::directed, Mode::unrestricted})
      for (const auto& entry :
           fs::directory_iterator(root() / "corpus/seeds" / dialect(section) / twin(section, mode))) {
        const spec::Case c = decode(section, contents(entry.path()));
        EXPECT_FALSE(c.program.empty()) << entry.path();
        const judge::Trial t = judge::try_case(c);
        EXPECT_FALSE(t.found()) << entry.path() << ": " << explain(*t.verdict.difference);
        if (mode == Mode::directed) {
          EXPECT_EQ(t.acceptance, judge::Acceptance::accepted) << entry.path();
        }
      }
}

// A campaign knows the targets by a list of its own.
TEST(Inventory, CampaignsKnowEveryTarget) {
  std::map<std::string, fs::path> known;
  for (const Target& target : fuzz::targets()) known.emplace(target.name, target.seeds);
  EXPECT_EQ(known, targets_of_the_tree());
}

// The short run of every target in CI takes its list from the same folder.
TEST(Inventory, ShortRunsTakeEveryTarget) {
  const std::string script = contents(root() / "tests/fuzz_briefly");
  EXPECT_NE(script.find("find fuzz/targets -name '*.cpp'"), std::string::npos);
  EXPECT_NE(script.find("echo read_outside"), std::string::npos);
}

}  // namespace
}  // namespace toolcomp::fuzz
