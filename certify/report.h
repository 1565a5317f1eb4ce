// SPDX-License-Identifier: Apache-2.0
// The report of a certification: a page for people, JUnit XML and JSON for programs, and a file for every finding.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "certify/certificate.h"
#include "certify/path_svg.h"
#include "certify/trace/trace.h"
#include "host/file_writer.h"

namespace toolcomp::certify {

// One self-contained HTML page. It loads nothing from outside and is complete without scripts. It is readable on a
// phone and on paper, light and dark.
std::string html_report(const Certificate& certificate);
// One test suite for each section, one test case for each clause: failed if it has findings, skipped if it was not
// exercised.
std::string junit_report(const Certificate& certificate);
// Everything in the page, without the pictures.
std::string json_report(const Certificate& certificate);
// SARIF 2.1.0: one rule for each clause to which a finding is attributed, one result for each group of findings with
// one cause.
std::string sarif_report(const Certificate& certificate);

// index.html, junit.xml, certificate.json, certificate.sarif and findings/NN-KIND.json in `folder`; finding files of an
// earlier report there are removed. Returns the paths of the findings. Throws std::runtime_error for a folder that
// cannot be written.
std::vector<std::filesystem::path> write_report(const Certificate& certificate, const std::filesystem::path& folder);

// Removes the findings of a report in the folder, except these.
void remove_findings(const std::filesystem::path& report, const std::vector<host::FileText>& but = {});

// The same for a trace of program `c`, recorded in `file`.
struct TraceReport {
  spec::Case c;
  std::string file;
  TraceOptions options;
  TraceResult result;
  Occasion occasion;
};
// The size of a finding in words, as distance or time: "0.5", "0.49 to 0.51", "0.1, C 5", "0.2 s".
std::string extent(const TraceFinding& finding);
std::string html_report(const TraceReport& report);
std::string junit_report(const TraceReport& report);
std::string json_report(const TraceReport& report);
std::string sarif_report(const TraceReport& report);
void write_report(const TraceReport& report, const std::filesystem::path& folder);

// The name of a finding's file: "01-hang.json".
std::string file_name(const Finding& finding, std::size_t index);
// One or two sentences on what differs.
std::string explanation(const Finding& finding);
// The same, preceded by the clause it rests on and how well that is known.
std::string accusation(const Finding& finding);
// For a finding that is not reproduced every time and by itself: ", after 49 requests before it", ", in 3 of 10 runs",
// ", not settled: no time was left".
std::string how_it_comes(const Finding& finding);

}  // namespace toolcomp::certify
