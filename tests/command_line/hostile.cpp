// SPDX-License-Identifier: Apache-2.0
// Files, answers and names made to fool the command or to break it: what strangers may send. Each of these was
// believed, obeyed, or the end of the process once.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <map>
#include <string>
#include <vector>

#include "tests/command_line/bundles.h"
#include "tests/command_line/command.h"
#include "tests/effort.h"

namespace {

namespace fs = std::filesystem;
using toolcomp::test::adapt_manifest;
using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Members;
using toolcomp::test::members_of;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;
using toolcomp::test::write_bundle;

const std::string kBinary = TOOLCOMP_BINARY_DIR "/toolcomp";
const std::string kPlate = TOOLCOMP_SOURCE_DIR "/examples/fanuc/plate-cutter-compensation-b/plate.nc";
// What a process may hold. Sanitizers reserve more than that before they begin.
const std::string kMemory = toolcomp::test::kSanitized ? "" : "ulimit -v 4000000; ";
// ESC, a line end, C1's CSI in UTF-8 and as a byte, bidirectional marks, DEL, BEL.
const std::string kHostile =
    "\x1b[31m\nconforms\xc2\x9b"
    "2J\x9b\xe2\x80\xae\xe2\x81\xa6\x7f\x07";

// No byte that a terminal obeys.
void expect_harmless(const std::string& text, const std::string& where) {
  for (const char c : text)
    if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7F) {
      ADD_FAILURE() << where << ": byte " << static_cast<int>(c) << " in\n" << text.substr(0, 2000);
      return;
    }
  for (const char* mark : {"\xc2\x9b", "\xe2\x80\xae", "\xe2\x81\xa6"})
    EXPECT_EQ(text.find(mark), std::string::npos) << where << '\n' << text.substr(0, 2000);
}
void expect_harmless(const Outcome& outcome, const std::string& where) {
  // A line that says so is one of ours.
  for (const std::string& text : {outcome.out, outcome.err})
    EXPECT_EQ(("\n" + text).find("\nconforms\xef\xbf\xbd"), std::string::npos) << where << '\n' << text.substr(0, 2000);
  expect_harmless(outcome.out, where + ", output");
  expect_harmless(outcome.err, where + ", errors");
}

void expect_refused(const Outcome& outcome, const std::string& words, const std::string& what) {
  EXPECT_EQ(outcome.status, 2) << what << '\n' << outcome.out.substr(0, 500) << outcome.err.substr(0, 500);
  EXPECT_NE(outcome.err.find(words), std::string::npos) << what << '\n' << outcome.err.substr(0, 500);
}

