// SPDX-License-Identifier: Apache-2.0
// `toolcomp results`: certificates of several controllers in one table. What is expected was written by hand, from what
// each certificate says.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/command_line/command.h"

namespace {

using nlohmann::json;
using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

// A certificate as certify writes it, of one section with ten cases; a test spoils what it wants to.
json certificate() {
  return json::parse(R"({
    "certificate": 1, "verdict": "conforms in 1 of 13 sections, 12 not asked for", "exit_status": 0,
    "identity": {"tool": "toolcomp 0.1.0", "corpus": "none"},
    "occasion": {"date": "2026-11-29T10:00:00Z", "operator": "", "serial": "", "arguments": ""},
    "controller": {"name": "mill", "version": "3", "fields_not_judged": ["feed"]},
    "sections": [{"section": "fanuc/tool-offset",
      "results": {"agrees": 10, "differs": 0, "undecided": 0, "nothing judged": 0, "not applicable": 2, "not run": 0,
                  "not judged": 0},
      "values": 100, "values_not_judged": 0, "events_left_out": 0}],
    "findings": [], "left_out": {"judged": ["manual", "sister", "recollection", "ours"]},
    "clauses": {"fanuc.tool-offset.increase": {"reached": 3}}})");
}

json finding(const std::string& clause) {
  return {{"section", "fanuc/tool-offset"},
          {"clause", clause},
          {"source", "manual: B-1, page 2"},
          {"kind", "coordinate"},
          {"line", 3},
          {"field", "axes.X"},
          {"expected", "5"},
          {"actual", "6"},
          {"occurrences", 4}};
}

class Results : public testing::Test {
 protected:
  Folder folder;

  // A folder with this certificate.
  std::string put(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(folder.path(name));
    std::ofstream(folder.path(name) + "/certificate.json", std::ios::binary) << text;
    return folder.path(name);
  }
  std::string put(const std::string& name, const json& certificate) const { return put(name, certificate.dump(1)); }

