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
#include "certify/files.h"
#include "certify/finding.h"
#include "certify/report.h"
#include "cli/controller.h"
#include "cli/progress.h"
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
  } catch (const spec::InputError&) {
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
  certify::write_file(path, certify::write_finding(finding));
  fmt::print("FINDING {}\n{}", path.string(), finding.smallest.program);
  fmt::print("  {}\n  toolcomp replay {}\n", certify::explanation(finding), path.string());
}

fuzz::CampaignResult built_in(const std::string& section, const Plan& plan, const FuzzOptions& options) {
  fuzz::CampaignOptions campaign;
  campaign.sections = {section};
  campaign.modes = {fuzz::Mode::directed, fuzz::Mode::unrestricted};
  campaign.seconds = static_cast<double>(plan.seconds);
  campaign.runs = plan.runs;
  campaign.jobs = options.jobs;
  campaign.seed = options.seed;
  if (!options.controller.empty())
    campaign.subject = [&options](unsigned) { return controller_subject(options.controller, options.timeout); };
  campaign.progress = [](const fuzz::CampaignProgress& p) {
    Progress::line(fmt::format("{} executions, {:.0f} s, {} features, {} findings", p.executions, p.seconds, p.features,
                               p.findings));
  };
  return fuzz::run_campaign(campaign);
}

// One libFuzzer process for each twin, side by side where there are jobs enough.
fuzz::CampaignResult clang_targets(const std::string& section, const Plan& plan, const FuzzOptions& options) {
  const fs::path work = fs::temp_directory_path() / fmt::format("toolcomp-fuzz-{}", ::getpid());
  fs::create_directories(work);
  const unsigned jobs = std::max(1U, options.jobs);
  const bool side_by_side = jobs >= 2;
  std::string script;
  std::vector<fs::path> statistics;
  std::vector<fs::path> artifacts;
  for (const fuzz::Mode mode : {fuzz::Mode::directed, fuzz::Mode::unrestricted}) {
    const std::string name = target_name(section, mode);
    const unsigned copies = side_by_side ? jobs / 2 + (mode == fuzz::Mode::directed ? jobs % 2 : 0) : 1;
    for (unsigned job = 0; job < copies; ++job) {
      const fs::path folder = work / fmt::format("{}-{}", name, job);
      fs::create_directories(folder / "corpus");
      statistics.push_back(folder / "statistics.json");
      artifacts.push_back(folder);
      // Half the time for each twin where they run one after the other.
      const std::uint64_t seconds = side_by_side ? plan.seconds : (plan.seconds + 1) / 2;
      const std::uint64_t runs = (plan.runs + 2 * copies - 1) / (2 * copies);
      script += fmt::format(
          "TOOLCOMP_FUZZ_STATISTICS='{0}' '{1}' -seed={2} {3} -artifact_prefix='{4}/' -use_value_profile=0 "
          "-max_len=16384 '{4}/corpus' >'{4}/log' 2>&1 {5}\n",
          statistics.back().string(), (target_folder() / name).string(), options.seed * 1000 + job + 1,
          plan.runs > 0 ? fmt::format("-runs={}", runs) : fmt::format("-max_total_time={}", seconds), folder.string(),
          side_by_side ? "&" : "");
    }
  }
  script += "wait\n";
  const fs::path file = work / "run";
  certify::write_file(file, script);
  Progress::line(fmt::format("{}: {}", section,
                             plan.runs > 0 ? fmt::format("{} runs", plan.runs) : fmt::format("{} s", plan.seconds)));
  if (std::system(fmt::format("/bin/sh '{}'", file.string()).c_str()) != 0)
    usage("the fuzz targets cannot be run");  // NOLINT(cert-env33-c,concurrency-mt-unsafe)

  fuzz::CampaignResult sum;
  for (std::size_t i = 0; i < statistics.size(); ++i) {
    if (!fs::exists(statistics[i]))
      throw std::runtime_error("a fuzz target left no statistics:\n" + certify::read_file(artifacts[i] / "log"));
    fuzz::add(sum, fuzz::read_summary(certify::read_file(statistics[i])));
    for (const auto& entry : fs::directory_iterator(artifacts[i])) {
      const std::string name = entry.path().filename();
      if (!name.starts_with("crash-") && !name.starts_with("timeout-") && !name.starts_with("oom-")) continue;
      fuzz::Finding finding;
      finding.input = fuzz::decode(section, certify::read_file(entry.path()));
      finding.input.section = section;
      finding.input.id = name;
      finding.difference.kind = name.substr(0, name.find('-'));
      finding.executions = 1;
      sum.findings.push_back(finding);
    }
  }
  fs::remove_all(work);
  return sum;
}

void print_summary(const std::string& section, const fuzz::CampaignResult& result, bool clang) {
  fmt::print("{}: {} executions in {:.1f} s, {:.0f} executions/s a core ({})\n", section, result.executions,
             result.seconds, result.per_second_per_core, clang ? "clang targets" : "built-in driver");
  fmt::print("  accepted {:.1f} %", 100 * result.accepted_share());
  for (std::size_t i = 1; i < fuzz::kAcceptances; ++i)
    if (result.acceptance.at(i) > 0)
      fmt::print(", {} {}", result.acceptance.at(i), fuzz::name(static_cast<fuzz::Acceptance>(i)));
  fmt::print(
      "\n  {} values judged, {} decisions, {} near ties, {} ties ({:.4f} % of decisions)\n", result.values,
      result.decisions, result.near_ties, result.ties,
      result.decisions == 0 ? 0 : 100 * static_cast<double>(result.ties) / static_cast<double>(result.decisions));
  fmt::print("  worst deviation {:.3g} ulp, {:.3g} µm\n", result.worst_ulp, result.worst_um);
  fuzz::print_outcomes(std::cout, section, result.clauses);
}

}  // namespace

int fuzz(const FuzzOptions& options) {
  const Plan plan = plan_of(options);
  fmt::print("seed {}\n", options.seed);
  std::size_t findings = 0;
  bool nothing_judged = false;
  bool undecided = false;
  for (const std::string& section : plan.sections) {
    const bool clang =
        options.controller.empty() && fs::exists(target_folder() / target_name(section, fuzz::Mode::directed));
    const Progress progress("executions");
    const fuzz::CampaignResult result =
        clang ? clang_targets(section, plan, options) : built_in(section, plan, options);
    print_summary(section, result, clang);
    for (const fuzz::Finding& finding : result.findings) write_finding(finding, findings++, options);
    nothing_judged = nothing_judged || result.values == 0;
    undecided = undecided || result.acceptance.at(static_cast<std::size_t>(fuzz::Acceptance::not_decided)) > 0;
  }
  fmt::print("{}\n", findings == 0 ? "no finding" : fmt::format("{} findings", findings));
  if (findings > 0) return kDiffers;
  return nothing_judged || undecided ? kUndecided : kAgrees;
}

}  // namespace toolcomp::cli
