// SPDX-License-Identifier: Apache-2.0
// A finding: the smallest case that shows a difference, with everything needed to judge it again.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "certify/judge.h"
#include "spec/language/case.h"

namespace toolcomp::certify {

struct Finding {
  spec::Case smallest;             // as shrunk
  FailureKey key;                  // its section is that of the case
  judge::Difference difference;    // of a file: without its event, and its clause only if this build has it
  std::string status;              // with a fault: how the controller's process ended
  std::string errors;              // last lines of its standard error
  std::string controller;          // the command; empty: the built-in fast engine; or kFormalSpecification
  std::string directory;           // folder in which it was run
  Capabilities subject;            // what it announced; without a name if it could not be asked
  std::string seed;                // of the certification or campaign
  std::string target;              // the fuzz target, if a campaign found it
  std::uint64_t executions = 0;    // executions of the worker up to and including this one; 0: not known
  double seconds = 0;              // since the start of that worker
  std::string tool;                // name and version of the program that found it
  std::string first_case;          // id of the case it was shrunk from
  std::uint64_t occurrences = 1;   // cases with the same key
  std::vector<spec::Case> before;  // requests that the same process must get before this case, in order
  std::uint64_t seen = 1;          // number of attempts that reproduced it, of `tried`
  std::uint64_t tried = 1;
  std::string not_settled;  // why it was neither tried again nor shrunk; otherwise empty
  std::size_t runs = 0;     // executions used for shrinking
  bool complete = true;     // nothing simpler fails in the same way
  std::string alone;        // which of model, engine and formal specification stands alone (voices.h); empty: not asked
  std::vector<spec::Event<double>> actual_events;  // for the picture in the report; not written to the file
};

// {"finding":1, "case":{…}, "kind":…, "clause":…, …}: one JSON object in a file, with a line feed at its end.
std::string write_finding(const Finding& finding);
// Reads a finding, or a bare case as a finding without a kind. Throws spec::InputError; unknown keys are errors.
Finding read_finding(std::string_view text, const std::string& file);

// How well its clause is known, which a report says first: "manual: A-78438E, page 23"; empty if it rests on no clause.
std::string how_known(const Finding& finding);

// Adds how it was found: by this build, in this folder, with this command and seed.
Finding signed_finding(Finding finding, const std::string& controller, std::uint64_t seed);

// The shell command that runs a command in a folder; in the current folder, if it is empty.
std::string command_in(const std::string& directory, const std::string& command);

// The subject a command names: a controller, or the built-in engine if it is empty.
inline constexpr std::size_t kReplyLimit = std::size_t{64} << 20;  // bytes
std::unique_ptr<Subject> subject_of(const std::string& controller, std::chrono::milliseconds timeout,
                                    std::size_t reply_limit = kReplyLimit);

// The same for the controller that a finding names, where this may be the formal specification in this process: throws
// spec::InputError if there is none.
inline constexpr const char* kFormalSpecification = "spec";
std::unique_ptr<Subject> subject_of_finding(const std::string& controller, std::chrono::milliseconds timeout);

// Exit status of one judged case: 0 agrees, 1 differs, 3 no verdict.
int exit_status(Result result);

}  // namespace toolcomp::certify
