// SPDX-License-Identifier: Apache-2.0
#include "certify/voices.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "certify/exactly.h"
#include "certify/judge.h"
#include "spec_engine/engine.h"

namespace toolcomp::certify {
namespace {

Voices not_known(std::string why) { return {Alone::not_known, "not known who stands alone: " + std::move(why)}; }

// The specification in the place of the model. What the oracle reads off clauses it reads off those of the model's
// events; the other outcomes of near ties are not tried.
judge::ModelRun as_model(const judge::ModelRun& run, std::vector<model::Event> said) {
  judge::ModelRun other;
  other.beyond = run.beyond;
  other.events = std::move(said);
  for (std::size_t i = 0; i < std::min(other.events.size(), run.events.size()); ++i)
    other.events[i].clauses = run.events[i].clauses;
  return other;
}

Voices heard(bool model, bool specification, bool both, std::string_view name) {
  if (both && model)
    return {Alone::nobody, fmt::format("nobody stands alone: model, formal specification and {} agree", name)};
  if (both) return {Alone::other, fmt::format("the {} stands alone: model and formal specification agree", name)};
  if (model && specification)
    return {Alone::nobody, fmt::format("model and formal specification differ by less than the {} can tell", name)};
  if (model)
    return {Alone::specification, fmt::format("the formal specification stands alone: model and {} agree", name)};
  if (specification)
    return {Alone::model, fmt::format("the model stands alone: {} and formal specification agree", name)};
  return {Alone::each, fmt::format("each stands alone: model, formal specification and {} all differ", name)};
}

Voices asked(const spec::Case& c, Subject& other, std::string_view name) {
  const judge::ModelRun run = judge::run_model(c);
  spec_engine::Run said = spec_engine::run(c);
  if (!said.not_said.empty()) return not_known(said.not_said);
  const Exactly held = hold_exactly(c.setup.axes, run.events, said.events);
  if (!held.undecided.empty()) return not_known(held.undecided);
  const auto capabilities = other.capabilities();
  const auto* const able = std::get_if<Capabilities>(&capabilities);
  if (able == nullptr) return not_known(fmt::format("the {} cannot be asked", name));
  const Answer answer = other.run(c);
  // Whether it agrees with one of the two; a broken law is no matter between them.
  std::string open;
  const auto agrees = [&](const judge::ModelRun& with) {
    const Judgement judgement = judge_answer(*able, c, with, answer);
    if (judgement.result == Result::differs) return judgement.verdict.difference->kind == "law";
    if (judgement.result != Result::agrees && judgement.result != Result::partly_judged &&
        judgement.result != Result::nothing_judged)
      open = judgement.why;
    return true;
  };
  const bool both = !held.difference;
  const bool model = agrees(run);
  const bool specification = both ? model : agrees(as_model(run, std::move(said.events)));
  if (!open.empty()) return not_known(open);
  return heard(model, specification, both, name);
}

}  // namespace

Voices ask_all(const spec::Case& c, Subject& other, std::string_view name) {
  if (!spec_engine::available()) return not_known("this toolcomp was built without the formal specification");
  try {
    return asked(c, other, name);
  } catch (const std::exception& error) {
    return not_known(error.what());
  }
}

}  // namespace toolcomp::certify
