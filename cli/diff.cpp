// toolcomp diff: model against fast, or the formal specification, and the first difference explained.
#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <iostream>
#include <system_error>

#include "certify/judge.h"
#include "certify/subject.h"
#include "cli/difference.h"
#include "cli/program.h"
#include "cli/progress.h"
#include "cli/verbs.h"
#include "formal/engine.h"
#include "fuzz/oracle/trial.h"
#include "fuzz/oracle/verdict.h"
#include "fuzz/parallel/judge_in_pieces.h"

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

// The formal specification against the model.
int diff_specification(const Program& program) {
  if (!formal::available())
    throw spec::InputError("--engines", 0, 0, "this toolcomp was built without the formal specification");
  const spec::Case c = program.as_case();
  const fuzz::ModelRun run = fuzz::run_model(c);
  const auto specification = certify::formal_specification();
  const auto able = std::get<certify::Capabilities>(specification->capabilities());
  const certify::Judgement judgement = certify::judge_case(*specification, able, c, run);
  if (judgement.difference) print_difference(*judgement.difference, program.place(judgement.difference->line));
  std::cerr << fmt::format("{} values judged; {}{}{}\n", judgement.verdict.values, certify::name(judgement.result),
                           judgement.why.empty() ? "" : ": ", judgement.why);
  switch (judgement.result) {
    case certify::Result::agrees:
      return kAgrees;
    case certify::Result::differs:
      return kDiffers;
    default:
      return kUndecided;
  }
}

}  // namespace

int diff(const DiffOptions& options) {
  const Program program(options.program, options.setup, options.samples);
  if (options.specification) return diff_specification(program);
  const Progress progress("blocks");
  fuzz::Verdict verdict;
  try {
    fuzz::JudgeInPieces pieces;
    pieces.jobs = jobs_for(program, options.jobs);
    verdict = fuzz::judge_in_pieces(program.text(), program.setup(), program.samples(), pieces, &Progress::count);
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
