// toolcomp diff: model against fast, and the first difference explained.
#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <iostream>
#include <system_error>

#include "cli/difference.h"
#include "cli/program.h"
#include "cli/progress.h"
#include "cli/verbs.h"
#include "fuzz/oracle/trial.h"
#include "fuzz/oracle/verdict.h"

namespace toolcomp::cli {

void print_difference(const fuzz::Difference& difference, const Place& place) {
  fmt::print("{}:{}: {}{}{}\n", spec::display_name(place.file), place.line, difference.kind,
             difference.field.empty() ? "" : " ", difference.field);
  fmt::print("  expected  {}\n  actual    {}\n", difference.expected, difference.actual);
  if (difference.deviation_um != 0) fmt::print("  deviation {:.6g} µm\n", difference.deviation_um);
  if (!difference.clause) return;
  const spec::ClauseInfo& clause = spec::info(*difference.clause);
  fmt::print("  clause    {}\n            {}\n", clause.id, clause.text);
}

namespace {

// Laws are asked with all events at hand: of programs up to this size, and not of what can be read only once.
constexpr std::uintmax_t kLargestForLaws = 1 << 20;  // bytes

std::uint64_t ask_laws(const Program& program, fuzz::Verdict& verdict) {
  if (verdict.outcome != fuzz::Outcome::agrees && verdict.outcome != fuzz::Outcome::nothing_judged) return 0;
  if (program.text().once) return 0;
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(program.path(), unknown);
  if (unknown || size > kLargestForLaws) return 0;
  const spec::Case c = program.as_case();
  return fuzz::hold_laws(c, fuzz::run_model(c), verdict);
}

}  // namespace

int diff(const DiffOptions& options) {
  const Program program(options.program, options.setup, options.samples);
  const Progress progress("blocks");
  fuzz::Verdict verdict;
  try {
    verdict = fuzz::judge_stream(program.text(), program.setup(), program.samples(), &Progress::count);
  } catch (const spec::InputError& error) {
    throw program.placed(error);
  }
  const std::uint64_t questions = ask_laws(program, verdict);
  if (verdict.difference) print_difference(*verdict.difference, program.place(verdict.difference->line));
  std::cerr << fmt::format(
      "{} values judged, {} questions of laws, {} decisions, {} near ties, {} ties; worst {:.3g} ulp, {:.3g} µm\n",
      verdict.values, questions, verdict.decisions, verdict.near_ties, verdict.ties, verdict.worst_ulp,
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
