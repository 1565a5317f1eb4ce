// SPDX-License-Identifier: Apache-2.0
// `toolcomp kit` as a user runs it: a kit made, its programs run, recordings of a perfect machine and of others judged.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "tests/command_line/command.h"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;

const std::string kMachine =
    "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[workpiece.G54]\nX = 10\nY = -20\nZ = 5\n"
    "[position]\nX = 1\nY = 2\n";
const std::string kTravels = " --travel X=-300,300 --travel Y=-250,250 --travel Z=-200,200";

// What an ideal control would leave behind: the positions of the events, 20 ms apart, and the rests of G04. It follows
// arcs by itself; of everything else it knows the ends of moves alone.
class PerfectMachine {
 public:
  explicit PerfectMachine(std::string letters) : letters_(std::move(letters)) {}

  void run(const std::string& program, const std::vector<json>& events) {
    std::map<std::size_t, double> rests;  // by line
    std::istringstream lines(read(program));
    std::string line;
    for (std::size_t number = 1; std::getline(lines, line); ++number)
      if (line.starts_with("G04 P")) rests[number] = std::stod(line.substr(5)) / 1000;
    auto rest = rests.begin();
    for (const json& event : events) {
      if (event["kind"] != "move") continue;
      for (; rest != rests.end() && rest->first < event["line"].get<std::size_t>(); ++rest) stand(rest->second);
      move(event);
    }
    for (; rest != rests.end(); ++rest) stand(rest->second);
  }

  // `off` is added to Y of the samples in the range given.
  [[nodiscard]] std::string csv(const std::string& header, double shift_x = 0, double off_after = 1e9,
                                double off = 0) const {
    std::string text = header + "\n";
    for (const auto& [time, at] : samples_) {
      text += fmt::format("{:.3f}", time);
      for (const char axis : letters_)
        text += fmt::format(",{:.6f}",
                            at.at(axis) + (axis == 'X' ? shift_x : 0) + (axis == 'Y' && time > off_after ? off : 0));
      text += "\n";
    }
    return text;
  }

 private:
  void sample() { samples_.emplace_back(time_, at_); }
  void stand(double seconds) {
    for (long ticks = std::lround(seconds / 0.02); ticks > 0; --ticks) {
      time_ += 0.02;
      sample();
    }
  }
  void move(const json& event) {
    std::map<char, double> to;
    for (const auto& [axis, value] : event["axes"].items()) to[axis[0]] = value.get<double>();
    if (at_.empty()) at_ = to;
    const std::map<char, double> from = at_;
    const int parts = from == to && !event.contains("center") ? 1 : std::max(25, chords(event, from));
    for (int i = 1; i <= parts; ++i) {
      const double t = static_cast<double>(i) / parts;
      for (const auto& [axis, value] : to) at_[axis] = from.at(axis) + t * (value - from.at(axis));
      if (event.contains("center") && event.contains("sweep") && i < parts) on_the_arc(event, from, t);
      time_ += 0.02;
      sample();
    }
    at_ = to;
  }
  // So many that no chord is a fifth of the tolerance off its arc: 1 where there is none.
  [[nodiscard]] static int chords(const json& event, const std::map<char, double>& from) {
    if (!event.contains("center") || !event.contains("sweep")) return 1;
    double radius = 0;
    for (const auto& [axis, value] : event["center"].items())
      radius = std::hypot(radius, from.at(axis[0]) - value.get<double>());
    const double sweep = event["sweep"].get<double>() * std::numbers::pi / 180;
    return static_cast<int>(std::ceil(sweep * std::sqrt(radius / 8 / 0.002))) + 1;
  }
  void on_the_arc(const json& event, const std::map<char, double>& from, double t) {
    const std::string plane = event["plane"];
    const double turn = event["direction"] == "ccw" ? 1 : -1;
    const double angle = turn * t * event["sweep"].get<double>() * std::numbers::pi / 180;
    const double u = event["center"][plane.substr(0, 1)].get<double>();
    const double v = event["center"][plane.substr(1, 1)].get<double>();
    const double a = from.at(plane[0]) - u;
    const double b = from.at(plane[1]) - v;
    double grown = 1;
    if (event.contains("radius"))
      grown = 1 + t * (event["radius"][1].get<double>() / event["radius"][0].get<double>() - 1);
    at_[plane[0]] = u + grown * (a * std::cos(angle) - b * std::sin(angle));
    at_[plane[1]] = v + grown * (a * std::sin(angle) + b * std::cos(angle));
  }

