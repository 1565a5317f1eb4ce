// SPDX-License-Identifier: Apache-2.0
#include "fuzz/campaign/floors.h"

#include <fmt/format.h>

#include <algorithm>

#include "fuzz/faults/faults.h"
#include "judge/oracle/policy.h"

namespace toolcomp::fuzz {

std::vector<std::string> shortfalls(const Target& target, const Counters& result) {
  std::vector<std::string> all;
  if (result.executions == 0) return {"not run"};
  if (target.is_reader()) return all;
  if (result.values == 0) all.emplace_back("no value judged");
  const std::uint64_t open = result.count(judge::Acceptance::not_decided);
  if (open > 0) all.push_back(fmt::format("{} executions that could not be decided", open));
  if (result.executions < kEnoughToJudge) return all;
  const std::uint64_t given = result.values + result.wide;
  if (static_cast<double>(result.wide) > judge::policy::kMostWide * static_cast<double>(given))
    all.push_back(fmt::format("judged share {:.1f} %, at least {:.0f} % required",
                              100 * static_cast<double>(result.values) / static_cast<double>(given),
                              100 * (1 - judge::policy::kMostWide)));
  const double floor = target.mode == Mode::directed ? kDirectedFloor : kUnrestrictedFloor;
  if (result.accepted_share() < floor)
    all.push_back(
        fmt::format("acceptance {:.1f} %, at least {:.0f} % required", 100 * result.accepted_share(), 100 * floor));
  const double laws =
      static_cast<double>(result.law_checks) / static_cast<double>(std::max<std::uint64_t>(1, result.acceptance[0]));
  if (target.mode == Mode::directed && laws < kLawFloor)
    all.push_back(
        fmt::format("{:.2f} law checks for each accepted execution, at least {:.0f} required", laws, kLawFloor));
  return all;
}

FaultsWithin faults_within(std::string_view section, std::uint64_t directed_executions) {
  FaultsWithin faults;
  for (const SeededFault& fault : seeded_faults()) {
    if (fault.section != section) continue;
    ++faults.all;
    if (fault.budget <= directed_executions) ++faults.within;
    faults.largest = std::max(faults.largest, fault.budget);
  }
  return faults;
}

}  // namespace toolcomp::fuzz
