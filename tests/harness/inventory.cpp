// Nothing is forgotten: every section has its twin targets, every target has seeds, the seeds are cases that are
// judged.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "fuzz/oracle/policy.h"
#include "fuzz/oracle/trial.h"

namespace toolcomp::fuzz {
namespace {

namespace fs = std::filesystem;

fs::path root() { return TOOLCOMP_SOURCE_DIR; }

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// What fuzz/CMakeLists.txt builds: one target a file, in any folder, by the name of the file.
std::set<std::string> targets() {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(root() / "fuzz/targets"))
    if (entry.path().extension() == ".cpp") {
      EXPECT_TRUE(names.insert(entry.path().stem()).second) << entry.path();
    }
  return names;
}

std::string twin(std::string_view section, Mode mode) {
  std::string name(section.substr(section.find('/') + 1));
  std::replace(name.begin(), name.end(), '-', '_');
  return name + (mode == Mode::directed ? "_directed" : "_unrestricted");
}

TEST(Inventory, EverySectionHasItsTwinTargetsAndARowOfThePolicy) {
  for (const std::string_view section : sections()) {
    for (const Mode mode : {Mode::directed, Mode::unrestricted}) {
      const std::string name = twin(section, mode);
      EXPECT_TRUE(targets().contains(name)) << name;
      const std::string dialect(section.substr(0, section.find('/')));
      const std::string source = contents(root() / "fuzz/targets" / dialect / (name + ".cpp"));
      EXPECT_NE(source.find("\"" + std::string(section) + "\""), std::string::npos) << name;
      EXPECT_NE(source.find(mode == Mode::directed ? "Mode::directed" : "Mode::unrestricted"), std::string::npos)
          << name;
    }
    EXPECT_EQ(policy::budget(section).section, section);
  }
}

TEST(Inventory, EveryTargetHasSeedsAndEverySeedFolderATarget) {
  for (const std::string& name : targets()) {
    const fs::path folder = root() / "corpus/seeds" / name;
    ASSERT_TRUE(fs::is_directory(folder)) << name;
    EXPECT_GT(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 0) << name;
  }
  for (const auto& entry : fs::directory_iterator(root() / "corpus/seeds"))
    if (entry.is_directory()) {
      EXPECT_TRUE(targets().contains(entry.path().filename())) << entry.path();
    }
}

TEST(Inventory, EverySeedOfASectionIsACaseOnWhichTheEnginesAgree) {
  for (const std::string_view section : sections())
    for (const Mode mode : {Mode::directed, Mode::unrestricted})
      for (const auto& entry : fs::directory_iterator(root() / "corpus/seeds" / twin(section, mode))) {
        const spec::Case c = decode(section, contents(entry.path()));
        EXPECT_FALSE(c.program.empty()) << entry.path();
        const Trial t = try_case(c);
        EXPECT_FALSE(t.found()) << entry.path() << ": " << explain(*t.verdict.difference);
        if (mode == Mode::directed) {
          EXPECT_EQ(t.acceptance, Acceptance::accepted) << entry.path();
        }
      }
}

// The short run of every target in CI takes its list from the same folder.
TEST(Inventory, ShortRunsTakeEveryTarget) {
  const std::string script = contents(root() / "tests/fuzz_briefly");
  EXPECT_NE(script.find("find fuzz/targets -name '*.cpp'"), std::string::npos);
}

}  // namespace
}  // namespace toolcomp::fuzz
