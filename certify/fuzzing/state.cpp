// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/state.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "spec/language/input_error.h"
#include "spec/language/outside_json.h"

namespace toolcomp::certify::fuzzing {
namespace {

using Json = nlohmann::ordered_json;

// Every counter, each said once for both ways.
template <class Result, class Take>
void counters(Result& r, Take take) {
  take("milliseconds", r.milliseconds);
  take("executions", r.executions);
  take("values", r.values);
  take("not_judged", r.wide);
  take("out_of_scope", r.out_of_scope);
  take("few_events", r.few_events);
  take("law_checks", r.law_checks);
  take("decisions", r.decisions);
  take("near_ties", r.near_ties);
  take("ties", r.ties);
  take("worst_ulp", r.worst_ulp);
  take("worst_um", r.worst_um);
}

Json json_of(const TargetState& target) {
  Json json{{"slices", target.slices}};
  counters(target.sum, [&json](const char* name, const auto& value) { json[name] = value; });
  json["acceptance"] = target.sum.acceptance;
  json["hits"] = target.sum.hits;
  Json clauses = Json::object();
  for (std::size_t i = 0; i < target.sum.clauses.size(); ++i) {
    const model::ClauseCount& c = target.sum.clauses[i];
    if (c.reached != 0)
      clauses[std::string(spec::info(static_cast<spec::Clause>(i)).id)] = {c.reached, c.positive, c.negative, c.tie};
  }
  json["clauses"] = std::move(clauses);
  return json;
}

TargetState target_of(const Json& json) {
  TargetState target;
  target.slices = json.at("slices").get<std::uint64_t>();
  counters(target.sum, [&json](const char* name, auto& value) { json.at(name).get_to(value); });
  json.at("acceptance").get_to(target.sum.acceptance);
  json.at("hits").get_to(target.sum.hits);
  target.sum.clauses.resize(spec::kClauseCount);
  for (const auto& [id, counts] : json.at("clauses").items())
    // A clause that is no more takes its counts along.
    if (const auto clause = spec::find_clause(id))
      target.sum.clauses[static_cast<std::size_t>(*clause)] = {
          counts.at(0).get<std::uint64_t>(), counts.at(1).get<std::uint64_t>(), counts.at(2).get<std::uint64_t>(),
          counts.at(3).get<std::uint64_t>()};
  return target;
}

template <class Key>
void add(std::map<Key, std::uint64_t>& total, const std::map<Key, std::uint64_t>& part) {
  for (const auto& [key, count] : part) total[key] += count;
}

void add(TargetState& sum, const TargetState& part) {
  fuzz::add(sum.sum, part.sum);
  sum.slices += part.slices;
}

}  // namespace

std::uint64_t State::executions() const {
  std::uint64_t sum = 0;
  for (const auto& [name, target] : targets) sum += target.sum.executions;
  return sum;
}

std::string write_state(const State& state, const std::vector<Running>& running) {
  Json json{{"campaign", 1},
            {"begun", state.begun},
            {"seed", state.seed},
            {"starts", state.starts},
            {"milliseconds", state.milliseconds},
            {"executions", state.executions()},
            {"findings", state.groups},
            {"ends", state.ends},
            {"next_slice", state.next_slice},
            {"open", state.open}};
  for (const Running& now : running)
    json["running"].push_back(
        {{"slice", now.slice}, {"target", now.target}, {"process", now.process}, {"executions", now.executions}});
  Json targets = Json::object();
  for (const auto& [name, target] : state.targets) targets[name] = json_of(target);
  json["targets"] = std::move(targets);
  json["specification"] = json_of(state.specification);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

State read_state(std::string_view text, const std::string& file) {
  State state;
  try {
    const Json json = spec::read_outside_json(text, file);
    if (json.at("campaign") != 1) throw spec::InputError(file, 0, 0, "is the state of a campaign of another version");
    json.at("begun").get_to(state.begun);
    json.at("seed").get_to(state.seed);
    json.at("starts").get_to(state.starts);
    json.at("milliseconds").get_to(state.milliseconds);
    json.at("findings").get_to(state.groups);
    json.at("ends").get_to(state.ends);
    json.at("next_slice").get_to(state.next_slice);
    json.at("open").get_to(state.open);
    for (const auto& [name, target] : json.at("targets").items()) state.targets[name] = target_of(target);
    if (json.contains("specification")) state.specification = target_of(json.at("specification"));
  } catch (const Json::exception& error) {
    throw spec::InputError(file, 0, 0, std::string("is not the state of a campaign: ") + error.what());
  }
  return state;
}

void merge(State& total, const State& part) {
  if (total.begun.empty() || (!part.begun.empty() && part.begun < total.begun)) total.begun = part.begun;
  // Of campaigns with several seeds the first by number.
  total.seed = total.starts == 0 ? part.seed : std::min(total.seed, part.seed);
  total.starts += part.starts;
  total.milliseconds += part.milliseconds;
  for (const auto& [name, target] : part.targets) add(total.targets[name], target);
  add(total.specification, part.specification);
  add(total.ends, part.ends);
  add(total.groups, part.groups);
  // Slices of all of them have ended, and none of theirs is one of this folder.
  total.next_slice = total.next_slice + part.next_slice - 1;
}

}  // namespace toolcomp::certify::fuzzing
