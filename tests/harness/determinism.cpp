// SPDX-License-Identifier: Apache-2.0
// No hidden state: the same input gives the same result alone, in a batch, and in another order.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/features.h"
#include "fuzz/campaign/summary.h"
#include "fuzz/gen/encode.h"
#include "fuzz/oracle/number.h"
#include "fuzz/oracle/trial.h"
#include "tests/effort.h"

namespace toolcomp::fuzz {
namespace {

// Everything a trial shows, bit for bit.
std::string digest(const spec::Case& c) {
  const Trial t = try_case(c);
  std::string text =
      fmt::format("{} {} {} {} {} {:a} {:a}\n", static_cast<int>(t.acceptance), static_cast<int>(t.verdict.outcome),
                  t.verdict.values, t.verdict.decisions, t.verdict.near_ties, t.verdict.worst_ulp, t.verdict.worst_um);
  if (t.verdict.difference) text += explain(*t.verdict.difference) + '\n';
  for (const model::Event& e : t.run.events)
    for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
      if (e.point.has(i)) text += e.point[i].decimal(20) + ' ';
  for (const std::uint32_t feature : features(t.run.recorder)) text += fmt::format("{} ", feature);
  if (t.acceptance != Acceptance::accepted) return text;
  for (const fast::Event& e : run_fast(c))
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

TEST(Determinism, TheSameSeedIsTheSameCampaign) {
  CampaignOptions options;
  options.modes = {Mode::directed, Mode::unrestricted};
  options.runs = test::random_cases(1500);
  const auto text = [&] {
    CampaignResult r = run_campaign(options);
    r.seconds = r.per_second_per_core = 0;
    std::string all = write_summary(r);
    for (const Finding& f : r.findings) all += encode(f.input) + explain(f.difference);
    return all;
  };
  const std::string first = text();
  EXPECT_EQ(text(), first);
  options.seed = 2;
  EXPECT_NE(text(), first);
}

TEST(Determinism, JobsShareTheRuns) {
  CampaignOptions options;
  options.runs = 301;
  options.jobs = 3;
  const CampaignResult r = run_campaign(options);
  EXPECT_EQ(r.executions, 301U);
  EXPECT_EQ(r.cores, 3);
  std::uint64_t sum = 0;
  for (const std::uint64_t n : r.acceptance) sum += n;
  EXPECT_EQ(sum, r.executions) << "an execution was thrown away uncounted";
}

TEST(Determinism, ASummaryIsReadBack) {
  CampaignOptions options;
  options.runs = 200;
  const CampaignResult r = run_campaign(options);
  EXPECT_EQ(write_summary(read_summary(write_summary(r))), write_summary(r));
}

}  // namespace
}  // namespace toolcomp::fuzz
