// SPDX-License-Identifier: Apache-2.0
#include "certify/report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "certify/event_fields.h"
#include "certify/exactly.h"
#include "certify/junit.h"
#include "certify/markup.h"
#include "host/file_writer.h"
#include "spec/language/known.h"

namespace toolcomp::certify {
namespace {

using Json = nlohmann::ordered_json;

Json clause_ids(const std::vector<spec::Clause>& clauses) {
  Json ids = Json::array();
  for (const spec::Clause clause : clauses) ids.push_back(spec::info(clause).id);
  return ids;
}

Json to_json(const SectionResult& s) {
  Json json;
  json["section"] = s.section;
  json["cases"] = {
      {"golden", s.count(Origin::golden)}, {"generated", s.count(Origin::generated)}, {"own", s.count(Origin::own)}};
  for (std::size_t i = 0; i < s.results.size(); ++i)
    json["results"][std::string(name(static_cast<Result>(i)))] = s.results.at(i);
  json["values"] = s.values;
  json["decisions"] = s.decisions;
  json["near_ties"] = s.near_ties;
  json["ties"] = s.ties;
  json["values_not_judged"] = s.wide;
  json["largest_width_um"] = s.widths.largest();
  json["cases_with_more_than_1_percent_not_judged"] = s.wide_cases;
  json["cases_not_judged_to_their_end"] = s.cut_cases;
  json["events_out_of_scope"] = s.out_of_scope;
  json["events"] = s.events;
  json["events_left_out"] = s.left_out;
  json["cases_with_fewer_than_three_events"] = s.few_events;
  if (!s.known_differences.empty()) json["known_differences"] = s.known_differences;
  json["worst_um"] = s.worst_um;
  json["worst_ulp"] = s.worst_ulp;
  if (s.bias.count > 0)
    json["rounded_lengths_um"] = {{"count", s.bias.count}, {"mean", s.bias.mean()}, {"worst", s.bias.worst}};
  return json;
}

Json to_json(const Finding& f, std::size_t index) {
  Json json;
  json["file"] = "findings/" + file_name(f, index);
  json["section"] = f.key.section;
  json["clause"] = f.key.clause.empty() ? Json() : Json(f.key.clause);
  const auto clause = spec::find_clause(f.key.clause);
  json["known"] = clause ? Json(spec::known_name(spec::info(*clause).known)) : Json();
  json["source"] = clause ? Json(how_known(f)) : Json();
  json["kind"] = f.key.kind;
  json["line"] = f.difference.line;
  json["field"] = f.difference.field;
  json["expected"] = f.difference.expected;
  json["actual"] = f.difference.actual;
  json["deviation_um"] = f.difference.deviation_um;
  json["occurrences"] = f.occurrences;
  json["seen"] = f.seen;
  json["tried"] = f.tried;
  json["settled"] = f.not_settled.empty();
  if (!f.not_settled.empty()) json["not_settled"] = f.not_settled;
  json["requests_before"] = f.before.size();
  if (!f.status.empty()) json["status"] = f.status;
  if (!f.errors.empty()) json["errors"] = f.errors;
  json["first_case"] = f.first_case;
  json["program"] = f.smallest.program;
  json["shrink_runs"] = f.runs;
  json["shrink_complete"] = f.complete;
  return json;
}

std::string dump(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string failure(const Finding& f) {
  std::string message = accusation(f);
  if (!f.not_settled.empty()) message += " Not settled: " + f.not_settled;
  return fmt::format(R"(<failure type="{}" message="{}">{}</failure>)", escape(f.key.kind), escape(message),
                     escape(f.smallest.program));
}

Json to_json(const spec::KnownCounts& counts) {
  Json json;
  for (const spec::Known known : spec::kAllKnown) json[std::string(spec::known_name(known))] = counts.of(known);
  return json;
}

// The findings of a section on a clause (empty: on none).
std::string failures_of(const Certificate& c, std::string_view section, std::string_view clause) {
  std::string out;
  for (const Finding& f : c.findings)
    if (f.key.section == section && f.key.clause == clause) out += failure(f);
  return out;
}

junit::Suite suite_of(const Certificate& c, const SectionResult& s) {
  junit::Suite suite;
  std::string group = s.section.empty() ? "own programs" : s.section;
  std::vector<std::string_view> named{""};
  for (std::size_t i = 0; i < spec::clauses().size() && i < c.clauses.size(); ++i) {
    const spec::ClauseInfo& info = spec::clauses()[i];
    if (info.section != s.section || !info.testable || info.kind == spec::ClauseKind::note || !info.replaced_by.empty())
      continue;
    std::string inside = failures_of(c, s.section, info.id);
    if (inside.empty() && c.clauses[i].reached == 0) inside = "<skipped message=\"not exercised\"/>";
    suite.add(group, info.id, inside);
    named.push_back(info.id);
  }
  // Findings on clauses of another section, or on none.
  for (const Finding& f : c.findings)
    if (f.key.section == s.section && (f.key.clause.empty() || std::ranges::find(named, f.key.clause) == named.end()))
      suite.add(group, f.key.clause.empty() ? "no clause: " + f.key.kind : f.key.clause, failure(f));
  const std::uint64_t undecided = s.count(Result::undecided);
  suite.add(group, "decided",
            undecided == 0
                ? ""
                : fmt::format(R"(<error type="undecided" message="{} cases could not be decided"/>)", undecided));
  suite.add(group, "not judged",
            s.count(Result::partly_judged) == 0 && !too_many_wide(s.values, s.wide)
                ? ""
                : fmt::format(R"(<error type="not judged" message="{}"/>)", escape(words_on_wide(s.values, s.wide))));
  suite.add(group, "judged", s.values > 0 ? "" : R"(<error type="nothing judged" message="no value was judged"/>)");
  return suite;
}

}  // namespace

void remove_findings(const std::filesystem::path& report, const std::vector<host::FileText>& but) {
  const std::filesystem::path folder = report / "findings";
  if (!std::filesystem::is_directory(folder)) return;
  std::vector<std::filesystem::path> old;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string file = entry.path().filename().string();
    const bool ours = file.size() > 3 && file[0] >= '0' && file[0] <= '9' && file[1] >= '0' && file[1] <= '9' &&
                      file.ends_with(".json");
    const bool stays = std::ranges::find(but, entry.path(), &host::FileText::first) != but.end();
    if (ours && !stays) old.push_back(entry.path());
  }
  for (const auto& path : old) std::filesystem::remove(path);
}

std::string file_name(const Finding& finding, std::size_t index) {
  std::string kind;
  for (const char c : finding.key.kind) kind += (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '-';
  return fmt::format("{:02}-{}.json", index + 1, kind);
}

std::string explanation(const Finding& f) {
  const std::string& kind = f.key.kind;
  const judge::Difference& d = f.difference;
  if (kind == "crash") return "The controller " + d.actual + ".";
  if (kind == "hang") return "The controller gives " + d.actual + ".";
  if (kind == "malformed reply") return "The controller's answer breaks the protocol: " + d.actual + ".";
  if (kind == "error") return "The controller answers with an error: " + d.actual + ".";
  if (kind == "reply too long") return "The controller gives " + d.actual + ".";
  const std::string place = "Line " + std::to_string(d.line) + ": ";
  if (kind == "missing field")
    return place + d.field + " is announced in the capabilities, and is missing in event " +
           std::to_string(d.event + 1) + ".";
  if (kind == kNeverSent) return place + d.field + " is announced in the capabilities, and is in no answer.";
  if (kind == "missing event") return place + "the event " + d.expected + " is missing; there is " + d.actual + ".";
  if (kind == "extra event") return place + "there is " + d.actual + ", and the specification has " + d.expected + ".";
  if (kind == "order") return place + "the events come in another order: " + d.actual + " before " + d.expected + ".";
  if (kind.starts_with("law "))
    return place + "the model itself breaks the law " + d.field + ". Checked: " + d.expected + ". Found: " + d.actual +
           ".";
  if (kind == kSpecificationKind)
    return place + d.field + " is " + d.expected + " in the model and " + d.actual + " in the formal specification.";
  std::string text = place + d.field + " is " + d.actual + " and should be " + d.expected;
  if (d.deviation_um != 0) text += fmt::format(" ({:.3g} µm off)", d.deviation_um);
  return text + ".";
}

std::string accusation(const Finding& f) {
  const std::string known = how_known(f);
  return known.empty() ? explanation(f) : fmt::format("Rests on {} [{}]. {}", f.key.clause, known, explanation(f));
}

std::string how_it_comes(const Finding& f) {
  std::string text;
  if (!f.before.empty())
    text += fmt::format(", after {} request{} before it", f.before.size(), f.before.size() == 1 ? "" : "s");
  if (!f.not_settled.empty()) return text + ", not settled: " + f.not_settled;
  if (f.tried == 0) return text + ", not tried again";
  if (f.seen < f.tried) text += fmt::format(", in {} of {} runs", f.seen, f.tried);
  return text;
}

std::string json_report(const Certificate& c) {
  Json json;
  json["certificate"] = 1;
  json["verdict"] = verdict(c);
  json["exit_status"] = exit_status(c);
  json["scope"] = scope(c);
  json["interrupted"] = c.interrupted;
  json["cases_not_run"] = cases_not_run(c);
  json["self_check"] = c.self_check.empty() ? "passed" : c.self_check;
  const Identity& id = c.identity;
  json["identity"] = {{"tool", id.tool},
                      {"tool_sha256", id.tool_hash},
                      {"clauses_sha256", id.clause_hash},
                      {"corpus", id.corpus},
                      {"corpus_sha256", id.corpus_hash},
                      {"setups", id.setups},
                      {"setups_sha256", id.setup_hash},
                      {"seed", id.seed},
                      {"generated", id.generated},
                      {"command", id.controller}};
  json["occasion"] = to_json(c.occasion);
  json["controller"] = {{"name", c.subject.name},
                        {"version", c.subject.version},
                        {"sections", c.subject.sections},
                        {"resolution", c.subject.resolution.words()},
                        {"fields", c.subject.fields},
                        {"fields_not_judged", fields_not_judged(c.subject)},
                        {"setup", c.subject.setup.empty() ? Json::object() : Json::parse(c.subject.setup)},
                        {"chatter", c.chatter}};
  json["sections"] = Json::array();
  for (const SectionResult& s : c.sections) json["sections"].push_back(to_json(s));
  json["findings"] = Json::array();
  for (std::size_t i = 0; i < c.findings.size(); ++i) json["findings"].push_back(to_json(c.findings[i], i));
  json["causes"] = Json::array();
  for (const SharedCause& cause : c.causes)
    json["causes"].push_back({{"cause", cause.words}, {"findings", cause.findings}, {"cases", cause.cases}});
  json["settling"] = {{"seconds", std::chrono::duration<double>(c.settling).count()},
                      {"groups", c.causes.size()},
                      {"settled", groups_settled(c)}};
  json["read_without_effect"] = c.without_effect;
  if (!c.known_reasons.empty()) json["known_differences"] = c.known_reasons;
  json["unsettled"] = Json::array();
  for (const Unsettled& u : c.unsettled)
    json["unsettled"].push_back({{"id", u.id}, {"section", u.section}, {"result", name(u.result)}, {"why", u.why}});
  json["clauses"] = Json::object();
  for (std::size_t i = 0; i < spec::clauses().size() && i < c.clauses.size(); ++i) {
    const model::ClauseCount& n = c.clauses[i];
    if (n.reached > 0)
      json["clauses"][std::string(spec::clauses()[i].id)] = {
          {"reached", n.reached}, {"positive", n.positive}, {"negative", n.negative}, {"tie", n.tie}};
  }
  json["clauses_not_exercised"] = clause_ids(clauses_not_exercised(c));
  json["open_clauses_relied_on"] = clause_ids(open_clauses_relied_on(c));
  const auto known = known_clauses(c);
  json["known"] = {{"clauses", to_json(spec::sum_of(known))}, {"sections", Json::object()}};
  for (const auto& [section, counts] : known) json["known"]["sections"][std::string(section)] = to_json(counts);
  json["left_out"] = {{"judged", c.subject.known.names()}, {"clauses", Json::object()}};
  for (const auto& [clause, events] : left_out_for(c))
    json["left_out"]["clauses"][std::string(spec::info(clause).id)] = events;
  return dump(json);
}

std::string junit_report(const Certificate& c) {
  std::string suites;
  for (const SectionResult& s : c.sections)
    suites += suite_of(c, s).xml(s.section.empty() ? "own programs" : s.section);
  if (!c.self_check.empty()) {
    junit::Suite harness;
    harness.add("harness", "self-check",
                fmt::format(R"(<error type="self-check" message="{}"/>)", escape(c.self_check)));
    suites += harness.xml("harness");
  }
  return junit::document(suites);
}

std::vector<std::filesystem::path> write_report(const Certificate& c, const std::filesystem::path& folder) {
  std::vector<host::FileText> files{{folder / "certificate.json", json_report(c)},
                                    {folder / "junit.xml", junit_report(c)},
                                    {folder / "certificate.sarif", sarif_report(c)},
                                    {folder / "index.html", html_report(c)}};
  std::vector<std::filesystem::path> paths;
  for (std::size_t i = 0; i < c.findings.size(); ++i) {
    paths.push_back(folder / "findings" / file_name(c.findings[i], i));
    files.emplace_back(paths.back(), write_finding(c.findings[i]));
  }
  host::write_files(files);
  remove_findings(folder, files);
  return paths;
}

std::string extent(const TraceFinding& finding) {
  // Distances carry roundings: nine decimals of them are right.
  constexpr double kDecimals = 1e9;
  const auto number = [](double value) { return fmt::format("{:.6g}", std::round(value * kDecimals) / kDecimals); };
  const auto words = [&](const Bounds& b) {
    const std::string lower = number(b.lower);
    const std::string upper = number(b.upper);
    return lower == upper ? upper : lower + " to " + upper;
  };
  if (finding.distance.upper == 0 && finding.rotary.upper == 0 && finding.duration > 0)
    return fmt::format("{:.6g} s", finding.duration);
  std::string out = words(finding.distance);
  if (finding.rotary_axis != 0) out += std::string(", ") + finding.rotary_axis + " " + words(finding.rotary);
  if (finding.duration > 0) out += fmt::format(", {:.6g} s", finding.duration);
  return out;
}

std::string json_report(const TraceReport& report) {
  const auto bounds = [](const Bounds& b) { return Json{{"lower", b.lower}, {"upper", b.upper}}; };
  const TraceResult& r = report.result;
  Json json;
  json["trace"] = 1;
  json["exit_status"] = exit_status(r);
  json["file"] = report.file;
  json["occasion"] = to_json(report.occasion);
  json["tolerance"] = report.options.tolerance;
  json["rotary_tolerance"] = report.options.rotary_tolerance.value_or(report.options.tolerance);
  json["recorded"] = r.recorded;
  json["not_recorded"] = r.not_recorded;
  json["samples"] = r.samples;
  json["samples_off"] = r.off;
  json["corners"] = r.corners;
  json["corners_missed"] = r.corners_missed;
  json["moves_not_judged_inside"] = r.not_judged_moves;
  json["length"] = r.length;
  json["covered"] = r.covered;
  json["worst"] = bounds(r.worst);
  json["worst_sample"] = r.worst_sample;
  json["worst_rotary"] = bounds(r.worst_rotary);
  json["worst_rotary_sample"] = r.worst_rotary_sample;
  json["time_steps_not_judged"] = r.steps_not_judged;
  json["undecided"] = r.undecided;
  json["cause"] = r.cause.value_or("");
  json["findings_total"] = r.findings_total;
  json["findings"] = Json::array();
  for (const TraceFinding& f : r.findings) {
    Json finding{{"kind", f.kind}, {"sample", f.sample},       {"samples", f.samples},
                 {"line", f.line}, {"last_line", f.last_line}, {"distance", bounds(f.distance)}};
    if (f.n) finding["n"] = *f.n;
    if (f.last_n) finding["last_n"] = *f.last_n;
    if (f.rotary_axis != 0) {
      finding["rotary"] = bounds(f.rotary);
      finding["rotary_axis"] = std::string(1, f.rotary_axis);
    }
    if (f.worst_sample > 0) finding["worst_sample"] = f.worst_sample;
    if (f.duration > 0) finding["duration"] = f.duration;
    for (std::size_t i = 0; i < report.c.setup.axes.size(); ++i)
      if (f.at.has(i)) finding["at"][std::string(1, report.c.setup.axes.letter(i))] = f.at[i];
    json["findings"].push_back(std::move(finding));
  }
  return dump(json);
}

std::string junit_report(const TraceReport& report) {
  junit::Suite suite;
  for (const TraceFinding& f : report.result.findings)
    suite.add("trace", fmt::format("{} at sample line {}", f.kind, f.sample),
              fmt::format(R"(<failure type="{}" message="program line {}, distance {}"/>)", escape(f.kind), f.line,
                          escape(extent(f))));
  if (exit_status(report.result) == 3)
    suite.add("trace", "judged",
              fmt::format(R"(<error type="nothing judged" message="{}"/>)", escape(report.result.undecided)));
  else
    suite.add("trace", "judged", "");
  return junit::document(suite.xml(report.file));
}

void write_report(const TraceReport& report, const std::filesystem::path& folder) {
  host::write_files({{folder / "certificate.json", json_report(report)},
                     {folder / "junit.xml", junit_report(report)},
                     {folder / "certificate.sarif", sarif_report(report)},
                     {folder / "index.html", html_report(report)}});
  remove_findings(folder);
}

}  // namespace toolcomp::certify
