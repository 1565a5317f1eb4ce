// SPDX-License-Identifier: Apache-2.0
// Groups differences by their cause, and settles one finding of each group: whether it can be reproduced, after which
// requests, and the smallest program that shows it.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "certify/causes/shared_cause.h"
#include "certify/finding.h"

namespace toolcomp::certify {

// A difference as it was seen, and the function that settles it until `stop` says to end (make_finding). If it was
// never tried, it is as it was seen, with all earlier requests.
struct Sighting {
  Finding finding;
  std::function<Finding(const std::function<bool()>& stop)> settle;
};

// Given to the caller when the settling of a group begins, and before each attempt.
struct SettlingGroup {
  std::size_t number = 0;  // from 1
  std::size_t groups = 0;
  const SharedCause& cause;
};

struct SettlingOptions {
  std::chrono::milliseconds budget{30'000};  // for all groups; 0: none is settled. A started attempt is finished.
  std::function<std::chrono::steady_clock::time_point()> clock = [] { return std::chrono::steady_clock::now(); };
  std::function<std::string()> stop;  // returns why to stop, or an empty text to go on
  std::function<void(const SettlingGroup&)> told;
  std::function<void(const Finding&)> settled;
};

struct Settled {
  std::vector<Finding> findings;    // group by group, the settled finding first
  std::vector<SharedCause> causes;  // the groups, by the number of cases; each finding is in one of them
};

// Settles the groups in order, each in an equal share of the time that is left. In a group, the finding with the
// smallest program is settled. For every other finding `not_settled` says why it was not.
Settled settle(std::vector<Sighting> sightings, const SettlingOptions& options);

}  // namespace toolcomp::certify
