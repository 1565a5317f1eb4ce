// SPDX-License-Identifier: Apache-2.0
// The model against another engine, and block by block.
#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "certify/comparison.h"
#include "certify/explained.h"
#include "certify/input/program.h"
#include "python/bindings.h"
#include "python/formal_thread.h"
#include "python/interrupt.h"
#include "python/numbers.h"
#include "spec/language/event_json.h"
#include "spec/language/event_names.h"
#include "spec/language/known.h"

namespace py = pybind11;

namespace toolcomp::python {
namespace {

using certify::input::Program;
using Json = nlohmann::ordered_json;
using Released = py::call_guard<py::gil_scoped_release>;

std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json counts(const judge::Verdict& verdict) {
  return {{"values", verdict.values},         {"decisions", verdict.decisions},
          {"near_ties", verdict.near_ties},   {"ties", verdict.ties},
          {"worst_ulp", verdict.worst_ulp},   {"worst_um", verdict.worst_um},
          {"values_not_judged", verdict.wide}};
}

Json to_json(const std::optional<judge::Difference>& difference, const Program& program) {
  if (!difference) return {};
  const certify::input::Place place = program.place(difference->line);
  Json json{{"file", place.file},
            {"line", place.line},
            {"kind", difference->kind},
            {"field", difference->field},
            {"expected", difference->expected},
            {"actual", difference->actual},
            {"deviation_um", difference->deviation_um}};
  json["clause"] = difference->clause ? Json(spec::info(*difference->clause).id) : Json();
  return json;
}

std::string_view name(judge::Outcome outcome) {
  switch (outcome) {
    case judge::Outcome::agrees:
      return "agrees";
    case judge::Outcome::differs:
      return "differs";
    case judge::Outcome::undecided:
      return "undecided";
    case judge::Outcome::nothing_judged:
      break;
  }
  return "nothing judged";
}

std::string diff_fast(const std::shared_ptr<Program>& program) {
  // judge_stream() takes a plain function.
  static thread_local Interrupt interrupt;
  const certify::Comparison comparison = certify::compare_fast(*program, [](std::uint64_t) { interrupt.check(); });
  Json json = counts(comparison.verdict);
  json["outcome"] = name(comparison.verdict.outcome);
  json["why"] = comparison.verdict.undecided;
  json["questions"] = comparison.questions;
  json["difference"] = to_json(comparison.verdict.difference, *program);
  return dump(json);
}

std::string diff_specification(const std::shared_ptr<Program>& program) {
  certify::Judgement judgement;
  in_formal_thread([&] { judgement = certify::compare_specification(*program); });
  Json json = counts(judgement.verdict);
  json["outcome"] = certify::name(judgement.result);
  json["why"] = judgement.why;
  json["questions"] = 0;
  json["difference"] = to_json(judgement.difference(), *program);
  return dump(json);
}

template <class Number, class AppendNumber>
Json event_json(const spec::Event<Number>& event, const spec::Axes& axes, const AppendNumber& append) {
  std::string text;
  spec::append_event_json(text, event, axes, append);
  return Json::parse(text);
}

Json number_json(const exact::Real& value, int digits) {
  std::string text;
  ExactNumber{digits}(text, value);
  return Json::parse(text);
}

Json to_json(const model::Decision& decision, int digits) {
  const spec::ClauseInfo& clause = spec::info(decision.clause);
  Json json{{"clause", clause.id}, {"quantity", number_json(decision.quantity, digits)}};
  const bool scaled = decision.scale.sign() == exact::Sign::positive;
  json["scale"] = scaled ? number_json(decision.scale, digits) : Json();
  json["margin"] = scaled ? number_json(decision.quantity / decision.scale, digits) : Json();
  const bool positive = decision.outcome == exact::Sign::positive;
  const bool tie = decision.outcome == exact::Sign::zero;
  json["outcome"] = tie ? "tie" : positive ? "positive" : "negative";
  json["meaning"] = tie ? clause.tie : positive ? clause.positive : clause.negative;
  return json;
}

Json to_json(const certify::ExplainedBlock& block, const Program& program, int digits) {
  const spec::Axes& axes = program.setup().axes;
  Json json{{"line", block.line}, {"n", block.n ? Json(*block.n) : Json()}, {"text", block.text}};
  json["decisions"] = Json::array();
  for (const model::Decision& decision : block.decisions) json["decisions"].push_back(to_json(decision, digits));
  json["exact"] = Json::array();
  for (const certify::ExplainedEvent& event : block.exact)
    json["exact"].push_back({{"event", event_json(event.event, axes, ExactNumber{digits})},
                             {"measured", event.measured},
                             {"corner", event.corner}});
  json["fast"] = Json::array();
  for (const fast::Event& event : block.fast) json["fast"].push_back(event_json(event, axes, DoubleNumber{}));
  return json;
}

std::string explain(const std::shared_ptr<Program>& program, std::optional<std::uint64_t> block, int digits) {
  Json json = Json::array();
  for (const certify::ExplainedBlock& explained : certify::explain_blocks(*program, block, digits))
    json.push_back(to_json(explained, *program, digits));
  return dump(json);
}

std::string clause(const std::string& id) {
  const auto found = spec::find_clause(id);
  if (!found) throw py::key_error(id);
  const spec::ClauseInfo& info = spec::info(*found);
  return dump({{"id", info.id},
               {"section", info.section},
               {"text", info.text},
               {"known", spec::known_name(info.known)},
               {"source", spec::cited(info)},
               {"formula", info.formula},
               {"alternatives", info.alternatives},
               {"open", info.kind == spec::ClauseKind::open}});
}

}  // namespace

void bind_compare(py::module_& module) {
  module.def("diff_fast", &diff_fast, py::arg("program"), Released());
  module.def("diff_specification", &diff_specification, py::arg("program"), Released());
  module.def("explain", &explain, py::arg("program"), py::arg("block"), py::arg("digits"), Released());
  module.def("clause", &clause, py::arg("id"));
}

}  // namespace toolcomp::python
