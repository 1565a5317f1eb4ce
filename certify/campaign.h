// SPDX-License-Identifier: Apache-2.0
// Certification: many cases through one controller, and what came of it.
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

// A case, what came of asking for it, and what is said of that.
struct JudgedCase {
  const spec::Case& c;
  const Answer* answer;  // none: the case was not asked
  const CaseResult& result;
};

struct CampaignOptions {
  std::string controller;  // command; empty: the fast engine in this process
  // Makes what is judged instead of the command, which then is its name alone; one for each job.
  std::function<std::unique_ptr<Subject>()> subject;
  std::vector<std::string> sections;  // of the generated cases; empty: every section that is built
  std::vector<CaseInput> cases;       // judged first
  std::uint32_t generated = 1000;     // cases a section (certify/selection.h)
  std::uint64_t seed = 1;
  std::chrono::milliseconds timeout{10'000};  // for one answer
  std::size_t reply_limit = kReplyLimit;      // bytes of one answer
  std::string accepted_resolution;            // of the controller, where it is coarse (expect_fine_resolution)
  spec::KnownSet known;                       // only what rests on clauses known so well is judged
  unsigned jobs = 1;                          // controllers side by side
  std::size_t shrink_runs = 2000;             // executions a finding may take
  SettlingOptions settling;                   // how long and by which clock; who is told
  std::string corpus = "none";                // version of the golden corpus, for the certificate
  std::string corpus_hash;                    // of its manifest
  // Called with the cases done and their number, from one thread at a time.
  std::function<void(std::uint64_t, std::uint64_t)> progress;
  // Called while the generated cases of a section are chosen, with the candidates looked at; from one thread at a time.
  std::function<void(const std::string&, std::uint64_t)> choosing;
  // Called with a finding as soon as it is seen, not yet shrunk, again where a smaller program shows the same, and
  // again where it is settled; from one thread at a time. Until then it has the last requests before it alone.
  std::function<void(const Finding&)> found;
  // Called with every case as it has been judged or passed over, from one thread at a time. Cases that come after the
  // end that `stop` asks for are not among them.
  std::function<void(const JudgedCase&)> judged;
  // Why to come to an end before all is done; empty: go on. Asked before each case and while findings are shrunk.
  std::function<std::string()> stop;
};

// Judges every case; the smallest of those that fail in one section, at one clause and in one kind is a finding. Then
// the findings are put in groups by their cause, and one of each is settled (certify/settling.h). Case k of a section
// is the same for the same seed, however many jobs. A section that the controller answers no more, by hangs or
// faults in a row, is given up, and the certificate says what was not run. Throws spec::InputError for cases no control
// could read, for an unknown section, and for a command that cannot be run.
Certificate certify(const CampaignOptions& options);

}  // namespace toolcomp::certify
