// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "certify/fuzzing/dossier.h"
#include "certify/fuzzing/found.h"
#include "certify/fuzzing/third_voice.h"
#include "formal/engine.h"
#include "fuzz/campaign/floors.h"
#include "fuzz/campaign/summary.h"

namespace toolcomp::certify::fuzzing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// One section, over both of its targets as far as they are in the campaign.
struct SectionSum {
  std::string section;
  fuzz::CampaignResult sum;
  std::uint64_t directed = 0;  // executions
};

std::vector<SectionSum> sections_of(const CampaignOptions& options, const State& state) {
  std::vector<SectionSum> all;
  for (const fuzz::Target* target : options.targets) {
    if (target->is_reader()) continue;
    if (all.empty() || all.back().section != target->section) all.push_back({target->section, {}, 0});
    const auto known = state.targets.find(target->name);
    if (known == state.targets.end()) continue;
    fuzz::add(all.back().sum, known->second.sum);
    if (target->mode == fuzz::Mode::directed) all.back().directed += known->second.sum.executions;
  }
  return all;
}

std::uint64_t cases_of(const State& state, const fs::path& dossier) {
  const auto known = state.groups.find(dossier.filename().string());
  return known == state.groups.end() ? 0 : known->second;
}

std::string time_text(double seconds) {
  return seconds < 120    ? fmt::format("{:.0f} s", seconds)
         : seconds < 7200 ? fmt::format("{:.0f} min", seconds / 60)
                          : fmt::format("{:.1f} h", seconds / 3600);
}

fuzz::FaultsWithin all_faults(const std::vector<SectionSum>& sections) {
  fuzz::FaultsWithin all;
  for (const SectionSum& s : sections) {
    const fuzz::FaultsWithin one = fuzz::faults_within(s.section, s.directed);
    all.all += one.all;
    all.within += one.within;
  }
  return all;
}

// Where a longer search is known to find more.
std::string wanted(const std::vector<SectionSum>& sections) {
  std::string text;
  for (const SectionSum& s : sections)
    if (const auto faults = fuzz::faults_within(s.section, s.directed); faults.within < faults.all)
      text += fmt::format("    {}: {} of {}; {} directed executions, all need {}\n", s.section, faults.within,
                          faults.all, s.directed, faults.largest);
  return text;
}

constexpr const char* kNoScore =
    "  mutation score of a campaign with these seeds: not known; `./dev mutants` measures one\n";

}  // namespace

Verdict verdict_of(const CampaignOptions& options, const CampaignEnd& end) {
  Verdict verdict;
  for (const fuzz::Target* target : options.targets) {
    const auto known = end.state.targets.find(target->name);
    const fuzz::CampaignResult sum = known == end.state.targets.end() ? fuzz::CampaignResult{} : known->second.sum;
    for (const std::string& words : fuzz::shortfalls(*target, sum))
      verdict.shortfalls.push_back(target->name + ": " + words);
  }
  if (end.waiting > 0) verdict.shortfalls.push_back(fmt::format("{} sightings nobody has looked at", end.waiting));
  if (end.findings > 0) {
    verdict.status = 1;
    verdict.words = findings_text(end.findings, end.ways);
  } else if (!verdict.shortfalls.empty()) {
    verdict.status = 3;
    verdict.words = "no finding, which means nothing yet";
  } else {
    verdict.words = "no finding";
  }
  return verdict;
}

