// SPDX-License-Identifier: Apache-2.0
// A finding: the smallest case that shows a difference, with everything needed to judge it again.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/judge.h"
#include "spec/language/case.h"

namespace toolcomp::certify {

struct Finding {
  spec::Case smallest;     // as shrunk
  FailureKey key;          // its section is that of the case
  std::uint64_t line = 0;  // of the program, where they part
  std::string field;       // "point.X"
  std::string expected;    // for people
  std::string actual;
  double deviation_um = 0;         // linear coordinates
  std::string status;              // with a fault: how the controller's process ended
  std::string errors;              // the last of its standard error
  std::string controller;          // the command; empty: the built-in fast engine; or kFormalSpecification
  std::string directory;           // where it was run
  Capabilities subject;            // what it said of itself; without a name: it could not be asked
  std::string seed;                // of the campaign
  std::string target;              // of a campaign: which of its targets
  std::uint64_t executions = 0;    // of the worker that found it, this one included; 0: not known
  double seconds = 0;              // since that worker began
  std::string tool;                // name and version of what found it
  std::string first_case;          // id of the case it was shrunk from
  std::uint64_t occurrences = 1;   // cases with the same key
  std::vector<spec::Case> before;  // what the same process has to be asked before, in order
  std::uint64_t seen = 1;          // so many times, of so many tries
  std::uint64_t tried = 1;
  std::string not_settled;  // why it is as it was seen: neither tried again nor shrunk; empty: it was
  std::size_t runs = 0;     // executions that shrinking took
  bool complete = true;     // nothing simpler fails in the same way
  std::string alone;  // who stands alone among model, engine and formal specification (voices.h); empty: not asked

  // For the report's picture, not written to the file.
  std::vector<spec::Event<double>> expected_events;
  std::vector<spec::Event<double>> actual_events;
  std::optional<std::size_t> event;  // index of the first difference
};

// {"finding":1, "case":{…}, "kind":…, "clause":…, …}: one JSON object a file, with a line feed at its end.
std::string write_finding(const Finding& finding);
// Reads a finding, or a bare case as a finding without a kind. Throws spec::InputError; unknown keys are errors.
Finding read_finding(std::string_view text, const std::string& file);

// How its clause is known, before it accuses anybody: "manual: A-78438E, page 23"; empty: it rests on no clause.
std::string how_known(const Finding& finding);

// With what it was found by: this build, in this folder, with that command and seed.
Finding signed_finding(Finding finding, const std::string& controller, std::uint64_t seed);

// The command run in a folder; in this one, if that is empty.
std::string command_in(const std::string& directory, const std::string& command);

// The subject a command names: a controller, or the built-in engine if it is empty.
inline constexpr std::size_t kReplyLimit = std::size_t{64} << 20;  // bytes
std::unique_ptr<Subject> subject_of(const std::string& controller, std::chrono::milliseconds timeout,
                                    std::size_t reply_limit = kReplyLimit);

// The same for the controller that a finding names, where this may be the formal specification in this process: throws
// spec::InputError where there is none.
inline constexpr const char* kFormalSpecification = "spec";
std::unique_ptr<Subject> subject_of_finding(const std::string& controller, std::chrono::milliseconds timeout);

// Exit status of one judged case: 0 agrees, 1 differs, 3 anything that is no verdict.
int exit_status(Result result);

}  // namespace toolcomp::certify