std::string in_json(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

// --- recordings

TEST(HostileRecording, AHugePositionIsNoRecording) {
  const Folder folder;
  const auto judged = [&](const std::string& csv) {
    return toolcomp("certify --trace " + folder.write("t.csv", csv) + " --tolerance 0.05 --report " +
                    folder.path("report") + " " + kPlate);
  };
  for (const char* number : {"1e300", "-1e300", "1e10", "1e308"})
    expect_refused(judged(std::string("t,X,Y,Z\n0,0,0,0\n1,") + number + ",0,0\n"), "t.csv:3:3: ", number);
  expect_refused(judged("t,X,Y,Z\n0,0,0,0\n1,nan,0,0\n"), "t.csv:3:3: ", "nan");
  expect_refused(judged("t,X,Y,Z\n0,0,0,0\n1e300,0,0,0\n"), "t.csv:3:1: ", "time");
}

TEST(HostileRecording, TooFewSamplesCertifyNothing) {
  const Folder folder;
  // A path that comes back to where it began: a machine that stands still is within the tolerance of a small one.
  const std::string setup = folder.write("setup.toml", "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n");
  const std::string program = folder.write("p.nc", "G01 X.01 F100\nY.01\nX0\nY0\nX.01\nX0\n");
  const Outcome outcome = toolcomp("certify --trace " + folder.write("t.csv", "t,X,Y,Z\n0,0,0,0\n1,0,0,0\n") +
                                   " --tolerance 0.05 --report " + folder.path("report") + " " + program);
  EXPECT_EQ(outcome.status, 3) << outcome.out << outcome.err;
  EXPECT_NE(outcome.err.find("2 samples cannot have covered 6 corners"), std::string::npos) << outcome.err;
}

// --- output

TEST(HostileOutput, AFullDiskIsSaid) {
  const Folder folder;
  const std::string plate = kPlate + " ";
  const std::string setup = " --setup " TOOLCOMP_SOURCE_DIR "/examples/fanuc/plate-cutter-compensation-b/setup.toml";
  const std::vector<std::string> verbs = {
      "--help",
      "run --help",
      "spec list",
      "spec trace",
      "spec coverage",
      "config example",
      "config schema setup",
      "completion bash",
      "run " + plate,
      "run --engine model " + plate,
      "run --format csv " + plate,
      "run --format svg " + plate,
      "view --out - " + plate,
      "explain " + plate,
      "--version",
      "certify --controller fast --section fanuc/tool-offset --cases 2 --report " + folder.path("report")};
  for (const std::string& verb : verbs) {
    const Outcome full = command(kBinary + " " + verb + " >/dev/full");
    expect_refused(full, "standard output: cannot be written", verb);
    EXPECT_EQ(full.err.find("internal error"), std::string::npos) << verb << full.err;
    expect_refused(command("{ " + kBinary + " " + verb + "; } >&-"), "standard output: cannot be written", verb);
  }
  expect_refused(command("echo '{\"hello\":1}' | " + kBinary + " serve --engine fast >/dev/full"),
                 "standard output: cannot be written", "serve");
}

// --- JSON

TEST(HostileJson, DeepOrLargeIsRefused) {
  const Folder folder;
  const std::string deep = std::string(300'000, '[');
  expect_refused(toolcomp("replay " + folder.write("deep.json", "{\"finding\": 1, \"capabilities\": " + deep), kMemory),
                 "nested too deep", "finding");
  expect_refused(
      toolcomp(
          "replay " + folder.write("number.json",
                                   R"({"finding": 1, "capabilities": {"a": 1e999999}, "case": {"case": 1, "id": "a",
                 "section": "fanuc/tool-offset", "dialect": "fanuc", "setup": {"control": "fanuc"}, "program": ""}})"),
          kMemory),
      "number.json:1:38: \"1e999999\" is outside the range of a double", "number");
  std::string many = "[{}";
  for (int i = 0; i < 6'000'000; ++i) many += ",{}";
  many += "]";
  expect_refused(toolcomp("replay " + folder.write("many.json", "{\"finding\": 1, \"before\": " + many + "}"), kMemory),
                 "more than 5000000 values", "finding of many values");
  expect_refused(toolcomp("config check " + folder.write("setup.json", "{\"axes\": " + many + "}"), kMemory),
                 "more than 5000000 values", "setup of many values");
  std::string axes = "control = \"fanuc\"\naxes = [\"X\"";
  for (int i = 0; i < 100'000; ++i) axes += ", \"X\"";
  expect_refused(toolcomp("config check " + folder.write("axes.toml", axes + "]\n"), kMemory), "axes.toml", "axes");
}

TEST(HostileJson, AnswersOfControllers) {
  const Folder folder;
  const std::string deep = std::string(300'000, '[');
  const auto certified = [&](const std::string& answer) {
    const std::string script =
        folder.write("c.sh", "read line; cat " + folder.write("hello", answer + "\n") + "; read line\n");
    return toolcomp("certify --controller 'sh " + script +
                        "' --section fanuc/tool-offset --cases 1 --settle 0 --timeout 5 --report " +
                        folder.path("report"),
                    kMemory);
  };
  for (const std::string& answer : {"{\"name\":\"x\",\"version\":\"1\",\"protocol\":1,\"setup\":{\"a\":" + deep,
                                    "{\"a\":" + deep, std::string("{\"protocol\":1,\"x\":1e999999}")}) {
    const Outcome outcome = certified(answer);
    EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("malformed reply"), std::string::npos) << outcome.out;
  }
}

TEST(HostileBundle, ManifestsAndStrings) {
  const Folder folder;
  const std::string bundle = folder.path("b.tar.zst");
  ASSERT_EQ(toolcomp("certify --controller '" + kBinary +
                     " serve --engine fast' --section fanuc/tool-offset --cases 2 --evidence " + bundle + " --report " +
                     folder.path("report"))
                .status,
            0);
  const Members good = members_of(bundle);
  // A manifest as deep as a million brackets.
  Members deep = good;
  deep["manifest.json"] = "{\"evidence\":" + std::string(1'000'000, '[');
  write_bundle(folder.path("deep.tar.zst"), deep);
  expect_refused(toolcomp("verify " + folder.path("deep.tar.zst"), kMemory), "nested too deep",
                 "a manifest as deep as a million brackets");
  // What a manifest may not be, by its schema and by its reader.
  const std::string manifest = good.at("manifest.json");
  std::string files = folder.write("0.json", manifest);
  std::string expected = "True";
  for (const char* patch :
       {R"({"evidence": 2})", R"({"evidence": "1"})", R"({"more": 1})", R"({"tool": null})", R"({"made": 1})",
        R"({"command": "toolcomp"})", R"({"command": [1]})", R"({"sections": {}})", R"({"cases": -1})",
        R"({"cases": 1.5})", R"({"cases": 10000000000000})", R"({"inputs": [{"given": "a"}]})",
        R"({"inputs": [{"given": "a", "file": "b", "more": 1}]})",
        R"({"files": [{"file": "a", "size": "1", "sha256": ""}]})", R"({"files": [1]})"}) {
    auto changed = nlohmann::json::parse(manifest);
    const auto changes = nlohmann::json::parse(patch);
    for (const auto& [key, value] : changes.items()) {
      if (value.is_null())
        changed.erase(key);
      else
        changed[key] = value;
    }
    files += " " + folder.write(std::to_string(expected.size()) + ".json", changed.dump());
    expected += " False";
    Members members = good;
    members["manifest.json"] = changed.dump();
    write_bundle(folder.path("wrong.tar.zst"), members);
    expect_refused(toolcomp("verify " + folder.path("wrong.tar.zst")), "manifest.json:1:", patch);
  }
  EXPECT_EQ(command("/usr/bin/python3 -W ignore -c 'import json, sys, jsonschema\n"
                    "v = jsonschema.Draft202012Validator(json.load(open(sys.argv[1])))\n"
                    "print(*[v.is_valid(json.load(open(f))) for f in sys.argv[2:]])' " TOOLCOMP_SOURCE_DIR
                    "/corpus/schema/manifest.schema.json " +
                    files)
                .out,
            expected + "\n");
  // Every string of manifest, certificate and hello.
  for (const char* name : {"manifest.json", "certificate.json", "hello.json"}) {
    const auto original = nlohmann::ordered_json::parse(good.at(name));
    const auto flat = original.flatten();
    int tried = 0;
    for (const auto& [pointer, value] : flat.items()) {
      if (!value.is_string() || pointer.find("/sections/") == 0 || pointer.find("/fields/") == 0) continue;
      if (pointer.find("sha256") != std::string::npos || pointer.find("/files/") == 0) continue;
      if (++tried > 15) break;  // the rest are names of fields and of clauses
      auto changed = original;
      changed[nlohmann::ordered_json::json_pointer(pointer)] = std::string(
          "\x1b[31m\nconforms\xc2\x9b"
          "2J\xe2\x80\xae\xe2\x81\xa6\x7f\x07");
      Members members = good;
      members[name] = changed.dump();
      if (std::string(name) != "manifest.json") adapt_manifest(members);
      write_bundle(folder.path("hostile.tar.zst"), members);
      expect_harmless(toolcomp("verify " + folder.path("hostile.tar.zst")), name + pointer);
    }
  }
}

// --- text

TEST(HostileText, ReachesNoTerminal) {
  const Folder folder;
  const std::string words = in_json(kHostile);
  // A controller whose name, errors, alarms, chatter and error answers are hostile.
  const std::string script = folder.write("c.py", R"(import json, sys
hostile = )" + words + R"(
how = sys.argv[1]
for line in sys.stdin:
    request = json.loads(line)
    if "hello" in request:
        print(json.dumps({"name": hostile, "version": hostile, "protocol": 1, "sections": ["fanuc/tool-offset", hostile],
                          "fields": ["kind", "line", "point", "axes", "number", hostile]}), flush=True)
        continue
    sys.stderr.write(hostile); sys.stderr.flush()
    if how == "chatter": sys.stdout.write("x" + hostile.replace("\n", "") + "\n")
    if how == "error": print(json.dumps({"id": request["id"], "error": hostile}), flush=True)
    elif how == "not": print(json.dumps({"id": request["id"], "not_applicable": hostile}), flush=True)
    elif how == "id": print(json.dumps({"id": hostile, "events": []}), flush=True)
    elif how == "crash": sys.exit(3)
    else: print(json.dumps({"id": request["id"], "events": [{"kind": "alarm", "line": 1, "number": hostile, "message": hostile,
                            hostile: hostile}]}), flush=True)
)");
  for (const char* how : {"chatter", "error", "not", "id", "crash", "alarm"}) {
    const std::string report = folder.path(std::string("report-") + how);
    const Outcome outcome = toolcomp("certify --controller 'python3 " + script + " " + how +
                                     "' --section fanuc/tool-offset --cases 3 --settle 5s --report " + report);
    expect_harmless(outcome, how);
    for (const auto& entry : fs::recursive_directory_iterator(report))
      if (entry.is_regular_file()) expect_harmless(read(entry.path()), std::string(how) + " " + entry.path().string());
    for (const auto& entry : fs::directory_iterator(report))
      if (entry.path().filename() == "findings")
        for (const auto& finding : fs::directory_iterator(entry))
          expect_harmless(toolcomp("replay --yes " + finding.path().string()), std::string("replay ") + how);
  }
}

TEST(HostileText, NamesAndWordsInErrors) {
  const Folder folder;
  const std::string name = folder.write("a\x1b[31m\nconforms.nc", "G01 X1 F1\nG99999 X\n");
  const std::string quoted = "\"" + name + "\"";
  const std::string setup = folder.write("setup.toml", "control = \"fanuc\"\naxes = [\"X\"]\n");
  for (const std::string& verb :
       std::vector<std::string>{"run ", "diff ", "explain ", "view --out - ", "replay ", "config check ", "kit judge ",
                                "verify ", "certify --controller fast "})
    expect_harmless(toolcomp(verb + quoted + (verb.starts_with("certify") ? " --report " + folder.path("r") : "")).err,
                    verb);
  expect_harmless(toolcomp("run \"$(printf 'no\\033[31mfile\\nconforms')\""), "a name that is not there");
  expect_harmless(toolcomp("config check " + folder.write("key.toml", "\"a\\u001b[31m\\nconforms\" = 1\n")), "a key");
  expect_harmless(toolcomp("config check " + folder.write("value.toml", "control = \"a\\u001b[31m\\nconforms\"\n")),
                  "a value");
  expect_harmless(toolcomp("certify --tolerance 1 --trace " + folder.write("t.csv", "t,X,\x1b[31mconforms\n") + " " +
                           kPlate + " --report " + folder.path("r")),
                  "a column");
  expect_harmless(toolcomp("run " + folder.write("p.nc", "G01 X\x1b[31m\n")), "a program");
  expect_harmless(toolcomp("certify --controller \"$(printf '\\033[31mconforms')\" --report " + folder.path("r2")),
                  "a command");
  expect_harmless(toolcomp("\"$(printf '\\033[31m\\nconforms')\""), "a verb");
}

// A document with each of its strings made hostile, one after another. Returns how many there are.
template <class Use>
int each_string(const nlohmann::json& document, Use use) {
  int strings = 0;
  const auto flat = document.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    if (!value.is_string()) continue;
    auto changed = document;
    changed[nlohmann::json::json_pointer(pointer)] = "\x1b[31m\nconforms\xc2\x9b\xe2\x80\xae\x7f\x07";
    use(changed, pointer);
    ++strings;
  }
  return strings;
}

TEST(HostileText, InFilesThatPeoplePassOn) {
  const Folder folder;
  fs::create_directories(folder.path("adapters/a"));
  fs::create_directories(folder.path("kit"));
  const auto finding = nlohmann::json::parse(
      R"({"finding": 1, "kind": "coordinate", "clause": "fanuc.tool-offset.x", "line": 1, "field": "axes.X",
          "expected": "1", "actual": "2", "status": "exit status 0", "errors": "e", "alone": "the fast engine",
          "controller": "false", "directory": "/", "seed": "1", "target": "t", "tool": "toolcomp", "first_case": "f",
          "not_settled": "no time", "capabilities": {"name": "n", "version": "v", "protocol": 1, "sections": ["s"],
          "fields": ["kind"], "resolution": "0.1", "rounding": "nearest"},
          "case": {"case": 1, "id": "a", "section": "fanuc/tool-offset", "comment": "c", "clauses": ["x"],
          "dialect": "fanuc", "setup": {"control": "fanuc", "units": "mm", "axes": ["X"]}, "program": "G00 X1\n"}})");
  ASSERT_EQ(toolcomp("replay " + folder.write("good.json", finding.dump()) + " --controller '" + kBinary +
                     " serve --engine fast'")
                .status,
            0);
  int places = each_string(finding, [&](const auto& changed, const std::string& pointer) {
    const std::string file = folder.write("finding.json", changed.dump());
    expect_harmless(toolcomp("replay --yes " + file), "replay, " + pointer);
    expect_harmless(toolcomp("replay " + file + " --controller '" + kBinary + " serve --engine fast'"), pointer);
  });
  const auto kit = nlohmann::json::parse(
      R"({"kit": 1, "dialect": "fanuc", "tool": "t", "corpus": "1", "corpus_hash": "h", "sections": ["fanuc/tool-offset"],
          "machine": "control = \"fanuc\"\naxes = [\"X\"]\n", "travels": ["X=0,1"], "tolerance": "1", "offsets": "o",
          "groups": [{"parameters": {"5001#2": "1"}, "program": "p"}], "programs": [{"number": 8001, "group": 0,
          "file": "f", "setup": "s", "expected": "e", "mark_lines": [1, 2, 3], "cases": [{"id": "i", "section": "s",
          "machine": "same", "first_line": 1, "last_line": 1, "end_line": 1, "shows": ["o"]}]}], "outcomes": 0,
          "recorded": 0, "noted": 0, "missing": [{"outcome": "o", "text": "t", "why": "w"}], "files": {"f": "0"}})");
  places += each_string(kit, [&](const auto& changed, const std::string& pointer) {
    static_cast<void>(folder.write("kit/kit.json", changed.dump()));
    expect_harmless(toolcomp("kit judge " + folder.path("kit")), "kit, " + pointer);
  });
  const std::string good = "[[adapter]]\nname = \"a\"\nkind = \"pipe\"\ncommand = \"false\"\n";
  const std::string text = R"("\u001b[31m\nconforms\u009b\u202e")";
  for (const std::string& manifest :
       {good + "packages = [" + text + "]\nprograms = [" + text + "]\n", good + "tolerance = " + text + "\n",
        good + "setups = [" + text + "]\n", good + "known_differences = " + text + "\n", good + text + " = 1\n",
        "[[adapter]]\nname = " + text + "\n", "[[adapter]]\nname = \"a\"\nkind = " + text + "\n",
        "[[adapter]]\nname = \"a\"\nkind = \"pipe\"\ncommand = " + text + "\n"}) {
    static_cast<void>(folder.write("adapters/a/manifest.toml", manifest));
    expect_harmless(toolcomp("certify --controller a --cases 1 --section fanuc/tool-offset --adapters " +
                             folder.path("adapters") + " --report " + folder.path("r")),
                    manifest);
    ++places;
  }
  EXPECT_GE(places, 50);
}

// --- a finding's command

TEST(HostileFinding, IsNotRunUnasked) {
  const Folder folder;
  const std::string mark = folder.path("ran");
  const std::string file = folder.write(
      "f.json",
      R"({"finding": 1, "kind": "coordinate", "controller": "touch )" + mark +
          R"(", "case": {"case": 1, "id": "a", "section": "fanuc/tool-offset", "dialect": "fanuc", "setup": {"control": "fanuc", "axes": ["X"]}, "program": "G00 X1\n"}})");
  const Outcome outcome = toolcomp("replay " + file + " </dev/null");
  expect_refused(outcome, "--yes", "unasked");
  EXPECT_NE(outcome.err.find("touch "), std::string::npos) << "it is shown: " << outcome.err;
  EXPECT_FALSE(fs::exists(mark));
  EXPECT_EQ(toolcomp("replay " + file + " --controller '" + kBinary + " serve --engine fast'").status, 0);
  EXPECT_FALSE(fs::exists(mark));
  toolcomp("replay --yes " + file);
  EXPECT_TRUE(fs::exists(mark));
}

