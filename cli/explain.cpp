// SPDX-License-Identifier: Apache-2.0
// toolcomp explain: block by block, the clauses applied, each decision with its exact value and the double nearest to
// it.
#include <fmt/format.h>

#include <set>
#include <string>
#include <string_view>

#include "certify/certificate.h"
#include "certify/explained.h"
#include "cli/crossing.h"
#include "cli/program.h"
#include "cli/unjudged.h"
#include "cli/verbs.h"
#include "fast/basis/print.h"
#include "model/basis/print.h"
#include "spec/language/event_format.h"
#include "spec/language/known.h"

namespace toolcomp::cli {
namespace {

std::string_view outcome_text(const spec::ClauseInfo& clause, exact::Sign outcome) {
  switch (outcome) {
    case exact::Sign::positive:
      return clause.positive;
    case exact::Sign::negative:
      return clause.negative;
    case exact::Sign::zero:
      return clause.tie;
  }
  return {};
}

std::string_view comparison(exact::Sign outcome) {
  switch (outcome) {
    case exact::Sign::positive:
      return "> 0";
    case exact::Sign::negative:
      return "< 0";
    case exact::Sign::zero:
      return "= 0";
  }
  return {};
}

std::string exact_text(const exact::Real& value, int digits) {
  std::string text;
  model::append_number(text, value, digits);
  if (value.is_rational() && text.size() > 1) {
    const std::string fraction = value.rational().str();
    if (fraction.size() <= 40 && fraction.find('/') != std::string::npos) text += " = " + fraction;
    return text;
  }
  return text;
}

// `what`: what the clause does in the block, "clause" or "decision". What its symbols mean is said in its first place.
void print_clause(std::string_view what, const spec::ClauseInfo& clause, std::set<std::string_view>& known_symbols) {
  fmt::print("  {:<8} {}  [{}; {}]\n      {}\n", what, clause.id, certify::kind_name(clause.kind), spec::cited(clause),
             clause.text);
  if (!clause.formula.empty()) fmt::print("      {}\n", clause.formula);
  for (const std::string_view symbols : spec::items(clause.notation))
    if (known_symbols.insert(symbols).second) fmt::print("      with {}\n", symbols);
}

void print_decision(const model::Decision& decision, int digits, std::set<std::string_view>& known_symbols) {
  const spec::ClauseInfo& clause = spec::info(decision.clause);
  print_clause("decision", clause, known_symbols);
  fmt::print("      exact   {} {}\n", exact_text(decision.quantity, digits), comparison(decision.outcome));
  const exact::DoubleEnclosure enclosure = decision.quantity.double_enclosure();
  fmt::print("      double  {:.17g}\n", enclosure.lower / 2 + enclosure.upper / 2);
  if (decision.scale.sign() == exact::Sign::positive)
    fmt::print("      margin  {} of the scale {}\n", exact_text(decision.quantity / decision.scale, digits),
               exact_text(decision.scale, digits));
  const std::string_view meaning = outcome_text(clause, decision.outcome);
  if (!meaning.empty()) fmt::print("      so      {}\n", meaning);
}

void print(const certify::ExplainedBlock& block, const spec::Axes& axes, int digits) {
  fmt::print("line {}: {}\n", block.line, block.text);
  std::set<std::string_view> known_symbols;
  for (const model::Decision& decision : block.decisions) print_decision(decision, digits, known_symbols);
  for (const certify::ExplainedEvent& explained : block.exact) {
    const model::Event& event = explained.event;
    std::string text;
    spec::append_event_json(text, event, axes, [digits](std::string& out, const exact::Real& value) {
      model::append_number(out, value, digits);
    });
    fmt::print("  exact   {}\n", text);
    if (spec::ends_run(event.kind) || event.kind == spec::EventKind::warning)
      fmt::print("          {}\n", event.message);
    if (const auto by = crossing(event)) fmt::print("          the paths cross by {:.6g}\n", *by);
    for (const spec::Clause clause : block.other_clauses(explained))
      print_clause("clause", spec::info(clause), known_symbols);
    if (!explained.measured.empty()) fmt::print("  measured {}\n", explained.measured);
    if (!explained.corner.empty()) fmt::print("  corner   {}\n", explained.corner);
  }
  for (const auto& event : block.fast) {
    std::string text;
    spec::append_event_json(text, event, axes, [](std::string& out, double value) { fast::append_number(out, value); });
    fmt::print("  double  {}\n", text);
  }
  fmt::print("\n");
}

}  // namespace

int explain(const ExplainOptions& options) {
  say_what_is_read(options.program, options.setup);
  const Program program(options.program, options.setup, options.samples);
  Unjudged unjudged(program);
  for (const certify::ExplainedBlock& block : certify::explain_blocks(program, options.block, options.digits)) {
    print(block, program.setup().axes, options.digits);
    for (const certify::ExplainedEvent& explained : block.exact) unjudged.on(explained.event, explained.event.line, 1);
  }
  unjudged.end();
  return unjudged.status();
}

}  // namespace toolcomp::cli
