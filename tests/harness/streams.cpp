// SPDX-License-Identifier: Apache-2.0
// program: faults
// link: toolcomp_fast_faulty
// Judging while reading: long programs, and the same verdicts as on whole cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "fuzz/faults/fault.h"
#include "fuzz/faults/faults.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/policy.h"
#include "judge/oracle/trial.h"
#include "tests/effort.h"

namespace toolcomp::judge {
namespace {

TEST(Streams, GiveTheVerdictOfTheWholeCase) {
  const std::uint64_t seeds = test::random_cases(300);
  for (std::uint64_t seed = 0; seed < seeds; ++seed)
    for (const std::string_view section : fuzz::sections()) {
      fuzz::SeededSource source(seed);
      const spec::Case c = fuzz::generate(section, fuzz::Mode::directed, source, 40);
      const Trial whole = try_case(c);
      if (whole.acceptance != Acceptance::accepted) continue;
      // Laws are asked of whole cases alone.
      if (whole.verdict.difference && whole.verdict.difference->kind == "law") continue;
      const Verdict v = judge_stream({[&] { return spec::text_source(c.program); }}, c.setup, c.samples);
      EXPECT_EQ(v.outcome, whole.verdict.outcome) << fuzz::encode(c);
      if (v.outcome != Outcome::agrees) continue;
      EXPECT_EQ(v.values + v.wide, whole.verdict.values + whole.verdict.wide) << fuzz::encode(c);
      EXPECT_EQ(v.events, whole.verdict.events) << fuzz::encode(c);
      EXPECT_EQ(v.out_of_scope, whole.verdict.out_of_scope) << fuzz::encode(c);
      EXPECT_EQ(v.decisions, whole.verdict.decisions) << fuzz::encode(c);
      EXPECT_EQ(v.near_ties, whole.verdict.near_ties) << fuzz::encode(c);
    }
}

// What is found in a whole case is found while reading too, with events that are missing, too many, or wrong.
TEST(Streams, FindWhatTheWholeCaseFinds) {
  constexpr std::uint64_t kMost = 20;  // seeds a fault
  std::map<std::string, std::size_t> kinds;
  for (std::size_t i = 0; i < fuzz::seeded_faults().size(); ++i) {
    const fuzz::SeededFault& fault = fuzz::seeded_faults()[i];
    for (std::uint64_t seed = 1; seed <= kMost; ++seed) {
      fuzz::SeededSource source(seed);
      const spec::Case c = fuzz::generate(fault.section, fuzz::Mode::directed, source);
      fast::active_fault = static_cast<fast::Fault>(i + 1);
      const Trial whole = try_case(c);
      std::optional<Verdict> streamed;
      if (whole.found() && whole.verdict.difference->kind != "law" && whole.acceptance == Acceptance::accepted)
        streamed = judge_stream({[&] { return spec::text_source(c.program); }}, c.setup, c.samples);
      fast::active_fault = fast::Fault::none;
      if (!streamed) continue;
      ASSERT_EQ(streamed->outcome, Outcome::differs) << fault.name << '\n' << fuzz::encode(c);
      EXPECT_EQ(streamed->difference->event, whole.verdict.difference->event) << fault.name << " seed " << seed;
      EXPECT_NE(streamed->difference->expected, "") << fault.name << " seed " << seed;
      EXPECT_NE(streamed->difference->actual, "") << fault.name << " seed " << seed;
      ++kinds[streamed->difference->kind];
      break;
    }
  }
  for (const char* kind : {"missing event", "coordinate", "kind"}) EXPECT_GT(kinds[kind], 0U) << kind;
}

// 5001#2 = 1: the last block moves nothing, and the faulty engine moves by the new offset.
TEST(Streams, NoticeAnEventTooManyAtTheEnd) {
  spec::Setup setup;
  setup.parameters[{5001, 2}] = spec::decimal(1);
  setup.h[1].geometry = spec::decimal(1);
  setup.h[2].geometry = spec::decimal(2);
  const auto judged = [&] { return judge_stream({[] { return spec::text_source("G43 Z0 H1\nH2\n"); }}, setup); };
  EXPECT_EQ(judged().outcome, Outcome::agrees);
  fast::active_fault = fast::Fault::h_modal_under_ofh;
  const Verdict v = judged();
  fast::active_fault = fast::Fault::none;
  ASSERT_EQ(v.outcome, Outcome::differs);
  EXPECT_EQ(v.difference->kind, "extra event");
}

// A move without side, OUT_OF_SCOPE (RL without M128), two moves.
TEST(Streams, CountWhatStandsBehindAnOutOfScopeEvent) {
  spec::Setup setup;
  setup.control = spec::Control::heidenhain;
  setup.tools.emplace_back().number = 10;
  const Verdict v =
      judge_stream({[] { return spec::text_source("TOOL CALL 1 Z\nL X+1 R0\nL X+2 RL\nL X+3 R0\nL X+4\n"); }}, setup);
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : v.undecided);
  EXPECT_EQ(v.events, 4U);
  EXPECT_EQ(v.out_of_scope, 2U);
}

// Blocks in changing directions, made as they are read.
class Endless final : public spec::ByteSource {
 public:
  explicit Endless(int blocks) : blocks_(blocks) {}
  std::size_t read(char* buffer, std::size_t size) override {
    std::size_t n = 0;
    while (n < size) {
      if (at_ == line_.size()) {
        if (made_ == blocks_) return n;
        at_ = 0;
        line_ = next();
        ++made_;
      }
      buffer[n++] = line_[at_++];
    }
    return n;
  }

