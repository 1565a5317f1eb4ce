// SPDX-License-Identifier: Apache-2.0
#include "certify/adapter_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "certify/junit.h"
#include "certify/markup.h"
#include "certify/page.h"
#include "certify/report.h"
#include "certify/sarif.h"
#include "certify/sort_by.h"
#include "host/file_writer.h"

namespace toolcomp::certify {
namespace {

// Runs of one machine, or of given programs.
std::string group_of(const std::string& machine) { return machine.empty() ? "programs" : machine; }

std::string known_differences(const AdapterCertificationOptions& certification, const AdapterCertificate& certificate) {
  std::vector<Row> rows{{"known difference", "why", "how it is recognised", "programs"}};
  for (const KnownDifference& known : certification.adapter.known) {
    const auto programs = std::ranges::count_if(certificate.runs, [&](const AdapterRun& run) {
      return std::ranges::find(run.known, known.id) != run.known.end();
    });
    rows.push_back({"<code>" + escape(known.id) + "</code>", escape(known.reason), escape(known.recognised),
                    std::to_string(programs)});
  }
  return rows.size() == 1 ? "<p>None.</p>\n" : table(rows, 3);
}

std::string machines(const AdapterCertificate& certificate) {
  std::vector<Row> rows{{"machine", "programs", "conform", "both refuse", "known differences", "differ",
                         "not applicable", "undecided", "failed", "not run", "samples", "largest distance",
                         "largest of a rotary axis, degrees"}};
  for (const MachineSummary& m : summaries(certificate)) {
    Row row{escape(group_of(m.machine)), std::to_string(m.programs)};
    for (const std::size_t count : m.outcomes) row.push_back(std::to_string(count));
    row.push_back(std::to_string(m.samples));
    row.push_back(plain(m.worst, 6));
    row.push_back(plain(m.worst_rotary, 6));
    rows.push_back(std::move(row));
  }
  return table(rows, 1);
}

std::string causes(const AdapterCertificate& certificate) {
  std::vector<Row> rows{{"one mistake that explains the difference", "programs"}};
  for (const LikelyCause& likely : likely_causes(certificate))
    rows.push_back({escape(likely.cause), std::to_string(likely.programs)});
  return rows.size() == 1 ? "" : "<h2>Likely causes</h2>\n" + table(rows, 1);
}

// What did not conform, with its program.
std::string others(const AdapterCertificate& certificate) {
  std::string out;
  for (const AdapterRun& run : certificate.runs) {
    if (run.outcome == RunOutcome::conforms || run.outcome == RunOutcome::not_applicable ||
        run.outcome == RunOutcome::not_run)
      continue;
    const Tone tone = run.outcome == RunOutcome::differs                                           ? Tone::bad
                      : run.outcome == RunOutcome::both_refuse || run.outcome == RunOutcome::known ? Tone::good
                                                                                                   : Tone::open;
    out += "<h3>" + badge(name(run.outcome), tone) + " " + escape(run.c.id) + "</h3>\n";
    for (const std::string& id : run.known) out += "<p><code>" + escape(id) + "</code></p>\n";
    if (!run.why.empty()) out += "<p>" + escape(run.why) + "</p>\n";
    if (run.result.cause) out += "<p>Likely cause: " + escape(*run.result.cause) + "</p>\n";
    if (run.outcome == RunOutcome::differs && run.result.samples > 0)
      out += fmt::format("<p><a href=\"runs/{0}/report/index.html\">trace {0}</a></p>\n",
                         escape(run.folder.filename().string()));
    out += listing(run.c.program, run.result.findings.empty() ? 0 : run.result.findings.front().line);
  }
  return out.empty() ? "<p>None.</p>\n" : out;
}

}  // namespace

std::vector<MachineSummary> summaries(const AdapterCertificate& certificate) {
  std::vector<MachineSummary> list;
  for (const AdapterRun& run : certificate.runs) {
    auto found = std::ranges::find(list, run.machine, &MachineSummary::machine);
    if (found == list.end()) found = list.insert(list.end(), MachineSummary{.machine = run.machine});
    ++found->programs;
    ++found->outcomes.at(static_cast<std::size_t>(run.outcome));
    found->samples += run.result.samples;
    found->worst = std::max(found->worst, run.result.worst.upper);
    found->worst_rotary = std::max(found->worst_rotary, run.result.worst_rotary.upper);
  }
  return list;
}

std::vector<LikelyCause> likely_causes(const AdapterCertificate& certificate) {
  // "H1 is off by +0.01": the kind stands before the figure.
  const auto kind = [](const std::string& cause) { return cause.substr(0, cause.rfind(" by ")); };
  std::vector<LikelyCause> list;
  for (const AdapterRun& run : certificate.runs) {
    if (run.outcome != RunOutcome::differs || !run.result.cause) continue;
    const auto same = std::ranges::find_if(
        list, [&](const LikelyCause& likely) { return kind(likely.cause) == kind(*run.result.cause); });
    if (same == list.end())
      list.push_back({*run.result.cause, 1});
    else
      ++same->programs;
  }
  sort_by(list, [](const LikelyCause& likely) { return SIZE_MAX - likely.programs; });
  return list;
}

std::size_t not_run(const AdapterCertificate& certificate) {
  return static_cast<std::size_t>(std::ranges::count(certificate.runs, RunOutcome::not_run, &AdapterRun::outcome));
}

std::string_view verdict(const AdapterCertificate& certificate) {
  const int status = exit_status(certificate);
  if (status == 3 && !certificate.interrupted.empty()) return "not decided: interrupted";
  return status == 0 ? "conforms" : status == 1 ? "does not conform" : "not decided";
}

std::string html_report(const AdapterCertificationOptions& certification, const AdapterCertificate& certificate) {
  const int status = exit_status(certificate);
  std::string body = "<section class=\"first\">\n<h1>Recordings of " + escape(certification.adapter.name) +
                     "</h1>\n<p>" +
                     badge(verdict(certificate), status == 0   ? Tone::good
                                                 : status == 1 ? Tone::bad
                                                               : Tone::open) +
                     "</p>\n";
  body += fmt::format(
      "<p>{} programs were run and recorded in {:.0f} s, and judged against the exact path in {:.0f} s, with a "
      "tolerance "
      "of {}; seed {}.</p>\n",
      certificate.runs.size(), certificate.seconds_run, certificate.seconds_judged, plain(certificate.tolerance, 9),
      certification.seed);
  if (!certificate.errors.empty()) body += "<p>The adapter: " + escape(certificate.errors) + "</p>\n";
  if (!certificate.interrupted.empty())
    body += fmt::format("<p class=\"bad\">{} programs not run: {}.</p>\n", not_run(certificate),
                        escape(certificate.interrupted));
  std::vector<Row> identity = rows(certificate.occasion);
  identity.push_back({"tool", "toolcomp " TOOLCOMP_VERSION});
  body += facts(identity) + std::string(kSignature) + "</section>\n";
  body += "<h2>Machines</h2>\n" + machines(certificate) + causes(certificate);
  body += "<h2>Known differences</h2>\n" + known_differences(certification, certificate);
  body += "<h2>Programs with a verdict other than conforms</h2>\n" + others(certificate);
  return page("toolcomp: " + certification.adapter.name + " " + std::string(verdict(certificate)), body);
}

std::string json_report(const AdapterCertificationOptions& certification, const AdapterCertificate& certificate) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["adapter"] = certification.adapter.name;
  json["exit_status"] = exit_status(certificate);
  json["verdict"] = verdict(certificate);
  json["tool"] = "toolcomp " TOOLCOMP_VERSION;
  json["interrupted"] = certificate.interrupted;
  json["programs_not_run"] = not_run(certificate);
  json["occasion"] = to_json(certificate.occasion);
  json["seed"] = certification.seed;
  json["tolerance"] = certificate.tolerance;
  json["seconds_run"] = certificate.seconds_run;
  json["seconds_judged"] = certificate.seconds_judged;
  json["errors"] = certificate.errors;
  json["known_differences"] = Json::object();
  for (const KnownDifference& known : certification.adapter.known) json["known_differences"][known.id] = known.reason;
  json["runs"] = Json::array();
  for (const AdapterRun& run : certificate.runs) {
    Json one{{"id", run.c.id},
             {"section", run.c.section},
             {"machine", run.machine},
             {"outcome", name(run.outcome)},
             {"why", run.why},
             {"known", run.known},
             {"samples", run.result.samples},
             {"worst", run.result.worst.upper},
             {"worst_rotary", run.result.worst_rotary.upper}};
    if (run.result.cause) one["cause"] = *run.result.cause;
    if (run.outcome != RunOutcome::conforms) one["program"] = run.c.program;
    json["runs"].push_back(std::move(one));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string junit_report(const AdapterCertificate& certificate) {
  std::string suites;
  for (const MachineSummary& machine : summaries(certificate)) {
    const std::string group = group_of(machine.machine);
    junit::Suite suite;
    for (const AdapterRun& run : certificate.runs) {
      if (run.machine != machine.machine) continue;
      const auto with = [&run](std::string_view element) {
        return fmt::format(R"(<{} type="{}" message="{}"/>)", element, name(run.outcome), escape(run.why));
      };
      std::string inside;
      switch (run.outcome) {
        case RunOutcome::conforms:
        case RunOutcome::both_refuse:
        case RunOutcome::known:
          break;
        case RunOutcome::differs:
          inside = with("failure");
          break;
        case RunOutcome::not_applicable:
        case RunOutcome::not_run:
          inside = with("skipped");
          break;
        case RunOutcome::undecided:
        case RunOutcome::failed:
          inside = with("error");
          break;
      }
      suite.add(group, run.c.id, inside);
    }
    suites += suite.xml(group);
  }
  return junit::document(suites);
}

std::string sarif_report(const AdapterCertificate& certificate) {
  sarif::TraceResults results;
  for (const AdapterRun& run : certificate.runs) {
    if (run.outcome != RunOutcome::differs) continue;
    const std::string folder = "runs/" + run.folder.filename().string();
    for (const TraceFinding& finding : run.result.findings) results.add(finding, folder + "/trace.csv");
    if (run.result.findings.empty()) results.add("whole run", run.c.id + ": " + run.why, folder + "/program.nc");
  }
  const int status = exit_status(certificate);
  sarif::Json notes = sarif::Json::array({sarif::notification("note", std::string(verdict(certificate)))});
  if (!certificate.errors.empty()) notes.push_back(sarif::notification("error", certificate.errors));
  if (!certificate.interrupted.empty()) notes.push_back(sarif::notification("warning", certificate.interrupted));
  for (const LikelyCause& likely : likely_causes(certificate))
    notes.push_back(sarif::notification("note", fmt::format("{} programs: {}", likely.programs, likely.cause)));
  return results.log(
      {{"executionSuccessful", status <= 1}, {"exitCode", status}, {"toolExecutionNotifications", notes}});
}

void write_report(const AdapterCertificationOptions& certification, const AdapterCertificate& certificate) {
  for (const AdapterRun& run : certificate.runs) {
    if (run.outcome != RunOutcome::differs || run.result.samples == 0) continue;
    TraceReport trace;
    trace.c = run.c;
    trace.file = (run.folder / "trace.csv").string();
    trace.options.tolerance = certificate.tolerance;
    trace.options.rotary_tolerance = certification.rotary_tolerance;
    trace.result = run.result;
    trace.occasion = certificate.occasion;
    write_report(trace, run.folder / "report");
  }
  const std::filesystem::path folder = certification.report;
  host::write_files({{folder / "certificate.json", json_report(certification, certificate)},
                     {folder / "junit.xml", junit_report(certificate)},
                     {folder / "certificate.sarif", sarif_report(certificate)},
                     {folder / "index.html", html_report(certification, certificate)}});
}

}  // namespace toolcomp::certify