  std::string letters_;
  double time_ = 0;
  std::map<char, double> at_;
  std::vector<std::pair<double, std::map<char, double>>> samples_;
};

class Kit : public testing::Test {
 protected:
  Folder folder;

  [[nodiscard]] Outcome make(const std::string& setup, const std::string& more, const std::string& out = "kit") const {
    return toolcomp("kit make --setup " + folder.write("machine.toml", setup) + " --out " + folder.path(out) + more);
  }
  // One section in which little compensation can be had wrong.
  [[nodiscard]] Outcome make_small(const std::string& out = "kit") const {
    return make(kMachine, kTravels + " --section fanuc/cutter-compensation-b --section fanuc/tool-length-offset", out);
  }
  [[nodiscard]] json manifest() const { return json::parse(read(folder.path("kit/kit.json"))); }
  [[nodiscard]] std::vector<json> run(const json& program) const {
    const std::string file = folder.path("kit/" + program["file"].get<std::string>());
    const Outcome outcome =
        toolcomp("run " + file + " --setup " + folder.path("kit/") + program["setup"].get<std::string>());
    EXPECT_EQ(outcome.status, 0) << file << outcome.err;
    return outcome.events();
  }
  // Writes the alarm form with what is expected.
  [[nodiscard]] std::string noted(const json& kit) const {
    std::string form = "program,alarm,block,note\n";
    for (const json& program : kit["programs"])
      if (program.contains("alarm"))
        form += fmt::format("O{},{},N{},as it came\n", program["number"].get<int>(),
                            program["alarm"].get<std::string>(), program["alarm_n"].get<int>());
    return folder.write("noted.csv", form);
  }
  [[nodiscard]] Outcome judged(const std::string& recordings, const std::string& more = "") const {
    return toolcomp("kit judge " + folder.path("kit") + " " + recordings + " --tolerance 0.01 --report " +
                    folder.path("report") + more);
  }
};

TEST_F(Kit, EveryProgramRunsInsideTheTravelsAndEndsAsItSays) {
  const Outcome made = make_small();
  ASSERT_EQ(made.status, 0) << made.err;
  const json kit = manifest();
  ASSERT_GT(kit["programs"].size(), 3U);
  const std::map<std::string, double> origin{{"X", 10}, {"Y", -20}, {"Z", 5}};
  const std::map<std::string, double> most{{"X", 300}, {"Y", 250}, {"Z", 200}};
  std::size_t alarms = 0;
  for (const json& program : kit["programs"]) {
    const std::vector<json> events = run(program);
    ASSERT_FALSE(events.empty());
    for (const json& event : events)
      if (event["kind"] == "move") {
        for (const auto& [axis, value] : event["axes"].items())
          EXPECT_LE(std::abs(value.get<double>() + origin.at(axis)), most.at(axis)) << program["file"];
      }
    const json& last = events.back();
    if (program.contains("alarm")) {
      ++alarms;
      EXPECT_EQ(last["number"], program["alarm"]) << program["file"];
      EXPECT_EQ(last["n"], program["alarm_n"]) << program["file"];
    } else {
      EXPECT_EQ(last["kind"], "move");
      EXPECT_EQ(last["axes"]["X"], 1.0) << program["file"];
      EXPECT_EQ(last["axes"]["Y"], 2.0) << program["file"];
    }
    const std::string text = read(folder.path("kit/" + program["file"].get<std::string>()));
    for (const std::string word : {" M03", " M3\n", " M08", " M8\n", " S", " T"})
      EXPECT_EQ(text.find(word), std::string::npos) << program["file"] << word;
  }
  EXPECT_GT(alarms, 0U);
  EXPECT_LT(alarms, kit["programs"].size());
  EXPECT_EQ(kit["recorded"].get<std::size_t>() + kit["noted"].get<std::size_t>() + kit["missing"].size(),
            kit["outcomes"].get<std::size_t>());
  for (const json& missing : kit["missing"]) EXPECT_FALSE(missing["why"].get<std::string>().empty());
}

