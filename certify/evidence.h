// SPDX-License-Identifier: Apache-2.0
// From a difference to a finding: whether it comes again, what has to be asked before it, and the smallest program.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "certify/finding.h"
#include "certify/judge.h"

namespace toolcomp::certify {

// A difference as it was seen.
struct Witness {
  spec::Case c;
  Judgement judgement;
  std::vector<spec::Event<double>> answer;  // events
  std::vector<spec::Case> before;           // what the same process had been asked before, in order
};

struct EvidenceOptions {
  std::size_t shrink_runs = 2000;             // executions a finding may take
  std::chrono::milliseconds timeout{10'000};  // for one answer
  // Whether to come to an end. What is known by then stays; before it is known how the finding comes, it is as it was
  // seen, tried never.
  std::function<bool()> stop;
};

// Of what never comes again, and of what is not asked again, so many requests before it are kept.
inline constexpr std::size_t kRequestsKept = 50;
// The last of them, `n` at most.
std::vector<spec::Case> last_of(const std::vector<spec::Case>& cases, std::size_t n);

// Whether it is a fault of a controller (FaultKind).
bool is_fault(const FailureKey& key);

// The time-out where a controller may hang again and again.
std::chrono::milliseconds short_patience(const Subject& subject, std::chrono::milliseconds timeout);

// The witness as a finding, without asking again.
Finding as_seen(const Capabilities& capabilities, const Witness& witness);

// Asks again: a fresh process for the case alone, else for all that came before it and then the case. What comes again
// is shrunk, the program and the requests before it, in one process as long as that lives, where nothing has to be
// asked before; a fresh one then confirms it. What does not come again is kept as it was seen. In any case `seen` of
// `tried` says how often it came. A controller that cannot say hello has no capabilities.
Finding make_finding(Subject& subject, const Capabilities& capabilities, const Witness& witness,
                     const EvidenceOptions& options);

// A fresh process, asked what came before and then the case.
Answer ask_fresh(Subject& subject, const std::vector<spec::Case>& before, const spec::Case& c,
                 std::optional<std::chrono::milliseconds> patience = {});

// The answer's events for people and pictures; none if it is no list of events.
std::vector<spec::Event<double>> events_in_double(const Answer& answer);

}  // namespace toolcomp::certify
