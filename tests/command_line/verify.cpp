// SPDX-License-Identifier: Apache-2.0
// `toolcomp certify --evidence` and `toolcomp verify`: what is accepted, and what is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <functional>
#include <string>

#include "tests/command_line/bundles.h"
#include "tests/command_line/command.h"

namespace {

using toolcomp::test::adapt_manifest;
using toolcomp::test::Cases;
using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Json;
using toolcomp::test::Members;
using toolcomp::test::members_of;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;
using toolcomp::test::write_bundle;
namespace fs = std::filesystem;

const std::string kServe = TOOLCOMP_BINARY_DIR "/toolcomp serve --engine fast";
const std::string kFaulty = TOOLCOMP_BINARY_DIR "/toolcomp_faulty_controller ";
const std::string kSection = " --section fanuc/tool-length-offset ";
const std::string kCorpus = TOOLCOMP_SOURCE_DIR "/corpus/golden";

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A bundle of a few golden and generated cases.
struct Bundle {
  const Folder folder;
  const std::string file = folder.path("evidence.tar.zst");
  const std::string other = folder.path("other.tar.zst");

  Outcome certify(const std::string& controller, const std::string& options, const std::string& shell = "") const {
    return toolcomp("certify --controller '" + controller + "'" + kSection + "--cases 10 --report " +
                        folder.path("report") + " --evidence " + file + " " + options,
                    shell);
  }
  // With its parts changed.
  void change(const std::function<void(Members&)>& change) const {
    Members members = members_of(file);
    change(members);
    write_bundle(other, members);
  }
};

void expect_refused(const std::string& arguments, const std::string& why) {
  const Outcome outcome = toolcomp("verify " + arguments);
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_TRUE(has(outcome.out, "refused: ")) << outcome.out;
  EXPECT_TRUE(has(outcome.out, why)) << "expected: " << why << '\n' << outcome.out;
  EXPECT_TRUE(has(outcome.out, ": refused\n")) << outcome.out;
}

// One bundle for all tests that change it.
class Verify : public testing::Test {
 public:
  static void SetUpTestSuite() {
    bundle = new Bundle;
    made = new Outcome(bundle->certify(kServe, ""));
  }
  static void TearDownTestSuite() {
    delete made;
    delete bundle;
  }

