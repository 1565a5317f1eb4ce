// SPDX-License-Identifier: Apache-2.0
// Findings in groups, one of each settled, within a time by a clock of the test; and how one is settled: by controllers
// in this process that are wrong always, every so often, behind something, or at first.
#include "certify/settling.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "certify/evidence.h"
#include "certify/program_text.h"
#include "fuzz/gen/generator.h"

namespace toolcomp::certify {
namespace {

using std::chrono::seconds;

// What was seen of a crash, whose words are its cause.
Sighting crash(const std::string& words, const std::string& program, std::uint64_t cases) {
  Sighting sighting;
  Finding& f = sighting.finding;
  f.key = {"fanuc/tool-length-offset", program, "crash"};
  f.smallest.program = program;
  f.difference.actual = words;
  f.occurrences = cases;
  f.before.resize(5);
  sighting.settle = [f](const std::function<bool()>& stop) {
    Finding settled = f;
    settled.seen = settled.tried = stop() ? 0 : 3;
    if (settled.tried > 0) settled.before.resize(2);
    return settled;
  };
  return sighting;
}

// Two findings of one cause with 6 cases, one of another with 7.
std::vector<Sighting> three() {
  return {crash("exit status 3", "G49\nX1\n", 2), crash("exit status 3", "G49\n", 4), crash("killed", "X1\n", 7)};
}

std::vector<std::string> reasons(const Settled& settled) {
  std::vector<std::string> all;
  for (const Finding& f : settled.findings) all.push_back(f.not_settled);
  return all;
}

TEST(Settling, OneOfEachGroupTheLargestFirst) {
  std::vector<std::string> told;
  SettlingOptions options;
  options.clock = [] { return std::chrono::steady_clock::time_point(); };
  options.told = [&](const SettlingGroup& group) {
    told.push_back(fmt::format("{} of {}: {}", group.number, group.groups, group.cause.words));
  };
  const Settled settled = settle(three(), options);
  ASSERT_EQ(settled.causes.size(), 2U);
  EXPECT_EQ(settled.causes[0].words, "crash: killed");
  EXPECT_EQ(settled.causes[0].cases, 7U);
  EXPECT_EQ(settled.causes[0].findings, std::vector<std::size_t>{0});
  EXPECT_EQ(settled.causes[1].words, "crash: exit status 3");
  EXPECT_EQ(settled.causes[1].cases, 6U);
  EXPECT_EQ(settled.causes[1].findings, (std::vector<std::size_t>{1, 2}));
  ASSERT_EQ(settled.findings.size(), 3U);
  EXPECT_EQ(settled.findings[1].smallest.program, "G49\n") << "the smallest of its group";
  EXPECT_EQ(reasons(settled), (std::vector<std::string>{"", "", "finding 2 represents its group"}));
  EXPECT_EQ(settled.findings[1].occurrences, 4U);
  EXPECT_EQ(settled.findings[1].tried, 3U);
  EXPECT_EQ(settled.findings[2].tried, 0U);
  EXPECT_EQ(settled.findings[2].before.size(), 2U) << "as many as the one that stands for it";
  EXPECT_EQ(told, (std::vector<std::string>{"1 of 2: crash: killed", "2 of 2: crash: exit status 3"}));
}

TEST(Settling, EndsWhenTheTimeIsOver) {
  SettlingOptions options;
  options.budget = seconds(10);
  auto now = std::chrono::steady_clock::time_point();
  options.clock = [&now] { return now; };
  // The first group takes 10 s, which is all there is.
  auto sightings = three();
  sightings[2].settle = [&now, settle = sightings[2].settle](const auto& stop) {
    Finding settled = settle(stop);
    now += seconds(10);
    return settled;
  };
  const Settled settled = settle(sightings, options);
  EXPECT_EQ(reasons(settled), (std::vector<std::string>{"", "no time was left", "finding 2 represents its group"}));
  EXPECT_EQ(settled.findings[1].before.size(), 5U) << "all, so that it can be replayed";
}

// Of what is left: the first of two groups ends after 5 of 10 s, the second after the 9 that are left then.
TEST(Settling, EachGroupHasAnEqualShare) {
  SettlingOptions options;
  options.budget = seconds(10);
  auto now = std::chrono::steady_clock::time_point();
  options.clock = [&now] { return now; };
  std::vector<seconds::rep> taken;
  const auto takes = [&](Sighting& sighting, seconds most) {
    sighting.settle = [&, f = sighting.finding, most](const auto& stop) {
      const auto begun = now;
      while (!stop() && now - begun < most) now += seconds(1);
      taken.push_back(std::chrono::duration_cast<seconds>(now - begun).count());
      return f;
    };
  };
  auto sightings = three();
  takes(sightings[1], seconds(100));
  takes(sightings[2], seconds(100));
  settle(sightings, options);
  EXPECT_EQ(taken, (std::vector<seconds::rep>{5, 5}));
  taken.clear();
  takes(sightings[2], seconds(1));
  settle(sightings, options);
  EXPECT_EQ(taken, (std::vector<seconds::rep>{1, 9}));
}

TEST(Settling, NothingWhereItIsNotWantedOrInterrupted) {
  SettlingOptions none;
  none.budget = seconds(0);
  EXPECT_EQ(reasons(settle(three(), none)),
            (std::vector<std::string>{"not asked for", "not asked for", "finding 2 represents its group"}));
  SettlingOptions interrupted;
  interrupted.stop = [] { return "interrupted (SIGINT)"; };
  EXPECT_EQ(reasons(settle(three(), interrupted))[0], "interrupted (SIGINT)");
}

// The fast engine as a process that may be wrong: all axes off by 1.
class Wrong : public Subject {
 public:
  std::variant<Capabilities, Fault> capabilities() override { return built_in_engine()->capabilities(); }
  Answer run(const spec::Case& c, std::optional<std::chrono::milliseconds> patience) override {
    if (!alive_) {
      ++starts_;
      asked_.clear();
    }
    alive_ = true;
    Answer answer = built_in_engine()->run(c, patience);
    if (is_wrong(c))
      for (auto& event : std::get<FastEvents>(answer.result)) event.axes.value[0] += 1;
    asked_.push_back(c.program);
    return answer;
  }
  [[nodiscard]] std::uint64_t starts() const override { return starts_; }
  void restart() override { alive_ = false; }

