// SPDX-License-Identifier: Apache-2.0
// Finding files: written, read back, refused.
#include "certify/finding.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "certify/replay.h"
#include "host/file_writer.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"
#include "spec/language/known.h"

namespace toolcomp::certify {
namespace {

Finding example() {
  Finding f;
  f.smallest.id = "fanuc.tool-length-offset.seed-1.7";
  f.smallest.section = "fanuc/tool-length-offset";
  f.smallest.program = "G43 Z1 H1\n";
  f.smallest.setup.h[1] = {*spec::parse_decimal("-0.10"), {}};
  f.key = {"fanuc/tool-length-offset", std::string(spec::clauses()[0].id), "coordinate"};
  f.difference.line = 1;
  f.difference.field = "axes.Z";
  f.difference.expected = "0.9 \"exact\"\n<b>";
  f.difference.actual = "1.1";
  f.difference.deviation_um = 200;
  f.errors = "servo \x01\xff not ready";
  f.status = "killed by signal 11 (Segmentation fault)";
  f.controller = "./cnc --option 'a b'";
  f.directory = "/home/a b";
  f.subject.name = "cnc";
  f.subject.version = "7";
  f.subject.fields = {"kind", "line"};
  f.subject.setup = R"({"units":"inch"})";
  f.before = {f.smallest, f.smallest};
  f.before[1].program = "G49\n";
  f.seen = 3;
  f.tried = 10;
  f.seed = "1";
  f.tool = "toolcomp 0.1.0";
  f.first_case = "fanuc.tool-length-offset.seed-1.3";
  f.occurrences = 12;
  f.not_settled = "no time was left";
  return f;
}

TEST(FindingFile, IsReadAsItWasWritten) {
  const Finding f = example();
  const Finding again = read_finding(write_finding(f), "finding.json");
  EXPECT_EQ(spec::write_case(again.smallest), spec::write_case(f.smallest));
  EXPECT_EQ(again.key, f.key);
  EXPECT_EQ(again.difference.line, f.difference.line);
  EXPECT_EQ(again.difference.field, f.difference.field);
  EXPECT_EQ(again.difference.expected, f.difference.expected);
  EXPECT_EQ(again.difference.actual, f.difference.actual);
  EXPECT_EQ(again.difference.deviation_um, f.difference.deviation_um);
  EXPECT_EQ(again.controller, f.controller);
  EXPECT_EQ(again.not_settled, f.not_settled);
  EXPECT_EQ(again.status, f.status);
  EXPECT_EQ(again.directory, f.directory);
  EXPECT_EQ(write_capabilities(again.subject), write_capabilities(f.subject));
  ASSERT_EQ(again.before.size(), 2U);
  EXPECT_EQ(again.before[1].program, "G49\n");
  EXPECT_EQ(again.seen, 3U);
  EXPECT_EQ(again.tried, 10U);
  EXPECT_EQ(again.seed, f.seed);
  EXPECT_EQ(again.tool, f.tool);
  EXPECT_EQ(again.first_case, f.first_case);
  EXPECT_EQ(again.occurrences, f.occurrences);
}

// A finding of a certificate that left something out is judged again in the same way.
TEST(FindingFile, KeepsWhatWasJudged) {
  Finding f = example();
  EXPECT_FALSE(nlohmann::json::parse(write_finding(f)).contains("judged"));
  EXPECT_TRUE(read_finding(write_finding(f), "f").subject.known.is_all());
  f.subject.known = spec::KnownSet::of({"sister", "manual"});
  const auto json = nlohmann::json::parse(write_finding(f));
  EXPECT_EQ(json["judged"], nlohmann::json::parse(R"(["manual", "sister"])"));
  EXPECT_EQ(json["known"], spec::known_name(spec::clauses()[0].known));
  EXPECT_EQ(json["source"], spec::cited(spec::clauses()[0]));
  EXPECT_EQ(read_finding(write_finding(f), "f").subject.known, f.subject.known);
  f.key.clause.clear();
  EXPECT_FALSE(nlohmann::json::parse(write_finding(f)).contains("known"));
}

// Digits must not pass through a double on their way: 0.1 as written, however many digits follow.
TEST(FindingFile, KeepsTheDigitsOfItsCase) {
  Finding f = example();
  f.before.clear();
  std::string text = write_finding(f);
  const std::size_t at = text.find("\"-0.10\"");
  ASSERT_NE(at, std::string::npos) << text;
  text.replace(at, 7, "-0.100000000000000001");
  EXPECT_EQ(to_string(read_finding(text, "f").smallest.setup.h.at(1).geometry), "-.100000000000000001");
}

TEST(FindingFile, IsValidJsonWhateverTheControllerPrinted) {
  EXPECT_FALSE(nlohmann::json::parse(write_finding(example()), nullptr, false).is_discarded());
}

TEST(FindingFile, ABareCaseWillDo) {
  const Finding f = read_finding(spec::write_case(example().smallest), "case.json");
  EXPECT_EQ(f.smallest.program, "G43 Z1 H1\n");
  EXPECT_EQ(f.key.kind, "");
}

TEST(FindingFile, RefusesWhatIsNone) {
  for (const char* text :
       {"", "[]", "{\"finding\":1}", "{\"finding\":2,\"case\":{}}", "{\"finding\":1,\"case\":{},\"colour\":1}",
        "{\"finding\":1,\"kind\":3,\"case\":{}}", "{\"finding\":1,\"line\":-1,\"case\":{}}", "not json"})
    EXPECT_THROW(read_finding(text, "f.json"), spec::InputError) << text;
}

TEST(FindingFile, ReplayOfAMissingFileIsBadInput) { EXPECT_THROW(replay("/nowhere/finding.json"), spec::InputError); }

// What the built-in engine does right is not reproduced.
TEST(FindingFile, ReplayJudgesAgain) {
  Finding f = example();
  f.controller.clear();
  const auto path = std::filesystem::path(testing::TempDir()) / "toolcomp-replay.json";
  host::write_file(path, write_finding(f));
  const Replay r = replay(path);
  EXPECT_EQ(r.judgement.result, Result::agrees);
  EXPECT_FALSE(r.reproduced());
  EXPECT_EQ(exit_status(r.judgement.result), 0);
}

TEST(FilesOfFindings, AreWrittenWholeOrNotAtAll) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "toolcomp-files";
  std::filesystem::remove_all(folder);
  host::write_file(folder / "deep" / "file", "one");
  host::write_file(folder / "deep" / "file", "two");
  EXPECT_EQ(spec::read_file(folder / "deep" / "file"), "two");
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder / "deep")) ++entries;
  EXPECT_EQ(entries, 1U);
  EXPECT_THROW(host::write_file(folder / "deep", "over a folder"), std::runtime_error);
  EXPECT_THROW(spec::read_file(folder / "none"), spec::InputError);
  EXPECT_THROW(spec::read_file(folder), spec::InputError);
  EXPECT_THROW(spec::read_file(folder / "deep" / "file", 2), spec::InputError);
}

}  // namespace
}  // namespace toolcomp::certify
