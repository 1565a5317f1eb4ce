// SPDX-License-Identifier: Apache-2.0
// The result of a certification, for reports.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/capabilities.h"
#include "certify/causes/shared_cause.h"
#include "certify/finding.h"
#include "certify/judge.h"
#include "certify/occasion.h"
#include "model/basis/recorder.h"
#include "spec/language/known.h"

namespace toolcomp::certify {

// Where a case came from.
enum class Origin : std::uint8_t { golden, generated, own };

// The sums of one section. Lengths in micrometres.
struct SectionResult {
  std::string section;                                // empty: programs of the user's own
  std::array<std::uint64_t, 3> cases{};               // by origin
  std::array<std::uint64_t, kResultCount> results{};  // by Result
  std::uint64_t values = 0;                           // judged
  std::uint64_t decisions = 0;                        // of the model, by sign
  std::uint64_t near_ties = 0;                        // decisions inside their band
  std::uint64_t ties = 0;                             // near ties at which the other, permitted outcome was taken
  std::uint64_t wide = 0;                             // values that were granted more than policy::kCap: not judged
  std::uint64_t cut_cases = 0;                        // judged only up to a block that is not supported or not judged
  std::uint64_t cut_programs = 0;                     // of these, the user's own programs
  std::uint64_t wide_cases = 0;    // cases in which more than policy::kMostWide of the values are wide
  std::uint64_t out_of_scope = 0;  // events after an event with the reason OUT_OF_SCOPE
  std::uint64_t events = 0;        // events of the model that were judged
  std::uint64_t left_out = 0;      // events that were left out because of Capabilities::known
  std::map<spec::Clause, std::uint64_t> left_out_for;  // how many of these rest on each clause
  std::uint64_t few_events = 0;                        // cases with a verdict and fewer than three events judged
  // Cases that do not apply because the controller does them otherwise by design, as it says, by the name of the
  // difference.
  std::map<std::string, std::uint64_t> known_differences;
  judge::Widths widths;  // that were granted
  double worst_ulp = 0;  // in the units that the policy multiplies by k
  double worst_um = 0;
  judge::Bias bias;  // of rounded lengths

  [[nodiscard]] std::uint64_t count(Result result) const { return results[static_cast<std::size_t>(result)]; }
  [[nodiscard]] std::uint64_t count(Origin origin) const { return cases[static_cast<std::size_t>(origin)]; }
  // Whether nothing was judged, only because of Capabilities::known.
  [[nodiscard]] bool is_left_out() const { return values == 0 && left_out > 0; }
  [[nodiscard]] std::uint64_t total() const { return cases[0] + cases[1] + cases[2]; }
};

// A case without a verdict, and the reason.
struct Unsettled {
  std::string id;
  std::string section;
  Result result{};
  std::string why;
};

// The exact path of one of the user's own programs.
struct Picture {
  std::string id;
  std::string html;  // view/view.h
};

// Everything that the certificate depends on, so that it can be made again. Hashes are SHA-256 in hexadecimal.
struct Identity {
  std::string tool;          // name and version
  std::string tool_hash;     // of the running executable; empty if it cannot be read
  std::string clause_hash;   // of all clauses with their texts
  std::string corpus;        // version of the golden corpus, "none" without one
  std::string corpus_hash;   // of its manifest
  std::string setup_hash;    // of all setups that were judged, sorted
  std::uint64_t setups = 0;  // number of different setups
  std::uint64_t seed = 0;
  std::uint32_t generated = 0;  // cases in each section
  std::string controller;       // command; empty: the built-in fast engine
};

struct Certificate {
  Identity identity;
  Occasion occasion;
  Capabilities subject;
  std::vector<SectionResult> sections;
  std::vector<model::ClauseCount> clauses;  // by clause, of the cases that were judged
  std::vector<Finding> findings;            // one for each section, clause and kind, in the order of the groups
  std::vector<SharedCause> causes;          // the groups of findings, those with most cases first (settling.h)
  std::chrono::milliseconds settling{0};    // the time limit for settling one finding of each group
  std::vector<Unsettled> unsettled;         // the first hundred
  std::set<std::string> without_effect;     // words of the user's own programs that are read and change no path
  std::vector<Picture> pictures;            // of the first programs of the user's own
  std::string self_check;                   // what failed; empty: nothing failed
  std::string interrupted;                  // why not all cases were run; otherwise empty
  std::string chatter;                      // the first line of the controller that is not an answer
  std::string hello;                        // its answer to hello, as it came; empty if none came
  // Of an adapter: why it does otherwise, by the name of the difference (SectionResult::known_differences).
  std::map<std::string, std::string> known_reasons;
};

// Normative, parameter and alarm clauses of the certificate's sections that can be tested and were not reached.
std::vector<spec::Clause> clauses_not_exercised(const Certificate& certificate);
// Open clauses that were reached. Their results rest on our own definition.
std::vector<spec::Clause> open_clauses_relied_on(const Certificate& certificate);

// How well the clauses that were reached and judged by are known, by section.
std::vector<std::pair<std::string_view, spec::KnownCounts>> known_clauses(const Certificate& certificate);
// "of 214 clauses judged, 61 from the manual, 40 from a sister manual, 70 from recollection, 43 ours".
std::string words_on_known(const Certificate& certificate);
// What was left out because of Capabilities::known: "812 of 2000 events left out: they do not rest only on clauses
// known as manual, sister"; empty if everything is judged.
std::string words_on_left_out(const Certificate& certificate);
// The clauses on which these events rest, with their numbers of events, the largest first.
std::vector<std::pair<spec::Clause, std::uint64_t>> left_out_for(const Certificate& certificate);

// 4 if a self-check failed; 1 if there is a finding; 3 if the run was interrupted, if the oracle could not decide a
// case, if no value of an applicable section was judged (unless all of it is left out), or if more than
// policy::kMostWide of the values of a section or of an own case were not judged; otherwise 0.
int exit_status(const Certificate& certificate);
// "conforms in 1 of 12 sections, 11 not applicable", "conforms in …; 14 cases differ by design", "does not conform",
// "not decided", "not decided: interrupted", "conforms only in part (…): more than 1 % not judged", "self-check
// failed".
std::string verdict(const Certificate& certificate);
// What was judged, in numbers: sections that were judged, do not apply to the controller, or rest on clauses that
// were left out, and programs of the user's own.
struct Scope {
  std::size_t judged = 0;
  std::size_t not_applicable = 0;
  std::size_t left_out = 0;
  std::uint64_t programs = 0;
};
Scope counted_scope(const Certificate& certificate);
// What was judged: "all 12 sections", "1 of 12 sections, 3 not applicable, 8 not asked for and 2 programs".
std::string scope(const Certificate& certificate);
std::uint64_t cases_not_run(const Certificate& certificate);
// Cases that the controller does otherwise by design, as it says, by the name of the difference.
std::map<std::string, std::uint64_t> known_differences(const Certificate& certificate);
// How many cases these are.
std::uint64_t sum_of(const std::map<std::string, std::uint64_t>& known_differences);
// "1 case differs by design", "2 programs differ by design".
std::string words_by_design(std::uint64_t n, std::string_view what);
// Groups of findings of which one was settled.
std::size_t groups_settled(const Certificate& certificate);
// "2 of 3 groups settled, within 30 s"; empty if there are no findings.
std::string words_on_settling(const Certificate& certificate);

std::string_view kind_name(spec::ClauseKind kind);

// SHA-256 of the clause set as built.
std::string clause_set_hash();

}  // namespace toolcomp::certify
