// SPDX-License-Identifier: Apache-2.0
// Long contours: the same bytes everywhere, closed, with arcs whose ends are equally far from their centres; both
// engines agree on them, and the tight ones end where elementary geometry says.
#include "corpus/contour.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>

#include "host/sha256.h"
#include "judge/oracle/verdict.h"
#include "model/basis/number.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/setup_format.h"

namespace toolcomp::corpus {
namespace {

using exact::Rational;

constexpr std::size_t kBlocks = 1500;

spec::Case as_case(const Contour& contour) {
  spec::Case c;
  c.section = "fanuc/cutter-compensation-c";
  c.setup = spec::read_setup_toml(contour.setup, "contour.toml");
  c.program = contour.program;
  return c;
}

std::vector<spec::Block> blocks(const spec::Case& c) {
  spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes);
  std::vector<spec::Block> list;
  for (spec::Block block; reader.next(block);) list.push_back(block);
  return list;
}

// The value of the block's word with this letter.
std::optional<Rational> value(const spec::Block& block, char letter) {
  for (const spec::Word& word : block.words())
    if (word.address == letter) return model::plain(word.value);
  return std::nullopt;
}

TEST(Contour, TheSameBytesOnEveryCompiler) {
  EXPECT_EQ(host::sha256(make_contour({.blocks = 500}).program),
            "f186d4fdc7bf970ef3862b9b358be920ffbe411d7d44b694eaaf019ecb4577e8");
  EXPECT_EQ(host::sha256(make_contour({.blocks = 500, .variant = ContourVariant::island, .seed = 2}).program),
            "466e5b9b319ed2daffae7531921cd8c828717734613140f99c10eb6817217bba");
  EXPECT_EQ(host::sha256(
                make_contour({.blocks = 2500, .variant = ContourVariant::tight, .place = TightPlace::groove}).program),
            "81dd5d48070160eefe9fbf50f65c26af428c30808b184851e22d74dd1c6fef9f");
}

TEST(Contour, IsClosedAndItsArcsAreCircles) {
  const Contour contour = make_contour({.blocks = kBlocks});
  EXPECT_EQ(contour.lines + contour.arcs, kBlocks);
  EXPECT_GT(contour.arcs, kBlocks / 5);
  std::map<char, Rational> at{{'X', 0}, {'Y', 0}};
  std::map<char, Rational> first;
  std::size_t circles = 0;
  for (const spec::Block& block : blocks(as_case(contour))) {
    std::map<char, Rational> end = at;
    for (const char letter : {'X', 'Y'})
      if (const auto v = value(block, letter)) end[letter] = *v;
    if (value(block, 'D')) first = end;
    if (const auto i = value(block, 'I')) {
      const Rational x = at['X'] + *i;
      const Rational y = at['Y'] + *value(block, 'J');
      const auto square = [&](std::map<char, Rational>& p) -> Rational {
        return (p['X'] - x) * (p['X'] - x) + (p['Y'] - y) * (p['Y'] - y);
      };
      EXPECT_EQ(square(at), square(end)) << "line " << block.line;
      ++circles;
    }
    bool cancels = false;
    for (const spec::Word& word : block.words()) cancels = cancels || (word.address == 'G' && word.value.digits == 40);
    if (cancels) {
      EXPECT_EQ(at, first) << "the contour closes";
    }
    at = end;
  }
  EXPECT_GT(circles, kBlocks / 5);
}

TEST(Contour, RefusesTooFewBlocks) { EXPECT_THROW(make_contour({.blocks = kLeastContour - 1}), std::invalid_argument); }

// The model's run, on which the fast engine must agree.
judge::ModelRun agreed(const spec::Case& c) {
  judge::ModelRun run = judge::run_model(c);
  const judge::Verdict verdict = judge::judge(c, run, judge::run_fast(c));
  EXPECT_EQ(verdict.outcome, judge::Outcome::agrees)
      << (verdict.difference ? judge::explain(*verdict.difference) : verdict.undecided);
  return run;
}

TEST(Contour, PocketAndIslandRunToTheirEnd) {
  for (const ContourVariant variant : {ContourVariant::pocket, ContourVariant::island})
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const judge::ModelRun run = agreed(as_case(make_contour({.blocks = kBlocks, .variant = variant, .seed = seed})));
      ASSERT_FALSE(run.events.empty());
      EXPECT_EQ(run.events.back().kind, spec::EventKind::move);
    }
}

TEST(Contour, TightPlacesEndTheRunWhereTheyMust) {
  for (const TightPlace place : {TightPlace::arc, TightPlace::groove})
    for (const std::size_t at : {std::size_t{3}, kBlocks / 2, kBlocks - 300}) {
      const Contour contour =
          make_contour({.blocks = kBlocks, .variant = ContourVariant::tight, .seed = 5, .at = at, .place = place});
      ASSERT_TRUE(contour.alarm_line.has_value());
      const spec::Case c = as_case(contour);
      const judge::ModelRun run = agreed(c);
      ASSERT_FALSE(run.events.empty());
      EXPECT_EQ(run.events.back().number, spec::Name("PS0041"));
      EXPECT_EQ(run.events.back().line, *contour.alarm_line);
      // Each arc that lost vectors before runs as one line.
      std::map<std::uint64_t, bool> is_arc;
      bool arc = false;
      for (const spec::Block& block : blocks(c)) {
        for (const spec::Word& word : block.words())
          if (word.address == 'G' && word.value.digits <= 3) arc = word.value.digits >= 2;
        is_arc[block.line] = arc;
      }
      std::size_t dropped = 0;
      for (const model::Event& e : run.events)
        if (e.kind == spec::EventKind::move && e.cause == spec::Cause::programmed && is_arc[e.line] && !e.arc)
          ++dropped;
      EXPECT_EQ(dropped, contour.dropped);
    }
}

}  // namespace
}  // namespace toolcomp::corpus
