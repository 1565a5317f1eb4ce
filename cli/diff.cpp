// SPDX-License-Identifier: Apache-2.0
// toolcomp diff: model against fast, or the formal specification, and the first difference explained.
#include <fmt/format.h>

#include <iostream>
#include <string>

#include "certify/comparison.h"
#include "certify/judge.h"
#include "cli/difference.h"
#include "cli/manners.h"
#include "cli/program.h"
#include "cli/progress.h"
#include "cli/unjudged.h"
#include "cli/verbs.h"
#include "judge/oracle/verdict.h"
#include "spec/language/known.h"
#include "spec/language/printable.h"

namespace toolcomp::cli {

void print_difference(const judge::Difference& difference, const Place& place) {
  const auto paint = [](Paint color, const std::string& text) { return painted(color, text, Stream::out); };
  fmt::print("{} {}{}{}\n",
             paint(Paint::place, fmt::format("{}:{}:", spec::printable(spec::display_name(place.file)), place.line)),
             spec::printable(difference.kind), difference.field.empty() ? "" : " ", spec::printable(difference.field));
  fmt::print("  expected  {}\n  actual    {}\n", paint(Paint::good, spec::printable(difference.expected)),
             paint(Paint::bad, spec::printable(difference.actual)));
  if (difference.deviation_um != 0) fmt::print("  deviation {:.6g} µm\n", difference.deviation_um);
  if (!difference.clause) return;
  const spec::ClauseInfo& clause = spec::info(*difference.clause);
  fmt::print("  clause    {}\n  known as  {}\n            {}\n", clause.id, spec::cited(clause), clause.text);
  if (!clause.formula.empty()) fmt::print("            {}\n", clause.formula);
  for (const std::string_view symbols : spec::items(clause.notation)) fmt::print("            with {}\n", symbols);
}

namespace {

// What the verdict does not reach is said; the exit status where the rest agrees.
int say_unjudged(const Program& program, const judge::Verdict& verdict) {
  Unjudged unjudged(program);
  unjudged.open(verdict.open.line, 1, verdict.open.out_of_scope, verdict.open.count);
  if (verdict.beyond) unjudged.ends(verdict.beyond->line, verdict.beyond->column, verdict.beyond->what);
  unjudged.end();
  return unjudged.status();
}

// The formal specification against the model.
int diff_specification(const Program& program) {
  const certify::Judgement judgement = certify::compare_specification(program);
  if (const auto difference = judgement.difference()) print_difference(*difference, program.place(difference->line));
  const std::string result =
      fmt::format("{} values judged; {}{}{}", judgement.verdict.values, certify::name(judgement.result),
                  judgement.why.empty() ? "" : ": ", judgement.why);
  switch (judgement.result) {
    case certify::Result::agrees:
      note(result);
      return say_unjudged(program, judgement.verdict);
    case certify::Result::differs:
      note(result);
      return kDiffers;
    default:
      std::cerr << result << '\n';
      return kUndecided;
  }
}

}  // namespace

int diff(const DiffOptions& options) {
  say_what_is_read(options.program, options.setup);
  const Program program(options.program, options.setup, options.samples);
  if (options.specification) return diff_specification(program);
  const Progress progress("blocks");
  detail("engines model and fast");
  const auto [verdict, questions] = certify::compare_fast(program, &Progress::count);
  if (verdict.difference) print_difference(*verdict.difference, program.place(verdict.difference->line));
  note(fmt::format("{} values judged, {} law checks, {} decisions, {} near ties, {} ties; worst {:.3g} ulp, {:.3g} µm",
                   verdict.values, questions, verdict.decisions, verdict.near_ties, verdict.ties, verdict.worst_ulp,
                   verdict.worst_um));
  const int unjudged = say_unjudged(program, verdict);
  switch (verdict.outcome) {
    case judge::Outcome::agrees:
      return unjudged;
    case judge::Outcome::differs:
      return kDiffers;
    case judge::Outcome::undecided:
      std::cerr << "could not decide\n";
      return kUndecided;
    case judge::Outcome::nothing_judged:
      std::cerr << "nothing to judge\n";
      return kUndecided;
  }
  return kSelfCheckFailed;
}

}  // namespace toolcomp::cli
