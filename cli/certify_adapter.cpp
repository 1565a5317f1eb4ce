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
#include "spec/language/decimal.h"
#include "spec/language/file_writer.h"
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

void print(const certify::AdapterCampaign& campaign, const certify::AdapterCertificate& certificate) {
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
  if (!certificate.errors.empty()) std::cerr << campaign.adapter.name << ": " << certificate.errors << '\n';
  if (!certificate.interrupted.empty())
    fmt::print("{} programs not run: {}\n", certify::not_run(certificate), certificate.interrupted);
  fmt::print("{}; seed {}; {:.0f} s run, {:.0f} s judged; {}\n", certify::verdict(certificate), campaign.seed,
             certificate.seconds_run, certificate.seconds_judged, campaign.report + "/index.html");
}

}  // namespace

void write_badge(const CertifyOptions& options, const std::string& badge) {
  if (!options.badge.empty()) spec::write_file(options.badge, badge);
}

int certify_adapter(const CertifyOptions& options, const certify::Adapter& adapter, std::vector<spec::Case> cases,
                    const Tolerances& tolerances, const certify::Occasion& occasion) {
  if (!options.corpus.empty() || !options.sections.empty() || options.widths)
    throw spec::InputError("toolcomp certify", 0, 0,
                           "--corpus, --section and --widths are not for a recorded controller");
  certify::AdapterCampaign campaign;
  campaign.adapter = adapter;
  campaign.show_known = options.inputs.empty() && options.setup.empty();
  campaign.generated = options.cases.value_or(cases.empty() ? kPrograms : 0);
  if (options.inputs.empty() && !options.setup.empty()) campaign.adapter.setups = {options.setup};
  campaign.cases = std::move(cases);
  campaign.seed = options.seed;
  campaign.tolerance = tolerances.linear;
  campaign.rotary_tolerance = tolerances.rotary;
  campaign.timeout = std::chrono::milliseconds(std::llround(options.timeout * 1000));
  campaign.report = options.report;
  for (const std::string& text : options.altered) campaign.altered.insert(read_altered(text));
  campaign.progress = [](const std::string& line) { note(line); };
  detail(fmt::format("adapter {} of {}; {} programs read, {} generated, seed {}", adapter.name, adapter.folder.string(),
                     campaign.cases.size(), campaign.generated, campaign.seed));
  certify::RunningMark mark(options.report, adapter.name);
  if (mark.earlier()) {
    const auto aside = certify::set_aside(std::filesystem::path(options.report) / "runs");
    note(options.report + ": " + certify::words(*mark.earlier()) +
         (aside ? "; its recordings are in " + aside->string() : ""));
  }
  const Stop stop(options.time_limit.empty() ? std::nullopt
                                             : std::optional(duration_of(options.time_limit, "--time-limit")));
  campaign.stop = [&stop] { return stop.why(); };
  certify::AdapterCertificate certificate = certify::certify_adapter(campaign);
  certificate.occasion = occasion;
  certify::write_report(campaign, certificate);
  write_badge(options, certify::badge_json(certificate));
  print(campaign, certificate);
  return certify::exit_status(certificate);
}

}  // namespace toolcomp::cli
