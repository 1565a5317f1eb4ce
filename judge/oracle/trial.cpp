// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/trial.h"

#include <optional>
#include <utility>

#include "judge/laws/changed_program.h"
#include "judge/laws/laws.h"
#include "spec/language/input_error.h"
#include "spec/language/naming_clause.h"

namespace toolcomp::judge {
namespace {

Verdict difference(std::string kind, std::string expected, std::string actual) {
  Verdict v;
  v.outcome = Outcome::differs;
  v.difference.emplace();
  v.difference->kind = std::move(kind);
  v.difference->expected = std::move(expected);
  v.difference->actual = std::move(actual);
  return v;
}

Acceptance acceptance(const Verdict& v) {
  if (v.outcome == Outcome::undecided) return Acceptance::not_decided;
  return v.numbers > 0 ? Acceptance::accepted : Acceptance::no_number;
}

// What the program reader refuses concerns no engine. Engines are constructed first, so a refusal of both is a setup.
bool is_setup(const spec::Case& c) {
  try {
    spec::Case empty = c;
    empty.program.clear();
    run_model(empty);
    return false;
  } catch (const spec::InputError&) {
    return true;
  }
}

}  // namespace

std::string_view name(Acceptance acceptance) {
  constexpr std::string_view names[kAcceptances] = {"accepted",        "no move before an alarm", "setup refused",
                                                    "no program text", "could not decide",        "too long"};
  return names[static_cast<std::size_t>(acceptance)];
}

std::uint64_t hold_laws(const spec::Case& c, const ModelRun& run, Verdict& verdict) {
  if (verdict.outcome != Outcome::agrees && verdict.outcome != Outcome::nothing_judged) return 0;
  laws::LawResult held = laws::hold(c, run.events);
  if (!held.violation) {
    const laws::LawResult changed =
        laws::hold_changed(c, run.events, [](const spec::Case& other) { return run_model(other).events; });
    held.checks += changed.checks;
    held.violation = changed.violation;
  }
  if (!held.violation) return held.checks;
  const laws::Violation& violation = *held.violation;
  verdict.outcome = Outcome::differs;
  Difference& d = verdict.difference.emplace();
  d.kind = "law";
  d.expected = violation.text;
  d.actual = violation.amount.empty() ? "does not hold" : violation.amount;
  d.field = violation.law;
  d.line = violation.line;
  d.event = violation.event;
  if (violation.event < run.events.size()) d.clauses = run.events[violation.event].clauses;
  d.clause = spec::naming_clause(d.clauses);
  return held.checks;
}

Trial try_case(const spec::Case& c) {
  Trial trial;
  std::optional<std::string> refused;
  try {
    trial.run = run_model(c);
  } catch (const spec::InputError& error) {
    refused = error.what();
  } catch (const std::exception& error) {
    trial.verdict = difference("exception", "events of the model", error.what());
    return trial;
  }
  try {
    const std::vector<fast::Event> events = run_fast(c);
    if (refused) {
      trial.verdict = difference("setup", *refused, "accepted");
      return trial;
    }
    trial.verdict = judge(c, trial.run, events);
    trial.acceptance = acceptance(trial.verdict);
    trial.law_checks = hold_laws(c, trial.run, trial.verdict);
  } catch (const spec::InputError& error) {
    if (!refused) {
      trial.verdict = difference("setup", "accepted", error.what());
      return trial;
    }
    trial.acceptance = is_setup(c) ? Acceptance::no_setup : Acceptance::no_text;
  } catch (const std::exception& error) {
    trial.verdict = difference("exception", "a verdict", error.what());
  }
  return trial;
}

Trial try_case(const spec::Case& c, const CaseJudge& judged_by) {
  if (!judged_by) return try_case(c);
  Trial trial;
  try {
    trial.run = run_model(c);
  } catch (const spec::InputError&) {
    trial.acceptance = is_setup(c) ? Acceptance::no_setup : Acceptance::no_text;
    return trial;
  }
  trial.verdict = judged_by(c, trial.run);
  trial.acceptance = acceptance(trial.verdict);
  trial.law_checks = hold_laws(c, trial.run, trial.verdict);
  return trial;
}

}  // namespace toolcomp::judge