  [[nodiscard]] json table(const std::string& folders) const {
    const Outcome outcome = toolcomp("results --json " + folders);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.status == 0 ? json::parse(outcome.out) : json();
  }
  // Where the one controller stands in the section.
  [[nodiscard]] json standing(const json& certificate, const std::string& section = "fanuc/tool-offset") const {
    const json all = table(put("one", certificate));
    return all.is_null() ? all : all["controllers"][0]["cells"][section]["standing"];
  }
  void expect_refused(const std::string& folder_name, const std::string& why) const {
    const Outcome outcome = toolcomp("results --json " + folder_name);
    EXPECT_EQ(outcome.status, 2) << why;
    EXPECT_NE(outcome.err.find("certificate.json"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "") << "no half of a table";
  }
};

// Of controllers that run: one that conforms, one with a finding, one that has another section alone.
TEST_F(Results, OfWhatCertifyWrites) {
  const std::string fast = folder.path("fast");
  const std::string common = " --section fanuc/tool-length-offset --cases 3 --report ";
  ASSERT_EQ(toolcomp("certify --controller fast --section fanuc/tool-offset" + common + fast).status, 0);
  const std::string late = folder.path("late");
  ASSERT_EQ(
      toolcomp("certify --controller '" TOOLCOMP_BINARY_DIR "/toolcomp_faulty_controller late'" + common + late).status,
      1);
  const std::string python = folder.path("python");
  ASSERT_EQ(toolcomp("certify --controller 'python3 " TOOLCOMP_SOURCE_DIR
                     "/adapters/examples/controller.py' --section fanuc/tool-offset" +
                     common + python)
                .status,
            0);
  const std::string page = folder.path("results.html");
  const Outcome outcome = toolcomp("results --json --out " + page + ' ' + fast + ' ' + late + ' ' + python);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json all = json::parse(outcome.out);
  EXPECT_EQ(all["sections"].size(), 13U);
  const auto standing = [&](std::size_t controller, const char* section) {
    return all["controllers"][controller]["cells"][section]["standing"];
  };
  EXPECT_EQ(standing(0, "fanuc/tool-length-offset"), "conforms");
  EXPECT_EQ(standing(0, "fanuc/tool-offset"), "conforms");
  EXPECT_EQ(standing(0, "heidenhain/face-milling"), "not asked");
  EXPECT_EQ(standing(1, "fanuc/tool-length-offset"), "finding");
  EXPECT_EQ(standing(2, "fanuc/tool-length-offset"), "conforms");
  EXPECT_EQ(standing(2, "fanuc/tool-offset"), "not applicable");
  EXPECT_EQ(all["controllers"][2]["name"], "length offsets");
  const std::string html = toolcomp::test::read(page);
  const std::string first = html.substr(html.find("<h1>"), html.find("</p>") - html.find("<h1>"));
  EXPECT_NE(first.find("length offsets 1</a>, certified 20"), std::string::npos) << first;
  EXPECT_EQ(all["controllers"][1]["causes"][0]["cause"], "positions come one block late");
  EXPECT_NE(html.find("look like: positions come one block late.</p>"), std::string::npos);
  // The finding says its clause, in words.
  const std::string clause = all["controllers"][1]["findings"][0]["clause"];
  ASSERT_NE(clause, "");
  EXPECT_NE(html.find("Clause <code>" + clause + "</code>"), std::string::npos);
  if (command("command -v chromium").status != 0) return;
  const Outcome look = command("python3 " TOOLCOMP_SOURCE_DIR "/tests/browser/look.py " + page);
  ASSERT_EQ(look.status, 0) << look.err;
  const json seen = json::parse(look.out);
  EXPECT_EQ(seen["console"], json::array());
  EXPECT_EQ(seen["requests"], json::array());
  EXPECT_EQ(seen["overflow"]["1280"], 0);
  EXPECT_EQ(seen["overflow"]["400"], 0);
  EXPECT_NE(seen["light_paper"], seen["dark_paper"]);
}

// Each reason to say less than "conforms", and which counts where there are two.
TEST_F(Results, StandingsAreWhatTheCountsSay) {
  EXPECT_EQ(standing(certificate()), "conforms");
  json c = certificate();
  const json::json_pointer counts("/sections/0/results");
  c["sections"][0]["known_differences"]["outer-corner"] = 2;
  EXPECT_EQ(standing(c), "differs by design");
  c["exit_status"] = 3;
  c[counts]["not run"] = 1;
  EXPECT_EQ(standing(c), "partly judged");
  c[counts]["undecided"] = 1;
  EXPECT_EQ(standing(c), "not decided");
  c["exit_status"] = 1;
  c["findings"].push_back(finding("fanuc.tool-offset.increase"));
  EXPECT_EQ(standing(c), "finding");

  // Two values of a hundred are more than one percent, one is not.
  c = certificate();
  c["exit_status"] = 3;
  c["sections"][0]["values"] = 98;
  c["sections"][0]["values_not_judged"] = 2;
  EXPECT_EQ(standing(c), "partly judged");
  c = certificate();
  c["sections"][0]["values"] = 99;
  c["sections"][0]["values_not_judged"] = 1;
  EXPECT_EQ(standing(c), "conforms");
  c["sections"][0]["events_left_out"] = 1;
  c["left_out"]["judged"] = json::array({"manual", "sister"});
  EXPECT_EQ(standing(c), "partly judged");

  c = certificate();
  c["exit_status"] = 3;
  c["sections"][0]["values"] = 0;
  EXPECT_EQ(standing(c), "not decided") << "nothing judged";
  c = certificate();
  c["exit_status"] = 4;
  EXPECT_EQ(standing(c), "not decided") << "by a harness that is not sound";
  c = certificate();
  c[counts]["agrees"] = 0;
  c["sections"][0]["values"] = 0;
  EXPECT_EQ(standing(c), "not applicable");
  EXPECT_EQ(standing(c, "fanuc/leading-edge-offset"), "not asked");
}

// Of an adapter that records: by program, each with its section; those of before had none.
TEST_F(Results, OfRecordedPrograms) {
  const auto run = [](const char* section, const char* outcome, const json& known = json::array()) {
    return json{{"id", "p"}, {"section", section}, {"outcome", outcome}, {"why", "off by 1"}, {"known", known}};
  };
  json c{{"adapter", "my-machine"},
         {"exit_status", 0},
         {"verdict", "conforms"},
         {"tool", "toolcomp 0.1.0"},
         {"occasion", {{"date", "2026-11-29T10:00:00Z"}, {"serial", ""}}},
         {"known_differences", json::object()}};
  c["known_differences"]["outer-corner"] = "It runs an arc there (fanuc.cutter-c.outer-obtuse).";
  c["runs"] =
      json::array({run("fanuc/tool-length-offset", "conforms"), run("fanuc/cutter-compensation-c", "both refuse"),
                   run("fanuc/cutter-compensation-c", "known difference", json::array({"outer-corner"})),
                   run("fanuc/tool-center-point-control", "not applicable")});
  EXPECT_EQ(standing(c, "fanuc/tool-length-offset"), "conforms");
  EXPECT_EQ(standing(c, "fanuc/cutter-compensation-c"), "differs by design");
  EXPECT_EQ(standing(c, "fanuc/tool-center-point-control"), "not applicable");
  ASSERT_EQ(toolcomp("results --out " + folder.path("r.html") + " " + folder.path("one")).status, 0);
  EXPECT_NE(toolcomp::test::read(folder.path("r.html")).find("fanuc.cutter-c.outer-obtuse"), std::string::npos);
  c["runs"].push_back(run("fanuc/tool-length-offset", "failed"));
  c["exit_status"] = 3;
  EXPECT_EQ(standing(c, "fanuc/tool-length-offset"), "not decided");
  c["runs"].push_back(run("fanuc/tool-length-offset", "differs"));
  c["exit_status"] = 1;
  EXPECT_EQ(standing(c, "fanuc/tool-length-offset"), "finding");
  c["exit_status"] = 0;
  expect_refused(put("liar", c), "exit_status: is 0, and a run differs");
}

TEST_F(Results, SpoiledOnesAreRefusedWithTheirPlace) {
  expect_refused(folder.path("nowhere"), "");
  expect_refused(put("empty", std::string()), ":1:1: ");
  expect_refused(put("cut", certificate().dump(1).substr(0, 300)), ":");
  expect_refused(put("list", std::string("[]")), ":1:1: a certificate");
  expect_refused(put("other", std::string("{\"events\": []}")), ":1:1: is no certificate");
  expect_refused(put("trace", std::string("{\"trace\": 1}")), "is the certificate of one recording");
  expect_refused(put("kit", std::string("{\"kit_certificate\": 1}")), "is the certificate of a kit");
  json c = certificate();
  c["sections"][0].erase("values");
  expect_refused(put("less", c), "\"values\" is missing");
  c = certificate();
  c["sections"][0]["section"] = "fanuc/tool-ofset";
  expect_refused(put("section", c), "\"fanuc/tool-ofset\" is none of this toolcomp");
  c = certificate();
  c["sections"].push_back(c["sections"][0]);
  expect_refused(put("twice", c), "\"fanuc/tool-offset\" twice");
  c = certificate();
  c["sections"][0]["values"] = -1;
  expect_refused(put("negative", c), "values");
  c = certificate();
  c["controller"]["name"] = 7;
  expect_refused(put("type", c), "name");
}

// Whoever changes a certificate by hand has to change it everywhere.
TEST_F(Results, ContradictionsAreRefused) {
  json c = certificate();
  c["findings"].push_back(finding("fanuc.tool-offset.increase"));
  expect_refused(put("green", c), "exit_status: is 0, and there are 1 findings");
  c = certificate();
  c["exit_status"] = 1;
  expect_refused(put("red", c), "exit_status: is 1, and there are 0 findings");
  c = certificate();
  c["sections"][0]["results"]["differs"] = 2;
  expect_refused(put("silent", c), "2 cases of \"fanuc/tool-offset\" differ, and no finding is of them");
  c = certificate();
  c["sections"][0]["results"]["undecided"] = 1;
  expect_refused(put("undecided", c), "exit_status: is 0, and of \"fanuc/tool-offset\" 1 case could not be decided");
}

TEST_F(Results, TooLargeIsRefusedUnread) {
  const std::string large = put("large", std::string("{"));
  std::filesystem::resize_file(large + "/certificate.json", (std::uintmax_t{16} << 20) + 1);
  expect_refused(large, "is longer than 16777216 bytes");
  const std::string deep = put("deep", std::string(100'000, '['));
  expect_refused(deep, "nested too deep");
  std::filesystem::create_directories(folder.path("pipe"));
  ASSERT_EQ(command("mkfifo " + folder.path("pipe/certificate.json")).status, 0);
  expect_refused(folder.path("pipe"), "");
}

// What a certificate says is shown and obeyed by nobody.
TEST_F(Results, TextOfStrangersIsEscaped) {
  const std::string evil = "<script>alert(1)</script>\" onclick=\"x\x1b[31m\xe2\x80\xae";
  json c = certificate();
  c["exit_status"] = 1;
  c["verdict"] = evil;
  c["controller"]["name"] = evil;
  c["occasion"]["date"] = evil;
  c["findings"].push_back(finding(evil));
  c["findings"][0]["actual"] = evil;
  c["sections"][0]["known_differences"][evil] = 1;
  c["known_differences"][evil] = evil;
  const std::string page = folder.path("evil.html");
  const Outcome outcome = toolcomp("results --verbose --json --out " + page + " " + put("evil", c));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const std::string& text : {toolcomp::test::read(page), outcome.out, outcome.err}) {
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.find("\xe2\x80\xae"), std::string::npos);
  }
  const std::string html = toolcomp::test::read(page);
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("\" onclick"), std::string::npos);
  EXPECT_NE(html.find("&lt;script&gt;"), std::string::npos);
}

// A page that nobody named replaces one of ours alone.
TEST_F(Results, AFileOfAnotherKindStays) {
  const std::string one = put("one", certificate());
  const std::string in = "cd " + folder.path("") + "; ";
  EXPECT_EQ(toolcomp("results one", in).status, 0);
  EXPECT_EQ(toolcomp("results one", in).status, 0) << "ours";
  std::ignore = folder.write("results.html", "<p>mine</p>");
  const Outcome refused = toolcomp("results one", in);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("--out"), std::string::npos) << refused.err;
  EXPECT_EQ(toolcomp::test::read(folder.path("results.html")), "<p>mine</p>");
}

}  // namespace
