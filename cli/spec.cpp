// SPDX-License-Identifier: Apache-2.0
// toolcomp spec: the clauses, where each is found, what the golden corpus exercises of them; keys and parameters of
// setups.
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "cli/manners.h"
#include "cli/verbs.h"
#include "corpus/check.h"
#include "corpus/golden.h"
#include "corpus/proofs/proofs.h"
#include "spec/coverage/report.h"

namespace toolcomp::cli {
namespace {

spec::ReportFormat format_of(const SpecOptions& options) {
  return options.json ? spec::ReportFormat::json : spec::ReportFormat::text;
}

std::filesystem::path folder_of(const SpecOptions& options, const std::filesystem::path& usual) {
  return options.directory.empty() ? usual : std::filesystem::path(options.directory);
}

int print(const std::string& text) {
  std::cout << text;
  return kAgrees;
}

}  // namespace

int spec_list(const SpecOptions& options) { return print(spec::list_clauses(format_of(options))); }
int spec_show(const SpecOptions& options) { return print(spec::show_clause(options.id, format_of(options))); }
int spec_sections(const SpecOptions& options) { return print(spec::list_sections(format_of(options))); }
int spec_keys(const SpecOptions& options) { return print(spec::list_keys(format_of(options))); }
int spec_parameters(const SpecOptions& options) { return print(spec::list_parameters(format_of(options))); }
int spec_alarms(const SpecOptions& options) { return print(spec::list_alarms(format_of(options))); }

int spec_trace(const SpecOptions& options) {
  const std::filesystem::path folder = folder_of(options, spec::default_source());
  return print(spec::show_trace(spec::trace(folder), format_of(options)));
}

int spec_coverage(const SpecOptions& options) {
  const std::filesystem::path folder = folder_of(options, corpus::default_folder());
  detail("corpus " + folder.string());
  const corpus::Coverage coverage = corpus::coverage(folder);
  std::vector<spec::ProofCount> proofs;
  if (options.directory.empty()) proofs = corpus::count_proofs(folder);
  return print(spec::show_coverage(coverage.counts, coverage.vectors, proofs, format_of(options)));
}

}  // namespace toolcomp::cli
