// SPDX-License-Identifier: Apache-2.0
// Turns a difference into a finding: whether it can be reproduced, which requests must come before it, and the smallest
// program.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "certify/finding.h"
#include "certify/judge.h"

namespace toolcomp::certify {

struct EvidenceOptions {
  std::size_t shrink_runs = 2000;             // executions a finding may take
  std::chrono::milliseconds timeout{10'000};  // for one answer
  // Whether to stop. What is known by then is kept. If it is not yet known how the finding can be reproduced, the
  // finding stays as it was seen, with no attempts.
  std::function<bool()> stop;
};

// The number of earlier requests that are kept for a finding that is never reproduced, or not tried again.
inline constexpr std::size_t kRequestsKept = 50;
// The last of these requests, at most `n`.
std::vector<spec::Case> last_of(const std::vector<spec::Case>& cases, std::size_t n);

// Whether the failure is a fault of a controller (FaultKind).
bool is_fault(const FailureKey& key);

// The time-out for a controller that may hang repeatedly.
std::chrono::milliseconds short_patience(const Subject& subject, std::chrono::milliseconds timeout);

// The difference of a judged answer as a finding, without trying again. `before`: earlier requests to the same process,
// in order.
Finding as_seen(const Capabilities& capabilities, const spec::Case& c, const Judgement& judgement, const Answer& answer,
                std::vector<spec::Case> before);

// Tries again: asks a fresh process for the case alone, or else for all earlier requests and then the case. If the
// difference is reproduced, the program and the earlier requests are shrunk. If no earlier requests are needed, this
// uses one process as long as it lives, and a fresh process then confirms the result. If the difference is not
// reproduced, it is kept as it was seen. `seen` of `tried` says how often it was reproduced. A controller that does not
// answer hello has no capabilities.
Finding make_finding(Subject& subject, const Finding& seen, const EvidenceOptions& options);

// Asks a fresh process the earlier requests and then the case.
Answer ask_fresh(Subject& subject, const std::vector<spec::Case>& before, const spec::Case& c,
                 std::optional<std::chrono::milliseconds> patience = {});

}  // namespace toolcomp::certify
