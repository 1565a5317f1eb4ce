// SPDX-License-Identifier: Apache-2.0
#include "certify/certificate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "certify/sort_by.h"
#include "fuzz/gen/generator.h"
#include "host/sha256.h"

namespace toolcomp::certify {
namespace {

bool names_section(const Certificate& certificate, std::string_view section) {
  return std::ranges::any_of(certificate.sections, [&](const SectionResult& s) { return s.section == section; });
}

template <class Wanted>
std::vector<spec::Clause> select(const Certificate& certificate, Wanted wanted) {
  std::vector<spec::Clause> selected;
  for (std::size_t i = 0; i < spec::clauses().size() && i < certificate.clauses.size(); ++i)
    if (wanted(spec::clauses()[i], certificate.clauses[i])) selected.push_back(static_cast<spec::Clause>(i));
  return selected;
}

// Every case, and something in every section that applies.
bool is_decided(const Certificate& certificate) {
  std::uint64_t values = 0;
  for (const SectionResult& s : certificate.sections) {
    values += s.values;
    const std::uint64_t applicable = s.total() - s.count(Result::not_applicable);
    if (s.count(Result::undecided) > 0 || (applicable > 0 && s.values == 0 && !s.is_left_out())) return false;
  }
  return values > 0;
}

// Of the user's own.
std::uint64_t programs_cut(const Certificate& certificate) {
  std::uint64_t sum = 0;
  for (const SectionResult& s : certificate.sections) sum += s.cut_programs;
  return sum;
}

// "clauses known as manual, sister".
std::string known_as(const Certificate& certificate) {
  return fmt::format("clauses known as {}", fmt::join(certificate.subject.known.names(), ", "));
}

bool is_too_wide(const SectionResult& s) {
  return s.count(Result::partly_judged) > 0 || too_many_wide(s.values, s.wide);
}

}  // namespace

std::vector<spec::Clause> clauses_not_exercised(const Certificate& certificate) {
  return select(certificate, [&](const spec::ClauseInfo& clause, const model::ClauseCount& count) {
    return count.reached == 0 && clause.testable && clause.replaced_by.empty() &&
           clause.kind != spec::ClauseKind::note && names_section(certificate, clause.section);
  });
}

std::vector<spec::Clause> open_clauses_relied_on(const Certificate& certificate) {
  return select(certificate, [](const spec::ClauseInfo& clause, const model::ClauseCount& count) {
    return clause.kind == spec::ClauseKind::open && count.reached > 0;
  });
}

std::vector<std::pair<std::string_view, spec::KnownCounts>> known_clauses(const Certificate& certificate) {
  return spec::known_by_section([&](spec::Clause clause) {
    const auto i = static_cast<std::size_t>(clause);
    return i < certificate.clauses.size() && certificate.clauses[i].reached > 0 &&
           certificate.subject.known.has(spec::info(clause).known);
  });
}

std::string words_on_known(const Certificate& certificate) {
  const spec::KnownCounts sum = spec::sum_of(known_clauses(certificate));
  return fmt::format("of {} clauses judged, {}", sum.total(), sum.words());
}

std::string words_on_left_out(const Certificate& certificate) {
  if (certificate.subject.known.is_all()) return {};
  std::uint64_t left_out = 0;
  std::uint64_t judged = 0;
  for (const SectionResult& s : certificate.sections) {
    left_out += s.left_out;
    judged += s.events;
  }
  return fmt::format("{} of {} events left out: they do not rest only on {}", left_out, left_out + judged,
                     known_as(certificate));
}

std::vector<std::pair<spec::Clause, std::uint64_t>> left_out_for(const Certificate& certificate) {
  std::map<spec::Clause, std::uint64_t> sums;
  for (const SectionResult& s : certificate.sections)
    for (const auto& [clause, events] : s.left_out_for) sums[clause] += events;
  std::vector<std::pair<spec::Clause, std::uint64_t>> list(sums.begin(), sums.end());
  sort_by(list, [](const auto& clause) { return ~clause.second; });  // most events first
  return list;
}

int exit_status(const Certificate& certificate) {
  if (!certificate.self_check.empty()) return 4;
  if (!certificate.findings.empty()) return 1;
  if (!certificate.interrupted.empty() || !is_decided(certificate)) return 3;
  return std::ranges::any_of(certificate.sections, is_too_wide) ? 3 : 0;
}

Scope counted_scope(const Certificate& certificate) {
  Scope scope;
  for (const SectionResult& s : certificate.sections) {
    const std::uint64_t applicable = s.total() - s.count(Result::not_applicable);
    if (s.section.empty())
      scope.programs += applicable;
    else if (s.is_left_out())
      ++scope.left_out;
    else
      ++(applicable > 0 ? scope.judged : scope.not_applicable);
  }
  return scope;
}

std::string scope(const Certificate& certificate) {
  const auto [judged, not_applicable, left_out, programs] = counted_scope(certificate);
  const std::size_t all = fuzz::sections().size();
  std::string text;
  if (judged + not_applicable + left_out > 0) {
    text = judged == all ? fmt::format("all {} sections", all) : fmt::format("{} of {} sections", judged, all);
    if (not_applicable > 0) text += fmt::format(", {} not applicable", not_applicable);
    if (left_out > 0) text += fmt::format(", {} left out", left_out);
    if (const std::size_t seen = judged + not_applicable + left_out; seen < all)
      text += fmt::format(", {} not asked for", all - seen);
  }
  if (programs > 0)
    text += fmt::format("{}{} program{}", text.empty() ? "" : " and ", programs, programs == 1 ? "" : "s");
  return text.empty() ? "nothing" : text;
}

std::string verdict(const Certificate& certificate) {
  switch (exit_status(certificate)) {
    case 0: {
      const std::uint64_t by_design = sum_of(known_differences(certificate));
      return "conforms in " + scope(certificate) +
             (certificate.subject.known.is_all() ? "" : ", judged only by " + known_as(certificate)) +
             (by_design == 0 ? "" : "; " + words_by_design(by_design, "case"));
    }
    case 1:
      return "does not conform";
    case 4:
      return "self-check failed";
    default:
      break;
  }
  if (!certificate.interrupted.empty()) return "not decided: " + certificate.interrupted;
  if (!is_decided(certificate)) return "not decided";
  const std::uint64_t cut = programs_cut(certificate);
  if (cut > 0)
    return fmt::format("conforms only in part ({}): {} program{} not judged to the end", scope(certificate), cut,
                       cut == 1 ? "" : "s");
  return "conforms only in part (" + scope(certificate) + "): more than 1 % not judged";
}

std::map<std::string, std::uint64_t> known_differences(const Certificate& certificate) {
  std::map<std::string, std::uint64_t> sums;
  for (const SectionResult& s : certificate.sections)
    for (const auto& [id, cases] : s.known_differences) sums[id] += cases;
  return sums;
}

std::uint64_t sum_of(const std::map<std::string, std::uint64_t>& known_differences) {
  std::uint64_t sum = 0;
  for (const auto& [id, cases] : known_differences) sum += cases;
  return sum;
}

std::string words_by_design(std::uint64_t n, std::string_view what) {
  return fmt::format("{} {}{} by design", n, what, n == 1 ? " differs" : "s differ");
}

std::uint64_t cases_not_run(const Certificate& certificate) {
  std::uint64_t sum = 0;
  for (const SectionResult& s : certificate.sections) sum += s.count(Result::not_run);
  return sum;
}

std::size_t groups_settled(const Certificate& certificate) {
  return static_cast<std::size_t>(std::ranges::count_if(certificate.causes, [&](const SharedCause& group) {
    return certificate.findings[group.findings.front()].not_settled.empty();
  }));
}

std::string words_on_settling(const Certificate& certificate) {
  if (certificate.causes.empty()) return {};
  const std::size_t groups = certificate.causes.size();
  return fmt::format("{} of {} group{} settled, within {:g} s at most", groups_settled(certificate), groups,
                     groups == 1 ? "" : "s", std::chrono::duration<double>(certificate.settling).count());
}

std::string_view kind_name(spec::ClauseKind kind) {
  constexpr std::array<std::string_view, 5> names{"normative", "parameter", "alarm", "open", "note"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string clause_set_hash() {
  host::Sha256 hash;
  for (const spec::ClauseInfo& c : spec::clauses())
    for (const std::string_view part : {c.id, c.section, kind_name(c.kind), c.text, c.formula, c.parameters,
                                        c.alternatives, c.positive, c.negative, c.tie, c.unreachable, c.replaced_by}) {
      hash.update(part);
      hash.update(std::string_view("\0", 1));
    }
  return hash.hex();
}

}  // namespace toolcomp::certify
