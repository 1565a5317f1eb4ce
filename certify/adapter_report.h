// SPDX-License-Identifier: Apache-2.0
// The report of a batch of recorded programs.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "certify/adapter_run.h"

namespace toolcomp::certify {

std::string html_report(const AdapterCertificationOptions& certification, const AdapterCertificate& certificate);
std::string json_report(const AdapterCertificationOptions& certification, const AdapterCertificate& certificate);

// One test suite for each machine, one test case for each program.
std::string junit_report(const AdapterCertificate& certificate);
// SARIF 2.1.0: one result for each finding, at its sample.
std::string sarif_report(const AdapterCertificate& certificate);

// index.html, certificate.json, junit.xml and certificate.sarif in the folder of the report, and the report of its
// trace in the folder of each program that differs. Throws std::runtime_error for a folder that cannot be written.
void write_report(const AdapterCertificationOptions& certification, const AdapterCertificate& certificate);

// Runs of one machine, or of given programs; for the table of the report and the terminal.
struct MachineSummary {
  std::string machine;  // empty: given programs
  std::size_t programs = 0;
  std::array<std::size_t, kRunOutcomes> outcomes{};
  std::uint64_t samples = 0;
  double worst = 0;         // largest accepted distance, setup units
  double worst_rotary = 0;  // degrees
};
std::vector<MachineSummary> summaries(const AdapterCertificate& certificate);

// A mistake that explains the findings of each of some programs (docs/trace.md), the most frequent first. The figures
// of one kind of mistake differ from program to program; these are the figures of the first program.
struct LikelyCause {
  std::string cause;
  std::size_t programs = 0;
};
std::vector<LikelyCause> likely_causes(const AdapterCertificate& certificate);

// Programs that were interrupted before they were judged.
std::size_t not_run(const AdapterCertificate& certificate);

// "conforms", "does not conform", "not decided", "not decided: interrupted".
std::string_view verdict(const AdapterCertificate& certificate);

}  // namespace toolcomp::certify
