// SPDX-License-Identifier: Apache-2.0
// toolcomp certify --controller NAME: adapters.
#include "cli/certify_adapter.h"
#include "cli/manners.h"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "certify/adapter_report.h"
#include "certify/adapter_run.h"
#include "certify/badge.h"
#include "certify/running_mark.h"
#include "cli/progress.h"
#include "cli/stop.h"
#include "host/file_writer.h"
#include "spec/language/decimal.h"
#include "spec/language/input_error.h"
#include "spec/language/parameter.h"

namespace toolcomp::cli {
namespace {

constexpr std::uint32_t kPrograms = 200;

// "19701=-7.24": what the judge alone is told.
std::pair<spec::ParameterId, spec::Decimal> read_altered(const std::string& text) {
  spec::ParameterId id;
  const char* const end = text.data() + text.size();
  const auto [sign, error] = std::from_chars(text.data(), end, id.number);
  const auto value = error == std::errc{} && sign != end && *sign == '='
                         ? spec::parse_decimal(std::string_view(sign + 1, end))
                         : std::nullopt;
  if (!value || spec::find_parameter(id) == nullptr)
    throw spec::InputError("--altered", 0, 0, "\"" + text + "\" is not PARAMETER=VALUE");
  return {id, *value};
}

void print(const certify::AdapterCertificationOptions& certification, const certify::AdapterCertificate& certificate) {
  for (const certify::MachineSummary& machine : certify::summaries(certificate)) {
    fmt::print("{:<12} {:>4} programs", machine.machine.empty() ? "programs" : machine.machine, machine.programs);
    for (std::size_t i = 0; i < machine.outcomes.size(); ++i)
      if (machine.outcomes.at(i) > 0)
        fmt::print(", {} {}", certify::name(static_cast<certify::RunOutcome>(i)), machine.outcomes.at(i));
    fmt::print(", {} samples, worst {:.3g}, {:.3g} degrees\n", machine.samples, machine.worst, machine.worst_rotary);
  }
  for (const certify::AdapterRun& run : certificate.runs) {
    if (run.outcome == certify::RunOutcome::differs)
      fmt::print("\nFINDING {}: {}\n{}  {}\n", run.c.id, run.why, run.c.program, run.folder.string());
    else if (run.outcome == certify::RunOutcome::undecided || run.outcome == certify::RunOutcome::failed)
      std::cerr << run.c.id << ": " << certify::name(run.outcome) << ", " << run.why << '\n';
  }
  for (const certify::LikelyCause& likely : certify::likely_causes(certificate))
    fmt::print("likely cause, in {} of the programs that differ: {}\n", likely.programs, likely.cause);
  if (!certificate.errors.empty()) std::cerr << certification.adapter.name << ": " << certificate.errors << '\n';
  if (!certificate.interrupted.empty())
    fmt::print("{} programs not run: {}\n", certify::not_run(certificate), certificate.interrupted);
  fmt::print("{}; seed {}; {:.0f} s run, {:.0f} s judged; {}\n", certify::verdict(certificate), certification.seed,
             certificate.seconds_run, certificate.seconds_judged, certification.report + "/index.html");
}

}  // namespace

void write_badge(const CertifyOptions& options, const std::string& badge) {
  if (!options.badge.empty()) host::write_file(options.badge, badge);
}

int certify_adapter(const CertifyOptions& options, const certify::Adapter& adapter, std::vector<spec::Case> cases,
                    const Tolerances& tolerances, const certify::Occasion& occasion) {
  if (!options.corpus.empty() || !options.sections.empty() || options.widths)
    throw spec::InputError("toolcomp certify", 0, 0,
                           "--corpus, --section and --widths are not for a recorded controller");
  certify::AdapterCertificationOptions certification;
  certification.adapter = adapter;
  certification.show_known = options.inputs.empty() && options.setup.empty();
  certification.generated = options.cases.value_or(cases.empty() ? kPrograms : 0);
  if (options.inputs.empty() && !options.setup.empty()) certification.adapter.setups = {options.setup};
  certification.cases = std::move(cases);
  certification.seed = options.seed;
  certification.tolerance = tolerances.linear;
  certification.rotary_tolerance = tolerances.rotary;
  certification.timeout = std::chrono::milliseconds(std::llround(options.timeout * 1000));
  certification.report = options.report;
  for (const std::string& text : options.altered) certification.altered.insert(read_altered(text));
  certification.progress = [](const std::string& line) { note(line); };
  detail(fmt::format("adapter {} of {}; {} programs read, {} generated, seed {}", adapter.name, adapter.folder.string(),
                     certification.cases.size(), certification.generated, certification.seed));
  certify::RunningMark mark(options.report, adapter.name);
  if (mark.earlier()) {
    const auto aside = certify::set_aside(std::filesystem::path(options.report) / "runs");
    note(options.report + ": " + certify::words(*mark.earlier()) +
         (aside ? "; its recordings are in " + aside->string() : ""));
  }
  const Stop stop(options.time_limit.empty() ? std::nullopt
                                             : std::optional(duration_of(options.time_limit, "--time-limit")));
  certification.stop = [&stop] { return stop.why(); };
  certify::AdapterCertificate certificate = certify::certify_adapter(certification);
  certificate.occasion = occasion;
  certify::write_report(certification, certificate);
  write_badge(options, certify::badge_json(certificate));
  print(certification, certificate);
  return certify::exit_status(certificate);
}

}  // namespace toolcomp::cli
