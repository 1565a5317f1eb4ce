// SPDX-License-Identifier: Apache-2.0
// Shards of generation: what they give together is what one machine gives, and what is missing or foreign is named.
#include "corpus/shard.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "corpus/select.h"
#include "host/file_writer.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"

namespace toolcomp::corpus {
namespace {

namespace fs = std::filesystem;

class Shards : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("shards_") + testing::UnitTest::GetInstance()->current_test_info()->name() + "_" +
               std::to_string(::getpid()));
    fs::remove_all(folder_);
    options_.vectors = 6;
    options_.candidates = 40;
    options_.sections = {"fanuc/leading-edge-offset", "heidenhain/face-milling"};
  }
  void TearDown() override { fs::remove_all(folder_); }

  GenerateOptions into(const std::string& name) const {
    GenerateOptions options = options_;
    options.folder = folder_ / name;
    return options;
  }
  void write(std::size_t index, std::size_t count) { write_shard(into("shards"), {index, count}); }

  // What merging says is wrong.
  std::string refusal() {
    try {
      // Everything else comes from the shards.
      GenerateOptions options;
      options.folder = folder_ / "merged";
      merge_shards(folder_ / "shards", options);
    } catch (const spec::InputError& error) {
      EXPECT_FALSE(fs::exists(folder_ / "merged"));
      return error.what();
    }
    return "";
  }
  void expect_same(const std::string& a, const std::string& b) const {
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / a)) {
      if (!entry.is_regular_file()) continue;
      ++files;
      EXPECT_EQ(spec::read_file(entry.path()), spec::read_file(folder_ / b / fs::relative(entry.path(), folder_ / a)));
    }
    EXPECT_GT(files, 4U);
  }

  fs::path folder_;
  GenerateOptions options_;
};

TEST_F(Shards, TogetherGiveWhatOneMachineGives) {
  generate(into("one"));
  for (const std::size_t i : {3U, 1U, 2U}) write(i, 3);
  EXPECT_EQ(refusal(), "");
  expect_same("one", "merged");
  expect_same("merged", "one");
}

// However the work is cut: by one shard, and by more of them than there are candidates for.
TEST_F(Shards, AnyNumberGivesTheSameChoice) {
  constexpr std::string_view section = "fanuc/cutter-compensation-c";
  const SelectOptions options{7, 20, 50};
  const auto whole = select(section, options);
  for (const std::size_t count : {1U, 2U, 7U, 60U}) {
    std::vector<Contender> all;
    for (std::size_t i = count; i >= 1; --i)
      look(section, options, {i, count}, [&](const Contender& contender) { all.push_back(contender); });
    const auto merged = select(section, options, std::move(all));
    ASSERT_EQ(merged.size(), whole.size()) << count;
    for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_EQ(merged[i].id, whole[i].id) << count;
  }
}

// What a shard did not keep is looked at where the whole needs it: nothing rests on how much shards keep.
TEST_F(Shards, WithoutContendersTheChoiceIsTheSame) {
  constexpr std::string_view section = "heidenhain/face-milling";
  const SelectOptions options{1, 30, 30};
  const auto whole = select(section, options);
  const auto alone = select(section, options, std::vector<Contender>());
  ASSERT_EQ(alone.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_EQ(alone[i].id, whole[i].id);
}

TEST_F(Shards, LostOnesAreNamed) {
  write(2, 4);
  const std::string why = refusal();
  EXPECT_NE(why.find("1/4 3/4 4/4"), std::string::npos) << why;
  write(1, 4);
  write(4, 4);
  EXPECT_NE(refusal().find("again: 3/4"), std::string::npos);
}

TEST_F(Shards, NoneOrOfTwoRuns) {
  EXPECT_NE(refusal().find("is not a folder"), std::string::npos);
  fs::create_directories(folder_ / "shards");
  EXPECT_NE(refusal().find("contains no shard"), std::string::npos);
  write(1, 2);
  write(1, 3);
  EXPECT_NE(refusal().find("shards of "), std::string::npos);
}

TEST_F(Shards, OfAnotherSeedOrDamaged) {
  write(1, 2);
  options_.seed = 2;
  write(2, 2);
  EXPECT_NE(refusal().find("is from another run"), std::string::npos);
  options_.seed = 1;
  write(2, 2);
  const fs::path file = shard_file(folder_ / "shards", {2, 2});
  const std::string whole = spec::read_file(file);
  for (const std::string& damaged : {whole.substr(0, whole.size() / 2), std::string(), whole + "\n", "x" + whole}) {
    host::write_file(file, damaged);
    EXPECT_NE(refusal().find("digest"), std::string::npos) << damaged.size();
  }
  host::write_file(file, whole);
  EXPECT_EQ(refusal(), "");
}

}  // namespace
}  // namespace toolcomp::corpus
