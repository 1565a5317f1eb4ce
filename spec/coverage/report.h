// SPDX-License-Identifier: Apache-2.0
// The output of `toolcomp spec`. Every function returns the whole text, which ends with a line feed.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spec/coverage/coverage.h"
#include "spec/coverage/trace.h"

namespace toolcomp::spec {

enum class ReportFormat : std::uint8_t { text, json };  // JSON: one document

// Every clause: id, kind, how well it is known, and text. JSON: everything in the clause files.
std::string list_clauses(ReportFormat format);

// One clause in full. Throws InputError for an id that does not exist; the message names the nearest ones.
std::string show_clause(std::string_view id, ReportFormat format);

// The sections, with their numbers of clauses by kind, and how well the clauses are known.
std::string list_sections(ReportFormat format);

// The registry of keys, the registry of parameters, and the alarms by cause, as tables in Markdown.
std::string list_keys(ReportFormat format);
std::string list_parameters(ReportFormat format);
std::string list_alarms(ReportFormat format);

// The trace table (indexed by Clause): the code that marks each clause, the tests that name it, the theorems that prove
// it, the vectors that exercise it.
std::string show_trace(std::span<const ClauseTrace> table, ReportFormat format);

// The number of golden vectors of a section, and the number of those of which Coq proves every number.
struct ProofCount {
  std::string section;
  std::size_t vectors = 0;
  std::size_t proven = 0;
};

// The outcomes of every clause (indexed by Clause) that `runs` runs exercised, and those they did not; how well
// the clauses exercised are known, by section; and the proofs.
std::string show_coverage(std::span<const OutcomeCounts> counts, std::uint64_t runs, std::span<const ProofCount> proofs,
                          ReportFormat format);

}  // namespace toolcomp::spec
