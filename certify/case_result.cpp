// SPDX-License-Identifier: Apache-2.0
#include "certify/case_result.h"

#include <algorithm>
#include <array>
#include <utility>

#include "certify/event_fields.h"
#include "host/sha256.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify {
namespace {

// Cases with fewer events judged are counted apart.
constexpr std::uint64_t kFewestEvents = 3;

bool has_verdict(const CaseResult& r) { return r.result == Result::agrees || r.result == Result::partly_judged; }

}  // namespace

std::string_view name(Origin origin) {
  constexpr std::array<std::string_view, 3> names{"golden", "generated", "own"};
  return names.at(static_cast<std::size_t>(origin));
}

CaseResult not_asked(const spec::Case& c, Origin origin, Result result, std::string why) {
  CaseResult r;
  r.result = result;
  r.origin = origin;
  r.section = c.section;
  r.id = c.id;
  r.why = std::move(why);
  return r;
}

CaseResult asked_and_judged(const spec::Case& c, Origin origin, const judge::ModelRun& run, const Answer& answer,
                            Judgement judgement) {
  // Those of the fast engine are all there.
  const bool needed = std::holds_alternative<TextEvents>(answer.result);
  return asked_and_judged(c, origin, needed ? fields_of(run) : spec::FieldSet(), answer, std::move(judgement));
}

CaseResult asked_and_judged(const spec::Case& c, Origin origin, const spec::FieldSet& fields, const Answer& answer,
                            Judgement judgement) {
  CaseResult r = not_asked(c, origin, judgement.result, std::move(judgement.why));
  r.known_difference = std::move(judgement.known_difference);
  r.sent = answer.sent;
  // What is missing where something differs is part of that finding.
  const bool whole = has_verdict(r) && !judgement.verdict.beyond;
  if (whole && std::holds_alternative<TextEvents>(answer.result)) r.due = fields;
  if (r.result == Result::differs) r.key = key_of(c, judgement);
  r.setup = spec::write_setup_json(c.setup);
  r.verdict = std::move(judgement.verdict);
  return r;
}

Result counted(const CaseResult& r) {
  return r.result == Result::partly_judged && r.origin != Origin::own ? Result::agrees : r.result;
}

void add(SectionResult& s, const CaseResult& r) {
  ++s.cases.at(static_cast<std::size_t>(r.origin));
  ++s.results.at(static_cast<std::size_t>(counted(r)));
  if (!r.known_difference.empty()) ++s.known_differences[r.known_difference];
  const bool partly = r.result == Result::partly_judged;
  s.cut_cases += partly && r.verdict.beyond ? 1 : 0;
  s.cut_programs += partly && r.verdict.beyond && r.origin == Origin::own ? 1 : 0;
  s.wide_cases += partly && !r.verdict.beyond ? 1 : 0;
  s.wide += r.verdict.wide;
  s.widths.add(r.verdict.widths);
  s.out_of_scope += r.verdict.out_of_scope;
  s.events += r.verdict.events;
  s.left_out += r.verdict.left_out;
  for (const auto& [clause, events] : r.verdict.left_out_for) s.left_out_for[clause] += events;
  s.few_events += has_verdict(r) && r.verdict.events < kFewestEvents ? 1 : 0;
  s.values += r.verdict.values;
  s.decisions += r.verdict.decisions;
  s.near_ties += r.verdict.near_ties;
  s.ties += r.verdict.ties;
  // The distance of a wrong answer is a finding, not a rounding error.
  if (!has_verdict(r)) return;
  s.bias.add(r.verdict.bias);
  s.worst_ulp = std::max(s.worst_ulp, r.verdict.worst_ulp);
  s.worst_um = std::max(s.worst_um, r.verdict.worst_um);
}

std::vector<NeverSent> never_sent(const std::vector<std::string>& announced, const std::vector<CaseResult>& results) {
  spec::FieldSet sent;
  for (const CaseResult& r : results) sent.add(r.sent);
  std::vector<NeverSent> fields;
  for (const std::string& name : announced) {
    const auto field = spec::find_field(name);
    if (!field || sent.has(*field)) continue;
    const auto due = [&](const CaseResult& r) { return r.due.has(*field); };
    const auto first = std::ranges::find_if(results, due);
    if (first == results.end()) continue;
    fields.push_back({*field, static_cast<std::size_t>(first - results.begin()),
                      static_cast<std::uint64_t>(std::ranges::count_if(results, due))});
  }
  return fields;
}

std::string setups_hash(const std::set<std::string>& setups) {
  host::Sha256 hash;
  for (const std::string& setup : setups) {
    hash.update(setup);
    hash.update("\n");
  }
  return hash.hex();
}

}  // namespace toolcomp::certify
