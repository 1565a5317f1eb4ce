// toolcomp diff: model against fast, and the first difference explained.
#include <fmt/format.h>

#include <iostream>

#include "cli/difference.h"
#include "cli/program.h"
#include "cli/progress.h"
#include "cli/verbs.h"
#include "fuzz/oracle/verdict.h"

namespace toolcomp::cli {

void print_difference(const fuzz::Difference& difference, const std::string& path) {
  fmt::print("{}:{}: {}{}{}\n", spec::display_name(path), difference.line, difference.kind,
             difference.field.empty() ? "" : " ", difference.field);
  fmt::print("  expected  {}\n  actual    {}\n", difference.expected, difference.actual);
  if (difference.deviation_um != 0) fmt::print("  deviation {:.6g} µm\n", difference.deviation_um);
  if (!difference.clause) return;
  const spec::ClauseInfo& clause = spec::info(*difference.clause);
  fmt::print("  clause    {}\n            {}\n", clause.id, clause.text);
}

int diff(const DiffOptions& options) {
  const Program program(options.program, options.setup, options.samples);
  const Progress progress("blocks");
  const fuzz::Verdict verdict =
      fuzz::judge_stream(program.text(), program.setup(), program.samples(), &Progress::count);
  if (verdict.difference) print_difference(*verdict.difference, program.path());
  std::cerr << fmt::format("{} values judged, {} decisions, {} near ties, {} ties; worst {:.3g} ulp, {:.3g} µm\n",
                           verdict.values, verdict.decisions, verdict.near_ties, verdict.ties, verdict.worst_ulp,
                           verdict.worst_um);
  switch (verdict.outcome) {
    case fuzz::Outcome::agrees:
      return kAgrees;
    case fuzz::Outcome::differs:
      return kDiffers;
    case fuzz::Outcome::undecided:
      std::cerr << "could not decide\n";
      return kUndecided;
    case fuzz::Outcome::nothing_judged:
      std::cerr << "nothing to judge\n";
      return kUndecided;
  }
  return kSelfCheckFailed;
}

}  // namespace toolcomp::cli
