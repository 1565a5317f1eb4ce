// SPDX-License-Identifier: Apache-2.0
// toolcomp spec: the clauses, where each is found, what the golden corpus exercises of them; keys and parameters of
// setups.
#include <filesystem>
#include <iostream>
#include <vector>

#include "cli/manners.h"
#include "cli/verbs.h"
#include "corpus/check.h"
#include "corpus/golden.h"
#include "corpus/proofs/proofs.h"
#include "spec/language/input_error.h"
#include "spec/trace/report.h"

namespace toolcomp::cli {
int spec(const SpecOptions& options) {
  const auto format = options.json ? spec::ReportFormat::json : spec::ReportFormat::text;
  if (options.verb == "list") std::cout << spec::list_clauses(format);
  if (options.verb == "sections") std::cout << spec::list_sections(format);
  if (options.verb == "keys") std::cout << spec::list_keys(format);
  if (options.verb == "parameters") std::cout << spec::list_parameters(format);
  if (options.verb == "coverage") {
    detail("corpus " + (options.directory.empty() ? corpus::default_folder().string() : options.directory));
    const corpus::Coverage coverage = corpus::coverage(
        options.directory.empty() ? corpus::default_folder() : std::filesystem::path(options.directory));
    std::vector<spec::ProofCount> proofs;
    if (options.directory.empty()) proofs = corpus::count_proofs(corpus::default_folder());
    std::cout << spec::show_coverage(coverage.counts, coverage.vectors, proofs, format);
  }
  if (options.verb == "show") {
    if (options.id.empty())
      throw spec::InputError("toolcomp spec show", 0, 0, "name a clause; `toolcomp spec list` lists them");
    std::cout << spec::show_clause(options.id, format);
  }
  if (options.verb == "trace")
    std::cout << spec::show_trace(
        spec::trace(options.directory.empty() ? spec::default_source() : std::filesystem::path(options.directory)),
        format);
  return kAgrees;
}

}  // namespace toolcomp::cli
