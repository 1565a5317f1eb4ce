// SPDX-License-Identifier: Apache-2.0
#include "cli/fuzz_findings.h"
#include "cli/manners.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <utility>

#include "certify/report.h"
#include "certify/voices.h"
#include "spec/language/file_writer.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

namespace fs = std::filesystem;

std::chrono::milliseconds timeout_of(const FuzzOptions& options) {
  return std::chrono::milliseconds(std::llround(options.timeout * 1000));
}

certify::EvidenceOptions evidence_of(const FuzzOptions& options, const std::function<bool()>& stop) {
  certify::EvidenceOptions evidence;
  evidence.timeout = timeout_of(options);
  evidence.stop = stop;
  return evidence;
}

certify::Finding as_found(const fuzz::Finding& found) {
  certify::Finding finding;
  finding.smallest = found.input;
  finding.first_case = found.input.id;
  finding.key = {found.input.section,
                 found.difference.clause ? std::string(spec::info(*found.difference.clause).id) : "",
                 found.difference.kind};
  finding.line = found.difference.line;
  finding.field = found.difference.field;
  finding.expected = found.difference.expected;
  finding.actual = found.difference.actual;
  finding.deviation_um = found.difference.deviation_um;
  finding.complete = false;
  return finding;
}

// With who stands alone, where that can be asked.
certify::Finding with_voices(certify::Finding finding, certify::Subject& subject, std::string_view name) {
  if (!certify::is_fault(finding.key) && finding.before.empty())
    finding.alone = certify::ask_all(finding.smallest, subject, name).words;
  return finding;
}

// A name that no file of the folder has.
fs::path free_file(const fs::path& folder, const certify::Finding& finding) {
  for (std::size_t n = 0;; ++n) {
    const std::string name = certify::file_name(finding, n);
    const std::string number = name.substr(0, name.find('-') + 1);
    bool taken = false;
    if (fs::is_directory(folder))
      for (const auto& entry : fs::directory_iterator(folder))
        taken = taken || entry.path().filename().string().starts_with(number);
    if (!taken) return folder / name;
  }
}

}  // namespace

FuzzFindings::FuzzFindings(const FuzzOptions& options, std::function<bool()> stop)
    : options_(options), stop_(std::move(stop)), folder_(options.findings), mark_(folder_, options.controller) {
  if (mark_.earlier()) note(options.findings + ": " + certify::words(*mark_.earlier()) + "; what it found is there");
}

Watch FuzzFindings::watch() {
  return {[this](const certify::FailureKey& key, const std::string& program) -> std::optional<std::size_t> {
            const std::scoped_lock lock(mutex_);
            const std::size_t number = groups_.cases();
            if (stop_() || !groups_.add(key, number, program)) return std::nullopt;
            return number;
          },
          [this](const certify::Capabilities& able, std::size_t number, certify::Witness witness) {
            const std::scoped_lock lock(mutex_);
            able_ = able;
            const certify::Finding seen = signed_by_us(certify::as_seen(able, witness));
            if (groups_.keep(seen.key, number, std::move(witness))) write(seen);
          }};
}

void FuzzFindings::seen(const fuzz::Finding& found) {
  if (!options_.controller.empty() || stop_()) return;
  const std::scoped_lock lock(mutex_);
  write(signed_by_us(as_found(found)));
}

void FuzzFindings::settle(const fuzz::CampaignResult& result) {
  if (options_.controller.empty()) {
    for (const fuzz::Finding& found : result.findings) {
      certify::Finding finding = settled(found);
      // Its file is that of how it was seen, even where looking again names another clause.
      if (auto seen = files_.extract(as_found(found).key); !seen.empty()) {
        seen.key() = finding.key;
        files_.insert(std::move(seen));
      }
      settle(std::move(finding), found.executions);
    }
    return;
  }
  const auto subject = certify::subject_of(options_.controller, timeout_of(options_));
  static_cast<void>(subject->capabilities());
  const certify::FailureGroups groups = std::exchange(groups_, {});
  for (const auto& [key, group] : groups.all())
    settle(with_voices(certify::make_finding(*subject, able_, group.witness, evidence_of(options_, stop_)), *subject,
                       "controller"),
           group.cases);
}

// Judged again and shrunk; as it was found where there is no run to shrink.
certify::Finding FuzzFindings::settled(const fuzz::Finding& found) const {
  const auto subject = certify::built_in_engine();
  const auto able = std::get<certify::Capabilities>(subject->capabilities());
  try {
    const fuzz::ModelRun run = fuzz::run_model(found.input);
    const certify::Answer answer = subject->run(found.input);
    certify::Judgement judgement = certify::judge_answer(able, found.input, run, answer);
    if (judgement.result == certify::Result::differs)
      return with_voices(certify::make_finding(
                             *subject, able, {found.input, std::move(judgement), certify::events_in_double(answer), {}},
                             evidence_of(options_, stop_)),
                         *subject, certify::kFastEngine);
  } catch (const spec::InputError&) {  // NOLINT(bugprone-empty-catch)
    // One engine refuses the setup and the other does not: there is no run to shrink.
  }
  return as_found(found);
}

certify::Finding FuzzFindings::signed_by_us(certify::Finding finding) const {
  return certify::signed_finding(std::move(finding), options_.controller, options_.seed);
}

void FuzzFindings::write(const certify::Finding& finding) {
  const auto [place, fresh] = files_.try_emplace(finding.key);
  if (fresh) place->second = free_file(folder_, finding);
  spec::write_file(place->second, certify::write_finding(finding));
}

void FuzzFindings::settle(certify::Finding finding, std::uint64_t executions) {
  finding = signed_by_us(std::move(finding));
  finding.occurrences = executions;
  write(finding);
  print(files_.at(finding.key), finding);
}

void FuzzFindings::adopt(certify::Finding finding) {
  finding = signed_by_us(std::move(finding));
  const fs::path file = free_file(folder_, finding);
  spec::write_file(file, certify::write_finding(finding));
  ++adopted_;
  print(file, finding);
}

void FuzzFindings::print(const fs::path& file, const certify::Finding& finding) {
  fmt::print("FINDING {}{}\n{}", file.string(), certify::how_it_comes(finding), finding.smallest.program);
  fmt::print("  {}\n", certify::explanation(finding));
  if (!finding.alone.empty()) fmt::print("  {}\n", finding.alone);
  fmt::print("  toolcomp replay {}\n", file.string());
}

}  // namespace toolcomp::cli
