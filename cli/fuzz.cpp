// toolcomp fuzz: the search for differences, by the clang targets of build/fuzz, or by the built-in driver.
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "certify/judge.h"
#include "certify/process.h"
#include "cli/controller.h"
#include "cli/fuzz_findings.h"
#include "cli/program.h"
#include "cli/progress.h"
#include "cli/stop.h"
#include "cli/verbs.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/summary.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void usage(const std::string& message) { throw spec::InputError("toolcomp fuzz", 0, 0, message); }

std::string target_name(std::string_view section, fuzz::Mode mode) {
  std::string name(section.substr(section.find('/') + 1));
  for (char& c : name)
    if (c == '-') c = '_';
  return name + (mode == fuzz::Mode::directed ? "_directed" : "_unrestricted");
}

// Beside build/release/toolcomp lies build/fuzz.
fs::path target_folder() { return fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "fuzz"; }

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
    Progress::line(fmt::format("{} executions, {:.0f} s, {} features, {} findings", p.executions, p.seconds, p.features,
                               p.findings));
  };
  return fuzz::run_campaign(campaign);
}

// What a process of libFuzzer left behind: its statistics, and inputs that did not pass. Whether it came to its end.
bool collect(const fs::path& folder, const std::string& section, fuzz::CampaignResult& sum) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with("crash-") && !name.starts_with("timeout-") && !name.starts_with("oom-")) continue;
    fuzz::Finding finding;
    finding.input = fuzz::decode(section, spec::read_file(entry.path()));
    finding.input.section = section;
    finding.input.id = name;
    finding.difference.kind = name.substr(0, name.find('-'));
    finding.difference.actual = "ended at this input";
    finding.executions = 1;
    sum.findings.push_back(finding);
  }
  if (!fs::exists(folder / "statistics")) return false;
  fuzz::add(sum, fuzz::read_summary(spec::read_file(folder / "statistics")));
  return true;
}

// Where the targets of one twin work: among the findings, so that nothing is lost with this process.
fs::path work_folder(const FuzzOptions& options, const std::string& section, fuzz::Mode mode) {
  return fs::path(options.findings) / ("running-" + target_name(section, mode));
}

// What targets had found when an earlier run was ended by a kill.
void settle_earlier(const FuzzOptions& options, FuzzFindings& findings) {
  for (const std::string_view section : fuzz::sections())
    for (const fuzz::Mode mode : {fuzz::Mode::directed, fuzz::Mode::unrestricted}) {
      const fs::path folder = work_folder(options, std::string(section), mode);
      if (!fs::is_directory(folder)) continue;
      fuzz::CampaignResult left;
      for (const auto& job : fs::directory_iterator(folder))
        if (job.is_directory()) static_cast<void>(collect(job.path(), std::string(section), left));
      findings.settle(left);
      fs::remove_all(folder);
    }
}

// libFuzzer processes of one twin side by side, one for each job. They end with this process, even if it is killed:
// then their standard input ends.
fuzz::CampaignResult clang_targets(const std::string& section, fuzz::Mode mode, const Plan& plan,
                                   const FuzzOptions& options, const Stop& stop) {
  const fs::path work = work_folder(options, section, mode);
  const unsigned jobs = std::max(1U, options.jobs);
  const std::uint64_t parts = 2 * std::uint64_t{jobs};
  const std::string limit = plan.runs > 0 ? fmt::format("-runs={}", (plan.runs + parts - 1) / parts)
                                          : fmt::format("-max_total_time={}", (plan.seconds + 1) / 2);
  std::string script = "exec 3<&0\n{ cat <&3 >/dev/null; kill -KILL 0; } &\nwatcher=$!\ntargets=\n";
  for (unsigned job = 0; job < jobs; ++job) {
    const fs::path folder = fs::absolute(work) / std::to_string(job);
    fs::create_directories(folder / "corpus");
    script += fmt::format(
        "TOOLCOMP_FUZZ_STATISTICS={0}/statistics {1} -seed={2} {3} -artifact_prefix={0}/ -max_len=16384 {0}/corpus "
        ">{0}/log 2>&1 &\ntargets=\"$targets $!\"\n",
        certify::shell_quoted(folder.string()),
        certify::shell_quoted((target_folder() / target_name(section, mode)).string()), options.seed * 1000 + job + 1,
        limit);
  }
  script += "wait $targets\necho done\nkill -KILL $watcher\n";
  Progress::line(fmt::format("{}: {}", target_name(section, mode), limit));
  certify::Process process(script);
  std::string reply;
  const auto long_enough = certify::Clock::now() + std::chrono::hours(24 * 365);
  process.receive_line(reply, long_enough, 1024);
  process.finish();
  fuzz::CampaignResult sum;
  for (unsigned job = 0; job < jobs; ++job)
    if (!collect(work / std::to_string(job), section, sum) && sum.findings.empty() && stop.why().empty())
      throw std::runtime_error("a fuzz target ended without a result:\n" +
                               spec::read_file(work / std::to_string(job) / "log"));
  fs::remove_all(work);
  return sum;
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
  const Plan plan = plan_of(options);
  expect_folder(options.findings, "--findings");
  fmt::print("seed {}\n", options.seed);
  const Stop stop;
  FuzzFindings findings(options, [&stop] { return !stop.why().empty(); });
  settle_earlier(options, findings);
  std::string not_run;
  bool nothing_judged = false;
  bool undecided = false;
  bool wide = false;
  for (const std::string& section : plan.sections) {
    if (!stop.why().empty()) {
      not_run += (not_run.empty() ? "" : ", ") + section;
      continue;
    }
    const bool clang =
        options.controller.empty() && fs::exists(target_folder() / target_name(section, fuzz::Mode::directed));
    const Progress progress("executions");
    fuzz::CampaignResult sum;
    for (const fuzz::Mode mode : {fuzz::Mode::directed, fuzz::Mode::unrestricted}) {
      if (!stop.why().empty()) break;
      const fuzz::CampaignResult result = clang ? clang_targets(section, mode, plan, options, stop)
                                                : built_in(section, mode, plan, options, findings, stop);
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
