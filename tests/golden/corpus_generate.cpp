// SPDX-License-Identifier: Apache-2.0
// Generation: versions, seeds, and that what cannot be right is refused. That it gives the corpus of the tree, byte for
// byte: command_line/certify.cpp.
#include "corpus/generate.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "corpus/lint.h"
#include "corpus/select.h"
#include "corpus/vector.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace toolcomp::corpus {
namespace {

namespace fs = std::filesystem;

class Generation : public testing::Test {
 protected:
  void SetUp() override {
    options_.folder = fs::path(testing::TempDir()) /
                      (std::string("generate_") + testing::UnitTest::GetInstance()->current_test_info()->name() + "_" +
                       std::to_string(::getpid()));
    fs::remove_all(options_.folder);
  }
  void TearDown() override { fs::remove_all(options_.folder); }

  // Few and quick.
  void little() {
    options_.vectors = 5;
    options_.candidates = 20;
    options_.sections = {"fanuc/leading-edge-offset"};
  }

  GenerateOptions options_;
};

TEST_F(Generation, IsClean) {
  little();
  EXPECT_TRUE(generate(options_).rejected.empty());
  EXPECT_TRUE(lint(options_.folder).empty());
}

// A new folder has the version of the tree.
TEST_F(Generation, AgainLeavesTheVersion) {
  little();
  const Version tree = parse_version(read_manifest(default_folder()).version);
  ASSERT_NE(to_string(tree), "1.0.0");
  EXPECT_EQ(generate(options_).version, to_string(tree));
  EXPECT_EQ(read_manifest(options_.folder).version, to_string(tree));
  EXPECT_EQ(generate(options_).version, to_string(tree));
  options_.candidates = 30;  // the first twenty are the same: vectors are added, some may be chosen otherwise
  const Version version = parse_version(generate(options_).version);
  EXPECT_TRUE(version == (Version{tree.major, tree.minor + 1, 0}) || version == (Version{tree.major + 1, 0, 0}))
      << to_string(version);
  options_.version = "7.8.9";
  EXPECT_EQ(generate(options_).version, "7.8.9");
}

TEST_F(Generation, AnotherSeedGivesOtherVectors) {
  little();
  const auto one = select("fanuc/leading-edge-offset", {1, 5, 20});
  const auto two = select("fanuc/leading-edge-offset", {2, 5, 20});
  ASSERT_GE(one.size(), 5U);
  ASSERT_GE(two.size(), 5U);
  for (const spec::Case& a : one)
    EXPECT_TRUE(std::ranges::none_of(two, [&](const spec::Case& b) { return a.id == b.id; })) << a.id;
}

TEST_F(Generation, OneSectionLeavesTheFilesOfOthers) {
  little();
  generate(options_);
  options_.sections = {"fanuc/tool-length-offset"};
  generate(options_);
  const Manifest manifest = read_manifest(options_.folder);
  EXPECT_EQ(manifest.files.size(), 6U);
  EXPECT_TRUE(lint(options_.folder).empty());
}

TEST_F(Generation, UnknownSection) {
  options_.sections = {"fanuc/no-such-section"};
  EXPECT_THROW(generate(options_), spec::InputError);
  EXPECT_FALSE(fs::exists(options_.folder / "manifest.json"));
}

// What both engines refuse, or nobody can decide, is no vector.
TEST(Vectors, NotEverythingCanBeOne) {
  spec::Case c;
  c.section = "fanuc/leading-edge-offset";
  c.setup = spec::read_setup_toml("control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n", "setup");
  c.program = "(nothing)\n";
  EXPECT_EQ(complete(c), "nothing could be judged");
  c.program = std::string("X1\0\n", 4);
  EXPECT_EQ(complete(c), "the program cannot be read");
  c.setup.parameters[{19631, -1}] = spec::decimal(91);
  c.program = "X1\n";
  EXPECT_EQ(complete(c), "no control could have this setup");
}

TEST(Vectors, TheIdBelongsToTheQuestion) {
  spec::Case c;
  c.section = "fanuc/leading-edge-offset";
  c.program = "X1\n";
  const std::string id = vector_id(c);
  EXPECT_TRUE(id.starts_with("fanuc.leading-edge-offset."));
  c.comment = "Words do not matter.";
  EXPECT_EQ(vector_id(c), id);
  c.program = "X2\n";
  EXPECT_NE(vector_id(c), id);
  c.program = "X1\n";
  c.samples = 4;
  EXPECT_NE(vector_id(c), id);
}

}  // namespace
}  // namespace toolcomp::corpus
