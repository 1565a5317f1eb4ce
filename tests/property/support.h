// SPDX-License-Identifier: Apache-2.0
// What the property tests share: generated cases through RapidCheck's choices, exact runs, and changes to cases whose
// effect on the result is known.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <optional>
#include <string>

#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "fuzz/gen/program_text.h"
#include "judge/oracle/verdict.h"
#include "spec/language/input_error.h"

namespace toolcomp::laws {

using exact::Rational;
using exact::Real;
using spec::EventKind;

// RapidCheck's own choices: a failing case shrinks choice by choice.
class RapidCheckSource final : public fuzz::ChoiceSource {
 public:
  std::uint64_t below(std::uint64_t n) override { return n <= 1 ? 0 : *rc::gen::inRange<std::uint64_t>(0, n); }
};

inline spec::Case generated(std::string_view section, fuzz::Mode mode = fuzz::Mode::directed) {
  RapidCheckSource source;
  return fuzz::generate(section, mode, source);
}

// The model's events; nothing for a setup no control could have.
inline std::optional<judge::ModelRun> model_run(const spec::Case& c) {
  try {
    return judge::run_model(c);
  } catch (const spec::InputError&) {
    return std::nullopt;
  }
}

// The fast engine obeys a law of the model if it agrees with the model on both sides of it.
inline void fast_agrees(const spec::Case& c, const judge::ModelRun& run) {
  const judge::Verdict v = judge::judge(c, run, judge::run_fast(c));
  if (v.outcome == judge::Outcome::differs) RC_LOG() << fuzz::encode(c) << '\n' << judge::explain(*v.difference);
  RC_ASSERT(v.outcome != judge::Outcome::differs);
}

using Table = spec::AxisValues<Real>;
// What a law makes of the values of an event.
using Map = std::function<Table(const spec::Axes&, const Table&)>;

// Certified equality; where a sum of roots over sines has no proof of zero within the budget, equality to 300 bits.
inline bool equal(const Real& a, const Real& b) {
  constexpr int bits = 300;
  try {
    return a == b;
  } catch (const exact::Undecided&) {
    const exact::Enclosure x = a.enclosure(bits);
    const exact::Enclosure y = b.enclosure(bits);
    return x.lower <= y.upper && y.lower <= x.upper;
  }
}

inline bool same(const Table& a, const Table& b) {
  if (a.present != b.present) return false;
  for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
    if (a.has(i) && !equal(a[i], b[i])) return false;
  return true;
}

// Events of `changed` are those of `original` with `map` applied to every table, lines moved by `shift`; no
// tolerance.
inline void mapped(const spec::Case& original, const spec::Case& changed, const Map& map, std::uint64_t shift = 0) {
  const auto a = model_run(original);
  const auto b = model_run(changed);
  RC_PRE(a.has_value());
  RC_LOG() << fuzz::encode(original) << "---\n" << fuzz::encode(changed);
  RC_ASSERT(b.has_value());
  RC_ASSERT(a->events.size() == b->events.size());
  for (std::size_t i = 0; i < a->events.size(); ++i) {
    const model::Event& e = a->events[i];
    const model::Event& f = b->events[i];
    RC_LOG() << "event " << i << '\n';
    RC_ASSERT(e.kind == f.kind);
    RC_ASSERT(e.line + shift == f.line);
    RC_ASSERT(e.number == f.number);
    if (e.kind != EventKind::move && e.kind != EventKind::sample) continue;
    RC_ASSERT(e.cause == f.cause);
    RC_ASSERT(e.type == f.type);
    const spec::Axes& axes = original.setup.axes;
    RC_ASSERT(same(map(axes, e.programmed), f.programmed));
    RC_ASSERT(same(map(axes, e.point), f.point));
    RC_ASSERT(same(map(axes, e.axes), f.axes));
    RC_ASSERT(same(map(axes, e.machine), f.machine));
  }
  fast_agrees(changed, *b);
}

// Every word of the program changed by `change`.
inline std::string each_word(const std::string& program, const std::function<void(std::string&)>& change) {
  std::string text;
  for (const std::string& line : fuzz::lines(program)) {
    fuzz::WordTexts words = fuzz::words(line);
    for (std::string& word : words) change(word);
    text += fuzz::joined_words(words) + '\n';
  }
  return text;
}

inline void negate(std::string& word) {
  if (word.size() > 1 && word[1] == '-')
    word.erase(1, 1);
  else
    word.insert(1, "-");
}

inline bool has_word(const std::string& program, const std::function<bool(const std::string&)>& found) {
  bool any = false;
  each_word(program, [&](std::string& word) { any = any || found(word); });
  return any;
}

inline bool is_one_of(const std::string& word, std::initializer_list<const char*> words) {
  for (const char* w : words)
    if (word == w) return true;
  return false;
}

// Every axis table of a setup.
inline void each_table(spec::Setup& setup, const std::function<void(spec::AxisTable&)>& change) {
  for (spec::AxisTable& table : setup.workpiece) change(table);
  for (auto& [number, table] : setup.additional_workpiece) change(table);
  change(setup.position);
  for (auto& [number, table] : setup.reference) change(table);
  change(setup.floating_reference);
}

// No rotary axis turns the tool, so that laws of space hold for the linear axes alone.
inline void without_kinematics(spec::Setup& setup) {
  for (auto it = setup.parameters.begin(); it != setup.parameters.end();)
    it = it->first.number >= 19600 && it->first.number != 19631 ? setup.parameters.erase(it) : std::next(it);
}

}  // namespace toolcomp::laws
