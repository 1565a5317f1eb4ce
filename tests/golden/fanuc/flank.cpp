// SPDX-License-Identifier: Apache-2.0
// Long five-axis programs: the same bytes everywhere, on the flank that the formula describes, and both engines agree
// on them.
#include "corpus/flank.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/sha256.h"
#include "judge/oracle/verdict.h"
#include "model/basis/number.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/setup_format.h"

namespace toolcomp::corpus {
namespace {

constexpr std::size_t kBlocks = 400;

spec::Case as_case(const Flank& flank) {
  spec::Case c;
  c.section = "fanuc/tool-side-compensation";
  c.setup = spec::read_setup_toml(flank.setup, "flank.toml");
  c.program = flank.program;
  return c;
}

// The positions of the flank's own blocks, those without a G code, pass by pass.
using Position = std::map<char, double>;
std::vector<std::vector<Position>> passes(const spec::Case& c) {
  std::vector<std::vector<Position>> result;
  spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes);
  for (spec::Block block; reader.next(block);) {
    Position p;
    bool code = false;
    bool starts = false;
    for (const spec::Word& word : block.words()) {
      if (word.address == 'G') {
        code = true;
        starts = starts || word.value.digits == 412 || word.value.digits == 422 || word.value.digits == 416 ||
                 word.value.digits == 426;
      } else {
        p[word.address] = model::plain(word.value).to_double();
      }
    }
    if (starts) result.emplace_back();
    if (!code && !p.empty() && !result.empty() && p.contains('X')) result.back().push_back(p);
  }
  return result;
}

TEST(Flank, TheSameBytesOnEveryCompiler) {
  EXPECT_EQ(host::sha256(make_flank({.blocks = 500}).program),
            "26ce415db503382b23304209ff562279b451cb269b273e63c5560ccbd91359df");
  EXPECT_EQ(host::sha256(make_flank({.blocks = 500, .tool = FlankTool::vector}).program),
            "767c1d291996041ae026b09a86f5ec751036791ac111bbf7e5bee4b9cc45e138");
}

double degrees(double angle) { return angle * std::numbers::pi / 180; }

// The formula of the header in double: every number of the program is it, rounded.
TEST(Flank, LiesOnTheFormula) {
  constexpr double kHalfACount = 0.5000001e-4;
  const Flank flank = make_flank({.blocks = kBlocks});
  ASSERT_EQ(flank.passes, 2U);
  const std::vector<std::vector<Position>> all = passes(as_case(flank));
  ASSERT_EQ(all.size(), 2U);
  for (std::size_t pass = 0; pass < 2; ++pass) {
    ASSERT_EQ(all[pass].size(), kBlocks / 2);
    const double height = pass == 0 ? 24 : 2;
    for (std::size_t j = 1; j <= all[pass].size(); ++j) {
      const Position& p = all[pass][j - 1];
      const double along = static_cast<double>(j) / static_cast<double>(all[pass].size());
      const double u = pass == 0 ? along : 1 - along;
      EXPECT_NEAR(p.at('B'), 68 - 44 * u + 6 * std::sin(degrees(360 * u)), kHalfACount);
      EXPECT_NEAR(p.at('C'), 55 * u + 12 * std::cos(degrees(180 * u)), kHalfACount);
      const double r = 80 - 50 * std::cos(degrees(90 * u));
      const double sin_b = std::sin(degrees(p.at('B')));
      EXPECT_NEAR(p.at('X'), r * std::cos(degrees(55 * u)) + height * sin_b * std::cos(degrees(p.at('C'))),
                  kHalfACount);
      EXPECT_NEAR(p.at('Y'), r * std::sin(degrees(55 * u)) + height * sin_b * std::sin(degrees(p.at('C'))),
                  kHalfACount);
      EXPECT_NEAR(p.at('Z'), 50 - 50 * std::sin(degrees(90 * u)) + height * std::cos(degrees(p.at('B'))), kHalfACount);
    }
  }
}

// The vectors are those of the angles, and angles (directions) change in every block.
TEST(Flank, TheToolTurnsInEveryBlock) {
  const auto angles = passes(as_case(make_flank({.blocks = kBlocks})));
  const auto vectors = passes(as_case(make_flank({.blocks = kBlocks, .tool = FlankTool::vector})));
  ASSERT_EQ(angles.size(), vectors.size());
  for (std::size_t pass = 0; pass < angles.size(); ++pass) {
    ASSERT_EQ(angles[pass].size(), vectors[pass].size());
    for (std::size_t j = 0; j < angles[pass].size(); ++j) {
      const Position& p = angles[pass][j];
      const Position& v = vectors[pass][j];
      EXPECT_NEAR(v.at('I'), std::sin(degrees(p.at('B'))) * std::cos(degrees(p.at('C'))), 0.51e-6);
      EXPECT_NEAR(v.at('J'), std::sin(degrees(p.at('B'))) * std::sin(degrees(p.at('C'))), 0.51e-6);
      EXPECT_NEAR(v.at('K'), std::cos(degrees(p.at('B'))), 0.51e-6);
      if (j == 0) continue;
      EXPECT_NE(p.at('B'), angles[pass][j - 1].at('B'));
      EXPECT_NE(p.at('C'), angles[pass][j - 1].at('C'));
    }
  }
}

// Both engines run to the end and agree; on the flank the tool's centre line stays at its radius from the programmed
// line of each block: |V|^2 >= 25 with V at right angles to the tool, and hardly more on so smooth a path.
TEST(Flank, BothEnginesRunItToItsEnd) {
  for (const FlankTool tool : {FlankTool::rotary, FlankTool::vector}) {
    const spec::Case c = as_case(make_flank({.blocks = kBlocks, .tool = tool}));
    const judge::ModelRun run = judge::run_model(c);
    const std::vector<fast::Event> events = judge::run_fast(c);
    const judge::Verdict verdict = judge::judge(c, run, events);
    EXPECT_EQ(verdict.outcome, judge::Outcome::agrees)
        << (verdict.difference ? judge::explain(*verdict.difference) : verdict.undecided);
    ASSERT_FALSE(run.events.empty());
    EXPECT_EQ(run.events.back().kind, spec::EventKind::move);
    EXPECT_GT(run.events.size(), kBlocks);
    std::size_t beside = 0;
    for (const fast::Event& e : events) {
      double length2 = 0;
      double along = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double v = e.point[i] - e.programmed[i];
        length2 += v * v;
        along += v * (*e.tool_axis)[i];
      }
      if (length2 == 0) continue;
      EXPECT_NEAR(along, 0, 1e-12) << "line " << e.line;
      EXPECT_GT(length2, 25 - 1e-10) << "line " << e.line;
      EXPECT_LT(length2, 25.01) << "line " << e.line;
      ++beside;
    }
    EXPECT_GE(beside, kBlocks);
  }
}

TEST(Flank, RefusesTooFewOrTooManyBlocks) {
  EXPECT_THROW(make_flank({.blocks = kLeastFlank - 1}), std::invalid_argument);
  EXPECT_THROW(make_flank({.blocks = kMostFlank + 1}), std::invalid_argument);
}

}  // namespace
}  // namespace toolcomp::corpus
