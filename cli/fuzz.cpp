// SPDX-License-Identifier: Apache-2.0
// toolcomp fuzz: the search for differences, by the clang targets of build/fuzz, or by the built-in driver.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/fuzzing/campaign.h"
#include "certify/judge.h"
#include "cli/controller.h"
#include "cli/fuzz_bench.h"
#include "cli/fuzz_findings.h"
#include "cli/manners.h"
#include "cli/program.h"
#include "cli/progress.h"
#include "cli/stop.h"
#include "cli/verbs.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/summary.h"
#include "fuzz/campaign/target.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

namespace fs = std::filesystem;
namespace fuzzing = certify::fuzzing;

[[noreturn]] void usage(const std::string& message) { throw spec::InputError("toolcomp fuzz", 0, 0, message); }

constexpr std::array kModes = {fuzz::Mode::directed, fuzz::Mode::unrestricted};

struct Plan {
  std::vector<std::string> sections;
  std::uint64_t seconds = 0;  // a section
  std::uint64_t runs = 0;     // a section, instead of seconds
};

Plan plan_of(const FuzzOptions& options) {
  Plan plan;
  plan.sections = options.sections;
  if (plan.sections.empty())
    for (const std::string_view section : fuzz::sections()) plan.sections.emplace_back(section);
  for (const std::string& section : plan.sections)
    if (std::ranges::find(fuzz::sections(), section) == fuzz::sections().end())
      usage("no section " + section + "; `toolcomp spec sections` lists them");
  if (options.runs > 0 && !options.duration.empty()) usage("--for or --runs, not both");
  plan.runs = options.runs;
  if (plan.runs == 0)
    plan.seconds =
        static_cast<std::uint64_t>(duration_of(options.duration.empty() ? "60s" : options.duration, "--for").count());
  return plan;
}

// Half the time and half the runs for each twin.
fuzz::CampaignResult built_in(const std::string& section, fuzz::Mode mode, const Plan& plan, const FuzzOptions& options,
                              FuzzFindings& findings, const Stop& stop) {
  fuzz::CampaignOptions campaign;
  campaign.sections = {section};
  campaign.modes = {mode};
  campaign.seconds = static_cast<double>(plan.seconds) / 2;
  campaign.runs = (plan.runs + 1) / 2;
  campaign.jobs = options.jobs;
  campaign.seed = options.seed;
  if (!options.controller.empty())
    campaign.subject = [&](unsigned) {
      return controller_subject(options.controller, options.timeout, options.accept_resolution, findings.watch());
    };
  campaign.on_finding = [&findings](const fuzz::Finding& found) { findings.seen(found); };
  campaign.stop = [&stop] { return !stop.why().empty(); };
  campaign.progress = [&findings](const fuzz::CampaignProgress& p) {
    findings.progress(p.executions);
    Progress::line(fmt::format("{} executions, {:.0f} s, {} features, {} findings", p.executions, p.seconds, p.reached,
                               p.findings));
  };
  return fuzz::run_campaign(campaign);
}

// The clang targets work as a campaign in a folder among the findings, so that nothing is lost with this process.
fuzzing::CampaignOptions campaign_of(const FuzzOptions& options, const Stop& stop) {
  fuzzing::CampaignOptions campaign;
  campaign.folder = fs::path(options.findings) / "running";
  campaign.bench = fuzz_bench(options);
  campaign.jobs = std::max(1U, options.jobs);
  campaign.seed = options.seed;
  campaign.stop = [&stop] { return !stop.why().empty(); };
  campaign.show = [](const fuzzing::BoardView& view) { Progress::line(fuzzing::plain_line(view)); };
  return campaign;
}

// Its findings become those of this run, and its folder goes; where somebody ended it before all was looked at, the
// next run takes up the rest.
void adopt(const fs::path& folder, FuzzFindings& findings, std::optional<fuzz::NotDecided>& open) {
  for (const certify::Finding& finding : fuzzing::findings_in(folder / "findings")) findings.adopt(finding);
  for (const certify::Finding& finding : fuzzing::findings_in(folder / "open"))
    fuzz::keep_shortest(open, {finding.smallest, finding.actual});
  if (fuzzing::Folder(folder).waiting().empty()) {
    fs::remove_all(folder);
    return;
  }
  for (const char* const part : {"findings", "open"})
    for (const fs::path& dossier : fuzzing::dossiers_in(folder / part)) fs::remove_all(dossier);
}

// What targets had found when an earlier run was ended by a kill.
void settle_earlier(const FuzzOptions& options, FuzzFindings& findings, const Stop& stop) {
  fuzzing::CampaignOptions campaign = campaign_of(options, stop);
  if (!fs::exists(campaign.folder / "state.json")) return;
  campaign.seconds = 0;
  campaign.targets = {&fuzz::targets().front()};
  fuzzing::run_campaign(campaign);
  std::optional<fuzz::NotDecided> open;
  adopt(campaign.folder, findings, open);
}