 private:
  [[nodiscard]] std::string next() const {
    if (made_ == 0) return "G91 G01 F100 G43.5 H0 I3. K4.\n";
    if (made_ == 1) return "G41.3 D1\n";
    return "X" + std::to_string(made_ % 7) + ".1 Y-" + std::to_string(made_ % 5) + ".3 Z0.7\n";
  }

  int blocks_;
  int made_ = 0;
  std::string line_;
  std::size_t at_ = 0;
};

std::size_t g_most_nodes = 0;

// Twenty thousand blocks: the exact nodes are bounded by the look-ahead and the decisions kept.
TEST(Streams, HoldNoMoreThanTheirWindow) {
  constexpr int blocks = 20'000;
  spec::Setup setup;
  setup.d[1].geometry = spec::decimal(10);
  const Verdict v = judge_stream({[] { return std::make_unique<Endless>(int{blocks}); }}, setup, 0,
                                 [](std::uint64_t) { g_most_nodes = std::max(g_most_nodes, exact::live_nodes()); });
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : v.undecided);
  EXPECT_GT(v.values, 9U * blocks);
  EXPECT_LT(g_most_nodes, 100'000U);
}

// Decisions are kept for a while and counted in the end: as many as of the whole case, over several times that while.
TEST(Streams, CountDecisionsOfLongPrograms) {
  spec::Case c;
  c.setup.axes = spec::Axes("XYZ");
  c.setup.d[1].geometry = spec::decimal(1);
  c.program = "G91 G01 F100 G41 D1 X10.\n";
  for (int i = 0; i < 1000; ++i) c.program += i % 2 == 0 ? "X10. Y3.\n" : "X10. Y-2.\n";
  const Trial whole = try_case(c);
  ASSERT_EQ(whole.verdict.outcome, Outcome::agrees);
  EXPECT_GT(whole.verdict.decisions, 1000U);
  const Verdict v = judge_stream({[&] { return spec::text_source(c.program); }}, c.setup);
  EXPECT_EQ(v.outcome, Outcome::agrees);
  EXPECT_EQ(v.decisions, whole.verdict.decisions);
  EXPECT_EQ(v.near_ties, whole.verdict.near_ties);
}

// A corner 1/30 short of a reversal, whose vector of 600 mm is known to 60 ulps of it (Conditions,
// OfAnIntersectionNearAReversal). The samples of the block behind it, more than a window holds, do not hide the way
// back.
TEST(Streams, SeeTheMovementBehindManySamples) {
  spec::Case c;
  c.setup.axes = spec::Axes("XYZBC");
  for (const auto& [number, value] :
       {std::pair{19680U, 2}, std::pair{19681U, 5}, std::pair{19682U, 3}, std::pair{19686U, 4}, std::pair{19687U, 2}})
    c.setup.parameters[{number, -1}] = spec::decimal(value);
  c.setup.parameters[{5008, 0}] = spec::decimal(1);
  c.setup.d[1].geometry = spec::decimal(10);
  c.program = "G43.5 H0 I0 J0 K1\nG41.6 D1 G01 X10 F100\nX40\nX-1460 Y50\nG40 X-1500\n";
  for (const std::uint32_t samples : {0U, 20U}) {
    c.samples = samples;
    const Trial whole = try_case(c);
    ASSERT_EQ(whole.verdict.outcome, Outcome::agrees);
    EXPECT_GT(whole.verdict.widths.largest(), 1000 * policy::kAnySection.coordinate * 60 * policy::ulp(600));
    const Verdict v = judge_stream({[&] { return spec::text_source(c.program); }}, c.setup, c.samples);
    EXPECT_EQ(v.outcome, Outcome::agrees);
    EXPECT_EQ(v.widths.largest(), whole.verdict.widths.largest()) << samples;
    EXPECT_EQ(v.widths.quantile(0.5), whole.verdict.widths.quantile(0.5)) << samples;
  }
}

// The fault takes a lean away from the movement for one towards it: the other outcome of a decision by sign. Within the
// band of a near tie that is permitted, which a program that can be opened again shows and one read once cannot.
TEST(Streams, SettleNearTiesByRunningAgain) {
  const auto program = [](const std::string& lean) {
    return "G91 G01 F100 G43.5 H0 I-" + lean + " K1.\nG41.3 D1\nX100.\nX50.\nG40\n";
  };
  spec::Setup setup;
  setup.d[1].geometry = spec::decimal(10);
  setup.parameters[{19631, -1}] = spec::decimal(0);
  const auto text = [](const std::string& written, bool once = false) {
    return StreamedProgram{[&written] { return spec::text_source(written); }, once};
  };
  const std::string inside = program("0.0000000000001");
  const std::string outside = program("0.00000000001");

  fast::active_fault = fast::Fault::above_90_not_reversed;
  const Verdict settled = judge_stream(text(inside), setup);
  const Verdict open = judge_stream(text(inside, true), setup);
  const Verdict wrong = judge_stream(text(outside), setup);
  fast::active_fault = fast::Fault::none;

  EXPECT_EQ(settled.outcome, Outcome::agrees)
      << (settled.difference ? explain(*settled.difference) : settled.undecided);
  EXPECT_GT(settled.ties, 0U);
  EXPECT_EQ(open.outcome, Outcome::undecided);
  EXPECT_EQ(wrong.outcome, Outcome::differs);
  EXPECT_EQ(judge_stream(text(inside, true), setup).outcome, Outcome::agrees);
}

// The near tie of NearTies.AForkThatEndsUndecidedNeverAgrees, and an engine that writes a wrong value behind it.
TEST(Streams, AForkThatEndsUndecidedSettlesNothing) {
  spec::Setup setup;
  setup.h[1].geometry = spec::decimal(10);
  setup.measurement['Z'] = *spec::parse_decimal("7.0710678118654");
  const auto judged = [&] {
    return judge_stream({[] { return spec::text_source("G90 G01 F100 G43.5 H1 I1. K1. Z0\nG49\nH1\nG37 Z5.\n"); }},
                        setup);
  };
  const Verdict right = judged();
  EXPECT_EQ(right.outcome, Outcome::agrees) << (right.difference ? explain(*right.difference) : right.undecided);
  EXPECT_GE(right.near_ties, 1U);
  fast::active_fault = fast::Fault::difference_reversed;
  const Verdict wrong = judged();
  fast::active_fault = fast::Fault::none;
  EXPECT_EQ(wrong.outcome, Outcome::differs);
}

}  // namespace
}  // namespace toolcomp::judge
