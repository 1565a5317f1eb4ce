// SPDX-License-Identifier: Apache-2.0
// The certificate of a kit: JSON and a page.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "certify/kit/judge.h"
#include "certify/kit/kit_json.h"
#include "certify/markup.h"
#include "certify/page.h"
#include "certify/report.h"
#include "host/file_writer.h"
#include "host/sha256.h"

namespace toolcomp::certify::kit {
namespace {

using Json = nlohmann::ordered_json;

std::string_view sentence(const KitVerdict& verdict) {
  switch (exit_status(verdict)) {
    case 0:
      return "complete: all programs and alarms of the kit conform";
    case 1:
      return "does not conform";
    default:
      return "not complete";
  }
}

const KitProgram& program_of(const Kit& kit, unsigned number) {
  return *std::ranges::find(kit.programs, number, &KitProgram::number);
}

Json json_of(const Bounds& bounds) { return {{"lower", bounds.lower}, {"upper", bounds.upper}}; }

Json json_of(const KitVerdict& verdict, const JudgedProgram& judged) {
  Json json;
  json["program"] = judged.number;
  json["verdict"] = name(judged.verdict);
  json["recording"] = judged.file;
  json["why"] = judged.why;
  json["samples"] = judged.trace.samples;
  json["off"] = judged.trace.off;
  json["corners"] = judged.trace.corners;
  json["corners_missed"] = judged.trace.corners_missed;
  json["worst"] = json_of(judged.trace.worst);
  json["worst_rotary"] = json_of(judged.trace.worst_rotary);
  if (judged.trace.cause) json["cause"] = *judged.trace.cause;
  json["axes_not_recorded"] = judged.trace.not_recorded;
  json["cases_off"] = Json::array();
  for (const std::size_t i : judged.cases_off)
    json["cases_off"].push_back(program_of(verdict.kit, judged.number).cases[i].id);
  json["findings"] = Json::array();
  for (const TraceFinding& finding : judged.trace.findings) {
    Json entry;
    entry["kind"] = finding.kind;
    entry["sample"] = finding.sample;
    entry["line"] = finding.line;
    entry["distance"] = json_of(finding.distance);
    entry["rotary"] = json_of(finding.rotary);
    json["findings"].push_back(std::move(entry));
  }
  return json;
}

std::string json_text(const KitVerdict& verdict) {
  Json json;
  json["kit_certificate"] = 1;
  json["verdict"] = sentence(verdict);
  json["tool"] = "toolcomp " TOOLCOMP_VERSION;
  json["kit"] = verdict.kit.digest;
  json["corpus"] = verdict.kit.corpus;
  json["corpus_hash"] = verdict.kit.corpus_hash;
  json["tolerance"] = verdict.tolerance;
  json["outcomes"] = verdict.kit.outcomes;
  json["outcomes_of_the_kit"] = verdict.kit.recorded + verdict.kit.noted;
  json["outcomes_shown"] = verdict.shown;
  json["programs"] = Json::array();
  for (const JudgedProgram& judged : verdict.programs) json["programs"].push_back(json_of(verdict, judged));
  json["alarms"] = Json::array();
  for (const JudgedAlarm& judged : verdict.alarms) {
    Json entry;
    entry["program"] = judged.number;
    entry["verdict"] = name(judged.verdict);
    entry["expected"] = program_of(verdict.kit, judged.number).alarm;
    entry["noted"] = judged.noted;
    json["alarms"].push_back(std::move(entry));
  }
  json["strangers"] = verdict.strangers;
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Tone tone_of(ProgramVerdict verdict) {
  return verdict == ProgramVerdict::conforms ? Tone::good : verdict == ProgramVerdict::differs ? Tone::bad : Tone::open;
}

Tone tone_of(AlarmVerdict verdict) {
  return verdict == AlarmVerdict::as_expected ? Tone::good
         : verdict == AlarmVerdict::not_noted ? Tone::open
                                              : Tone::bad;
}

std::string programs(const KitVerdict& verdict) {
  std::vector<Row> rows{{"Program", "Verdict", "Recording", "Findings", "Samples", "Corners missed", "Worst accepted"}};
  for (const JudgedProgram& judged : verdict.programs) {
    std::string findings = escape(judged.why);
    if (judged.trace.cause) findings += "one mistake explains everything: " + escape(*judged.trace.cause);
    for (const TraceFinding& finding : judged.trace.findings)
      findings += fmt::format("{}{} of line {}, sample on line {}, by {}", findings.empty() ? "" : "<br/>",
                              escape(finding.kind), finding.line, finding.sample, escape(extent(finding)));
    rows.push_back({program_name(verdict.kit.machine.setup.control, judged.number),
                    badge(name(judged.verdict), tone_of(judged.verdict)), escape(judged.file), findings,
                    std::to_string(judged.trace.samples),
                    fmt::format("{} of {}", judged.trace.corners_missed, judged.trace.corners),
                    plain(judged.trace.worst.upper, 6)});
  }
  return "<h2>Recorded programs</h2>\n" + table(rows, 4);
}

std::string alarms(const KitVerdict& verdict) {
  if (verdict.alarms.empty()) return {};
  std::vector<Row> rows{{"Program", "Verdict", "Expected", "Noted"}};
  for (const JudgedAlarm& judged : verdict.alarms) {
    const KitProgram& program = program_of(verdict.kit, judged.number);
    rows.push_back({program_name(verdict.kit.machine.setup.control, judged.number),
                    badge(name(judged.verdict), tone_of(judged.verdict)),
                    escape(program.alarm) + fmt::format(", block {}", program.alarm_n), escape(judged.noted)});
  }
  return "<h2>Noted alarms</h2>\n" + table(rows);
}

std::string html(const KitVerdict& verdict) {
  const int status = exit_status(verdict);
  const Tone tone = status == 0 ? Tone::good : status == 1 ? Tone::bad : Tone::open;
  std::string body = "<h1>Certificate of a kit</h1>\n<p>" + badge(sentence(verdict), tone) + "</p>\n";
  body += facts({{"Kit", "<code>" + escape(verdict.kit.digest) + "</code>, made by " + escape(verdict.kit.tool)},
                 {"Golden corpus", escape(verdict.kit.corpus)},
                 {"Tolerance", plain(verdict.tolerance, 6)},
                 {"Clause outcomes", fmt::format("{} shown, of {} that the kit can show, of {} in all", verdict.shown,
                                                 verdict.kit.recorded + verdict.kit.noted, verdict.kit.outcomes)}});
  for (const std::string& stranger : verdict.strangers)
    body += "<p>The mark of a program that is not in the kit: " + escape(stranger) + "</p>\n";
  return page("toolcomp kit: certificate", body + programs(verdict) + alarms(verdict));
}

}  // namespace

void write_certificate(const KitVerdict& verdict, const std::filesystem::path& folder) {
  host::write_files({{folder / "certificate.json", json_text(verdict)}, {folder / "index.html", html(verdict)}});
}

}  // namespace toolcomp::certify::kit
