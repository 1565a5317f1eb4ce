// SPDX-License-Identifier: Apache-2.0
// The last move before an alarm of geometry: the block that raises it gave the head, and gives no event.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "judge/oracle/verdict.h"
#include "tests/harness/liar.h"

namespace toolcomp::judge {
namespace {

using Plane = std::array<double, 2>;

// G41, 0.1. A along (3, 4)/5, B back beside it: i of 100 shorter than 100, and 0.01 to the left of A at its end. So the
// head lies some 2000 back along A, and B runs against itself: PS0041.
struct Reversal {
  int x;  // of the end of B, thousandths
  int y;

  explicit Reversal(int i) : x(-60'008 + 600 * i), y(-79'994 + 800 * i) {}
  [[nodiscard]] spec::Case in_a_case() const {
    spec::Case c;
    c.section = "fanuc/cutter-compensation-c";
    c.setup.d[1].geometry = *spec::parse_decimal("0.1");
    const auto decimal = [](int thousandths) { return fmt::format("{:.3f}", thousandths / 1000.0); };
    c.program = "G90 G00 X-3000. Y-4100.\nG41 D1 G01 X-3000. Y-4000. F100\nX0 Y0\nX" + decimal(x) + " Y" + decimal(y) +
                "\nX-100. Y-200.\n";
    return c;
  }
  // Where the two offset lines n · V = 0.1 cross, each normal made of its own block, in doubles.
  [[nodiscard]] Plane head() const {
    const auto left = [](double u, double v) { return Plane{-v / std::hypot(u, v), u / std::hypot(u, v)}; };
    const Plane a = left(3000, 4000);
    const Plane b = left(x / 1000.0, y / 1000.0);
    const double sine = a[0] * b[1] - a[1] * b[0];
    return {0.1 * (b[1] - a[1]) / sine, 0.1 * (a[0] - b[0]) / sine};
  }
};

TEST(HeadsBeforeAlarms, AreJudgedByTheBlockThatPlacedThem) {
  double farthest = 0;
  for (int i = 0; i < 10; ++i) {
    const spec::Case c = Reversal(i).in_a_case();
    const ModelRun run = run_model(c);
    std::vector<fast::Event> events = test::in_doubles(run);
    ASSERT_EQ(events.size(), 4U);
    ASSERT_EQ(events[3].number.view(), "PS0041");
    ASSERT_EQ(events[3].line, 4U);
    const Plane plain = Reversal(i).head();
    EXPECT_NEAR(std::hypot(plain[0], plain[1]), 2000 - 20 * i, 1);
    farthest = std::fmax(farthest, std::hypot(plain[0] - events[2].point[0], plain[1] - events[2].point[1]));
    for (const std::size_t axis : {0U, 1U}) {
      events[2].point.set(axis, plain.at(axis));
      events[2].axes.set(axis, plain.at(axis));
    }
    const Verdict v = judge::judge(c, run, events);
    EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : v.undecided);
    // An ulp of 1 in a normal moves the head by 2 · 2000/1e-4 of it: 32 · 4e7 · 2^-52 = 2.9e-7 along A.
    for (const double by : {1e-6, -1e-6}) {
      std::vector<fast::Event> liar = events;
      liar[2].point.set(0, plain[0] + 0.6 * by);
      liar[2].point.set(1, plain[1] + 0.8 * by);
      EXPECT_EQ(judge::judge(c, run, liar).outcome, Outcome::differs);
    }
  }
  EXPECT_GT(farthest, 1e-10) << "32 ulps of 5000 and 2000 are 4e-11";
}

}  // namespace
}  // namespace toolcomp::judge