// The offset program, run from an empty memory, writes what the setups of the programs have.
TEST_F(Kit, TheOffsetProgramEntersTheTable) {
  ASSERT_EQ(make_small().status, 0);
  const Outcome run = toolcomp("run " + folder.path("kit/O8000.nc") + " --setup " + folder.path("machine.toml"));
  ASSERT_EQ(run.status, 0) << run.err;
  std::istringstream list(read(folder.path("kit/offsets.csv")));
  std::string line;
  std::getline(list, line);
  std::size_t rows = 0;
  for (const json& event : run.events()) {
    ASSERT_EQ(event["kind"], "setting");
    ASSERT_TRUE(std::getline(list, line));
    std::istringstream fields(line);
    std::string table;
    std::string number;
    std::string geometry;
    std::getline(fields, table, ',');
    std::getline(fields, number, ',');
    std::getline(fields, geometry, ',');
    EXPECT_EQ(event["name"], "H" + number);
    EXPECT_DOUBLE_EQ(event["value"].get<double>(), std::stod(geometry));
    ++rows;
  }
  EXPECT_GT(rows, 3U);
  EXPECT_FALSE(std::getline(list, line));
}

// What the adapter of a control says that it does not have, or does otherwise, stays at home, and no program ends in an
// alarm.
TEST_F(Kit, ForAControlThatAnAdapterDescribes) {
  fs::create_directories(folder.path("adapters/fake"));
  const auto write = [&](const std::string& name, const std::string& text) {
    ASSERT_FALSE(folder.write("adapters/fake/" + name, text).empty());
  };
  write("machine.toml", kMachine);
  write("manifest.toml",
        "[[adapter]]\nname = \"fake\"\nkind = \"trace\"\ncommand = \"sh run.sh\"\ntolerance = \"0.01\"\n"
        "setups = [\"machine.toml\"]\nknown_differences = \"known.toml\"\n");
  write("known.toml",
        "[[difference]]\nid = \"negative\"\nreason = \"r\"\nrecognised = \"r\"\nsetup = \"machine.toml\"\n"
        "program = \"G44 H1 Z1.\"\n");
  write("run.sh",
        "test \"$1\" = --ask || exit 9\nfor one in \"$2\"/*/; do cd \"$one\"\n"
        "grep -q '[ 0-9]G42' program.nc && echo 'no G42' >not_applicable.txt\n"
        "grep -q '[ 0-9]G44' program.nc && echo 'negative 1 9' >known.txt\ndone\nexit 0\n");
  const std::string sections = " --section fanuc/cutter-compensation-c --section fanuc/tool-length-offset";
  const Outcome made =
      make(kMachine, kTravels + sections + " --cases 20 --controller fake --adapters " + folder.path("adapters"));
  ASSERT_EQ(made.status, 0) << made.err;
  const json kit = manifest();
  ASSERT_FALSE(kit["programs"].empty());
  std::size_t generated = 0;
  for (const json& program : kit["programs"]) {
    EXPECT_FALSE(program.contains("alarm"));
    const std::string text = read(folder.path("kit/" + program["file"].get<std::string>()));
    for (const std::string word : {" G42", " G44"}) EXPECT_EQ(text.find(word), std::string::npos) << program["file"];
    for (const json& c : program["cases"]) generated += c["id"].get<std::string>().starts_with("generated-") ? 1 : 0;
  }
  EXPECT_GT(generated, 0U);
  std::string why;
  for (const json& missing : kit["missing"]) why += missing["why"].get<std::string>();
  EXPECT_NE(why.find("fake does not have: no G42"), std::string::npos);
  EXPECT_NE(why.find("fake is known to differ: negative"), std::string::npos);

  write("run.sh", "echo broken >&2; exit 7\n");
  const Outcome broken =
      make(kMachine, kTravels + sections + " --controller fake --adapters " + folder.path("adapters"), "other");
  EXPECT_EQ(broken.status, 2);
  EXPECT_NE(broken.err.find("exit status 7: broken"), std::string::npos) << broken.err;
  EXPECT_EQ(make(kMachine, kTravels + sections + " --controller nobody", "third").status, 2);
}

TEST_F(Kit, TheSameInputGivesTheSameBytes) {
  ASSERT_EQ(make_small("kit").status, 0);
  ASSERT_EQ(make_small("again").status, 0);
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path("kit"))) {
    if (entry.is_directory()) continue;
    const fs::path name = fs::relative(entry.path(), folder.path("kit"));
    EXPECT_EQ(read(entry.path()), read(fs::path(folder.path("again")) / name)) << name;
    ++files;
  }
  EXPECT_EQ(manifest()["files"].size() + 1, files);
}

