// SPDX-License-Identifier: Apache-2.0
#include "certify/badge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

#include "fuzz/gen/generator.h"

namespace toolcomp::certify {
namespace {

// Names of shields.io.
constexpr std::string_view kConforms = "brightgreen";
constexpr std::string_view kByDesign = "yellowgreen";
constexpr std::string_view kFindings = "red";
constexpr std::string_view kNotDecided = "yellow";
constexpr std::string_view kNothing = "lightgrey";

std::string json(const std::string& message, std::string_view color, bool is_error = false) {
  nlohmann::ordered_json badge{
      {"schemaVersion", 1}, {"label", "toolcomp"}, {"message", message}, {"color", std::string(color)}};
  if (is_error) badge["isError"] = true;
  return badge.dump() + "\n";
}

std::string counted(std::uint64_t n, std::string_view what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

std::string conforms(const Certificate& c) {
  const Scope scope = counted_scope(c);
  const std::size_t all = fuzz::sections().size();
  std::string where;
  if (scope.judged > 0)
    where = scope.judged == all ? counted(all, "section") : fmt::format("{} of {} sections", scope.judged, all);
  if (scope.programs > 0) where += (where.empty() ? "" : " and ") + counted(scope.programs, "program");
  std::string message = "conforms in " + where;
  if (!c.subject.known.is_all())
    message += fmt::format(", by clauses known as {}", fmt::join(c.subject.known.names(), ", "));
  return message;
}

}  // namespace

std::string badge_json(const Certificate& c) {
  switch (exit_status(c)) {
    case 0: {
      const std::uint64_t known = sum_of(known_differences(c));
      if (known == 0) return json(conforms(c), kConforms);
      return json(conforms(c) + "; " + words_by_design(known, "case"), kByDesign);
    }
    case 1:
      return json(counted(c.findings.size(), "finding"), kFindings);
    case 4:
      return json("self-check failed", kFindings, true);
    default:
      break;
  }
  if (std::ranges::all_of(c.sections, [](const SectionResult& s) { return s.values == 0; }))
    return json("nothing judged", kNothing);
  if (!c.interrupted.empty()) return json("interrupted, not decided", kNotDecided);
  return json(verdict(c).starts_with("conforms") ? "judged only in part" : "not decided", kNotDecided);
}

std::string badge_json(const TraceReport& report) {
  const TraceResult& r = report.result;
  switch (exit_status(r)) {
    case 0:
      return json("the recording conforms", kConforms);
    case 1:
      return json(counted(r.findings_total, "finding"), kFindings);
    default:
      return r.samples == 0 || r.corners == 0 ? json("nothing judged", kNothing) : json("not decided", kNotDecided);
  }
}

std::string badge_json(const AdapterCertificate& certificate) {
  const auto programs = [&](RunOutcome outcome) {
    return static_cast<std::uint64_t>(std::ranges::count(certificate.runs, outcome, &AdapterRun::outcome));
  };
  const std::uint64_t agree = programs(RunOutcome::conforms) + programs(RunOutcome::both_refuse);
  const std::uint64_t known = programs(RunOutcome::known);
  switch (exit_status(certificate)) {
    case 0:
      if (known == 0) return json("conforms in " + counted(agree, "program"), kConforms);
      return json(
          (agree == 0 ? "" : "conforms in " + counted(agree, "program") + "; ") + words_by_design(known, "program"),
          kByDesign);
    case 1: {
      const std::uint64_t differ = programs(RunOutcome::differs);
      return json(fmt::format("{} program{}", differ, differ == 1 ? " differs" : "s differ"), kFindings);
    }
    default:
      break;
  }
  if (agree + known == 0) return json("nothing judged", kNothing);
  return json(certificate.interrupted.empty() ? "not decided" : "interrupted, not decided", kNotDecided);
}

std::string unfinished_badge() { return json("not finished", kNothing); }

}  // namespace toolcomp::certify