// Of both targets of a section, directed first.
std::vector<fuzz::CampaignResult> clang_targets(const std::string& section, const Plan& plan,
                                                const FuzzOptions& options, FuzzFindings& findings, const Stop& stop) {
  fuzzing::CampaignOptions campaign = campaign_of(options, stop);
  for (const fuzz::Mode mode : kModes) campaign.targets.push_back(fuzz::find_target(fuzz::twin_name(section, mode)));
  campaign.runs = (plan.runs + 1) / 2;
  if (plan.runs == 0) campaign.seconds = plan.seconds;
  const fuzzing::CampaignEnd end = fuzzing::run_campaign(campaign);
  std::vector<fuzz::CampaignResult> results;
  for (const fuzz::Target* target : campaign.targets) {
    const auto known = end.state.targets.find(target->name);
    fuzz::CampaignResult result = known == end.state.targets.end() ? fuzz::CampaignResult{} : known->second.sum;
    if (known != end.state.targets.end()) {
      // The seconds of all workers, as if of one.
      result.seconds = static_cast<double>(known->second.milliseconds) / 1000;
      result.cores = 1;
      result.per_second_per_core = result.seconds > 0 ? static_cast<double>(result.executions) / result.seconds : 0;
    }
    results.push_back(std::move(result));
  }
  std::optional<fuzz::NotDecided> open;
  adopt(campaign.folder, findings, open);
  for (fuzz::CampaignResult& result : results)
    if (result.acceptance.at(static_cast<std::size_t>(fuzz::Acceptance::not_decided)) > 0)
      result.not_decided = std::exchange(open, std::nullopt);
  return results;
}

void print_summary(const std::string& section, fuzz::Mode mode, const fuzz::CampaignResult& result, bool clang) {
  fmt::print("{}, {}: {} executions in {:.1f} s, {:.0f} executions/s a core ({})\n", section,
             mode == fuzz::Mode::directed ? "directed" : "unrestricted", result.executions, result.seconds,
             result.per_second_per_core, clang ? "clang targets" : "built-in driver");
  fmt::print("  accepted {:.1f} %", 100 * result.accepted_share());
  for (std::size_t i = 1; i < fuzz::kAcceptances; ++i)
    if (result.acceptance.at(i) > 0)
      fmt::print(", {} {}", result.acceptance.at(i), fuzz::name(static_cast<fuzz::Acceptance>(i)));
  fmt::print(
      "\n  {} values judged, {} questions of laws, {} decisions, {} near ties, {} ties ({:.4f} % of decisions)\n",
      result.values, result.law_checks, result.decisions, result.near_ties, result.ties,
      result.decisions == 0 ? 0 : 100 * static_cast<double>(result.ties) / static_cast<double>(result.decisions));
  fmt::print("  {} values not judged, {} events out of scope, {} executions with fewer than three events judged\n",
             result.wide, result.out_of_scope, result.few_events);
  fmt::print("  worst deviation {:.3g} ulp, {:.3g} µm\n", result.worst_ulp, result.worst_um);
  if (const auto& open = result.not_decided)
    fmt::print("  could not decide the case below: {}\n{}\n", open->why, fuzz::encode(open->input));
}

}  // namespace

int fuzz(const FuzzOptions& options) {
  for (const auto& [given, option] : {std::pair{!options.targets.empty(), "--target"},
                                      std::pair{!options.shard.empty(), "--shard"}, std::pair{options.json, "--json"}})
    if (given) usage(std::string(option) + " needs --campaign");
  const Plan plan = plan_of(options);
  expect_folder(options.findings, "--findings");
  fmt::print("seed {}\n", options.seed);
  detail(fmt::format("{} jobs; findings go to {}", options.jobs, options.findings));
  const Stop stop;
  FuzzFindings findings(options, [&stop] { return !stop.why().empty(); });
  settle_earlier(options, findings, stop);
  const fuzzing::Bench bench = fuzz_bench(options);
  std::string not_run;
  bool nothing_judged = false;
  bool undecided = false;
  bool wide = false;
  for (const std::string& section : plan.sections) {
    if (!stop.why().empty()) {
      not_run += (not_run.empty() ? "" : ", ") + section;
      continue;
    }
    const bool clang = bench.has_clang(*fuzz::find_target(fuzz::twin_name(section, fuzz::Mode::directed)));
    detail(section + (clang ? ": clang targets" : ": built-in driver") +
           (options.controller.empty() ? ", engine fast" : ", controller " + options.controller));
    const Progress progress("executions");
    fuzz::CampaignResult sum;
    std::vector<fuzz::CampaignResult> results;
    if (clang) results = clang_targets(section, plan, options, findings, stop);
    for (const fuzz::Mode mode : kModes) {
      if (!clang && !stop.why().empty()) break;
      const auto at = static_cast<std::size_t>(mode);
      if (!clang) results.push_back(built_in(section, mode, plan, options, findings, stop));
      const fuzz::CampaignResult& result = results[at];
      print_summary(section, mode, result, clang);
      nothing_judged = nothing_judged || result.values == 0;
      undecided = undecided || result.acceptance.at(static_cast<std::size_t>(fuzz::Acceptance::not_decided)) > 0;
      fuzz::add(sum, result);
    }
    if (certify::too_many_wide(sum.values, sum.wide)) {
      fmt::print("  {}\n", certify::words_on_wide(sum.values, sum.wide));
      wide = true;
    }
    static_cast<void>(std::fflush(stdout));
    fuzz::print_outcomes(std::cout, section, sum.clauses);
    std::cout.flush();
    findings.settle(sum);
  }
  if (!stop.why().empty()) fmt::print("{}{}\n", stop.why(), not_run.empty() ? "" : "; not run: " + not_run);
  fmt::print("{}{}\n", findings.count() == 0 ? "no finding" : fmt::format("{} findings", findings.count()),
             wide ? "; more than 1 % of a section not judged" : "");
  if (findings.count() > 0) return kDiffers;
  return nothing_judged || undecided || wide || !stop.why().empty() ? kUndecided : kAgrees;
}

}  // namespace toolcomp::cli
