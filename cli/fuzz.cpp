// toolcomp fuzz: the search for differences, by the clang targets of build/fuzz, or by the built-in driver.
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "certify/campaign.h"
#include "certify/finding.h"
#include "certify/report.h"
#include "certify/temporary_folder.h"
#include "cli/controller.h"
#include "cli/program.h"
#include "cli/progress.h"
#include "cli/verbs.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/summary.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "spec/language/byte_source.h"
#include "spec/language/file_writer.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void usage(const std::string& message) { throw spec::InputError("toolcomp fuzz", 0, 0, message); }

// "90", "90s", "10m", "1h" in seconds.
std::uint64_t seconds_of(const std::string& text) {
  std::size_t used = 0;
  std::uint64_t number = 0;
  try {
    number = std::stoull(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  const std::string unit = text.substr(used);
  const std::uint64_t factor = unit.empty() || unit == "s" ? 1 : unit == "m" ? 60 : unit == "h" ? 3600 : 0;
  if (used == 0 || text[0] == '-' || number == 0 || number > 1'000'000 || factor == 0)
    usage("--for takes a time such as 60s, 10m or 1h");
  return number * factor;
}

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
  if (plan.runs == 0) plan.seconds = seconds_of(options.duration.empty() ? "60s" : options.duration);
  return plan;
}

// Shrinks what was found and writes it where it can be replayed.
void write_finding(const fuzz::Finding& found, std::size_t index, const FuzzOptions& options) {
  const auto timeout = std::chrono::milliseconds(static_cast<std::int64_t>(options.timeout * 1000));
  const auto subject = certify::subject_of(options.controller, timeout);
  const auto capabilities = subject->capabilities();
  certify::Finding finding;
  try {
    if (const auto* able = std::get_if<certify::Capabilities>(&capabilities)) {
      const fuzz::ModelRun run = fuzz::run_model(found.input);
      const certify::Judgement judgement = certify::judge_case(*subject, *able, found.input, run);
      if (judgement.result == certify::Result::differs)
        finding =
            certify::make_finding(*subject, *able, found.input, certify::key_of(found.input, judgement), 2000, timeout);
    }
  } catch (const spec::InputError&) {  // NOLINT(bugprone-empty-catch)
    // One engine refuses the setup and the other does not: there is no run to shrink.
  }
  if (finding.key.kind.empty()) {
    finding.smallest = found.input;
    finding.key = {found.input.section,
                   found.difference.clause ? std::string(spec::info(*found.difference.clause).id) : "",
                   found.difference.kind};
    finding.line = found.difference.line;
    finding.field = found.difference.field;
    finding.expected = found.difference.expected;
    finding.actual = found.difference.actual;
  }
  finding.seed = std::to_string(options.seed);
  finding.occurrences = found.executions;
  const fs::path path = fs::path(options.findings) / certify::file_name(finding, index);
  spec::write_file(path, certify::write_finding(finding));
  fmt::print("FINDING {}\n{}", path.string(), finding.smallest.program);
  fmt::print("  {}\n  toolcomp replay {}\n", certify::explanation(finding), path.string());
}

// Half the time and half the runs for each twin.
fuzz::CampaignResult built_in(const std::string& section, fuzz::Mode mode, const Plan& plan,
                              const FuzzOptions& options) {
  fuzz::CampaignOptions campaign;
  campaign.sections = {section};
  campaign.modes = {mode};
  campaign.seconds = static_cast<double>(plan.seconds) / 2;
  campaign.runs = (plan.runs + 1) / 2;
  campaign.jobs = options.jobs;
  campaign.seed = options.seed;
  if (!options.controller.empty())
    campaign.subject = [&options](unsigned) {
      return controller_subject(options.controller, options.timeout, options.accept_resolution);
    };
  campaign.progress = [](const fuzz::CampaignProgress& p) {
    Progress::line(fmt::format("{} executions, {:.0f} s, {} features, {} findings", p.executions, p.seconds, p.features,
                               p.findings));
  };
  return fuzz::run_campaign(campaign);
}

// What a process of libFuzzer left behind: its statistics, and inputs that did not pass.
void collect(const fs::path& folder, const std::string& section, fuzz::CampaignResult& sum) {
  const std::size_t before = sum.findings.size();
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with("crash-") && !name.starts_with("timeout-") && !name.starts_with("oom-")) continue;
    fuzz::Finding finding;
    finding.input = fuzz::decode(section, spec::read_file(entry.path()));
    finding.input.section = section;
    finding.input.id = name;
    finding.difference.kind = name.substr(0, name.find('-'));
    finding.executions = 1;
    sum.findings.push_back(finding);
  }
  if (const fs::path statistics = folder / "statistics"; fs::exists(statistics))
    fuzz::add(sum, fuzz::read_summary(spec::read_file(statistics)));
  else if (sum.findings.size() == before)
    throw std::runtime_error("a fuzz target ended without a result:\n" + spec::read_file(folder / "log"));
}

