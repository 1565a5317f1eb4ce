// SPDX-License-Identifier: Apache-2.0
// program: misbehaviour
// begins first
// Controllers that break in every way the harness must survive: each gives the right typed finding, shrunk to a program
// a machinist can key in, and replay reproduces it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "certify/certification.h"
#include "certify/program_text.h"
#include "certify/replay.h"
#include "certify/report.h"
#include "certify/selection.h"
#include "fuzz/campaign/features.h"
#include "fuzz/gen/generator.h"
#include "host/file_writer.h"
#include "spec/language/input_error.h"
#include "tests/effort.h"

namespace toolcomp::certify {
namespace {

using std::chrono::milliseconds;

std::string faulty(const std::string& fault, const std::string& text = "") {
  std::string command = std::string("'") + TOOLCOMP_BINARY_DIR + "/toolcomp_faulty_controller' " + fault;
  return text.empty() ? command : command + " '" + text + "'";
}

CertificationOptions options(const std::string& controller) {
  CertificationOptions o;
  o.controller = controller;
  o.sections = {"fanuc/tool-length-offset"};
  o.generated = 40;
  // No bound but on what never comes: that is waited for.
  const auto is = [&](const char* words) { return controller.find(words) != std::string::npos; };
  o.timeout = is("hang")      ? std::chrono::seconds(1)
              : is("rubbish") ? std::chrono::seconds(5)
                              : std::chrono::seconds(120);
  o.settling.clock = [] { return std::chrono::steady_clock::time_point(); };
  return o;
}

// The findings that stand for a group each, by number.
std::vector<std::size_t> settled(const Certificate& c) {
  std::vector<std::size_t> all;
  for (const SharedCause& group : c.causes) all.push_back(group.findings.front());
  return all;
}

std::filesystem::path folder(const std::string& name) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / ("toolcomp-" + name);
  std::filesystem::remove_all(path);
  return path;
}

const SectionResult& section(const Certificate& c) { return c.sections.at(0); }

TEST(Controller, TheFastEngineThroughThePipeConforms) {
  const Certificate c = certify::certify(options(faulty("none")));
  EXPECT_EQ(exit_status(c), 0) << json_report(c);
  EXPECT_EQ(section(c).count(Origin::generated), 40U);
  EXPECT_GT(section(c).values, 1000U);
  EXPECT_EQ(c.subject.name, "faulty controller");
}

struct Misbehaviour {
  const char* fault;
  const char* kind;  // of the finding; "" for any difference of events
  std::size_t most_blocks;
};
class Misbehaves : public testing::TestWithParam<Misbehaviour> {};

TEST_P(Misbehaves, GivesATypedFindingThatReplayReproduces) {
  const Misbehaviour& m = GetParam();
  CertificationOptions o = options(faulty(m.fault));
  // Most of them end the process, and under sanitizers one takes a while to begin.
  if (test::kSanitized) o.generated = 16;
  // 200 MB come: the default limit would read a third of them each time.
  if (std::string(m.fault) == "long-line") o.reply_limit = std::size_t{4} << 20;
  const Certificate c = certify::certify(o);
  EXPECT_EQ(exit_status(c), 1);
  ASSERT_FALSE(c.findings.empty());
  const auto paths = write_report(c, folder(m.fault));
  ASSERT_EQ(paths.size(), c.findings.size());
  for (const Finding& f : c.findings) {
    if (*m.kind != '\0') {
      EXPECT_EQ(f.key.kind, m.kind);
    }
    EXPECT_TRUE(spec::find_clause(f.key.clause)) << f.key.clause << " in\n" << f.smallest.program;
  }
  for (const std::size_t i : settled(c)) {
    const Finding& f = c.findings[i];
    EXPECT_EQ(f.not_settled, "");
    EXPECT_LE(count_blocks(f.smallest.program), m.most_blocks) << f.smallest.program;
    EXPECT_GE(count_blocks(f.smallest.program), 1U);
    EXPECT_NE(f.difference.actual, "");
    ReplayOptions how;
    how.timeout = o.timeout;
    const Replay again = replay(paths[i], how);
    EXPECT_TRUE(again.reproduced()) << again.key.clause << " " << again.key.kind << "\n" << f.smallest.program;
    EXPECT_EQ(exit_status(again.judgement.result), 1);
    // The built-in engine does not have the fault.
    how.controller = "";
    EXPECT_EQ(exit_status(replay(paths[i], how).judgement.result), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Faults, Misbehaves,
    testing::Values(Misbehaviour{"flip-sign", "", 3}, Misbehaviour{"drop-event", "missing event", 3},
                    Misbehaviour{"hang", "hang", 3}, Misbehaviour{"rubbish", "malformed reply", 3},
                    Misbehaviour{"exit", "crash", 3}, Misbehaviour{"abort", "crash", 3},
                    Misbehaviour{"long-line", "reply too long", 3}, Misbehaviour{"wrong-id", "malformed reply", 3},
                    Misbehaviour{"no-events", "malformed reply", 3}, Misbehaviour{"missing-field", "missing field", 3},
                    Misbehaviour{"missing-axes", "", 3}, Misbehaviour{"error", "error", 3},
                    Misbehaviour{"not-a-number", "malformed reply", 3},
                    Misbehaviour{"hello-rubbish", "malformed reply", 3}, Misbehaviour{"hello-hang", "hang", 3}),
    [](const auto& test) {
      std::string name = test.param.fault;
      std::ranges::replace(name, '-', '_');
      return name;
    });

TEST(Controller, StandardErrorOfACrashIsKept) {
  CertificationOptions o = options(faulty("exit"));
  o.shrink_runs = 0;
  const Certificate c = certify::certify(o);
  ASSERT_FALSE(c.findings.empty());
  EXPECT_NE(c.findings[0].errors.find("servo not ready"), std::string::npos);
  EXPECT_NE(c.findings[0].difference.actual.find("exit status 3"), std::string::npos);
  EXPECT_EQ(c.findings[0].status, "exit status 3");
}

// A fault at every seventh case that a process is asked: the rest of the section goes on with a fresh process, the
// finding keeps the six requests before it, and replay asks them again.
TEST(Controller, AFaultBehindOtherRequestsKeepsThem) {
  for (const char* fault : {"seventh-exit", "seventh-drop-event"}) {
    CertificationOptions o = options(faulty(fault));
    o.shrink_runs = 20;
    const Certificate c = certify::certify(o);
    EXPECT_EQ(section(c).count(Result::not_run), 0U) << fault;
    EXPECT_GE(section(c).count(Result::differs), 4U) << fault;
    ASSERT_FALSE(c.findings.empty());
    const auto report = folder(fault);
    const auto paths = write_report(c, report);
    for (const std::size_t i : settled(c)) {
      const Finding& f = c.findings[i];
      EXPECT_EQ(f.before.size(), 6U) << fault << '\n' << write_finding(f);
      EXPECT_EQ(f.seen, f.tried) << fault;
      const Replay again = replay(paths[i]);
      EXPECT_TRUE(again.reproduced()) << fault;
      EXPECT_EQ(again.asked, faulty(fault));
      EXPECT_EQ(again.finding.subject.name, "faulty controller");
      // Without them it does not come.
      Finding alone = f;
      alone.before.clear();
      const auto file = report / "alone.json";
      host::write_file(file, write_finding(alone));
      EXPECT_EQ(replay(file).judgement.result, Result::agrees) << fault;
    }
  }
}

// What comes by chance is kept, with how often it came.
TEST(Controller, AFaultByChanceIsKeptWithItsShare) {
  CertificationOptions o = options(faulty("sometimes-drop-event"));
  o.shrink_runs = 20;
  std::uint64_t seen = 0;
  std::uint64_t tried = 0;
  bool replayed = false;
  for (int run = 0; run < 5; ++run) {
    const Certificate c = certify::certify(o);
    ASSERT_FALSE(c.findings.empty());
    for (const std::size_t i : settled(c)) {
      EXPECT_EQ(c.findings[i].key.kind, "missing event");
      seen += c.findings[i].seen;
      tried += c.findings[i].tried;
    }
    const auto paths = write_report(c, folder("sometimes"));
    replayed = replayed || replay(paths.front()).judgement.result == Result::differs;
  }
  EXPECT_LT(seen, tried) << "all of them came every time, by a chance of less than a millionth";
  EXPECT_GT(seen, 0U);
  EXPECT_TRUE(replayed);
}

// Found at once, and again where a smaller program shows the same: each time as a file that replay takes.
TEST(Controller, FindingsAreToldAsTheyAreSeen) {
  CertificationOptions o = options(faulty("drop-event"));
  std::vector<Finding> told;
  o.found = [&told](const Finding& f) { told.push_back(f); };
  const Certificate c = certify::certify(o);
  ASSERT_GE(told.size(), c.findings.size());
  for (const Finding& f : c.findings)
    EXPECT_TRUE(std::ranges::any_of(told, [&](const Finding& early) { return early.key == f.key; })) << f.key.clause;
  for (const Finding& f : told) {
    EXPECT_EQ(f.controller, o.controller);
    EXPECT_EQ(write_finding(read_finding(write_finding(f), "told")), write_finding(f));
  }
}

// An end that was asked for keeps all there is, and says what is missing.
TEST(Controller, AnEndBeforeAllIsDone) {
  CertificationOptions o = options(faulty("drop-event"));
  std::uint64_t done = 0;
  o.progress = [&done](std::uint64_t now, std::uint64_t) { done = now; };
  o.stop = [&done] { return done < 10 ? std::string() : std::string("enough"); };
  const Certificate c = certify::certify(o);
  EXPECT_EQ(section(c).count(Result::not_run), 30U);
  EXPECT_EQ(section(c).total(), 40U);
  EXPECT_EQ(c.interrupted, "enough");
  EXPECT_EQ(exit_status(c), 1);
  ASSERT_FALSE(c.findings.empty());
  EXPECT_EQ(c.findings[0].tried, 0U);
  const auto paths = write_report(c, folder("enough"));
  EXPECT_TRUE(replay(paths.front()).reproduced());
  o.controller = faulty("none");
  done = 0;
  const Certificate sound = certify::certify(o);
  EXPECT_EQ(exit_status(sound), 3);
  EXPECT_EQ(verdict(sound), "not decided: enough");
}

// Lines that are no answers are passed over, and shown once.
TEST(Controller, ChatterIsNoRubbish) {
  const Certificate c = certify::certify(options(faulty("chatter")));
  EXPECT_EQ(exit_status(c), 0) << json_report(c);
  EXPECT_EQ(c.chatter, "\"axes ready\"");
}

// One fault in some programs does not spoil the verdict on the others.
TEST(Controller, IsRestartedAfterACrash) {
  const Certificate c = certify::certify(options(faulty("exit", "G49")));
  EXPECT_GT(section(c).count(Result::agrees), 0U);
  EXPECT_GT(section(c).count(Result::differs), 0U);
  for (const Finding& f : c.findings) EXPECT_NE(f.smallest.program.find("G49"), std::string::npos);
}

TEST(Controller, RepeatedHangsEndASectionEarly) {
  CertificationOptions o = options(faulty("hang"));
  o.shrink_runs = 0;
  const Certificate c = certify::certify(o);
  EXPECT_EQ(section(c).count(Result::differs), 2U);
  EXPECT_EQ(section(c).count(Result::not_run), 38U);
}

TEST(Controller, LessThanTheMinimumIsNeverAPass) {
  const Certificate c = certify::certify(options(faulty("less-than-minimum")));
  EXPECT_TRUE(c.findings.empty());
  EXPECT_EQ(section(c).values, 0U);
  EXPECT_EQ(exit_status(c), 3);
}

// What is not announced is not judged, and the certificate says so.
TEST(Controller, FieldsThatAreNotAnnouncedAreNotJudged) {
  const Certificate c = certify::certify(options(faulty("no-type")));
  EXPECT_EQ(exit_status(c), 0) << json_report(c);
  EXPECT_EQ(fields_not_judged(c.subject), std::vector<std::string>{"type"});
}

TEST(Controller, ItsResolutionIsHonoured) {
  const Certificate c = certify::certify(options(faulty("coarse")));
  EXPECT_EQ(exit_status(c), 0) << json_report(c);
  // It truncates: by its mean the lengths lie toward zero of the exact ones, by less than an increment.
  EXPECT_GT(section(c).bias.count, 0U);
  EXPECT_LE(std::fabs(section(c).bias.worst), 25.4);
}

// One that truncates and announces that it rounds to nearest, or 0.0001 inches where it has 0.001, is found.
TEST(Controller, ARoundingOtherThanAnnouncedIsFound) {
  const Certificate c = certify::certify(options(faulty("coarse-rounding")));
  EXPECT_EQ(exit_status(c), 1);
}

TEST(Controller, CasesAgainstItsFixedSetupDoNotApply) {
  const Certificate c = certify::certify(options(faulty("fixed-setup")));
  EXPECT_GT(section(c).count(Result::not_applicable), 0U);
  EXPECT_TRUE(c.findings.empty());
}

TEST(Controller, SectionsItDoesNotAnnounceDoNotApply) {
  CertificationOptions o = options(faulty("one-section"));
  o.sections = {"fanuc/leading-edge-offset"};
  const Certificate c = certify::certify(o);
  EXPECT_EQ(section(c).count(Result::not_applicable), section(c).total());
  EXPECT_EQ(exit_status(c), 3);
}

TEST(Controller, ACommandThatIsNotThereIsBadUsage) {
  EXPECT_THROW(certify::certify(options("/nowhere/controller")), spec::InputError);
}

// The same seed gives the same certificate, with one job or three.
TEST(Controller, TheCertificateIsDeterministic) {
  CertificationOptions one = options(faulty("drop-event"));
  CertificationOptions three = one;
  three.jobs = 3;
  const Certificate a = certify::certify(one);
  EXPECT_EQ(json_report(a), json_report(certify::certify(one)));
  EXPECT_EQ(json_report(a), json_report(certify::certify(three)));
}

// Coarser than 0.01 mm, or 0.0004 inch where the setup is fixed in inches: only for a user who accepts it.
TEST(Controller, ACoarseResolutionMustBeAccepted) {
  EXPECT_EQ(exit_status(certify::certify(options(faulty("coarse")))), 0);
  for (const std::string fault : {"very-coarse", "very-coarse-inch"}) {
    CertificationOptions o = options(faulty(fault));
    EXPECT_THROW(certify::certify(o), spec::InputError) << fault;
    o.accepted_resolution = "0.0009";
    EXPECT_THROW(certify::certify(o), spec::InputError) << fault;
    o.accepted_resolution = "0.050";
    EXPECT_EQ(exit_status(certify::certify(o)), 0) << fault;
  }
}

TEST(Controller, AFieldAnnouncedAndNeverSentIsAFinding) {
  const Certificate c = certify::certify(options(faulty("never-sends")));
  EXPECT_EQ(exit_status(c), 1);
  ASSERT_EQ(c.findings.size(), 1U);
  EXPECT_EQ(c.findings[0].key.kind, "field never sent");
  ASSERT_EQ(c.causes.size(), 1U);
  EXPECT_EQ(c.causes[0].words, "field never sent: clauses");
  EXPECT_EQ(c.findings[0].difference.field, "clauses");
  EXPECT_LE(count_blocks(c.findings[0].smallest.program), 2U);
  const auto paths = write_report(c, folder("never-sends"));
  ASSERT_FALSE(paths.empty());
  EXPECT_TRUE(replay(paths.front()).reproduced());
  ReplayOptions sound;
  sound.controller = faulty("none");
  EXPECT_FALSE(replay(paths.front(), sound).reproduced());
}

std::size_t features_of(const std::vector<spec::Case>& cases) {
  std::set<std::uint32_t> reached;
  for (const spec::Case& c : cases) {
    const std::vector<std::uint32_t> features = fuzz::features(judge::run_model(c).recorder);
    reached.insert(features.begin(), features.end());
  }
  return reached.size();
}

// Chosen by the model alone: the same cases whatever answers, and the same again.
TEST(Selection, IsTheSameForASeedAndReachesWhatRandomCasesDoNot) {
  constexpr std::size_t kCount = 100;
  for (const std::string_view section : {"fanuc/cutter-compensation-c", "heidenhain/face-milling"}) {
    const Selection a = select_cases(section, 5, kCount);
    const Selection b = select_cases(section, 5, kCount);
    ASSERT_EQ(a.cases.size(), kCount);
    ASSERT_EQ(b.cases.size(), kCount);
    for (std::size_t i = 0; i < kCount; ++i) EXPECT_EQ(a.cases[i].program, b.cases[i].program);
    EXPECT_NE(a.cases[0].program, select_cases(section, 6, kCount).cases[0].program);
    std::vector<spec::Case> fresh;
    for (std::uint64_t seed = 1; fresh.size() < kCount; ++seed) {
      fuzz::SeededSource source(seed);
      fresh.push_back(fuzz::generate(section, fuzz::Mode::directed, source));
    }
    const std::size_t at_random = features_of(fresh);
    // Random ones have some features that no selection looks for: words that change no path.
    EXPECT_GT(features_of(a.cases), at_random + at_random / 30) << section;
  }
}

TEST(Controller, AnUnknownSectionIsBadUsage) {
  CertificationOptions o = options("");
  o.sections = {"fanuc/no-such-section"};
  EXPECT_THROW(certify::certify(o), spec::InputError);
}

TEST(Controller, TheBuiltInEngineConforms) {
  CertificationOptions o = options("");
  o.sections.clear();
  std::uint64_t done = 0;
  o.progress = [&done](std::uint64_t now, std::uint64_t) { done = now; };
  const Certificate c = certify::certify(o);
  EXPECT_EQ(exit_status(c), 0) << json_report(c);
  EXPECT_EQ(c.sections.size(), fuzz::sections().size());
  EXPECT_EQ(done, 40 * fuzz::sections().size());
  EXPECT_EQ(c.self_check, "");
}

}  // namespace
}  // namespace toolcomp::certify
