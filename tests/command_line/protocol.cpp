// SPDX-License-Identifier: Apache-2.0
// The protocol as docs/protocol.md tells it, and the controllers of adapters/examples.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "spec/language/fields.h"
#include "tests/command_line/command.h"

namespace {

using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;
using Json = nlohmann::json;

const std::string kExamples = TOOLCOMP_SOURCE_DIR "/adapters/examples/";
const std::string kServe = TOOLCOMP_BINARY_DIR "/toolcomp serve --engine fast";

std::string document() { return read(TOOLCOMP_SOURCE_DIR "/docs/protocol.md"); }

// The conversation at the head of the document: our own controller gives the same positions.
TEST(Protocol, TheConversationOfTheDocument) {
  std::istringstream lines(document());
  std::string requests;
  std::vector<Json> answers;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("→ ")) requests += line.substr(std::string("→ ").size()) + "\n";
    if (line.starts_with("← ")) answers.push_back(Json::parse(line.substr(std::string("← ").size())));
  }
  ASSERT_EQ(answers.size(), 2U);
  const Folder folder;
  const Outcome served = command(kServe + " <" + folder.write("requests", requests));
  EXPECT_EQ(served.status, 0) << served.err;
  std::istringstream replies(served.out);
  std::string line;
  ASSERT_TRUE(std::getline(replies, line));
  EXPECT_EQ(Json::parse(line)["protocol"], answers[0]["protocol"]);
  ASSERT_TRUE(std::getline(replies, line));
  const Json reply = Json::parse(line);
  EXPECT_EQ(reply["id"], answers[1]["id"]);
  ASSERT_EQ(reply["events"].size(), answers[1]["events"].size());
  for (const char* field : {"kind", "line", "axes"})
    EXPECT_EQ(reply["events"][0][field], answers[1]["events"][0][field]) << field;
}

// Every field of events has its row, and no other.
TEST(Protocol, TheTableOfFieldsIsWhole) {
  const std::string text = document();
  const std::size_t from = text.find("| field | in |");
  ASSERT_NE(from, std::string::npos);
  std::istringstream rows(text.substr(from, text.find("\n\n", from) - from));
  std::vector<std::string> named;
  for (std::string row; std::getline(rows, row);)
    if (row.starts_with("| `")) named.push_back(row.substr(3, row.find('`', 3) - 3));
  std::vector<std::string> all(toolcomp::spec::kFieldNames.begin(), toolcomp::spec::kFieldNames.end());
  std::ranges::sort(named);
  std::ranges::sort(all);
  EXPECT_EQ(named, all);
  std::vector<std::string> announced =
      Json::parse(toolcomp("config schema hello").out)["properties"]["fields"]["items"]["enum"];
  std::ranges::sort(announced);
  EXPECT_EQ(announced, all);
}

TEST(Protocol, SchemasByName) {
  for (const std::string name : {"setup", "case", "event", "hello", "answer"}) {
    const Json schema = Json::parse(toolcomp("config schema " + name).out, nullptr, false);
    EXPECT_EQ(schema.value("$id", ""), name + ".schema.json");
    EXPECT_EQ(read(TOOLCOMP_SOURCE_DIR "/corpus/schema/" + name + ".schema.json"),
              toolcomp("config schema " + name).out);
  }
  EXPECT_EQ(toolcomp("config schema").out, toolcomp("config schema setup").out);
  EXPECT_EQ(toolcomp("config schema cases").status, 2);
}

// Whatever cannot be read is answered, and the next request too.
TEST(Protocol, ServeAnswersWhatItCannotRead) {
  const Folder folder;
  const Outcome served = command(kServe + " <" + folder.write("requests", "what?\n{\"hello\":1}\n"));
  EXPECT_EQ(served.status, 2);
  EXPECT_NE(served.out.find("\"error\":\"stdin:1:1: "), std::string::npos) << served.out;
  EXPECT_NE(served.out.find("\"protocol\":1"), std::string::npos) << served.out;
}

class Examples : public testing::TestWithParam<std::pair<const char*, std::string>> {};

// Each is certified in what it has, and says of the rest that it does not have it.
TEST_P(Examples, AreCertified) {
  const Folder folder;
  const std::string program =
      folder.write("offsets.nc", "G90 G00 X10 Y-5.5\nG43 Z100. H1\nN3 G01 Z2 F100\nX-20.25\nG49\n");
  const std::string plain = folder.write("positions.nc", read(kExamples + "positions.nc"));
  const std::string setup =
      folder.write("setup.toml", "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.H]\n1 = 20\n");
  const Outcome outcome = toolcomp("certify --controller '" + GetParam().second + "' --setup " + setup + " --report " +
                                       folder.path("r") + " " + program + " " + plain,
                                   "TOOLCOMP=" TOOLCOMP_BINARY_DIR "/toolcomp ");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Json certificate = Json::parse(read(folder.path("r/certificate.json")));
  EXPECT_GT(certificate["sections"][0]["values"], 5);
  EXPECT_TRUE(certificate["findings"].empty());
}

INSTANTIATE_TEST_SUITE_P(Of, Examples,
                         testing::Values(std::pair{"Python", "python3 " + kExamples + "controller.py"},
                                         std::pair{"Shell", "sh " + kExamples + "controller.sh"},
                                         std::pair{"Cpp",
                                                   std::string(TOOLCOMP_BINARY_DIR "/toolcomp_example_controller")}),
                         [](const auto& test) { return std::string(test.param.first); });

// "in under 60 lines"
TEST(Protocol, AnAdapterIsShort) {
  const std::string text = read(kExamples + "controller.py");
  EXPECT_LT(std::ranges::count(text, '\n'), 60);
}

}  // namespace
