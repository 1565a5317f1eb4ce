// SPDX-License-Identifier: Apache-2.0
// toolcomp fuzz: a campaign in a folder, a temporary one where none is named.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/fuzzing/merge.h"
#include "certify/fuzzing/regression.h"
#include "certify/fuzzing/summary.h"
#include "cli/board.h"
#include "cli/controller.h"
#include "cli/manners.h"
#include "cli/program.h"
#include "cli/stop.h"
#include "cli/verbs.h"
#include "host/data_folder.h"
#include "host/temporary_folder.h"
#include "spec/language/input_error.h"
#include "spec/language/suggestion.h"

namespace toolcomp::cli {
namespace {

namespace fs = std::filesystem;
namespace fuzzing = certify::fuzzing;

[[noreturn]] void usage(const std::string& message) { throw spec::InputError("toolcomp fuzz", 0, 0, message); }

fuzzing::Shard shard_of(const std::string& text) {
  fuzzing::Shard shard;
  if (text.empty()) return shard;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.index);
  const bool slash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
  const auto second = slash ? std::from_chars(first.ptr + 1, end, shard.count) : first;
  if (!slash || second.ec != std::errc() || second.ptr != end || shard.index < 1 || shard.index > shard.count)
    throw spec::InputError("--shard", 0, 0, "takes I/N with 1 <= I <= N, found \"" + text + "\"");
  return shard;
}

fuzzing::Bench bench_of(const FuzzOptions& options) {
  fuzzing::Bench bench;
  bench.program = fs::read_symlink("/proc/self/exe");
  if (!options.built_in) bench.targets = bench.program.parent_path().parent_path() / "fuzz";
  bench.inputs.push_back(host::data_folder() / "corpus/seeds");
  bench.controller = options.controller;
  bench.timeout = options.timeout;
  return bench;
}

void add(std::vector<const fuzz::Target*>& list, const fuzz::Target& target) {
  if (std::ranges::find(list, &target) == list.end()) list.push_back(&target);
}

// Those named; both of every section named; without either, all that can be run.
std::vector<const fuzz::Target*> chosen(const FuzzOptions& options, const fuzzing::Bench& bench) {
  std::vector<const fuzz::Target*> list;
  for (const std::string& section : options.sections) {
    const std::size_t before = list.size();
    for (const fuzz::Target& target : fuzz::targets())
      if (target.section == section) add(list, target);
    if (list.size() == before) usage("no section " + section + "; `toolcomp spec sections` lists them");
  }
  for (const std::string& name : options.targets) {
    const fuzz::Target* const target = fuzz::find_target(name);
    if (target == nullptr) {
      std::vector<std::string> all;
      for (const fuzz::Target& known : fuzz::targets()) all.push_back(known.name);
      const std::string meant = spec::did_you_mean(name, all);
      usage(fmt::format("no target {}{}", name,
                        meant.empty() ? fmt::format("; expected one of {}", fmt::join(all, ", ")) : meant));
    }
    if (!bench.can_run(*target))
      usage("the reader " + name + " has no built-in driver; `./dev fuzz` builds its target");
    add(list, *target);
  }
  if (list.empty())
    for (const fuzz::Target& target : fuzz::targets())
      if (bench.can_run(target)) add(list, target);
  return list;
}

int merge(const FuzzOptions& options) {
  if (options.campaign.empty()) usage("--merge needs --campaign, a new folder for the merged campaign");
  const std::vector<fs::path> folders(options.merge.begin(), options.merge.end());
  fuzzing::merge_campaigns(folders, options.campaign);
  fmt::print("{} campaigns merged: {}\n", folders.size(), options.campaign);
  return kAgrees;
}

}  // namespace

int fuzz(const FuzzOptions& options) {
  if (!options.merge.empty()) return merge(options);
  if (options.runs > 0 && !options.duration.empty()) usage("give --for or --runs, not both");
  fuzzing::CampaignOptions campaign;
  campaign.temporary = options.campaign.empty();
  if (!campaign.temporary) expect_folder(options.campaign, "--campaign");
  const std::string findings = campaign.temporary && options.findings.empty() ? "findings" : options.findings;
  if (!findings.empty()) expect_folder(findings, "--findings");
  campaign.bench = bench_of(options);
  campaign.targets = chosen(options, campaign.bench);
  campaign.shard = shard_of(options.shard);
  // Half the runs for each target of a section.
  campaign.runs = (options.runs + 1) / 2;
  const std::string duration = campaign.temporary && options.runs == 0 ? "60s" : "";
  if (const std::string& given = options.duration.empty() ? duration : options.duration; !given.empty())
    campaign.seconds = static_cast<std::uint64_t>(duration_of(given, "--for").count());
  campaign.jobs = std::max(1U, options.jobs);
  campaign.seed = options.seed;
  // With a controller only findings are asked of it.
  campaign.specification = !options.no_specification && options.controller.empty();
  // Whether it can be used is known before hours of work.
  if (!options.controller.empty())
    static_cast<void>(judge_of_controller(options.controller, options.timeout, options.accept_resolution));
  std::optional<host::TemporaryFolder> temporary;
  if (campaign.temporary) temporary.emplace();
  campaign.folder = temporary ? temporary->path() : fs::path(options.campaign);
  campaign.bench.inputs.push_back(campaign.folder / "regression");
  detail(fmt::format("campaign {}: {} targets, {} jobs, seed {}", campaign.folder.string(), campaign.targets.size(),
                     campaign.jobs, campaign.seed));
  const std::string goes_on =
      fmt::format("`toolcomp fuzz --campaign {}` resumes the campaign", campaign.folder.string());
  if (temporary) note(fmt::format("seed {}; if this is killed, {}", campaign.seed, goes_on));
  const Stop stop;
  campaign.stop = [&stop] { return !stop.why().empty(); };
  Board board;
  campaign.show = [&board](const fuzzing::BoardView& view) { board.show(view); };
  campaign.say = [&board](const std::string& line) { board.say(line); };
  try {
    fuzzing::write_regression_inputs(host::data_folder() / "corpus/regression", campaign.folder / "regression");
    fuzzing::CampaignEnd end = fuzzing::run_campaign(campaign);
    board.close();
    // What nobody has looked at would be lost with its folder.
    if (temporary && end.waiting > 0) temporary->keep();
    if (!findings.empty()) {
      fuzzing::Found copied = fuzzing::copy_out(end.found, findings);
      if (temporary) end.found = std::move(copied);
    }
    const fuzzing::CampaignResult result = fuzzing::campaign_result(campaign, end);
    const std::string text = fuzzing::summary_text(campaign, end, result);
    if (!stop.why().empty()) std::cerr << stop.why() << '\n';
    if (options.json) std::cerr << text << std::flush;
    std::cout << (options.json ? fuzzing::summary_json(campaign, end, result) : text) << std::flush;
    if (temporary && end.waiting > 0) std::cerr << goes_on << ", with the findings that were not examined\n";
    return result.status;
  } catch (const spec::InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    // A folder that cannot be written is no fault of this program.
    if (temporary) temporary->keep();
    board.close();
    std::cerr << "toolcomp fuzz: " << error.what() << '\n';
    return kBadInput;
  }
}

}  // namespace toolcomp::cli
