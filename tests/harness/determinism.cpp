// SPDX-License-Identifier: Apache-2.0
// No hidden state: the same input gives the same result alone, in a batch, and in another order.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fuzz/campaign/driver.h"
#include "fuzz/campaign/features.h"
#include "fuzz/gen/encode.h"
#include "judge/oracle/number.h"
#include "judge/oracle/trial.h"
#include "tests/effort.h"

namespace toolcomp::fuzz {
namespace {

// Everything a trial shows, bit for bit.
std::string digest(const spec::Case& c) {
  const judge::Trial t = judge::try_case(c);
  std::string text =
      fmt::format("{} {} {} {} {} {:a} {:a}\n", static_cast<int>(t.acceptance), static_cast<int>(t.verdict.outcome),
                  t.verdict.values, t.verdict.decisions, t.verdict.near_ties, t.verdict.worst_ulp, t.verdict.worst_um);
  if (t.verdict.difference) text += explain(*t.verdict.difference) + '\n';
  for (const model::Event& e : t.run.events)
    for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
      if (e.point.has(i)) text += e.point[i].decimal(20) + ' ';
  for (const std::uint32_t feature : features(t.run.recorder)) text += fmt::format("{} ", feature);
  if (t.acceptance != judge::Acceptance::accepted) return text;
  for (const fast::Event& e : judge::run_fast(c))
    for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
      if (e.axes.has(i)) text += fmt::format("{:a} ", e.axes[i]);
  return text;
}

TEST(Determinism, ACaseAloneIsTheSameCaseInABatch) {
  std::vector<spec::Case> cases;
  for (std::uint64_t seed = 0; seed < test::random_cases(150); ++seed)
    for (const std::string_view section : sections())
      for (const Mode mode : {Mode::directed, Mode::unrestricted}) {
        SeededSource source(seed);
        cases.push_back(generate(section, mode, source));
      }
  std::vector<std::string> first;
  for (const spec::Case& c : cases) first.push_back(digest(c));
  for (std::size_t i = cases.size(); i-- > 0;) ASSERT_EQ(digest(cases[i]), first[i]) << encode(cases[i]);
}

TEST(Determinism, TheSameSeedIsTheSameSearch) {
  const auto text = [](std::uint64_t seed) {
    std::string all;
    for (const std::string_view section : sections())
      for (const Mode mode : {Mode::directed, Mode::unrestricted}) {
        DriverOptions options;
        options.section = section;
        options.mode = mode;
        options.seed = seed;
        options.on_input = [&all](const spec::Case& c) { all += encode(c); };
        Driver driver(options);
        for (std::uint64_t i = 0; i < test::random_cases(60); ++i) driver.step(i);
        all += write_counters(driver.result());
      }
    return all;
  };
  const std::string first = text(1);
  EXPECT_EQ(text(1), first);
  EXPECT_NE(text(2), first);
}

TEST(Determinism, EveryExecutionIsCountedAndReadBack) {
  DriverOptions options;
  options.section = "fanuc/tool-offset";
  options.mode = Mode::unrestricted;
  Driver driver(options);
  for (std::uint64_t i = 0; i < 200; ++i) driver.step(i);
  const Counters& counters = driver.result();
  EXPECT_EQ(counters.executions, 200U);
  std::uint64_t sum = 0;
  for (const std::uint64_t n : counters.acceptance) sum += n;
  EXPECT_EQ(sum, counters.executions) << "an execution was thrown away uncounted";
  EXPECT_EQ(write_counters(read_counters(write_counters(counters))), write_counters(counters));
}

}  // namespace
}  // namespace toolcomp::fuzz
