// SPDX-License-Identifier: Apache-2.0
// Judging by clauses known so well alone (JudgeOptions::known): a lie in an event that rests on another is not judged,
// any other one is found. Answers are the model's own, so what is expected is known without computing it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "certify/convert.h"
#include "corpus/golden.h"
#include "judge/oracle/verdict.h"

namespace toolcomp::judge {
namespace {

using spec::EventKind;
using spec::KnownSet;

constexpr double kLie = 1;
constexpr std::size_t kCases = 12;  // a section

bool rests_on_other(const model::Event& event, const KnownSet& known) {
  return std::ranges::any_of(event.clauses, [&](spec::Clause c) { return !known.has(spec::info(c).known); });
}

// A golden vector of a section and the model's answer.
struct Honest {
  spec::Case c;
  ModelRun run;
  std::vector<spec::Event<double>> answer;
};

// Vectors that the model decides to their end, with events of both sorts.
std::vector<Honest> vectors(const std::string& section, const KnownSet& known) {
  std::vector<Honest> found;
  for (spec::Case& c : corpus::read_golden(TOOLCOMP_SOURCE_DIR "/corpus/golden", {section})) {
    Honest honest{std::move(c), {}, {}};
    honest.run = run_model(honest.c);
    const auto& events = honest.run.events;
    const auto weak = [&](const model::Event& e) { return rests_on_other(e, known); };
    const bool moves = std::ranges::all_of(events, [](const model::Event& e) { return e.kind == EventKind::move; });
    if (!moves || honest.run.beyond || std::ranges::all_of(events, weak) || std::ranges::none_of(events, weak))
      continue;
    honest.answer = certify::in_doubles(events);
    found.push_back(std::move(honest));
    if (found.size() == kCases) break;
  }
  return found;
}

Verdict judged(const Honest& honest, const std::vector<spec::Event<double>>& answer, const KnownSet& known) {
  return judge::judge(honest.c, honest.run, answer, {{}, {}, known});
}

class KnownSections : public testing::TestWithParam<std::string> {};

TEST_P(KnownSections, ALieIsJudgedByWhatItsEventRestsOn) {
  const KnownSet known = KnownSet::of({"manual", "sister"});
  std::size_t strong = 0;
  std::size_t weak = 0;
  for (const Honest& honest : vectors(GetParam(), known)) {
    const auto left_out = static_cast<std::uint64_t>(
        std::ranges::count_if(honest.run.events, [&](const model::Event& e) { return rests_on_other(e, known); }));
    const Verdict whole = judged(honest, honest.answer, {});
    if (whole.outcome != Outcome::agrees) continue;
    EXPECT_EQ(whole.left_out, 0U) << honest.c.id;
    EXPECT_TRUE(whole.left_out_for.empty()) << honest.c.id;
    const Verdict part = judged(honest, honest.answer, known);
    EXPECT_EQ(part.outcome, Outcome::agrees) << honest.c.id;
    EXPECT_EQ(part.left_out, left_out) << honest.c.id;
    EXPECT_EQ(part.events + part.left_out, whole.events) << honest.c.id;
    EXPECT_LT(part.values, whole.values) << honest.c.id;
    for (const auto& [clause, events] : part.left_out_for) {
      EXPECT_FALSE(known.has(spec::info(clause).known)) << honest.c.id;
      EXPECT_LE(events, part.left_out) << honest.c.id;
    }
    for (std::size_t i = 0; i < honest.answer.size(); ++i) {
      auto answer = honest.answer;
      if (!answer[i].axes.has(0)) continue;
      answer[i].axes.set(0, answer[i].axes[0] + kLie);
      EXPECT_EQ(judged(honest, answer, {}).outcome, Outcome::differs) << honest.c.id << ", event " << i;
      const Verdict verdict = judged(honest, answer, known);
      if (rests_on_other(honest.run.events[i], known)) {
        ++weak;
        EXPECT_NE(verdict.outcome, Outcome::differs) << honest.c.id << ", event " << i;
        EXPECT_GE(verdict.left_out, left_out) << honest.c.id << ", event " << i;
      } else {
        ++strong;
        EXPECT_EQ(verdict.outcome, Outcome::differs) << honest.c.id << ", event " << i;
      }
    }
  }
  EXPECT_GT(strong, 0U) << "no such lie";
  EXPECT_GT(weak, 0U) << "no such lie";
}

// Another number of events where a weak clause decided, and nothing behind it wrong: not accused. What is wrong behind
// it is, once a move agrees again.
TEST_P(KnownSections, EventsMoreOrLessWhereSomethingIsLeftOut) {
  const KnownSet known = KnownSet::of({"manual", "sister"});
  std::size_t found = 0;
  for (const Honest& honest : vectors(GetParam(), known)) {
    if (judged(honest, honest.answer, {}).outcome != Outcome::agrees) continue;
    const auto weak = [&](const model::Event& e) { return rests_on_other(e, known); };
    const auto& events = honest.run.events;
    const auto at = std::ranges::find_if(events, weak) - events.begin();
    auto more = honest.answer;
    more.insert(more.begin() + at, honest.answer[static_cast<std::size_t>(at)]);
    more[static_cast<std::size_t>(at)].feed = 123.5;
    EXPECT_NE(judged(honest, more, known).outcome, Outcome::differs) << honest.c.id;
    auto less = honest.answer;
    less.erase(less.begin() + at);
    EXPECT_NE(judged(honest, less, known).outcome, Outcome::differs) << honest.c.id;
    // The first event judged behind one that agrees again.
    auto later = static_cast<std::size_t>(at) + 1;
    while (later < events.size() && weak(events[later])) ++later;
    const std::size_t wrong = later + 1;
    if (wrong >= events.size() || weak(events[wrong]) || !less[wrong - 1].axes.has(0)) continue;
    less[wrong - 1].axes.set(0, less[wrong - 1].axes[0] + kLie);
    EXPECT_EQ(judged(honest, less, known).outcome, Outcome::differs) << honest.c.id;
    ++found;
  }
  RecordProperty("found", std::to_string(found));
}

INSTANTIATE_TEST_SUITE_P(Sections, KnownSections,
                         testing::Values("fanuc/cutter-compensation-c", "fanuc/tool-side-compensation",
                                         "fanuc/tool-length-offset"),
                         [](const auto& section) {
                           std::string name = section.param;
                           std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
                           return name;
                         });

// The first event rests on what is ours; its alarm ends one run and not the other.
TEST(KnownClauses, AnAlarmMoreEndsWhatIsJudged) {
  const KnownSet known = KnownSet::of({"manual", "sister"});
  for (const Honest& honest : vectors("fanuc/cutter-compensation-c", known)) {
    const auto weak = [&](const model::Event& e) { return rests_on_other(e, known); };
    const auto& events = honest.run.events;
    const auto at = std::ranges::find_if(events, weak) - events.begin();
    std::vector<spec::Event<double>> answer(honest.answer.begin(), honest.answer.begin() + at);
    answer.emplace_back();
    answer.back().kind = EventKind::alarm;
    answer.back().line = events[static_cast<std::size_t>(at)].line;
    answer.back().number = "PS0041";
    const Verdict verdict = judged(honest, answer, known);
    EXPECT_NE(verdict.outcome, Outcome::differs) << honest.c.id;
    EXPECT_EQ(verdict.events, static_cast<std::uint64_t>(at)) << honest.c.id;
    EXPECT_EQ(verdict.left_out, events.size() - static_cast<std::size_t>(at)) << honest.c.id;
    EXPECT_EQ(judged(honest, answer, {}).outcome, Outcome::differs) << honest.c.id;
  }
}

}  // namespace
}  // namespace toolcomp::judge