// --- files

TEST(HostileFiles, WhatIsNoPlainFile) {
  const Folder folder;
  const std::string fifo = folder.path("fifo");
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const std::string setup = folder.write("setup.toml", "control = \"fanuc\"\naxes = [\"X\"]\n");
  const std::string program = folder.write("p.nc", "G01 X1 F1\n");
  expect_refused(toolcomp("run " + fifo), "not a regular file", "a FIFO as program");
  expect_refused(toolcomp("run " + program + " --setup /dev/zero"), "not a regular file", "/dev/zero as setup");
  expect_refused(toolcomp("config check /dev/zero"), "not a regular file", "/dev/zero");
  expect_refused(toolcomp("certify --trace " + fifo + " --tolerance 1 " + program + " --report " + folder.path("r")),
                 "not a regular file", "a FIFO as recording");
  expect_refused(toolcomp("view " + program + " --out " + fifo), "not a regular file", "--out onto a FIFO");
  EXPECT_TRUE(fs::is_fifo(fifo)) << "it is still there";
  // A pipe that a shell opened is read.
  EXPECT_EQ(toolcomp("run /dev/stdin --setup " + setup, "echo G01 X1 F1 | ").status, 0);
  // A link is replaced, what it points to stays.
  const std::string kept = folder.write("kept", "kept");
  fs::create_symlink(kept, folder.path("link.html"));
  EXPECT_EQ(toolcomp("view " + program + " --out " + folder.path("link.html")).status, 0);
  EXPECT_EQ(read(kept), "kept");
}

