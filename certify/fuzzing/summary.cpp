// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "certify/fuzzing/third_voice.h"
#include "fuzz/campaign/floors.h"
#include "spec/language/split.h"
#include "spec_engine/engine.h"

namespace toolcomp::certify::fuzzing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// One section, over both of its targets as far as they are in the campaign.
struct SectionSum {
  std::string section;
  fuzz::Counters sum;
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

std::uint64_t cases_of(const State& state, const Shown& way) {
  const auto known = state.groups.find(way.name);
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

// What drives the targets: "built-in driver", "clang targets", "4 clang targets of 24, built-in driver".
std::string drivers(const CampaignOptions& options) {
  std::size_t clang = 0;
  for (const fuzz::Target* target : options.targets) clang += options.bench.has_clang(*target) ? 1 : 0;
  if (clang == 0) return "built-in driver";
  if (clang == options.targets.size()) return "clang targets";
  return fmt::format("{} clang targets of {}, built-in driver", clang, options.targets.size());
}

std::string heading(const CampaignOptions& options, const CampaignEnd& end) {
  const std::string now = fmt::format("seed {}, {} executions in {} ({})", options.seed, end.executions,
                                      time_text(end.seconds), drivers(options));
  if (options.temporary) return now + "\n";
  return fmt::format("campaign {}: start {}, {}; in all {} in {}\n", options.folder.string(), end.state.starts, now,
                     end.state.executions(), time_text(static_cast<double>(end.state.milliseconds) / 1000));
}

// What was not accepted or not judged, by reason; nothing where all was.
std::string left_out(const fuzz::Counters& sum) {
  std::string text;
  const auto add = [&text](std::uint64_t count, std::string_view what) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  };
  for (std::size_t i = 1; i < judge::kAcceptances; ++i)
    add(sum.acceptance.at(i), judge::name(static_cast<judge::Acceptance>(i)));
  add(sum.wide, "values not judged");
  add(sum.out_of_scope, "events out of scope");
  return text.empty() ? text : "    not accepted or not judged: " + text + "\n";
}

// By reason.
Json not_accepted(const fuzz::Counters& sum) {
  Json json = Json::object();
  for (std::size_t i = 1; i < judge::kAcceptances; ++i)
    json[std::string(judge::name(static_cast<judge::Acceptance>(i)))] = sum.acceptance.at(i);
  return json;
}

std::string text_of(const SectionSum& s, bool all_missing) {
  const fuzz::Reached reached = fuzz::outcomes_reached(s.section, s.sum.clauses);
  std::string text = fmt::format(
      "  {}: {} of {} clause outcomes, {} values judged, worst {:.3g} ulp, {:.3g} µm; {} decisions, {} near ties\n",
      s.section, reached.seen, reached.all, s.sum.values, s.sum.worst_ulp, s.sum.worst_um, s.sum.decisions,
      s.sum.near_ties);
  text += left_out(s.sum);
  constexpr std::size_t kFew = 5;
  if (all_missing || reached.missing.size() <= kFew)
    for (const std::string& outcome : reached.missing) text += "    not reached: " + outcome + "\n";
  return text;
}

// Each line of a text, indented.
std::string indented(const std::string& text) {
  std::string lines;
  for (const std::string_view line : spec::split(text, '\n'))
    if (!line.empty()) lines += fmt::format("    {}\n", line);
  return lines;
}

std::string text_of(const Shown& shown) {
  const Story& story = shown.story;
  std::string text = fmt::format("{}\n  {}\n", shown.folder.string(), story.what);
  if (!story.voices.empty()) text += "  " + story.voices + "\n";
  text += indented(story.program);
  if (const fs::path file = shown.folder / "finding.json"; fs::exists(file))
    text += "  toolcomp replay " + file.string() + "\n";
  return text;
}

std::string text_of(const Family& finding, const CampaignEnd& end) {
  const std::vector<Shown>& ways = end.found.ways;
  std::string text = "FINDING " + text_of(ways[finding.first]) +
                     fmt::format("  cases that show it: {}\n", cases_of(end.state, ways[finding.first]));
  std::size_t nowhere = 0;
  std::uint64_t cases = 0;
  for (const std::size_t i : finding.others) {
    if (!ways[i].folder.empty()) {
      text += fmt::format("  also shows in {}: {} cases\n", ways[i].folder.string(), cases_of(end.state, ways[i]));
      continue;
    }
    ++nowhere;
    cases += cases_of(end.state, ways[i]);
  }
  if (nowhere > 0) text += fmt::format("  also shows in {} other ways: {} cases\n", nowhere, cases);
  return text;
}

constexpr const char* kNoScore =
    "  mutation score of a campaign with these seeds: not known; `./dev mutants` measures one\n";

}  // namespace

