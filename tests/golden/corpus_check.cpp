// SPDX-License-Identifier: Apache-2.0
// The golden corpus as it stands: both engines give every vector, every outcome of every clause is exercised, and
// nothing in it breaks its rules. Then the tools themselves, on small corpora spoilt by hand.
#include "corpus/check.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "corpus/diff.h"
#include "corpus/lint.h"
#include "fuzz/gen/generator.h"
#include "host/file_writer.h"
#include "host/sha256.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"

namespace toolcomp::corpus {
namespace {

namespace fs = std::filesystem;

TEST(GoldenCorpus, BothEnginesGiveEveryVector) {
  const CheckResult result = check({});
  for (const Failure& failure : result.failures)
    ADD_FAILURE() << failure.file << ':' << failure.line << ": " << failure.what;
  EXPECT_EQ(result.undecided, 0U);
  EXPECT_GT(result.values, 10'000U);
}

TEST(GoldenCorpus, KeepsItsRules) {
  for (const std::string& breach : lint()) ADD_FAILURE() << breach;
}

TEST(GoldenCorpus, ExercisesEveryOutcomeOfEveryClause) {
  for (const spec::ClauseOutcome& outcome : spec::missing_outcomes(coverage().counts))
    ADD_FAILURE() << spec::info(outcome.clause).id << ": " << outcome.name;
}

TEST(GoldenCorpus, HasTwoHundredGeneratedVectorsASection) {
  std::map<std::string, std::size_t> generated;
  for (const ManifestFile& file : read_manifest(default_folder()).files)
    if (file.file.ends_with("/generated.jsonl")) generated[file.section] = file.vectors;
  ASSERT_EQ(generated.size(), fuzz::sections().size());
  for (const auto& [section, vectors] : generated) EXPECT_GE(vectors, 200U) << section;
}

TEST(GoldenCorpus, ShardsPartIt) {
  std::map<std::string, int> seen;
  for (std::size_t i = 1; i <= 3; ++i) {
    Selection selection;
    set_shard(selection.share, std::to_string(i) + "/3");
    for (const Vector& vector : read_vectors(default_folder(), selection)) ++seen[vector.c.id];
  }
  EXPECT_EQ(seen.size(), read_golden(default_folder()).size());
  EXPECT_TRUE(std::ranges::all_of(seen, [](const auto& entry) { return entry.second == 1; }));
}

TEST(GoldenCorpus, BadShardsAndSections) {
  Selection selection;
  for (const char* shard : {"0/3", "4/3", "1", "1/", "/3", "a/b", "1/3x", "-1/3"})
    EXPECT_THROW(set_shard(selection.share, shard), spec::InputError) << shard;
  EXPECT_THROW(read_vectors(default_folder(), {.sections = {"fanuc/no-such-section"}, .share = {}}), spec::InputError);
  EXPECT_THROW(read_vectors("no-such-folder"), spec::InputError);
}

// A subject that answers nothing is no pass.
TEST(GoldenCorpus, ASubjectThatJudgesNothingFails) {
  CheckOptions options;
  options.selection = {.sections = {"fanuc/leading-edge-offset"}, .share = {.index = 1, .count = 50}};
  options.judged_by = [](const spec::Case&, const judge::ModelRun&) { return judge::Verdict(); };
  const CheckResult result = check(options);
  EXPECT_GT(result.vectors, 0U);
  EXPECT_EQ(result.failures.size(), result.vectors);
}

// A copy of the hand-written vectors of one section, to be spoilt.
class SmallCorpus : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("corpus_") + testing::UnitTest::GetInstance()->current_test_info()->name() + "_" +
               std::to_string(::getpid()));
    fs::remove_all(folder_);
    text_ = spec::read_file(default_folder() / kFile);
    put(text_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  // The file and a manifest that fits it.
  void put(const std::string& text) {
    host::write_file(folder_ / kFile, text);
    Manifest manifest;
    const auto vectors = static_cast<std::size_t>(std::ranges::count(text, '\n'));
    manifest.files = {{kFile, "fanuc/leading-edge-offset", vectors, host::sha256(text)}};
    host::write_file(folder_ / "manifest.json", write_manifest(manifest));
  }
  // The text with the first `from` replaced.
  [[nodiscard]] std::string replaced(const std::string& from, const std::string& to) const {
    std::string text = text_;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }
  // The text with this flag alone in its first vector.
  [[nodiscard]] std::string flagged(const std::string& flag) const {
    spec::Case c = read_cases(default_folder() / kFile).front();
    c.flags = {flag};
    return spec::write_case_line(c) + text_.substr(text_.find('\n'));
  }
  CheckResult checked() {
    CheckOptions options;
    options.folder = folder_;
    return check(options);
  }

  static constexpr const char* kFile = "fanuc/leading-edge-offset/examples.jsonl";
  fs::path folder_;
  std::string text_;
};

TEST_F(SmallCorpus, IsCleanAsItIs) {
  EXPECT_TRUE(lint(folder_).empty());
  EXPECT_TRUE(checked().failures.empty());
}

// LE1's point is (-8, 0, 6).
TEST_F(SmallCorpus, AWrongNumberFails) {
  put(replaced(R"({"v":"-8","r":"0","q":"-8/1"})", R"({"v":"-8.000000000000001","r":"0","q":"-8/1"})"));
  const CheckResult result = checked();
  ASSERT_EQ(result.failures.size(), 1U);
  EXPECT_EQ(result.failures[0].line, 1U);
  EXPECT_NE(result.failures[0].what.find("-8.000000000000001"), std::string::npos) << result.failures[0].what;
}

TEST_F(SmallCorpus, AMissingEventFails) {
  spec::Case c = read_cases(folder_ / kFile).front();
  c.expect.pop_back();
  put(spec::write_case_line(c) + '\n');
  ASSERT_EQ(checked().failures.size(), 1U);
  EXPECT_NE(checked().failures[0].what.find("nothing expected, the model gives"), std::string::npos);
}

TEST_F(SmallCorpus, WrongClausesAndFlagsFail) {
  put(replaced(R"("clauses":["fanuc.leading-edge.vector",)", R"("clauses":[)"));
  ASSERT_EQ(checked().failures.size(), 1U);
  EXPECT_TRUE(checked().failures[0].what.starts_with("clauses: "));
  put(flagged("near-tie"));
  ASSERT_EQ(checked().failures.size(), 1U);
  EXPECT_TRUE(checked().failures[0].what.starts_with("flags: ")) << checked().failures[0].what;
}

TEST_F(SmallCorpus, LintFindsForeignFiles) {
  host::write_file(folder_ / "fanuc/leading-edge-offset/examples.jsonl.rej", "");
  EXPECT_EQ(lint(folder_), std::vector<std::string>{std::string(kFile) + ".rej: does not belong to the corpus"});
}

TEST_F(SmallCorpus, LintFindsChangedBytes) {
  std::ofstream(folder_ / kFile, std::ios::app) << '\n';
  EXPECT_EQ(lint(folder_),
            std::vector<std::string>{std::string(kFile) + ": the SHA-256 is not the one in the manifest"});
}

TEST_F(SmallCorpus, LintFindsOtherFormatting) {
  put(replaced(R"({"case":1,)", R"({"case": 1,)"));
  EXPECT_EQ(lint(folder_),
            std::vector<std::string>{std::string(kFile) + ":1: the line is not in the form that toolcomp writes"});
}

TEST_F(SmallCorpus, LintFindsAnIdThatIsNotItsOwn) {
  put(replaced("G01 X100", "G01 X101"));
  EXPECT_EQ(lint(folder_), std::vector<std::string>{std::string(kFile) + ":1: the id does not belong to this vector"});
}

TEST_F(SmallCorpus, LintFindsRepetition) {
  put(text_.substr(0, text_.find('\n') + 1) + text_);
  EXPECT_EQ(lint(folder_), std::vector<std::string>{std::string(kFile) + ":2: the same vector occurs twice"});
}

TEST_F(SmallCorpus, LintFindsUnknownFlags) {
  put(flagged("odd"));
  EXPECT_EQ(lint(folder_), std::vector<std::string>{std::string(kFile) + ":1: unknown flag odd"});
}

TEST_F(SmallCorpus, WhatIsNoCaseIsNamedWithItsLine) {
  put(text_ + "{\"case\":1}\n");
  try {
    read_golden(folder_);
    FAIL();
  } catch (const spec::InputError& error) {
    EXPECT_EQ(error.line(), static_cast<std::uint64_t>(std::ranges::count(text_, '\n')) + 1);
  }
}

// The differences and versions below are counted by hand.
TEST(CorpusDiff, EveryKindOfChange) {
  std::vector<spec::Case> before = read_cases(default_folder() / "fanuc/leading-edge-offset/examples.jsonl");
  before.resize(4);
  std::vector<spec::Case> after = before;
  EXPECT_TRUE(diff(before, after).empty());
  after.erase(after.begin());                 // 0 is removed,
  after[0].expect[1].point.value[0].v = "9";  // 1 is changed in its second event,
  after[1].comment = "Other words.";          // 2 is described otherwise,
  after.push_back(read_cases(default_folder() / "fanuc/leading-edge-offset/rules.jsonl").front());  // one is added
  const std::vector<Change> changes = diff(before, after);
  ASSERT_EQ(changes.size(), 4U);
  EXPECT_EQ(changes[0].kind, ChangeKind::removed);
  EXPECT_EQ(changes[0].id, before[0].id);
  EXPECT_EQ(changes[1].kind, ChangeKind::changed);
  EXPECT_EQ(changes[1].id, before[1].id);
  EXPECT_TRUE(changes[1].clause.starts_with("fanuc.")) << changes[1].clause;
  EXPECT_NE(changes[1].after.find(R"("X":{"v":"9")"), std::string::npos) << changes[1].after;
  EXPECT_EQ(changes[2].kind, ChangeKind::described);
  EXPECT_EQ(changes[3].kind, ChangeKind::added);

  // Asked again, 0 is answered as it was; with another expectation it is not.
  std::vector<Change> asked = changes;
  ask_again(asked, before);
  EXPECT_EQ(to_string(asked[0]), to_string(changes[0]));
  EXPECT_EQ(by_clause(asked), (std::map<std::string, std::size_t>{{changes[1].clause, 1}}));
  before[0].expect[0].line = 7;
  ask_again(asked, before);
  EXPECT_EQ(asked[0].kind, ChangeKind::removed);
  EXPECT_NE(asked[0].before.find("\"line\":7"), std::string::npos) << asked[0].before;
  EXPECT_NE(asked[0].after, asked[0].before);

  const Version version{2, 3, 4};
  EXPECT_EQ(to_string(raised(version, changes)), "3.0.0");
  EXPECT_EQ(to_string(raised(version, std::vector<Change>{changes[3]})), "2.4.0");
  EXPECT_EQ(to_string(raised(version, std::vector<Change>{changes[2]})), "2.3.5");
  EXPECT_EQ(to_string(raised(version, {})), "2.3.4");
}

TEST(CorpusVersion, Text) {
  EXPECT_EQ(parse_version("1.20.3"), (Version{1, 20, 3}));
  for (const char* text : {"", "1", "1.2", "1.2.3.4", "1.2.x", "01.2.3", "1..3", "1.2.3 "})
    EXPECT_THROW(parse_version(text), std::invalid_argument) << text;
}

TEST(CorpusManifest, ReadsWhatItWrites) {
  const fs::path folder = fs::path(testing::TempDir()) / ("corpus_manifest_" + std::to_string(::getpid()));
  Manifest manifest;
  manifest.version = "1.2.3";
  manifest.generator = "g";
  manifest.seed = "7";
  manifest.files = {{"a/b.jsonl", "a", 4, host::sha256("x")}};
  host::write_file(folder / "manifest.json", write_manifest(manifest));
  const Manifest read = read_manifest(folder);
  EXPECT_EQ(read.version, "1.2.3");
  EXPECT_EQ(read.seed, "7");
  EXPECT_EQ(read.files, manifest.files);
  EXPECT_EQ(read.hash, host::sha256(write_manifest(manifest)));
  for (const char* bad : {"", "{", "{}", R"({"corpus":2})", R"({"corpus":1,"version":"x"})"}) {
    host::write_file(folder / "manifest.json", bad);
    EXPECT_THROW(read_manifest(folder), spec::InputError) << bad;
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace toolcomp::corpus