// No geometry here: the model knows no kinematics, so the travels are those of the tip.
TEST_F(Kit, KlartextProgramsRunAndEndAsTheySay) {
  const Outcome made = make("control = \"heidenhain\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"B\", \"C\"]\n",
                            kTravels + " --travel A=-360,360 --travel B=-360,360 --travel C=-360,360");
  ASSERT_EQ(made.status, 0) << made.err;
  const json kit = manifest();
  EXPECT_TRUE(fs::exists(folder.path("kit/tool.t")));
  std::size_t alarms = 0;
  for (const json& program : kit["programs"]) {
    const std::vector<json> events = run(program);
    ASSERT_FALSE(events.empty());
    if (program.contains("alarm")) {
      ++alarms;
      EXPECT_EQ(events.back()["number"], program["alarm"]) << program["file"];
      EXPECT_EQ(events.back()["line"].get<int>(), program["alarm_n"].get<int>() + 1) << program["file"];
    } else {
      EXPECT_EQ(events.back()["axes"]["X"], 0) << program["file"];
      EXPECT_EQ(events.back()["axes"]["Z"], 0) << program["file"];
    }
    const std::string text = read(folder.path("kit/" + program["file"].get<std::string>()));
    for (const std::string word : {" M3\n", " M8\n", " M13", " S+", " S1"})
      EXPECT_EQ(text.find(word), std::string::npos) << program["file"] << word;
  }
  EXPECT_GT(alarms, 3U);
  EXPECT_GT(kit["recorded"].get<std::size_t>(), 50U);
}

class Recorded : public Kit {
 protected:
  json kit;
  std::vector<json> programs;  // to record

  void SetUp() override {
    ASSERT_EQ(make_small().status, 0);
    kit = manifest();
    for (const json& program : kit["programs"])
      if (!program.contains("alarm")) programs.push_back(program);
    ASSERT_GT(programs.size(), 1U);
    fs::create_directories(folder.path("recordings"));
  }
  [[nodiscard]] PerfectMachine run_on_machine(const std::vector<json>& which) const {
    PerfectMachine machine("XYZ");
    for (const json& program : which)
      machine.run(folder.path("kit/" + program["file"].get<std::string>()), run(program));
    return machine;
  }
};

TEST_F(Recorded, APerfectMachineGetsACompleteCertificate) {
  // Several programs a file, last first.
  std::vector<json> order(programs.rbegin(), programs.rend());
  std::ignore = folder.write("recordings/day.csv", run_on_machine(order).csv("time,X,Y,Z"));
  const Outcome outcome = judged(folder.path("recordings"), " --alarms " + noted(kit));
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const json certificate = json::parse(read(folder.path("report/certificate.json")));
  EXPECT_EQ(certificate["outcomes_shown"], certificate["outcomes_of_the_kit"]);
  EXPECT_EQ(certificate["programs"].size(), programs.size());
  EXPECT_TRUE(fs::exists(folder.path("report/index.html")));
}

TEST_F(Recorded, MachineCoordinatesAreThoseOfG54AndTheOrigin) {
  const PerfectMachine machine = run_on_machine({programs.front()});
  // Only X has another origin here: Y and Z are left out of the recording.
  std::string csv = "time,X\n";
  std::istringstream lines(machine.csv("time,X,Y,Z", 10));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) csv += line.substr(0, line.find(',', line.find(',') + 1)) + "\n";
  std::ignore = folder.write("recordings/x.csv", csv);
  const Outcome outcome = judged(folder.path("recordings"), " --machine-coordinates");
  EXPECT_EQ(outcome.status, 3) << outcome.out << outcome.err;
  const std::string first = fmt::format("O{}: conforms\n", programs.front()["number"].get<int>());
  EXPECT_NE(outcome.out.find(first), std::string::npos) << outcome.out;
}

TEST_F(Recorded, WhatIsMissingIsSaid) {
  std::ignore = folder.write("recordings/one.csv", run_on_machine({programs.front()}).csv("time,X,Y,Z"));
  const Outcome outcome = judged(folder.path("recordings"));
  EXPECT_EQ(outcome.status, 3) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find(fmt::format("O{}: conforms\n", programs.front()["number"].get<int>())), std::string::npos);
  EXPECT_NE(outcome.out.find(fmt::format("O{}: missing, not recorded\n", programs.back()["number"].get<int>())),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("alarm not noted\n"), std::string::npos) << outcome.out;
}