CampaignResult campaign_result(const CampaignOptions& options, const CampaignEnd& end) {
  CampaignResult result;
  for (const fuzz::Target* target : options.targets) {
    const auto known = end.state.targets.find(target->name);
    const fuzz::Counters sum = known == end.state.targets.end() ? fuzz::Counters{} : known->second.sum;
    for (const std::string& words : fuzz::shortfalls(*target, sum))
      result.shortfalls.push_back(target->name + ": " + words);
  }
  if (end.waiting > 0) result.shortfalls.push_back(fmt::format("{} sightings were not examined", end.waiting));
  if (!end.found.findings.empty()) {
    result.status = 1;
    result.words = findings_text(end.found.findings.size(), end.found.ways.size());
  } else if (!result.shortfalls.empty()) {
    result.status = 3;
    result.words = "no finding, but the search was too short to count as a pass";
  } else {
    result.words = "no finding";
  }
  return result;
}

std::string summary_text(const CampaignOptions& options, const CampaignEnd& end, const CampaignResult& result) {
  const State& state = end.state;
  std::string text = heading(options, end);
  BoardView view = view_of(state, options.targets);
  view.seconds = end.seconds;
  view.specification.silent = silence(options);
  std::vector<std::string> lines = board_lines(view, true);
  lines.pop_back();
  for (const std::string& line : lines) text += "  " + line + "\n";
  const std::vector<SectionSum> sections = sections_of(options, state);
  if (!sections.empty()) text += "covered, both targets of a section together:\n";
  for (const SectionSum& s : sections) text += text_of(s, sections.size() == 1);
  if (const fuzz::FaultsWithin faults = all_faults(sections); faults.all > 0) {
    text += fmt::format(
        "what a search of this length finds:\n  {} of {} seeded faults of these sections, by "
        "their budgets\n",
        faults.within, faults.all);
    text += wanted(sections) + kNoScore;
  }
  for (const auto& [how, count] : state.ends) text += fmt::format("workers that ended by {}: {}\n", how, count);
  for (const Family& finding : end.found.findings) text += text_of(finding, end);
  for (const Shown& open : end.found.open) text += "NOT DECIDED " + text_of(open);
  for (const std::string& words : result.shortfalls) text += "below its floor: " + words + "\n";
  return text + result.words + "\n";
}

std::string summary_json(const CampaignOptions& options, const CampaignEnd& end, const CampaignResult& result) {
  const State& state = end.state;
  Json json{{"campaign", options.temporary ? Json() : Json(options.folder.string())},
            {"status", result.status},
            {"verdict", result.words},
            {"below_floor", result.shortfalls},
            {"seed", options.seed},
            {"shard", fmt::format("{}/{}", options.shard.index, options.shard.count)},
            {"starts", state.starts},
            {"seconds", end.seconds},
            {"seconds_in_all", static_cast<double>(state.milliseconds) / 1000},
            {"executions", end.executions},
            {"executions_in_all", state.executions()},
            {"to_look_at", end.waiting},
            {"ends", state.ends}};
  json["findings"] = Json::array();
  const auto shown = [](const Shown& way) {
    return Json{{"folder", way.folder.empty() ? Json() : Json(way.folder.string())},
                {"what", way.story.what},
                {"voices", way.story.voices},
                {"program", way.story.program}};
  };
  const auto counted = [&](const Shown& way) {
    Json json_of_way = shown(way);
    json_of_way["cases"] = cases_of(state, way);
    return json_of_way;
  };
  for (const Family& finding : end.found.findings) {
    Json one = counted(end.found.ways[finding.first]);
    one["other_ways"] = Json::array();
    for (const std::size_t i : finding.others) one["other_ways"].push_back(counted(end.found.ways[i]));
    json["findings"].push_back(std::move(one));
  }
  json["not_decided"] = Json::array();
  for (const Shown& open : end.found.open) json["not_decided"].push_back(shown(open));
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
                                {"out_of_scope", s.sum.out_of_scope},
                                {"decisions", s.sum.decisions},
                                {"near_ties", s.sum.near_ties},
                                {"few_events", s.sum.few_events},
                                {"not_accepted", not_accepted(s.sum)},
                                {"worst_ulp", s.sum.worst_ulp},
                                {"worst_um", s.sum.worst_um},
                                {"seeded_faults", faults.all},
                                {"seeded_faults_within_budget", faults.within}});
  }
  const VoiceCount voice = voice_count(state.specification);
  json["specification"] = {{"asked", options.specification && spec_engine::available()},
                           {"built_in", spec_engine::available()},
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