 protected:
  virtual bool is_wrong(const spec::Case& c) = 0;
  std::vector<std::string> asked_;  // of this process

 private:
  std::uint64_t starts_ = 0;
  bool alive_ = false;
};

spec::Case program(const std::string& text) {
  spec::Case c;
  c.section = "fanuc/tool-length-offset";
  c.setup.h[1] = {spec::decimal(20), {}};
  c.program = text;
  return c;
}

// What a process was asked, and got wrong at the last.
Finding settled(Wrong& wrong, const std::vector<spec::Case>& asked, const EvidenceOptions& options = {}) {
  const auto able = std::get<Capabilities>(wrong.capabilities());
  Answer answer;
  for (const spec::Case& c : asked) answer = wrong.run(c, {});
  const spec::Case& last = asked.back();
  const Judgement judgement = judge_answer(able, last, judge::run_model(last), answer);
  EXPECT_EQ(judgement.result, Result::differs);
  return make_finding(wrong, as_seen(able, last, judgement, answer, {asked.begin(), asked.end() - 1}), options);
}

std::vector<spec::Case> many() {
  std::vector<spec::Case> cases;
  for (int i = 1; i <= 20; ++i) cases.push_back(program(fmt::format("G43 Z10. H1\nG01 X{}. F100\nG49 Z0\n", i)));
  return cases;
}

TEST(Evidence, OneProcessWillDoForWhatIsWrongAlways) {
  class Always : public Wrong {
    bool is_wrong(const spec::Case&) override { return true; }
  } wrong;
  const Finding f = settled(wrong, many());
  EXPECT_EQ(wrong.starts(), 3U)
      << "that of the campaign, one that was asked nothing else, one for the smallest program";
  EXPECT_TRUE(f.before.empty());
  EXPECT_EQ(count_blocks(f.smallest.program), 1U);
  EXPECT_EQ(f.seen, 5U);
  EXPECT_EQ(f.tried, 5U);
  EXPECT_TRUE(f.complete);
  EXPECT_GT(f.runs, 5U);
}

// Six requests before it, whichever: the case itself.
TEST(Evidence, WhatComesEverySeventhTimeHasTheSixBeforeIt) {
  class Seventh : public Wrong {
    bool is_wrong(const spec::Case&) override { return asked_.size() % 7 == 6; }
  } wrong;
  auto cases = many();
  cases.resize(14);
  const Finding f = settled(wrong, cases);
  ASSERT_EQ(f.before.size(), 6U);
  for (const spec::Case& c : f.before) EXPECT_EQ(c.program, f.smallest.program);
  EXPECT_EQ(count_blocks(f.smallest.program), 1U);
  EXPECT_EQ(f.seen, f.tried);
}

// One request before it, and it must be that one.
TEST(Evidence, WhatComesBehindOneRequestHasThatBeforeIt) {
  class Sticky : public Wrong {
    bool is_wrong(const spec::Case&) override {
      return std::ranges::any_of(asked_, [](const std::string& p) { return p.find("X7.") != std::string::npos; });
    }
  } wrong;
  auto cases = many();
  const Finding f = settled(wrong, cases);
  ASSERT_EQ(f.before.size(), 1U);
  EXPECT_EQ(f.before.front().program, cases[6].program);
  EXPECT_EQ(f.seen, f.tried);
}

TEST(Evidence, WhatComesOfFreshProcessesAloneIsShrunkByThem) {
  class First : public Wrong {
    bool is_wrong(const spec::Case&) override { return asked_.empty(); }
  } wrong;
  const Finding f = settled(wrong, {many().front()});
  EXPECT_TRUE(f.before.empty());
  EXPECT_EQ(count_blocks(f.smallest.program), 1U);
  EXPECT_EQ(f.seen, 5U);
  EXPECT_EQ(f.tried, 5U);
}

// Not shrunk: any smaller program may fail by chance.
TEST(Evidence, WhatDoesNotComeAgainIsKept) {
  class Once : public Wrong {
    bool is_wrong(const spec::Case&) override { return starts() == 1 && asked_.size() == 19; }
  } wrong;
  const Finding f = settled(wrong, many());
  EXPECT_EQ(f.smallest.program, many().back().program);
  EXPECT_EQ(f.before.size(), 19U);
  EXPECT_EQ(f.seen, 0U);
  EXPECT_EQ(f.tried, 10U);
  EXPECT_FALSE(f.complete);
}

TEST(Evidence, WithoutTimeItStaysAsItWasSeen) {
  class Always : public Wrong {
    bool is_wrong(const spec::Case&) override { return true; }
  } wrong;
  EvidenceOptions options;
  options.stop = [] { return true; };
  const Finding f = settled(wrong, many(), options);
  EXPECT_EQ(wrong.starts(), 1U);
  EXPECT_EQ(f.tried, 0U);
  EXPECT_EQ(f.before.size(), 19U);
  EXPECT_EQ(f.smallest.program, many().back().program);
}

}  // namespace
}  // namespace toolcomp::certify
