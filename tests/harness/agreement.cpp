// SPDX-License-Identifier: Apache-2.0
// What is said of a case that is judged while it is read is what is said of it with all events at hand.
#include "judge/oracle/agreement.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "corpus/contour.h"
#include "corpus/flank.h"
#include "corpus/freeform.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "spec/language/event_map.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"
#include "tests/effort.h"

namespace toolcomp::judge {
namespace {

std::string differences(const Verdict& a, const Verdict& b) {
  std::string text;
  const auto compare = [&text](const char* name, const auto& x, const auto& y) {
    if (x != y) text += std::string(" ") + name;
  };
  compare("outcome", a.outcome, b.outcome);
  compare("values", a.values, b.values);
  compare("numbers", a.numbers, b.numbers);
  compare("wide", a.wide, b.wide);
  compare("events", a.events, b.events);
  compare("out of scope", a.out_of_scope, b.out_of_scope);
  compare("decisions", a.decisions, b.decisions);
  compare("near ties", a.near_ties, b.near_ties);
  compare("ties", a.ties, b.ties);
  compare("worst ulp", a.worst_ulp, b.worst_ulp);
  compare("worst µm", a.worst_um, b.worst_um);
  compare("widths", a.widths.count(), b.widths.count());
  compare("largest width", a.widths.largest(), b.widths.largest());
  return text;
}

std::string counts(const std::vector<model::ClauseCount>& clauses) {
  std::string text;
  for (const model::ClauseCount& c : clauses)
    text += fmt::format("{},{},{},{} ", c.reached, c.positive, c.negative, c.tie);
  return text;
}

// The fast engine's events as a controller sends them.
std::vector<spec::TextEvent> as_texts(const spec::Case& c) {
  std::vector<spec::TextEvent> texts;
  for (const fast::Event& event : run_fast(c))
    texts.push_back(spec::map_numbers<spec::NumberText>(
        event, [](double number) { return spec::NumberText{fmt::format("{}", number), {}, {}}; }));
  return texts;
}

// Nothing where streamed_agreement() is to give nothing.
std::optional<Agreed> agreement_at_once(const spec::Case& c, const ModelRun& run,
                                        const std::vector<spec::TextEvent>* texts) {
  Agreed whole{texts != nullptr ? judge::judge(c, run, *texts) : judge::judge(c, run, run_fast(c)),
               run.recorder.counts()};
  const bool plain = (whole.verdict.outcome == Outcome::agrees || whole.verdict.outcome == Outcome::nothing_judged) &&
                     whole.verdict.ties == 0;
  const auto undecided = [](const model::Event& event) { return event.kind == spec::EventKind::undecided; };
  if (!plain || (texts != nullptr && (run.beyond || std::ranges::any_of(run.events, undecided)))) return std::nullopt;
  return whole;
}

// How many agree, of the fast engine and of a controller.
std::size_t hold(const spec::Case& c) {
  std::size_t agreed = 0;
  const std::vector<spec::TextEvent> texts = as_texts(c);
  const ModelRun run = run_model(c);
  for (const bool controller : {false, true}) {
    const auto whole = agreement_at_once(c, run, controller ? &texts : nullptr);
    std::size_t events = 0;
    const auto streamed = controller
                              ? streamed_agreement(c, texts, {}, [&](const model::Event& /*event*/) { ++events; })
                              : streamed_agreement(c);
    EXPECT_TRUE(whole || !streamed) << fuzz::encode(c);
    if (!streamed || !whole) continue;
    ++agreed;
    EXPECT_EQ(differences(streamed->verdict, whole->verdict), "") << fuzz::encode(c);
    EXPECT_EQ(counts(streamed->clauses), counts(whole->clauses)) << fuzz::encode(c);
    EXPECT_EQ(events, controller ? run.events.size() : 0) << fuzz::encode(c);
  }
  return agreed;
}

TEST(StreamedAgreement, IsThatOfAllEventsAtHand) {
  const std::uint64_t seeds = test::random_cases(40);
  std::size_t agreed = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    for (const std::string_view section : fuzz::sections()) {
      fuzz::SeededSource source(seed);
      const spec::Case c = fuzz::generate(section, fuzz::Mode::directed, source, 60);
      try {
        agreed += hold(c);
      } catch (const spec::InputError&) {
        continue;
      }
    }
  EXPECT_GT(agreed, seeds * fuzz::sections().size());
}

// Over several times the while for which decisions are kept.
TEST(StreamedAgreement, IsThatOfAllEventsAtHandInLongPrograms) {
  const std::size_t blocks = test::effort(600U, 1500U);
  const corpus::Contour contour = corpus::make_contour({.blocks = blocks});
  const corpus::Flank flank = corpus::make_flank({.blocks = blocks});
  const corpus::Freeform freeform = corpus::make_freeform({.blocks = blocks});
  for (const auto& [program, toml] : {std::pair{contour.program, contour.setup}, std::pair{flank.program, flank.setup},
                                      std::pair{freeform.program, freeform.setup}}) {
    spec::Case c;
    c.setup = spec::read_setup_toml(toml, "setup");
    c.program = program;
    EXPECT_EQ(hold(c), 2U) << program.substr(0, 200);
  }
}

// An event moved, left out or doubled is no agreement.
TEST(StreamedAgreement, IsNoneWithAnotherList) {
  const corpus::Contour contour = corpus::make_contour({.blocks = 400});
  spec::Case c;
  c.setup = spec::read_setup_toml(contour.setup, "setup");
  c.program = contour.program;
  const std::vector<spec::TextEvent> texts = as_texts(c);
  const auto agrees = [&](const std::vector<spec::TextEvent>& events) {
    return streamed_agreement(c, events, {}, [](const model::Event& /*event*/) {}).has_value();
  };
  EXPECT_TRUE(agrees(texts));
  for (const std::size_t at : {std::size_t{0}, std::size_t{3}, texts.size() / 2, texts.size() - 1}) {
    std::vector<spec::TextEvent> fewer = texts;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(at));
    EXPECT_FALSE(agrees(fewer)) << at;
    std::vector<spec::TextEvent> more = texts;
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(at), texts[at]);
    EXPECT_FALSE(agrees(more)) << at;
    std::vector<spec::TextEvent> bad = texts;
    bad[at].axes.set(0, {"1.2.3", {}, {}});
    EXPECT_FALSE(agrees(bad)) << at;
    std::vector<spec::TextEvent> off = texts;
    if (!off[at].axes.has(0)) continue;
    off[at].axes.set(0, {fmt::format("{}", std::stod(off[at].axes[0].v) + 0.001), {}, {}});
    EXPECT_FALSE(agrees(off)) << at;
  }
}

// The last event moves to 0: a text that is no number, which is read as 0, is none all the same.
TEST(StreamedAgreement, IsNoneWithATextThatIsNoNumber) {
  spec::Case c;
  c.setup.axes = spec::Axes("XYZ");
  c.program = "G90 G01 F100 X1.\nX0\n";
  std::vector<spec::TextEvent> texts = as_texts(c);
  const auto agrees = [&] {
    return streamed_agreement(c, texts, {}, [](const model::Event& /*event*/) {}).has_value();
  };
  EXPECT_TRUE(agrees());
  texts.back().axes.set(0, {"zero", {}, {}});
  EXPECT_FALSE(agrees());
}

}  // namespace
}  // namespace toolcomp::judge
