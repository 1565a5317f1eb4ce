// SPDX-License-Identifier: Apache-2.0
// Finishing programs of LN blocks: the same bytes everywhere, on the surface that the formula describes, and both
// engines agree on them.
#include "corpus/freeform.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/sha256.h"
#include "judge/oracle/verdict.h"
#include "spec/language/setup_format.h"

namespace toolcomp::corpus {
namespace {

constexpr std::size_t kBlocks = 450;  // 15 passes of 30 points

spec::Case as_case(const Freeform& freeform) {
  spec::Case c;
  c.section = "heidenhain/face-milling";
  c.setup = spec::read_setup_toml(freeform.setup, "freeform.toml");
  c.dialect = "klartext";
  c.program = freeform.program;
  return c;
}

// The words of the LN blocks, as they stand in the text.
using Words = std::map<std::string, double>;
std::vector<Words> blocks(const std::string& program) {
  std::vector<Words> list;
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(" LN ") == std::string::npos) continue;
    std::istringstream in(line.substr(line.find(" LN ") + 4));
    Words words;
    for (std::string word; in >> word;) {
      const std::size_t key = word.find_first_of("+-");
      if (key != std::string::npos) words[word.substr(0, key)] = std::stod(word.substr(key));
    }
    list.push_back(words);
  }
  return list;
}

double height(double x, double y) {
  const double u = x / 60;
  const double v = y / 40;
  return 20 - 24 * u * u - 14 * v * v + 10 * u * u * u + 12 * u * v * v;
}

TEST(Freeform, TheSameBytesOnEveryCompiler) {
  EXPECT_EQ(host::sha256(make_freeform({.blocks = 500}).program),
            "4c702fe9b68dce6feb92dcd760073823865d06c34c025d8e3e13c78f28b8f17c");
  EXPECT_EQ(host::sha256(make_freeform({.blocks = 500, .tool_vector = false}).program),
            "bb36955233b14262004058e008437879284825d295bcac87837acb429643ccc3");
}

// The header's formulas in double: every number of the program is theirs, rounded.
TEST(Freeform, LiesOnTheFormula) {
  constexpr std::size_t kPasses = 15;
  constexpr std::size_t kPoints = 30;
  const Freeform freeform = make_freeform({.blocks = kBlocks});
  ASSERT_EQ(freeform.passes, kPasses);
  const std::vector<Words> all = blocks(freeform.program);
  ASSERT_EQ(all.size(), kBlocks);
  for (std::size_t i = 0; i < kBlocks; ++i) {
    const std::size_t pass = i / kPoints;
    const double along = 2 * static_cast<double>(i % kPoints) / (kPoints - 1) - 1;
    const double u = pass % 2 == 0 ? along : -along;
    const double v = 2 * static_cast<double>(pass) / (kPasses - 1) - 1;
    const double slope_x = (-48 * u + 30 * u * u + 12 * v * v) / 60;
    const double slope_y = (-28 * v + 24 * u * v) / 40;
    const double of_normal = std::hypot(slope_x, slope_y, 1.0);
    const std::array<double, 3> n{-slope_x / of_normal, -slope_y / of_normal, 1 / of_normal};
    const double lean_x = 0.1 - slope_x / 2;
    const double lean_y = 0.05 - slope_y / 2;
    const double of_tool = std::hypot(lean_x, lean_y, 1.0);
    const std::array<double, 3> t{lean_x / of_tool, lean_y / of_tool, 1 / of_tool};
    const std::array<double, 3> q{60 * u, 40 * v, height(60 * u, 40 * v)};
    for (std::size_t k = 0; k < 3; ++k) {
      const char letter = "XYZ"[k];
      EXPECT_NEAR(all[i].at(std::string(1, letter)), q.at(k) + 5 * (n.at(k) - t.at(k)), 0.5000001e-4);
      EXPECT_NEAR(all[i].at(std::string("N") + letter), n.at(k), 0.5000001e-7);
      EXPECT_NEAR(all[i].at(std::string("T") + letter), t.at(k), 0.5000001e-7);
    }
  }
}

// Both engines run to the end without a warning and agree. The effective ball, 4.95, touches the surface where the
// nominal one does: contact and centre of each block lie on it and above it, but for the four decimals of the program.
TEST(Freeform, BothEnginesTouchTheSurface) {
  constexpr double kRounding = 2e-4;
  for (const bool tool_vector : {true, false}) {
    const spec::Case c = as_case(make_freeform({.blocks = kBlocks, .tool_vector = tool_vector}));
    const judge::ModelRun run = judge::run_model(c);
    const std::vector<fast::Event> events = judge::run_fast(c);
    const judge::Verdict verdict = judge::judge(c, run, events);
    EXPECT_EQ(verdict.outcome, judge::Outcome::agrees)
        << (verdict.difference ? judge::explain(*verdict.difference) : verdict.undecided);
    std::size_t touching = 0;
    for (const fast::Event& event : events) {
      ASSERT_EQ(event.kind, spec::EventKind::move) << "line " << event.line;
      if (!event.space || !event.space->contact) continue;
      ++touching;
      const std::array<double, 3>& q = event.space->contact->point;
      EXPECT_NEAR(q[2], height(q[0], q[1]), kRounding) << "line " << event.line;
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(event.space->tool_center.at(k), q.at(k) + 4.95 * event.space->contact->normal.at(k), 1e-12);
    }
    EXPECT_EQ(touching, kBlocks);
    EXPECT_EQ(events.size(), kBlocks + 3);
  }
}

TEST(Freeform, RefusesTooFewOrTooManyBlocks) {
  EXPECT_THROW(make_freeform({.blocks = kLeastFreeform - 1}), std::invalid_argument);
  EXPECT_THROW(make_freeform({.blocks = kMostFreeform + 1}), std::invalid_argument);
}

}  // namespace
}  // namespace toolcomp::corpus
