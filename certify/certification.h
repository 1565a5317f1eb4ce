// SPDX-License-Identifier: Apache-2.0
// Certification: runs many cases through one controller, and collects the results.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "certify/case_result.h"
#include "certify/certificate.h"
#include "certify/settling.h"
#include "certify/subject.h"
#include "spec/language/case.h"

namespace toolcomp::certify {

struct CaseInput {
  spec::Case c;
  Origin origin = Origin::own;
};

// A case, the answer to it, and the judgement of the answer.
struct JudgedCase {
  const spec::Case& c;
  const Answer* answer;  // nullptr if the case was not asked
  const CaseResult& result;
};

struct CertificationOptions {
  std::string controller;  // command; empty: the fast engine in this process
  // Makes the subject that is judged instead of the command, one for each job. The command is then only its name.
  std::function<std::unique_ptr<Subject>()> subject;
  std::vector<std::string> sections;  // of the generated cases; empty: every section
  std::vector<CaseInput> cases;       // judged first
  std::uint32_t generated = 1000;     // cases in each section (certify/selection.h)
  std::uint64_t seed = 1;
  std::chrono::milliseconds timeout{10'000};  // for one answer
  std::size_t reply_limit = kReplyLimit;      // bytes of one answer
  std::string accepted_resolution;            // of a controller with coarse numbers (expect_fine_resolution)
  spec::KnownSet known;                       // only events that rest on clauses of these kinds are judged
  unsigned jobs = 1;                          // number of controllers that run at the same time
  std::size_t shrink_runs = 2000;             // largest number of executions to shrink a finding
  SettlingOptions settling;                   // time and clock; who is informed
  std::string corpus = "none";                // version of the golden corpus, for the certificate
  std::string corpus_hash;                    // of its manifest
  // Called with the cases done and their number, from one thread at a time.
  std::function<void(std::uint64_t, std::uint64_t)> progress;
  // Called while the generated cases of a section are chosen, with the number of candidates examined; from one thread
  // at a time.
  std::function<void(const std::string&, std::uint64_t)> choosing;
  // Called with a finding as soon as it is seen and not yet shrunk, again if a smaller program shows the same, and
  // again when it is settled; from one thread at a time. Before it is settled it has only the last requests before it.
  std::function<void(const Finding&)> found;
  // Called with every case when it has been judged or skipped, from one thread at a time. It is not called for cases
  // after the end that `stop` asks for.
  std::function<void(const JudgedCase&)> judged;
  // Returns why to stop early, or an empty text to go on. Asked before each case and while findings are shrunk.
  std::function<std::string()> stop;
};

// Judges every case. Of the cases that fail in one section, at one clause and in one kind, the smallest is a finding.
// Then the findings are grouped by their cause, and one of each group is settled (certify/settling.h). Case k of a
// section is the same for the same seed, whatever the number of jobs. If the controller no longer answers in a section,
// by hangs or faults in a row, the section is given up, and the certificate says what was not run. Throws
// spec::InputError for cases no control could read, for an unknown section, and for a command that cannot be run.
Certificate certify(const CertificationOptions& options);

}  // namespace toolcomp::certify