TEST_F(Recorded, APathThatIsOffIsFound) {
  // The mark is over behind 20 s; from then on Y is off by a tenth, so that the rests do not stand at their place.
  std::ignore = folder.write("recordings/off.csv", run_on_machine({programs.front()}).csv("time,X,Y,Z", 0, 20, 0.1));
  EXPECT_EQ(judged(folder.path("recordings")).status, 3);
  // Off by less than a mark is granted, by more than the tolerance.
  const Outcome outcome = toolcomp("kit judge " + folder.path("kit") + " " +
                                   folder.write("recordings/O8001.csv",
                                                [&] {
                                                  std::istringstream lines(
                                                      run_on_machine({programs.front()}).csv("time,X,Y,Z", 0, 20, 0.1));
                                                  std::string text = "X,Y,Z\n";
                                                  std::string line;
                                                  std::getline(lines, line);
                                                  while (std::getline(lines, line))
                                                    text += line.substr(line.find(',') + 1) + "\n";
                                                  return text;
                                                }()) +
                                   " --tolerance 0.01 --report " + folder.path("report"));
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("O8001: differs\n"), std::string::npos) << outcome.out;
}

TEST_F(Recorded, AnotherAlarmIsFound) {
  std::string form = read(noted(kit));
  const std::size_t at = form.find("PS00");
  ASSERT_NE(at, std::string::npos);
  form.replace(at, 6, "PS0999");
  const Outcome outcome = judged("", " --alarms " + folder.write("other.csv", form));
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("another alarm, PS0999"), std::string::npos) << outcome.out;
}

TEST_F(Recorded, BadInputIsNamedWithItsPlace) {
  const auto refused = [](const Outcome& outcome, const std::string& what) {
    EXPECT_EQ(outcome.status, 2) << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find(what), std::string::npos) << outcome.err;
  };
  refused(judged("", " --alarms " + folder.write("a.csv", "program,alarm,block,note\nO8501,41,N5,\nO7,1,,\n")),
          "a.csv:3:1: \"O7\" is not a program of this kit that ends in an alarm\n");
  refused(judged("", " --alarms " + folder.write("b.csv", "program,alarm\n")),
          "b.csv:1:1: the first line must be program,alarm,block,note\n");
  refused(judged(folder.write("r.csv", "time,X,Y,Z\n0,1,2\n")), "r.csv:2:6: fewer values than columns\n");
  refused(judged(folder.write("s.csv", "X,Y,Z\n0,1,2\n")), "s.csv:1:1: no time column");
  refused(toolcomp("kit judge " + folder.path("kit") + " --tolerance 0.06"),
          "must be at most the tolerance of the kit, 0.05");
  const std::string program = folder.path("kit/" + programs.front()["file"].get<std::string>());
  std::ofstream(program, std::ios::app) << "(changed)\n";
  refused(judged(""), programs.front()["file"].get<std::string>() + ": differs from kit.json");
  std::ignore = folder.write("kit/kit.json", "{\"kit\": 1,\n \"tool\": 2}\n");
  refused(judged(""), "kit.json:2:10: ");
}

TEST_F(Kit, BadInputToMakeIsNamedWithItsPlace) {
  const auto refused = [](const Outcome& outcome, const std::string& what) {
    EXPECT_EQ(outcome.status, 2) << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find(what), std::string::npos) << outcome.err;
  };
  refused(make("control = \"fanuc\"\naxes = [\"X\", \"Q\"]\n", kTravels), "machine.toml:2:14: axes");
  refused(make(kMachine, " --travel X=-300,300 --travel Y=-250,250"), "axis Z has no travel");
  refused(make(kMachine, kTravels + " --travel X=-1,1"), "\"X=-1,1\": the axis is given twice");
  refused(make(kMachine, " --travel X=3"), "--travel: \"X=3\": expected AXIS=LEAST,GREATEST");
  refused(make(kMachine, " --travel X=-1,5 --travel Y=-250,250 --travel Z=-9,9"), "the place of the marks");
  refused(make(kMachine, kTravels + " --section fanuc/nothing"), "no section \"fanuc/nothing\"");
  fs::create_directories(folder.path("full"));
  std::ignore = folder.write("full/x", "");
  refused(make(kMachine, kTravels, "full"), "is not empty");
  EXPECT_FALSE(fs::exists(folder.path("kit")));
}

}  // namespace
