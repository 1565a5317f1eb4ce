// SPDX-License-Identifier: Apache-2.0
#include "certify/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "certify/exactly.h"
#include "certify/program_text.h"
#include "judge/oracle/policy.h"
#include "judge/oracle/trial.h"
#include "spec/language/printable.h"

namespace toolcomp::certify {
namespace {

constexpr const char* kNoValue = "the program gives no value that can be judged";
constexpr const char* kLeftOutWhole = "every value rests on clauses that --known leaves out";

// Of the blocks of a program, counted as lines with words.
std::string share_judged(std::string_view program, std::uint64_t before_line) {
  std::size_t end = 0;
  for (std::uint64_t line = 1; line < before_line && end < program.size(); ++line)
    end = std::min(program.find('\n', end), program.size() - 1) + 1;
  const std::size_t judged = count_blocks(program.substr(0, end));
  const std::size_t all = count_blocks(program);
  return fmt::format("; {} of {} blocks were judged ({} %)", judged, all, all == 0 ? 0 : 100 * judged / all);
}

// The last clause among those of the events before and at `last`; where none was applied, a move is wrong that is
// nothing but its block's own.
std::optional<spec::Clause> last_clause(const judge::ModelRun& run, std::size_t last) {
  for (std::size_t i = std::min(last + 1, run.events.size()); i-- > 0;) {
    const spec::ClauseList& list = run.events[i].clauses;
    if (!list.empty()) return list.back();
  }
  return spec::find_clause("fanuc.program.own-move");
}

// The difference of an answer that is judged without the oracle.
Judgement differs(judge::Difference difference) {
  Judgement j;
  j.result = Result::differs;
  j.verdict.outcome = judge::Outcome::differs;
  j.verdict.difference = std::move(difference);
  return j;
}

Judgement fault(const Fault& fault, const judge::ModelRun& run) {
  judge::Difference d;
  d.kind = name(fault.kind);
  d.field = "reply";
  d.expected = "one line with the id and the events of the case";
  d.actual = fault.what;
  d.line = run.events.empty() ? 0 : run.events.back().line;
  d.clause = clause_of_fault(run);
  Judgement j = differs(std::move(d));
  j.status = fault.status;
  j.errors = fault.errors;
  return j;
}

Judgement missing_field(const MissingField& missing, const judge::ModelRun& run) {
  judge::Difference d;
  d.kind = "missing field";
  d.field = missing.field;
  d.line = missing.line;
  d.event = missing.event;
  d.expected = "announced in the capabilities";
  d.actual = "absent";
  d.clause = last_clause(run, missing.event);
  return differs(std::move(d));
}

// What was judged without the oracle's bounds; laws are not asked.
Judgement exactly(const spec::Case& c, const judge::ModelRun& run, const ExactEvents& events) {
  const Exactly held = hold_exactly(c.setup.axes, run.events, events);
  Judgement j;
  if (held.difference) {
    j = differs(*held.difference);
  } else if (!held.undecided.empty()) {
    j.result = Result::undecided;
    j.verdict.outcome = judge::Outcome::undecided;
    j.why = j.verdict.undecided = held.undecided;
  } else if (held.values > 0) {
    j.result = Result::agrees;
    j.verdict.outcome = judge::Outcome::agrees;
  }
  j.verdict.values = held.values;
  if (j.result == Result::nothing_judged) j.why = kNoValue;
  return j;
}

Result result_of(judge::Outcome outcome) {
  switch (outcome) {
    case judge::Outcome::agrees:
      return Result::agrees;
    case judge::Outcome::differs:
      return Result::differs;
    case judge::Outcome::undecided:
      return Result::undecided;
    case judge::Outcome::nothing_judged:
      break;
  }
  return Result::nothing_judged;
}

}  // namespace

std::string_view name(Result result) {
  switch (result) {
    case Result::agrees:
      return "agrees";
    case Result::differs:
      return "differs";
    case Result::undecided:
      return "undecided";
    case Result::nothing_judged:
      return "nothing judged";
    case Result::not_applicable:
      return "not applicable";
    case Result::partly_judged:
      return "not judged";
    case Result::not_run:
      break;
  }
  return "not run";
}

bool too_many_wide(std::uint64_t values, std::uint64_t wide) {
  return static_cast<double>(wide) > judge::policy::kMostWide * static_cast<double>(values + wide);
}

std::string words_on_wide(std::uint64_t values, std::uint64_t wide) {
  return fmt::format("{} of {} values were granted more than {} µm, and were not judged", wide, values + wide,
                     judge::policy::kCap);
}

std::string words_on_beyond(const judge::Beyond& beyond) {
  return fmt::format("line {}: {}; this block and the blocks after it are not judged", beyond.line, beyond.what);
}

std::optional<spec::Clause> clause_of_fault(const judge::ModelRun& run) { return last_clause(run, run.events.size()); }

std::optional<judge::Difference> Judgement::difference() const {
  if (result != Result::differs) return std::nullopt;
  auto d = verdict.difference;
  if (d) d->clause = clause;
  return d;
}

FailureKey key_of(const spec::Case& c, const judge::Difference& difference) {
  // No clause enters a law: its name is what differs.
  if (difference.kind == "law") return {c.section, "", "law " + difference.field};
  return {c.section, difference.clause ? std::string(spec::info(*difference.clause).id) : "", difference.kind};
}

FailureKey key_of(const spec::Case& c, const Judgement& judgement) {
  const auto difference = judgement.difference();
  return difference ? key_of(c, *difference) : FailureKey{c.section, "", ""};
}

namespace {

// What the controller wrote goes into findings, reports and lines on a terminal.
Judgement shown(Judgement j) {
  if (auto& d = j.verdict.difference)
    for (std::string* text : {&d->kind, &d->field, &d->expected, &d->actual}) *text = spec::printable(*text, 2000);
  j.why = spec::printable(j.why, 2000);
  j.status = spec::printable(j.status);
  j.errors = spec::printable_lines(j.errors);
  return j;
}

Judgement judged_answer(const Capabilities& capabilities, const spec::Case& c, const judge::ModelRun& run,
                        const Answer& answer) {
  if (const auto* failure = std::get_if<Fault>(&answer.result)) return fault(*failure, run);
  if (const auto* none = std::get_if<NotApplicable>(&answer.result)) {
    Judgement j;
    j.result = Result::not_applicable;
    j.why = none->why;
    j.known_difference = none->known_difference;
    return j;
  }
  if (!meets_minimum(capabilities)) {
    Judgement j;
    j.why = "the controller must announce kind, line, and one of point and axes";
    return j;
  }
  if (const auto* events = std::get_if<ExactEvents>(&answer.result)) return exactly(c, run, *events);
  if (answer.missing) return missing_field(*answer.missing, run);
  const judge::JudgeOptions options = judge_options(capabilities);
  const auto* const text = std::get_if<TextEvents>(&answer.result);
  judge::Verdict verdict = text != nullptr ? judge::judge(c, run, *text, options)
                                           : judge::judge(c, run, std::get<FastEvents>(answer.result), options);
  judge::hold_laws(c, run, verdict);
  return judged(std::move(verdict));
}

}  // namespace

Judgement judge_answer(const Capabilities& capabilities, const spec::Case& c, const judge::ModelRun& run,
                       const Answer& answer) {
  Judgement j = shown(judged_answer(capabilities, c, run, answer));
  if (const auto& d = j.verdict.difference; j.result == Result::differs)
    j.clause = d->clause ? d->clause : last_clause(run, d->event);
  if (j.result == Result::partly_judged && j.verdict.beyond) j.why += share_judged(c.program, j.verdict.beyond->line);
  return j;
}

Judgement judged(judge::Verdict verdict) {
  Judgement j;
  j.verdict = std::move(verdict);
  j.result = result_of(j.verdict.outcome);
  if (j.result == Result::undecided) j.why = j.verdict.undecided;
  if (j.result == Result::agrees && too_many_wide(j.verdict.values, j.verdict.wide)) {
    j.result = Result::partly_judged;
    j.why = words_on_wide(j.verdict.values, j.verdict.wide);
  }
  if (j.result == Result::agrees && j.verdict.beyond) j.result = Result::partly_judged;
  if (j.result == Result::nothing_judged) j.why = j.verdict.left_out > 0 ? kLeftOutWhole : kNoValue;
  if (j.verdict.beyond && (j.result == Result::partly_judged || j.result == Result::nothing_judged))
    j.why = words_on_beyond(*j.verdict.beyond);
  return j;
}

Judgement judge_case(Subject& subject, const Capabilities& capabilities, const spec::Case& c,
                     const judge::ModelRun& run, std::optional<std::chrono::milliseconds> patience) {
  if (std::string why = why_not_applicable(capabilities, c); !why.empty()) {
    Judgement j;
    j.result = Result::not_applicable;
    j.why = std::move(why);
    return j;
  }
  return judge_answer(capabilities, c, run, subject.run(c, patience));
}

}  // namespace toolcomp::certify