TEST(HostileFiles, NothingOutsideTheFolderIsCalled) {
  const Folder folder;
  fs::create_directories(folder.path("in"));
  const std::string outside = folder.write("outside.nc", "G01 X5 F1\nM99\n");
  static_cast<void>(folder.write("in/setup.toml", "control = \"fanuc\"\naxes = [\"X\"]\n"));
  fs::create_symlink(outside, folder.path("in/O0007.nc"));
  expect_refused(toolcomp("run " + folder.write("in/p.nc", "M98 P7\nM30\n")), "a link to a place outside the folder",
                 "M98");
}

TEST(HostileFiles, AKitOpensItsOwnFilesAlone) {
  const Folder folder;
  static_cast<void>(folder.write("outside.nc", "G01 X1\n"));
  fs::create_directories(folder.path("kit"));
  static_cast<void>(folder.write("kit/kit.json", R"({"kit": 1, "files": {"../outside.nc": "0"}})"));
  const Outcome outcome = toolcomp("kit judge " + folder.path("kit"));
  EXPECT_EQ(outcome.status, 2) << outcome.out << outcome.err;
}

// --- bounds

TEST(HostileSizes, APageOfAMillionLines) {
  const Folder folder;
  const std::string setup = folder.write("setup.toml", "control = \"fanuc\"\naxes = [\"X\"]\n");
  std::string text = "G01 F1\n";
  for (int i = 0; i < 1'000'000; ++i) text += "X1\n";
  expect_refused(toolcomp("view " + folder.write("p.nc", text) + " --out " + folder.path("v.html"), kMemory),
                 "more than 200000 lines", "a million lines");
}