std::string summary_text(const CampaignOptions& options, const CampaignEnd& end, const Verdict& verdict) {
  const State& state = end.state;
  std::string text =
      fmt::format("campaign {}: start {}, seed {}, {} executions in {}; in all {} in {}\n", options.folder.string(),
                  state.starts, options.seed, end.executions, time_text(end.seconds), state.executions(),
                  time_text(static_cast<double>(state.milliseconds) / 1000));
  BoardView view = view_of(state, options.targets);
  view.seconds = end.seconds;
  view.specification.silent = silence(options);
  view.findings = end.findings;
  view.ways = end.ways;
  view.waiting = end.waiting;
  std::vector<std::string> lines = board_lines(view, true);
  lines.pop_back();
  for (const std::string& line : lines) text += "  " + line + "\n";
  const std::vector<SectionSum> sections = sections_of(options, state);
  if (!sections.empty()) text += "covered, both targets of a section together:\n";
  for (const SectionSum& s : sections) {
    const fuzz::Reached reached = fuzz::outcomes_reached(s.section, s.sum.clauses);
    text += fmt::format("  {}: {} of {} clause outcomes, {} values judged, worst {:.3g} ulp, {:.3g} µm\n", s.section,
                        reached.seen, reached.all, s.sum.values, s.sum.worst_ulp, s.sum.worst_um);
    constexpr std::size_t kFew = 5;
    if (reached.missing.size() <= kFew)
      for (const std::string& outcome : reached.missing) text += "    not reached: " + outcome + "\n";
  }
  if (const fuzz::FaultsWithin faults = all_faults(sections); faults.all > 0) {
    text += fmt::format(
        "what a search of this length is known to find:\n  {} of {} seeded faults of these sections, by "
        "their budgets\n",
        faults.within, faults.all);
    text += wanted(sections) + kNoScore;
  }
  for (const auto& [how, count] : state.ends) text += fmt::format("workers that ended by {}: {}\n", how, count);
  const Found found = found_in(options.folder / "findings");
  for (const Family& finding : found.findings) {
    const fs::path& first = found.dossiers[finding.first];
    text += fmt::format("FINDING {}\n  {}\n", first.string(), found.what[finding.first]);
    if (const std::string& who = found.voices[finding.first]; !who.empty()) text += "  " + who + "\n";
    text += fmt::format("  cases that came to it: {}\n", cases_of(state, first));
    for (const std::size_t i : finding.others)
      text +=
          fmt::format("  shows in {} too: {} cases\n", found.dossiers[i].string(), cases_of(state, found.dossiers[i]));
  }
  for (const fs::path& dossier : dossiers_in(options.folder / "open"))
    text += fmt::format("NOT DECIDED {}\n", dossier.string());
  for (const std::string& words : verdict.shortfalls) text += "below its floor: " + words + "\n";
  return text + verdict.words + "\n";
}

std::string summary_json(const CampaignOptions& options, const CampaignEnd& end, const Verdict& verdict) {
  const State& state = end.state;
  Json json{{"campaign", options.folder.string()},
            {"status", verdict.status},
            {"verdict", verdict.words},
            {"below_floor", verdict.shortfalls},
            {"seed", options.seed},
            {"shard", fmt::format("{}/{}", options.shard.index, options.shard.count)},
            {"starts", state.starts},
            {"seconds", end.seconds},
            {"seconds_in_all", static_cast<double>(state.milliseconds) / 1000},
            {"executions", end.executions},
            {"executions_in_all", state.executions()},
            {"to_look_at", end.waiting},
            {"not_decided", end.open},
            {"ends", state.ends}};
  json["findings"] = Json::array();
  const Found found = found_in(options.folder / "findings");
  const auto way = [&](std::size_t i) {
    return Json{{"folder", found.dossiers[i].string()},
                {"what", found.what[i]},
                {"voices", found.voices[i]},
                {"cases", cases_of(state, found.dossiers[i])}};
  };
  for (const Family& finding : found.findings) {
    Json one = way(finding.first);
    one["other_ways"] = Json::array();
    for (const std::size_t i : finding.others) one["other_ways"].push_back(way(i));
    json["findings"].push_back(std::move(one));
  }
  json["targets"] = Json::array();
  for (const BoardRow& row : view_of(state, options.targets).rows)
    json["targets"].push_back({{"target", row.target},
                               {"executions", row.executions},
                               {"per_second", row.per_second},
                               {"accepted", row.accepted},
                               {"outcomes", row.outcomes},
                               {"of", row.of},
                               {"law_checks", row.law_checks},
                               {"ties", row.ties},
                               {"differ", row.hits}});
  const std::vector<SectionSum> sections = sections_of(options, state);
  json["sections"] = Json::array();
  for (const SectionSum& s : sections) {
    const fuzz::Reached reached = fuzz::outcomes_reached(s.section, s.sum.clauses);
    const fuzz::FaultsWithin faults = fuzz::faults_within(s.section, s.directed);
    json["sections"].push_back({{"section", s.section},
                                {"outcomes", reached.seen},
                                {"of", reached.all},
                                {"not_reached", reached.missing},
                                {"values", s.sum.values},
                                {"not_judged", s.sum.wide},
                                {"worst_ulp", s.sum.worst_ulp},
                                {"worst_um", s.sum.worst_um},
                                {"seeded_faults", faults.all},
                                {"seeded_faults_within_budget", faults.within}});
  }
  const VoiceCount voice = voice_count(state.specification);
  json["specification"] = {{"asked", options.specification && formal::available()},
                           {"built_in", formal::available()},
                           {"cases", voice.cases},
                           {"per_second", voice.per_second},
                           {"agreed", voice.agreed},
                           {"differ", voice.differ},
                           {"undecided", voice.undecided},
                           {"refused", voice.refused}};
  json["mutation_score"] = nullptr;  // not known for these seeds
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace toolcomp::certify::fuzzing
