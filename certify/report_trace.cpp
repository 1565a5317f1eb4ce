// SPDX-License-Identifier: Apache-2.0
// The page of a judged trace.
#include <fmt/format.h>

#include <algorithm>

#include "certify/markup.h"
#include "certify/page.h"
#include "certify/path_svg.h"
#include "certify/report.h"
#include "certify/trace_svg.h"
#include "certify/view/view.h"

namespace toolcomp::certify {
namespace {

std::string place(const spec::Axes& axes, const spec::AxisValues<double>& values) {
  std::string out;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (values.has(i)) out += (out.empty() ? "" : " ") + std::string(1, axes.letter(i)) + plain(values[i], 6);
  return out;
}

std::string moves(const TraceFinding& f) {
  const auto name = [](std::uint64_t line, const std::optional<std::uint64_t>& n) {
    return n ? fmt::format("N{} (line {})", *n, line) : fmt::format("line {}", line);
  };
  return name(f.line, f.n) + (f.last_line == f.line ? "" : " to " + name(f.last_line, f.last_n));
}

std::string findings(const TraceReport& report) {
  const TraceResult& r = report.result;
  if (r.findings_total == 0) return "<p>None.</p>\n";
  std::vector<Row> rows{{"kind", "program", "position", "CSV line", "samples", "by"}};
  for (const TraceFinding& f : r.findings)
    rows.push_back({escape(f.kind), moves(f), "<code>" + escape(place(report.c.setup.axes, f.at)) + "</code>",
                    std::to_string(f.sample), std::to_string(f.samples), extent(f)});
  std::string out = table(rows, 3);
  if (r.findings_total > r.findings.size())
    out += fmt::format("<p class=\"soft\">The first {} of {}.</p>\n", r.findings.size(), r.findings_total);
  return out;
}

std::string first_page(const TraceReport& report, std::string_view verdict, std::string_view unit, bool turns) {
  const TraceResult& r = report.result;
  const int status = exit_status(r);
  std::string out = "<section class=\"first\">\n<h1>Trace " + escape(report.file) + "</h1>\n<p>" +
                    badge(verdict, status == 0   ? Tone::good
                                   : status == 1 ? Tone::bad
                                                 : Tone::open) +
                    "</p>\n";
  if (!r.undecided.empty()) out += "<p>" + escape(r.undecided) + ".</p>\n";
  const std::string rotary =
      turns ? " and " + plain(report.options.rotary_tolerance.value_or(report.options.tolerance), 9) + " degrees" : "";
  out += fmt::format(
      "<p>{} samples were judged against the exact path with a tolerance of {} {}{}. {} samples are off the path, {} "
      "of {} corners were not reached, and {} {} of {} are covered.</p>\n",
      r.samples, plain(report.options.tolerance, 9), unit, rotary, r.off, r.corners_missed, r.corners,
      plain(r.covered, 6), unit, plain(r.length, 6));
  if (r.cause) out += "<p><b>One mistake explains everything found:</b> " + escape(*r.cause) + ".</p>\n";
  out += "<h2>Not judged</h2>\n" +
         facts({{"axes not recorded", r.not_recorded.empty() ? "none" : escape(r.not_recorded)},
                {"moves judged at their ends only", std::to_string(r.not_judged_moves)},
                {"long time steps, because the recording has no steady period", std::to_string(r.steps_not_judged)}});
  std::vector<Row> figures{
      {"axes judged", escape(r.recorded)},
      {"largest accepted distance", fmt::format("{} {} (CSV line {})", plain(r.worst.upper, 9), unit, r.worst_sample)},
      {"largest accepted distance of a rotary axis",
       turns ? fmt::format("{} degrees (CSV line {})", plain(r.worst_rotary.upper, 9), r.worst_rotary_sample)
             : std::string("none recorded")}};
  for (Row& row : rows(report.occasion)) figures.push_back(std::move(row));
  figures.push_back({"tool", "toolcomp " TOOLCOMP_VERSION});
  out += "<h2>Figures</h2>\n" + facts(figures);
  return out + std::string(kSignature) + "</section>\n";
}

}  // namespace

std::string html_report(const TraceReport& report) {
  const TraceResult& r = report.result;
  const spec::Setup& setup = report.c.setup;
  PathOptions drawing = path_options(report.c);
  const std::uint64_t marked = r.findings.empty() ? 0 : r.findings.front().line;
  if (const auto event = std::ranges::find(r.events, marked, &spec::Event<double>::line); event != r.events.end())
    drawing.marked = static_cast<std::size_t>(event - r.events.begin());
  const std::string& unit = drawing.unit;
  const int status = exit_status(r);
  const std::string_view verdict = status == 0 ? "conforms" : status == 1 ? "does not conform" : "not decided";
  const bool turns = std::ranges::any_of(r.recorded, spec::is_rotary_axis);
  std::string body = first_page(report, verdict, unit, turns);
  body += "<h2>Findings</h2>\n" + findings(report);
  if (const std::string picture = trace_svg(r, setup.axes, unit); !picture.empty())
    body += "<h2>Recording</h2>\n" + picture + "\n";
  body += "<h2>Deviations</h2>\n" + deviation_svg(r, report.options, unit) + "\n";
  body += "<h2>Path</h2>\n";
  const std::string picture = path_svg(r.events, setup.axes, drawing);
  // The events are in workpiece coordinates.
  if (report.options.frame == PathFrame::workpiece)
    body += view("Path and recording", report.c, view_run(report.c, r.events), {drawing, view_samples(r, setup.axes)},
                 picture);
  else
    body += picture;
  return page("toolcomp trace: " + std::string(verdict), body + listing(report.c.program, marked));
}

}  // namespace toolcomp::certify