// libFuzzer processes of one twin side by side, one for each job.
fuzz::CampaignResult clang_targets(const std::string& section, fuzz::Mode mode, const Plan& plan,
                                   const FuzzOptions& options) {
  const certify::TemporaryFolder work;
  const unsigned jobs = std::max(1U, options.jobs);
  const std::uint64_t parts = 2 * std::uint64_t{jobs};
  const std::string limit = plan.runs > 0 ? fmt::format("-runs={}", (plan.runs + parts - 1) / parts)
                                          : fmt::format("-max_total_time={}", (plan.seconds + 1) / 2);
  std::string script;
  for (unsigned job = 0; job < jobs; ++job) {
    const fs::path folder = work.path() / std::to_string(job);
    fs::create_directories(folder / "corpus");
    script += fmt::format(
        "TOOLCOMP_FUZZ_STATISTICS='{0}/statistics' '{1}' -seed={2} {3} -artifact_prefix='{0}/' -max_len=16384 "
        "'{0}/corpus' >'{0}/log' 2>&1 &\n",
        folder.string(), (target_folder() / target_name(section, mode)).string(), options.seed * 1000 + job + 1, limit);
  }
  script += "wait\n";
  Progress::line(fmt::format("{}: {}", target_name(section, mode), limit));
  spec::write_file(work.path() / "run", script);
  const std::string command = fmt::format("/bin/sh '{}'", (work.path() / "run").string());
  // NOLINTNEXTLINE(cert-env33-c,concurrency-mt-unsafe): a script of our own, on the only thread
  if (std::system(command.c_str()) != 0) usage("the fuzz targets cannot be run");
  fuzz::CampaignResult sum;
  for (unsigned job = 0; job < jobs; ++job) collect(work.path() / std::to_string(job), section, sum);
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
  std::size_t findings = 0;
  bool nothing_judged = false;
  bool undecided = false;
  bool wide = false;
  for (const std::string& section : plan.sections) {
    const bool clang =
        options.controller.empty() && fs::exists(target_folder() / target_name(section, fuzz::Mode::directed));
    const Progress progress("executions");
    fuzz::CampaignResult sum;
    for (const fuzz::Mode mode : {fuzz::Mode::directed, fuzz::Mode::unrestricted}) {
      const fuzz::CampaignResult result =
          clang ? clang_targets(section, mode, plan, options) : built_in(section, mode, plan, options);
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
    for (const fuzz::Finding& finding : sum.findings) write_finding(finding, findings++, options);
  }
  fmt::print("{}{}\n", findings == 0 ? "no finding" : fmt::format("{} findings", findings),
             wide ? "; more than 1 % of a section not judged" : "");
  if (findings > 0) return kDiffers;
  return nothing_judged || undecided || wide ? kUndecided : kAgrees;
}

}  // namespace toolcomp::cli
