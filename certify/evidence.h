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
  std::function<bool()> stop;                 // whether to come to an end: then it stays as it was seen
};

// Whether it is a fault of a controller (FaultKind).
bool is_fault(const FailureKey& key);

// The time-out where a controller may hang again and again.
std::chrono::milliseconds short_patience(const Subject& subject, std::chrono::milliseconds timeout);

// The witness as a finding, without asking again.
Finding as_seen(const Capabilities& capabilities, const Witness& witness);

// Asks fresh processes again: for the case alone, else behind all that came before it. What comes again is shrunk, the
// program and the requests before it; what does not is kept as it was seen. In any case `seen` of `tried` says how
// often it came. A controller that cannot say hello has no capabilities.
Finding make_finding(Subject& subject, const Capabilities& capabilities, const Witness& witness,
                     const EvidenceOptions& options);

// A fresh process, asked what came before and then the case.
Answer ask_fresh(Subject& subject, const std::vector<spec::Case>& before, const spec::Case& c,
                 std::optional<std::chrono::milliseconds> patience = {});

// The answer's events for people and pictures; none if it is no list of events.
std::vector<spec::Event<double>> events_in_double(const Answer& answer);

}  // namespace toolcomp::certify
