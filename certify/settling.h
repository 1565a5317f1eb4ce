// SPDX-License-Identifier: Apache-2.0
// What was seen, put in groups by its cause, and one finding of each group settled: whether it comes again, behind
// which requests, and the smallest program that shows it.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "certify/causes/shared_cause.h"
#include "certify/finding.h"

namespace toolcomp::certify {

// A difference as it was seen, and how it is settled until `stop` says to end (make_finding): tried never, it is as it
// was seen, with all the requests before it.
struct Sighting {
  Finding finding;
  std::function<Finding(const std::function<bool()>& stop)> settle;
};

// Called when a group begins to be settled, and before each try.
struct SettlingGroup {
  std::size_t number = 0;  // from 1
  std::size_t groups = 0;
  const SharedCause& cause;
};

struct SettlingOptions {
  std::chrono::milliseconds budget{30'000};  // for all groups; 0: none is settled. What is begun is finished.
  std::function<std::chrono::steady_clock::time_point()> clock = [] { return std::chrono::steady_clock::now(); };
  std::function<std::string()> stop;  // why to come to an end; empty: go on
  std::function<void(const SettlingGroup&)> told;
  std::function<void(const Finding&)> settled;
};

struct Settled {
  std::vector<Finding> findings;    // group by group, the one that was settled first
  std::vector<SharedCause> causes;  // the groups, by the number of cases; each finding is in one of them
};

// Groups are settled in their order, each in an equal share of the time that is left. Of a group it is the finding with
// the smallest program. `not_settled` says of every other one why it is as it was seen.
Settled settle(std::vector<Sighting> sightings, const SettlingOptions& options);

}  // namespace toolcomp::certify