 protected:
  void SetUp() override { ASSERT_EQ(made->status, 0) << made->out << made->err; }
  static inline Bundle* bundle = nullptr;
  static inline Outcome* made = nullptr;
};

TEST_F(Verify, ABundleIsAccepted) {
  EXPECT_TRUE(has(made->out, "evidence: " + bundle->file));
  for (const std::string options : {"", " --sample 3 --seed 7", " --all"}) {
    const Outcome outcome = toolcomp("verify " + bundle->file + options);
    EXPECT_EQ(outcome.status, 0) << options << outcome.out << outcome.err;
    EXPECT_TRUE(has(outcome.out, bundle->file + ": accepted\n")) << outcome.out;
    EXPECT_TRUE(has(outcome.out, "certificate: conforms in 1 of 13 sections")) << outcome.out;
    EXPECT_TRUE(has(outcome.out, "signature: none")) << outcome.out;
  }
  EXPECT_TRUE(has(toolcomp("verify --sample 3 --seed 7 " + bundle->file).out, "judged again: 3 of "));
  EXPECT_TRUE(has(toolcomp("verify --sample 3 --seed 7 " + bundle->file).out, "seed 7"));
}

TEST_F(Verify, ABundleHasEverything) {
  const Members members = members_of(bundle->file);
  for (const char* name :
       {"manifest.json", "cases.jsonl", "answers.jsonl", "results.jsonl", "hello.json", "certificate.json", "junit.xml",
        "certificate.sarif", "index.html", "corpus/manifest.json", "sbom.spdx.json"})
    EXPECT_TRUE(members.contains(name)) << name;
  EXPECT_EQ(members.at("corpus/manifest.json"), read(kCorpus + "/manifest.json"));
  EXPECT_EQ(members.at("index.html"), read(bundle->folder.path("report/index.html")));
  const Json hello = Json::parse(members.at("hello.json"));
  EXPECT_EQ(hello.at("protocol"), 1);
  const Cases cases(members);
  const Json first = Json::parse(cases.requests.front());
  EXPECT_FALSE(first.contains("expect"));
  EXPECT_EQ(Json::parse(cases.answers.front()).at("id"), first.at("id"));
  const Json manifest = Json::parse(members.at("manifest.json"));
  EXPECT_EQ(manifest.at("command").at(1), "certify");
  EXPECT_EQ(manifest.at("cases"), cases.requests.size());
  EXPECT_EQ(cases.requests.size(), cases.results.size());
  // SPDX 2.3: what a document and a package have to have.
  const Json sbom = Json::parse(members.at("sbom.spdx.json"));
  EXPECT_EQ(sbom.at("spdxVersion"), "SPDX-2.3");
  EXPECT_EQ(sbom.at("dataLicense"), "CC0-1.0");
  EXPECT_EQ(sbom.at("SPDXID"), "SPDXRef-DOCUMENT");
  for (const char* key : {"name", "documentNamespace"}) EXPECT_FALSE(sbom.at(key).get<std::string>().empty());
  EXPECT_TRUE(sbom.at("creationInfo").contains("created"));
  EXPECT_FALSE(sbom.at("creationInfo").at("creators").empty());
  std::vector<std::string> names;
  for (const Json& package : sbom.at("packages")) {
    names.push_back(package.at("name"));
    EXPECT_TRUE(package.at("SPDXID").get<std::string>().starts_with("SPDXRef-"));
    EXPECT_TRUE(package.contains("downloadLocation"));
  }
  for (const char* name : {"toolcomp", "GMP", "Arb", "libarchive"})
    EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
}

TEST_F(Verify, AChangedByteOfTheFileIsRefused) {
  const std::string bytes = read(bundle->file);
  for (std::size_t i = 0; i < 20; ++i) {
    std::string changed = bytes;
    const std::size_t at = (bytes.size() - 1) * i / 19;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    const Outcome outcome = toolcomp("verify " + bundle->folder.write("other.tar.zst", changed));
    EXPECT_TRUE(outcome.status == 1 || outcome.status == 2) << at << outcome.out << outcome.err;
    EXPECT_FALSE(has(outcome.out, "accepted"));
  }
  expect_refused(bundle->folder.write("other.tar.zst", bytes.substr(0, bytes.size() / 2)), "changed or truncated");
}

TEST_F(Verify, AChangedByteOfAnyMemberIsRefused) {
  for (const auto& [name, bytes] : members_of(bundle->file)) {
    if (name == "manifest.json") continue;
    bundle->change([&](Members& members) { members[name][bytes.size() / 2] ^= 1; });
    expect_refused(bundle->other, name + ": its SHA-256");
    bundle->change([&](Members& members) { members.erase(name); });
    expect_refused(bundle->other, name + ": is missing");
  }
  bundle->change([](Members& members) { members["more.txt"] = "more"; });
  expect_refused(bundle->other, "more.txt: is not in the manifest");
}

// With the manifest as it was, adapted, and with the certificate's sums adapted too.
TEST_F(Verify, ACaseLeftOutIsRefused) {
  const auto without = [&](std::size_t i, bool adapt, bool sums) {
    bundle->change([&](Members& members) {
      Cases cases(members);
      const Json record = Json::parse(cases.results.at(i));
      cases.erase(i);
      cases.put_into(members);
      if (sums) {
        Json certificate = Json::parse(members["certificate.json"]);
        Json& section = certificate["sections"][0];
        for (Json* count : {&section["cases"][record["origin"].get<std::string>()], &section["results"]["agrees"]})
          *count = count->get<int>() - 1;
        section["values"] = section["values"].get<int>() - record["values"].get<int>();
        members["certificate.json"] = certificate.dump(2) + "\n";
      }
      if (adapt) adapt_manifest(members);
    });
  };
  const Cases cases(members_of(bundle->file));
  for (const std::size_t i : {std::size_t{5}, cases.requests.size() - 1}) {
    const std::string id = Json::parse(cases.requests[i]).at("id");
    without(i, false, false);
    expect_refused(bundle->other, ": has ");
    without(i, true, false);
    expect_refused(bundle->other, id + ": is missing");
    without(i, true, true);
    expect_refused(bundle->other, id + ": is missing");
  }
}

TEST_F(Verify, ACaseAddedIsRefused) {
  const std::string id = Json::parse(Cases(members_of(bundle->file)).requests[3]).at("id");
  bundle->change([](Members& members) {
    Cases cases(members);
    cases.repeat(3);
    cases.put_into(members);
    adapt_manifest(members);
  });
  expect_refused(bundle->other, id + ": occurs twice");
  bundle->change([](Members& members) {
    Cases cases(members);
    cases.repeat(3);
    for (auto* line : {&cases.requests.back(), &cases.answers.back(), &cases.results.back()}) {
      Json json = Json::parse(*line);
      json["id"] = "one-more";
      *line = json.dump();
    }
    cases.put_into(members);
    adapt_manifest(members);
  });
  expect_refused(bundle->other, "one-more: is not a golden case");
}

// A vector that is another program, under its own name.
TEST_F(Verify, AnEasierCaseIsRefused) {
  for (const std::size_t from_the_end : {0U, 1U}) {
    std::string id;
    bundle->change([&](Members& members) {
      Cases cases(members);
      const std::size_t i = from_the_end == 0 ? cases.requests.size() - 1 : 2;
      Json request = Json::parse(cases.requests[i]);
      id = request["id"];
      request["program"] = request["program"].get<std::string>() + "G04 X1.\n";
      cases.requests[i] = request.dump();
      cases.put_into(members);
      adapt_manifest(members);
    });
    expect_refused(bundle->other + " --all", id + ": is not the ");
  }
}

TEST_F(Verify, AnEditedAnswerIsRefused) {
  std::string id;
  bundle->change([&](Members& members) {
    Cases cases(members);
    for (std::string& answer : cases.answers) {
      Json json = Json::parse(answer);
      if (json["events"].empty() || !json["events"][0].contains("axes")) continue;
      id = json["id"];
      json["events"][0]["axes"]["X"] = json["events"][0]["axes"]["X"].get<double>() + 1;
      answer = json.dump();
      break;
    }
    cases.put_into(members);
    adapt_manifest(members);
  });
  ASSERT_FALSE(id.empty());
  expect_refused(bundle->other + " --all",
                 id + ": the recorded result and the result judged again differ: result: \"agrees\" and \"differs\"");
}

// Sums that the cases do not have, and a verdict that the sums do not have.
TEST_F(Verify, AnEditedCertificateIsRefused) {
  const auto edit = [&](const std::function<void(Json&)>& change) {
    bundle->change([&](Members& members) {
      Json certificate = Json::parse(members["certificate.json"]);
      change(certificate);
      members["certificate.json"] = certificate.dump(2) + "\n";
      adapt_manifest(members);
    });
  };
  edit([](Json& c) { c["sections"][0]["values"] = 1'000'000; });
  expect_refused(bundle->other, "certificate.json: sections");
  edit([](Json& c) { c["scope"] = "all 12 sections"; });
  expect_refused(bundle->other, "certificate.json: scope");
  edit([](Json& c) { c["controller"]["name"] = "CNC 3000"; });
  expect_refused(bundle->other, "certificate.json: controller");
  edit([](Json& c) { c["clauses"].begin().value()["reached"] = 1'000'000; });
  expect_refused(bundle->other + " --all", "certificate.json: clauses");
  edit([](Json& c) { c["identity"]["clauses_sha256"] = std::string(64, '0'); });
  expect_refused(bundle->other, "clauses other than those");
  edit([](Json& c) { c.erase("findings"); });
  expect_refused(bundle->other, "certificate.json: ");
  bundle->change([](Members& members) {
    members["certificate.json"] = "[";
    adapt_manifest(members);
  });
  expect_refused(bundle->other, "certificate.json:1:2: ");
}

TEST_F(Verify, AnotherVersionsCorpusIsRefused) {
  const std::string corpus = bundle->folder.path("corpus");
  fs::copy(kCorpus, corpus, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  Json manifest = Json::parse(read(corpus + "/manifest.json"));
  manifest["version"] = "0.9.0";
  static_cast<void>(bundle->folder.write("corpus/manifest.json", manifest.dump(2) + "\n"));
  expect_refused(bundle->file + " --corpus " + corpus, "and this corpus is 0.9.0");
  // And made with that one.
  const Bundle old;
  ASSERT_EQ(old.certify(kServe, "--corpus " + corpus).status, 0);
  expect_refused(old.file, "the certificate used 0.9.0");
  EXPECT_EQ(toolcomp("verify " + old.file + " --corpus " + corpus).status, 0);
  // Vectors that are not those of their manifest are nobody's.
  fs::remove(corpus + "/fanuc/tool-length-offset/examples.jsonl");
  EXPECT_EQ(toolcomp("verify " + old.file + " --corpus " + corpus).status, 2);
  EXPECT_EQ(toolcomp("verify " + old.file + " --corpus " + bundle->folder.path("nowhere")).status, 2);
}

TEST_F(Verify, WhatIsNoBundleIsBadInput) {
  const Folder folder;
  const std::string text = folder.write("a.tar.zst", "no archive at all");
  const std::string empty = folder.write("b.tar.zst", "");
  write_bundle(folder.path("c.tar.zst"), {{"manifest.json", "{}"}});
  const std::string cut = folder.write("d.tar.zst", read(bundle->file).substr(0, 10));
  for (const std::string& file :
       {text, empty, cut, folder.path("c.tar.zst"), folder.path("none.tar.zst"), folder.path("")}) {
    const Outcome outcome = toolcomp("verify " + file);
    EXPECT_EQ(outcome.status, 2) << file << outcome.out << outcome.err;
    EXPECT_FALSE(outcome.err.empty()) << file;
  }
  bundle->change([](Members& members) {
    Json manifest = Json::parse(members["manifest.json"]);
    manifest["evidence"] = 2;
    members["manifest.json"] = manifest.dump();
  });
  const Outcome newer = toolcomp("verify " + bundle->other);
  EXPECT_EQ(newer.status, 2) << newer.out;
  EXPECT_NE(newer.err.find("manifest.json:1:"), std::string::npos) << newer.err;
  EXPECT_NE(newer.err.find("is of format 2; this toolcomp reads format 1"), std::string::npos) << newer.err;
}

TEST(Evidence, WhatCannotBeIsSaidBeforeItBegins) {
  const Folder folder;
  const std::string begin = "certify --report " + folder.path("r") + " --controller '" + kServe + "'" + kSection;
  for (const std::string& options :
       {std::string("--evidence a.zip"), std::string("--sign me"), "--evidence " + folder.write("f", "") + "/a.tar.zst",
        "--evidence " + folder.path("a.tar.zst") + " --sign nobody-has-this-key"}) {
    const Outcome outcome = toolcomp(begin + options, "export GNUPGHOME=" + folder.path("") + ";");
    EXPECT_EQ(outcome.status, 2) << options << outcome.out << outcome.err;
    EXPECT_TRUE(has(outcome.err, "--evidence") || has(outcome.err, "--sign")) << outcome.err;
    EXPECT_FALSE(fs::exists(folder.path("r"))) << options;
  }
  const Outcome no_gpg = toolcomp(begin + "--sign me --evidence " + folder.path("a.tar.zst"), "PATH=/nowhere ");
  EXPECT_EQ(no_gpg.status, 2);
  EXPECT_TRUE(has(no_gpg.err, "gpg is not installed")) << no_gpg.err;
  const std::string example = TOOLCOMP_SOURCE_DIR "/examples/fanuc/three-hole-boring/three-holes.nc";
  const Outcome trace = toolcomp("certify --trace x.csv --tolerance 0.1 --evidence a.tar.zst " + example);
  EXPECT_EQ(trace.status, 2);
  EXPECT_TRUE(has(trace.err, "a trace has no answers to keep")) << trace.err;
  const Outcome recorded = toolcomp("certify --controller linuxcnc-motion --evidence a.tar.zst " + example);
  EXPECT_EQ(recorded.status, 2);
}

// Programs of the user's own, with their setup.
TEST(Evidence, KeepsWhatWasGiven) {
  const Folder folder;
  const std::string example = TOOLCOMP_SOURCE_DIR "/examples/fanuc/three-hole-boring/three-holes.nc";
  const std::string file = folder.path("e.tar.zst");
  const Outcome outcome = toolcomp("certify --controller '" + kServe + "' --report " + folder.path("r") +
                                   " --evidence " + file + " " + example);
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Members members = members_of(file);
  EXPECT_EQ(members.at("inputs/001-three-holes.nc"), read(example));
  EXPECT_EQ(members.at("inputs/002-setup.toml"), read(fs::path(example).parent_path() / "setup.toml"));
  EXPECT_FALSE(members.contains("corpus/manifest.json"));
  EXPECT_EQ(toolcomp("verify --all " + file).status, 0);
  // The cases can be asked again as they are.
  const Outcome again = toolcomp("certify --controller '" + kServe + "' --report " + folder.path("r") + " " +
                                 folder.write("cases.jsonl", members.at("cases.jsonl")));
  EXPECT_EQ(again.status, 0) << again.out << again.err;
}

TEST(Evidence, TheSameGivesTheSameBytes) {
  const Bundle bundle;
  const std::string when = "export SOURCE_DATE_EPOCH=1700000000;";
  ASSERT_EQ(bundle.certify(kServe, "", when).status, 0);
  const Members first = members_of(bundle.file);
  const std::string bytes = read(bundle.file);
  ASSERT_EQ(bundle.certify(kServe, "", when).status, 0);
  for (const auto& [name, text] : members_of(bundle.file)) EXPECT_EQ(text, first.at(name)) << name;
  EXPECT_TRUE(bytes == read(bundle.file));
  EXPECT_EQ(Json::parse(first.at("manifest.json")).at("made"), "2023-11-14T22:13:20Z");
}

// A run that was ended is evidence of what it did.
TEST(Evidence, OfAnInterruptedRun) {
  const Bundle bundle;
  const std::string script = kServe + " | while IFS= read -r line; do n=$((n + 1)); printf '%s\\n' \"$line\"; " +
                             "if [ $n = 40 ]; then kill -INT $(cat " + bundle.folder.path("command") + "); fi; done\n";
  const Outcome outcome = bundle.certify("sh " + bundle.folder.write("controller", script), "",
                                         "sh -c 'echo $$ >" + bundle.folder.path("command") + "; exec \"$@\"' sh ");
  EXPECT_EQ(outcome.status, 3) << outcome.out << outcome.err;
  const Outcome verified = toolcomp("verify --all " + bundle.file);
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  EXPECT_TRUE(has(verified.out, ", interrupted (SIGINT)")) << verified.out;
  EXPECT_TRUE(has(verified.out, "not decided: interrupted")) << verified.out;
  // It stays interrupted.
  Members members = members_of(bundle.file);
  Json manifest = Json::parse(members["manifest.json"]);
  manifest["interrupted"] = "";
  members["manifest.json"] = manifest.dump();
  write_bundle(bundle.other, members);
  expect_refused(bundle.other, ": is missing");
}

// Controllers that fail leave evidence of that: it is accepted as such, and what is made of it is not.
class OfFaults : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Controllers, OfFaults,
                         testing::Values("exit", "rubbish", "no-events", "hello-rubbish", "never-sends", "two-lines",
                                         "one-section", "error"),
                         [](const auto& fault) {
                           std::string name = fault.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST_P(OfFaults, IsAccepted) {
  const Bundle bundle;
  const Outcome outcome = bundle.certify(kFaulty + GetParam(), "--timeout 3 --section fanuc/tool-offset");
  ASSERT_TRUE(outcome.status == 0 || outcome.status == 1) << outcome.out << outcome.err;
  const Outcome verified = toolcomp("verify --all " + bundle.file);
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
}

TEST(Evidence, AFindingThatIsHiddenIsRefused) {
  const Bundle bundle;
  ASSERT_EQ(bundle.certify(kFaulty + "exit", "").status, 1);
  const auto hide = [&](bool records) {
    bundle.change([&](Members& members) {
      Json certificate = Json::parse(members["certificate.json"]);
      certificate["findings"] = Json::array();
      certificate["verdict"] = "conforms in 1 of 13 sections, 11 not asked for";
      certificate["exit_status"] = 0;
      members["certificate.json"] = certificate.dump(2) + "\n";
      if (records) {
        Cases cases(members);
        for (std::string& line : cases.results) {
          Json record = Json::parse(line);
          if (record["result"] == "differs") record["result"] = "agrees";
          for (const char* key : {"kind", "clause", "fault"}) record.erase(key);
          line = record.dump();
        }
        cases.put_into(members);
      }
      adapt_manifest(members);
    });
  };
  hide(false);
  expect_refused(bundle.other, "certificate.json: has no finding crash");
  hide(true);
  expect_refused(bundle.other, ": has no answer");
}

TEST(Evidence, IsSigned) {
  const Bundle bundle;
  const Folder home;
  const std::string gnupg = "export GNUPGHOME=" + home.path("") + ";";
  const Outcome key = command("chmod 700 " + home.path("") + "; " + gnupg +
                              " gpg --batch --quiet --pinentry-mode loopback --passphrase '' --quick-generate-key "
                              "'Ada Lovelace <ada@example.org>' ed25519 sign never");
  ASSERT_EQ(key.status, 0) << key.err;
  const Outcome made = bundle.certify(kServe, "--sign ada@example.org", gnupg);
  EXPECT_EQ(made.status, 0) << made.out << made.err;
  EXPECT_TRUE(has(made.out, "signature: " + bundle.file + ".asc")) << made.out;
  const Outcome good = toolcomp("verify " + bundle.file, gnupg);
  EXPECT_EQ(good.status, 0) << good.out << good.err;
  EXPECT_TRUE(has(good.out, "signature: good, by Ada Lovelace <ada@example.org> (")) << good.out;
  // Somebody who does not know the key.
  const Folder stranger;
  const Outcome unknown = toolcomp("verify " + bundle.file, "export GNUPGHOME=" + stranger.path("") + ";");
  EXPECT_EQ(unknown.status, 1) << unknown.out;
  EXPECT_TRUE(has(unknown.out, "the public key")) << unknown.out;
  // Another bundle under its signature.
  bundle.change([](Members& members) {
    members["junit.xml"] += "\n";
    adapt_manifest(members);
  });
  fs::copy_file(bundle.file + ".asc", bundle.other + ".asc");
  const Outcome bad = toolcomp("verify " + bundle.other, gnupg);
  EXPECT_EQ(bad.status, 1) << bad.out;
  EXPECT_TRUE(has(bad.out, "it does not belong to this file")) << bad.out;
  // A new bundle does not keep the signature of the old one.
  EXPECT_EQ(bundle.certify(kServe, "").status, 0);
  EXPECT_FALSE(fs::exists(bundle.file + ".asc"));
  static_cast<void>(command(gnupg + " gpgconf --kill all"));
}

}  // namespace
