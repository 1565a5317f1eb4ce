// toolcomp spec: the clauses, where each is found, and what the golden corpus exercises of them.
#include <iostream>
#include <vector>

#include "cli/verbs.h"
#include "corpus/golden.h"
#include "fuzz/oracle/verdict.h"
#include "spec/language/input_error.h"
#include "spec/trace/report.h"

namespace toolcomp::cli {
namespace {

std::string coverage(const std::string& directory, spec::ReportFormat format) {
  std::vector<spec::OutcomeCounts> sum(spec::kClauseCount);
  std::uint64_t runs = 0;
  for (const spec::Case& c :
       corpus::read_golden(directory.empty() ? corpus::default_folder() : std::filesystem::path(directory))) {
    const fuzz::ModelRun run = fuzz::run_model(c);
    ++runs;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const model::ClauseCount& count = run.recorder.counts()[i];
      sum[i].reached += count.reached;
      sum[i].positive += count.positive;
      sum[i].negative += count.negative;
      sum[i].tie += count.tie;
    }
  }
  return spec::show_coverage(sum, runs, format);
}

}  // namespace

int spec(const SpecOptions& options) {
  const auto format = options.json ? spec::ReportFormat::json : spec::ReportFormat::text;
  if (options.verb == "list") std::cout << spec::list_clauses(format);
  if (options.verb == "sections") std::cout << spec::list_sections(format);
  if (options.verb == "coverage") std::cout << coverage(options.directory, format);
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
