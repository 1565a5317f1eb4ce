#include "certify/adapter_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "certify/markup.h"
#include "certify/page.h"
#include "certify/report.h"
#include "certify/sort_by.h"
#include "spec/language/file_writer.h"

namespace toolcomp::certify {
namespace {

std::string known_differences(const AdapterCampaign& campaign, const AdapterCertificate& certificate) {
  std::vector<Row> rows{{"known difference", "why", "how it is told", "programs"}};
  for (const KnownDifference& known : campaign.adapter.known) {
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
                         "not applicable", "undecided", "failed", "samples", "largest distance",
                         "of a rotary axis, degrees"}};
  for (const MachineSummary& m : summaries(certificate)) {
    Row row{m.machine.empty() ? "programs" : escape(m.machine), std::to_string(m.programs)};
    for (const std::size_t count : m.outcomes) row.push_back(std::to_string(count));
    row.push_back(std::to_string(m.samples));
    row.push_back(plain(m.worst, 6));
    row.push_back(plain(m.worst_rotary, 6));
    rows.push_back(std::move(row));
  }
  return table(rows, 1);
}

std::string causes(const AdapterCertificate& certificate) {
  std::vector<Row> rows{{"one mistake that explains what was found", "programs"}};
  for (const LikelyCause& likely : likely_causes(certificate))
    rows.push_back({escape(likely.cause), std::to_string(likely.programs)});
  return rows.size() == 1 ? "" : "<h2>What it looks like</h2>\n" + table(rows, 1);
}

// What did not conform, with its program.
std::string others(const AdapterCertificate& certificate) {
  std::string out;
  for (const AdapterRun& run : certificate.runs) {
    if (run.outcome == RunOutcome::conforms || run.outcome == RunOutcome::not_applicable) continue;
    const Tone tone = run.outcome == RunOutcome::differs                                           ? Tone::bad
                      : run.outcome == RunOutcome::both_refuse || run.outcome == RunOutcome::known ? Tone::good
                                                                                                   : Tone::open;
    out += "<h3>" + badge(name(run.outcome), tone) + " " + escape(run.c.id) + "</h3>\n";
    for (const std::string& id : run.known) out += "<p><code>" + escape(id) + "</code></p>\n";
    if (!run.why.empty()) out += "<p>" + escape(run.why) + "</p>\n";
    if (run.result.cause) out += "<p>Looks like: " + escape(*run.result.cause) + "</p>\n";
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

std::string_view verdict(const AdapterCertificate& certificate) {
  const int status = exit_status(certificate);
  return status == 0 ? "conforms" : status == 1 ? "does not conform" : "not decided";
}

std::string html_report(const AdapterCampaign& campaign, const AdapterCertificate& certificate) {
  const int status = exit_status(certificate);
  std::string body = "<h1>" + escape(campaign.adapter.name) + "</h1>\n<p>" +
                     badge(verdict(certificate), status == 0   ? Tone::good
                                                 : status == 1 ? Tone::bad
                                                               : Tone::open) +
                     "</p>\n";
  body += fmt::format(
      "<p>{} programs were run and recorded in {:.0f} s, and judged against the exact path in {:.0f} s, with a "
      "tolerance "
      "of {}; seed {}.</p>\n",
      certificate.runs.size(), certificate.seconds_run, certificate.seconds_judged, plain(certificate.tolerance, 9),
      campaign.seed);
  if (!certificate.errors.empty()) body += "<p>The adapter: " + escape(certificate.errors) + "</p>\n";
  body += machines(certificate) + causes(certificate);
  body += "<h2>Known differences</h2>\n" + known_differences(campaign, certificate);
  body += "<h2>Programs that do not simply conform</h2>\n" + others(certificate);
  body += facts({{"tool", "toolcomp " TOOLCOMP_VERSION}});
  return page("toolcomp: " + campaign.adapter.name + " " + std::string(verdict(certificate)), body);
}

std::string json_report(const AdapterCampaign& campaign, const AdapterCertificate& certificate) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["adapter"] = campaign.adapter.name;
  json["exit_status"] = exit_status(certificate);
  json["verdict"] = verdict(certificate);
  json["tool"] = "toolcomp " TOOLCOMP_VERSION;
  json["seed"] = campaign.seed;
  json["tolerance"] = certificate.tolerance;
  json["seconds_run"] = certificate.seconds_run;
  json["seconds_judged"] = certificate.seconds_judged;
  json["errors"] = certificate.errors;
  json["runs"] = Json::array();
  for (const AdapterRun& run : certificate.runs) {
    Json one{{"id", run.c.id},
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

void write_report(const AdapterCampaign& campaign, const AdapterCertificate& certificate) {
  for (const AdapterRun& run : certificate.runs) {
    if (run.outcome != RunOutcome::differs || run.result.samples == 0) continue;
    TraceReport trace;
    trace.c = run.c;
    trace.file = (run.folder / "trace.csv").string();
    trace.options.tolerance = certificate.tolerance;
    trace.options.rotary_tolerance = campaign.rotary_tolerance;
    trace.result = run.result;
    write_report(trace, run.folder / "report");
  }
  const std::filesystem::path folder = campaign.report;
  spec::write_file(folder / "certificate.json", json_report(campaign, certificate));
  spec::write_file(folder / "index.html", html_report(campaign, certificate));
}

}  // namespace toolcomp::certify