TEST(HostileSizes, WhatIsHeldInMemoryIsBounded) {
  const Folder folder;
  const std::string setup = folder.write("setup.toml", "control = \"fanuc\"\naxes = [\"X\"]\n");
  std::string text = "G01 F1\n";
  for (int i = 0; i < 1'000'001; ++i) text += "X1\n";
  expect_refused(toolcomp("explain " + folder.write("p.nc", text), kMemory), "more than 200000 blocks", "explain");
  const nlohmann::json c{{"case", 1},
                         {"id", "a"},
                         {"section", "fanuc/tool-offset"},
                         {"dialect", "fanuc"},
                         {"setup", {{"control", "fanuc"}, {"axes", {"X"}}}},
                         {"program", text}};
  expect_refused(toolcomp("replay " + folder.write("case.json", c.dump()), kMemory), "more than 1000000 lines",
                 "replay");
}

// A disk that is full in the middle of it leaves the report that was there.
TEST(HostileSizes, AReportIsWholeOrNotThere) {
  const Folder folder;
  const std::string report = folder.path("report");
  const std::string certify =
      kBinary + " certify --controller '" + TOOLCOMP_BINARY_DIR +
      "/toolcomp_faulty_controller drop-event' --section fanuc/tool-length-offset --cases 20 --settle 0 --report ";
  const auto files = [&] {
    std::map<std::string, std::string> list;
    if (fs::is_directory(report))
      for (const auto& entry : fs::recursive_directory_iterator(report))
        if (entry.is_regular_file()) list[entry.path().string()] = read(entry.path());
    return list;
  };
  // Findings and certificate fit, the page does not.
  const std::string full = "ulimit -f 1000; ";
  const Outcome first = command(full + certify + report);
  expect_refused(first, "index.html: cannot be written: ", "the first report");
  EXPECT_FALSE(fs::exists(report + "/certificate.json"));
  EXPECT_FALSE(fs::exists(report + "/index.html"));
  ASSERT_EQ(command(certify + report).status, 1);
  const auto before = files();
  expect_refused(command(full + certify + report + " --seed 7"),
                 "index.html: cannot be written: ", "the second report");
  for (const char* file : {"/certificate.json", "/junit.xml", "/certificate.sarif", "/index.html"})
    EXPECT_EQ(files()[report + file], before.at(report + file)) << file;
  for (const auto& [file, text] : files()) EXPECT_EQ(file.find(".part"), std::string::npos) << file;
}

