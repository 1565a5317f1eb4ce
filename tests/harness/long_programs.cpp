// SPDX-License-Identifier: Apache-2.0
// Long programs in a certification: judged while they are read, as short ones are with all events at hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "certify/certification.h"
#include "certify/event_fields.h"
#include "certify/long_program.h"
#include "corpus/freeform.h"
#include "judge/oracle/verdict.h"
#include "spec/language/event_map.h"
#include "spec/language/setup_format.h"
#include "tests/effort.h"

namespace toolcomp::certify {
namespace {

// A controller that computes as the fast engine does, and says so in decimals; or one that is off in one event.
class Texts final : public Subject {
 public:
  explicit Texts(bool wrong) : wrong_(wrong) {}
  std::variant<Capabilities, Fault> capabilities() override {
    return std::get<Capabilities>(built_in_engine()->capabilities());
  }
  Answer run(const spec::Case& c, std::optional<std::chrono::milliseconds> /*patience*/) override {
    TextEvents texts;
    Answer answer;
    for (const fast::Event& event : judge::run_fast(c))
      texts.push_back(spec::map_numbers<spec::NumberText>(
          event, [](double number) { return spec::NumberText{fmt::format("{}", number), {}, {}}; }));
    for (const model::Event& event : judge::run_model(c).events) answer.sent.add(fields_of(event));
    if (wrong_ && !texts.empty() && texts.back().axes.has(0))
      texts.back().axes.set(0, {fmt::format("{}", std::stod(texts.back().axes[0].v) + 1), {}, {}});
    answer.result = std::move(texts);
    return answer;
  }

 private:
  bool wrong_;
};

enum class Judged : std::uint8_t { here, controller };

// Under sanitizers made long by a comment.
spec::Case long_case() {
  const corpus::Freeform freeform = corpus::make_freeform({.blocks = test::effort(700U, 9500U)});
  spec::Case c;
  c.id = "long";
  c.dialect = "klartext";
  c.setup = spec::read_setup_toml(freeform.setup, "setup");
  c.program = freeform.program;
  if (!test::whole()) c.program += ";" + std::string(kLargestAtOnce, ' ') + "\n";
  return c;
}

CertificationOptions options_of(const spec::Case& c, Judged judged) {
  CertificationOptions options;
  options.cases = {{c, Origin::own}};
  options.generated = 0;
  if (judged != Judged::here) options.subject = [] { return std::make_unique<Texts>(false); };
  return options;
}

// What stands in the report but for the picture is what all events at hand give.
TEST(LongPrograms, AreJudgedAsShortOnes) {
  const spec::Case c = long_case();
  ASSERT_TRUE(is_long(c));
  for (const Judged judged : {Judged::here, Judged::controller}) {
    const Certificate certificate = certify::certify(options_of(c, judged));
    const auto subject = judged == Judged::here ? built_in_engine() : std::make_unique<Texts>(false);
    const auto able = std::get<Capabilities>(subject->capabilities());
    const judge::ModelRun run = judge::run_model(c);
    const Answer answer = subject->run(c);
    const Judgement whole = judge_answer(able, c, run, answer);
    EXPECT_EQ(whole.result, Result::agrees);
    SectionResult expected;
    add(expected, asked_and_judged(c, Origin::own, run, answer, whole));
    const SectionResult& found = certificate.sections.at(0);
    EXPECT_EQ(found.results, expected.results);
    EXPECT_EQ(found.values, expected.values);
    EXPECT_EQ(found.wide, expected.wide);
    EXPECT_EQ(found.decisions, expected.decisions);
    EXPECT_EQ(found.near_ties, expected.near_ties);
    EXPECT_EQ(found.worst_ulp, expected.worst_ulp);
    EXPECT_EQ(found.worst_um, expected.worst_um);
    EXPECT_EQ(found.widths.largest(), expected.widths.largest());
    for (std::size_t i = 0; i < spec::kClauseCount; ++i)
      EXPECT_EQ(certificate.clauses[i].reached, run.recorder.counts()[i].reached) << i;
  }
}

// What differs is left to be judged with all events at hand.
TEST(LongPrograms, DoNotAgreeWithAnotherController) {
  const spec::Case c = long_case();
  const auto beginning = beginning_of(c);
  for (const bool wrong : {false, true}) {
    Texts controller(wrong);
    const auto able = std::get<Capabilities>(controller.capabilities());
    const Answer answer = controller.run(c, {});
    EXPECT_EQ(judge_long(able, c, &answer, beginning).has_value(), !wrong);
  }
}

// The picture, and the laws, are of its first lines.
TEST(LongPrograms, AreDrawnAsTheyBegin) {
  const spec::Case c = long_case();
  const auto beginning = beginning_of(c);
  ASSERT_TRUE(beginning);
  EXPECT_TRUE(c.program.starts_with(beginning->c.program));
  EXPECT_EQ(beginning->c.id, fmt::format("long, lines 1 to {}", beginning->lines));
  EXPECT_LE(beginning->c.program.size(), 1U << 16U);
  EXPECT_GT(beginning->run.events.size(), 100U);
  spec::Case one_line = c;
  one_line.program.assign(1U << 21U, ' ');
  EXPECT_FALSE(beginning_of(one_line));
}

}  // namespace
}  // namespace toolcomp::certify
