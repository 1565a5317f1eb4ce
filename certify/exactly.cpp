// SPDX-License-Identifier: Apache-2.0
#include "certify/exactly.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "certify/serve.h"
#include "judge/oracle/compare.h"
#include "model/exact/alike.h"
#include "spec/language/event_json.h"
#include "spec/language/naming_clause.h"

namespace toolcomp::certify {
namespace {

using Json = nlohmann::ordered_json;
using exact::Real;

// An event as JSON with a mark in place of each number, and the numbers.
struct Laid {
  std::string form;
  std::vector<const Real*> numbers;
};

// What the specification does not say stays out.
model::Event bare(const model::Event& event) {
  model::Event copy = event;
  copy.clauses = {};
  copy.message = "";
  return copy;
}

Laid laid(const model::Event& event, const spec::Axes& axes) {
  Laid result;
  spec::append_event_json(result.form, event, axes, [&](std::string& out, const Real& value) {
    out += '0';
    result.numbers.push_back(&value);
  });
  return result;
}

std::string text(const model::Event& event, const spec::Axes& axes) {
  std::string out;
  spec::append_event_json(out, event, axes,
                          [](std::string& to, const Real& value) { to += '"' + value.decimal(kModelDigits) + '"'; });
  return out;
}

// Digits are made where it is not plain that the two are equal.
bool equal(const Real& a, const Real& b) {
  if (a.is_rational() && b.is_rational() && a.rational() == b.rational()) return true;
  if (exact::alike(a, b)) return true;
  return a.decimal(kModelDigits) == b.decimal(kModelDigits);
}

std::string shown(const Json& value) {
  return value.is_null() ? "absent" : value.is_string() ? value.get<std::string>() : value.dump();
}

// The first field in which two events differ: "axes.Z".
void name_field(const Json& expected, const Json& said, const std::string& path, judge::Difference& difference) {
  if (expected.is_object() && said.is_object()) {
    for (const Json* of : {&expected, &said})
      for (const auto& [key, value] : of->items()) {
        const Json a = expected.value(key, Json());
        const Json b = said.value(key, Json());
        if (a != b) return name_field(a, b, path.empty() ? key : fmt::format("{}.{}", path, key), difference);
      }
    return;
  }
  difference.field = path;
  difference.expected = shown(expected);
  difference.actual = shown(said);
}

// A run that could not certify a sign. What it held then went out as if nothing followed.
bool gives_up(const std::vector<model::Event>& run) {
  return !run.empty() && run.back().kind == spec::EventKind::undecided && !judge::left_open(run.back());
}

class Held {
 public:
  Held(const spec::Axes& axes, const std::vector<model::Event>& model, const std::vector<model::Event>& said)
      : axes_(axes), model_(model), said_(said) {}

  Exactly run() {
    for (std::size_t i = 0; i < std::max(model_.size(), said_.size()); ++i) {
      try {
        if (i < model_.size() && i < said_.size() && same(bare(model_[i]), bare(said_[i]))) continue;
        differ(i);
      } catch (const exact::Undecided& error) {
        result_.undecided = error.what();
      }
      break;
    }
    return std::move(result_);
  }

 private:
  bool same(const model::Event& expected, const model::Event& said) {
    const Laid a = laid(expected, axes_);
    const Laid b = laid(said, axes_);
    if (a.form != b.form) return false;
    for (std::size_t k = 0; k < a.numbers.size(); ++k)
      if (!equal(*a.numbers[k], *b.numbers[k])) return false;
    result_.values += a.numbers.size() + (spec::ends_run(expected.kind) ? 1 : 0);
    return true;
  }

  void differ(std::size_t i) {
    const model::Event* const expected = i < model_.size() ? &model_[i] : nullptr;
    const model::Event* const said = i < said_.size() ? &said_[i] : nullptr;
    for (const auto* const run : {&model_, &said_})
      if (gives_up(*run)) {
        result_.undecided = std::string(run == &model_ ? "the model" : "the formal specification") +
                            " could not decide: " + judge::describe(run->back());
        return;
      }
    judge::Difference& d = result_.difference.emplace();
    d.kind = kSpecificationKind;
    d.event = i;
    d.line = (expected != nullptr ? *expected : said_[i]).line;
    if (expected != nullptr) d.clauses = expected->clauses;
    d.clause = spec::naming_clause(d.clauses);
    d.field = "event";
    d.expected = expected != nullptr ? judge::describe(*expected) : "no more events";
    d.actual = said != nullptr ? judge::describe(*said) : "no more events";
    // Events that people would call the same differ in a field.
    if (expected != nullptr && said != nullptr && d.expected == d.actual)
      name_field(Json::parse(text(bare(*expected), axes_)), Json::parse(text(bare(*said), axes_)), "", d);
  }

  const spec::Axes& axes_;
  const std::vector<model::Event>& model_;
  const std::vector<model::Event>& said_;
  Exactly result_;
};

}  // namespace

Exactly hold_exactly(const spec::Axes& axes, const std::vector<model::Event>& model,
                     const std::vector<model::Event>& said) {
  return Held(axes, model, said).run();
}

}  // namespace toolcomp::certify