// A controller that answers nothing is asked five times, whatever it writes meanwhile.
TEST(HostileSizes, AControllerThatDoesNotAnswer) {
  const Folder folder;
  const std::string script = folder.write("c.py", R"(import json, sys, time
asked = sys.argv[2]
for line in sys.stdin:
    if "hello" in json.loads(line) and sys.argv[1] != "hello":
        print(json.dumps({"name": "n", "protocol": 1, "sections": ["fanuc/cutter-compensation-b"],
                          "fields": ["kind", "line", "point", "axes"]}), flush=True)
        continue
    open(asked, "a").write("x")
    while True:
        sys.stdout.write("{" if sys.argv[1] == "drip" else "busy\n" if sys.argv[1] == "chatter" else "")
        sys.stdout.flush()
        time.sleep(0.01)
)");
  for (const std::string how : {"hang", "drip", "chatter", "hello"}) {
    const std::string asked = folder.path(how);
    const Outcome outcome = toolcomp("certify --controller 'python3 " + script + " " + how + " " + asked +
                                     "' --timeout 5 --report " + folder.path("report") + " " + kPlate);
    EXPECT_EQ(outcome.status, 1) << how << outcome.err;
    EXPECT_LE(read(asked).size(), 5U) << how << outcome.out;
    const bool said = outcome.out.find("the controller does not answer") != std::string::npos;
    EXPECT_EQ(said, how == "hang" || how == "drip") << how << outcome.out;
  }
}

TEST(HostileSizes, AReportThatCannotBeWritten) {
  const Folder folder;
  static_cast<void>(folder.write("file", ""));
  for (const char* name : {"file", "file/report", "/dev/null", "/proc/report"}) {
    const std::string report = *name == '/' ? name : folder.path(name);
    EXPECT_EQ(toolcomp("certify --controller fast --section fanuc/tool-offset --cases 1 --report " + report).status, 2)
        << report;
  }
}

}  // namespace
