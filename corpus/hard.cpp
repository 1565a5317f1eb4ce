// SPDX-License-Identifier: Apache-2.0
#include "corpus/hard.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "corpus/golden.h"
#include "corpus/vector.h"
#include "fuzz/gen/numbers.h"
#include "judge/oracle/trial.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"

namespace toolcomp::corpus {
namespace {

namespace fs = std::filesystem;
using exact::Integer;
using exact::power_of_ten;
using exact::Rational;
using exact::Sign;
using Json = nlohmann::json;

constexpr int kMarginDigits = 3;
constexpr int kDeviationDigits = 4;

// What they are called in the manifest.
constexpr std::pair<Sign, std::string_view> kOutcomes[] = {
    {Sign::positive, "positive"}, {Sign::negative, "negative"}, {Sign::zero, "tie"}};
constexpr std::pair<Deviation, std::string_view> kDeviations[] = {{Deviation::ulp, "ulp"}, {Deviation::um, "µm"}};

template <class Value, std::size_t N>
std::string_view name_in(const std::pair<Value, std::string_view> (&names)[N], Value value) {
  return std::ranges::find(names, value, &std::pair<Value, std::string_view>::first)->second;
}

template <class Value, std::size_t N>
Value value_in(const std::pair<Value, std::string_view> (&names)[N], const Json& name, const fs::path& file) {
  for (const auto& [value, known] : names)
    if (name == known) return value;
  throw spec::InputError(file.string(), 0, 0, name.dump() + " is not known");
}

spec::Clause clause_of(const Json& id, const fs::path& file) {
  const auto clause = spec::find_clause(id.get<std::string>());
  if (!clause) throw spec::InputError(file.string(), 0, 0, "there is no clause " + id.dump());
  return *clause;
}

// |quantity| / scale from above.
Rational ratio(const model::Decision& d) {
  if (d.scale.sign() == Sign::zero) return 1;
  const exact::Real r = d.quantity / d.scale;
  const exact::Enclosure e = r.enclosure();
  return std::max(abs(e.lower), abs(e.upper));
}

// The smallest margin with that outcome that a run has for a clause, and where; nothing where it has none.
struct MarginFound {
  std::string margin;
  std::uint64_t line = 0;
};
std::optional<MarginFound> least_margin(const judge::ModelRun& run, spec::Clause clause, Sign outcome) {
  const model::Decision* least = nullptr;
  for (const model::Decision& d : run.recorder.decisions())
    if (d.clause == clause && d.outcome == outcome && (least == nullptr || judge::margin(d) < judge::margin(*least)))
      least = &d;
  if (least == nullptr) return std::nullopt;
  if (outcome == Sign::zero) return MarginFound{"0", least->line};
  return MarginFound{rounded_up(ratio(*least), kMarginDigits), least->line};
}

class Checker {
 public:
  Checker(const HardCases& hard, const std::vector<std::string>& sections,
          const std::function<void(std::uint64_t)>& progress)
      : hard_(hard), sections_(sections), progress_(progress) {}

  HardCheck run() {
    for (const std::string& section : sections_)
      if (!hard_.sections.contains(section))
        throw spec::InputError("--section", 0, 0, "there are no hard cases of section " + section);
    std::map<std::string, std::pair<const spec::Case*, std::vector<std::size_t>>> by_case;
    for (std::size_t i = 0; i < hard_.nearest.size() + hard_.worst.size(); ++i) {
      const bool near = i < hard_.nearest.size();
      const spec::Case& c = near ? hard_.nearest[i].c : hard_.worst[i - hard_.nearest.size()].c;
      if (!sections_.empty() && std::ranges::find(sections_, c.section) == sections_.end()) continue;
      auto& entry = by_case[c.section + ' ' + c.id];
      entry.first = &c;
      entry.second.push_back(i);
    }
    for (const auto& [name, entry] : by_case) {
      try_one(*entry.first, entry.second);
      if (progress_) progress_(++result_.cases);
    }
    result_.cases = by_case.size();
    return std::move(result_);
  }

 private:
  void fail(const spec::Case& c, const std::string& what) {
    result_.failures.push_back(fmt::format("{}.jsonl: {}: {}", c.section, c.id, what));
  }

  void try_one(const spec::Case& c, const std::vector<std::size_t>& statements) {
    const judge::Trial trial = judge::try_case(c);
    if (trial.verdict.outcome != judge::Outcome::agrees) {
      fail(c, trial.verdict.difference ? judge::explain(*trial.verdict.difference)
                                       : "could not be judged: " + trial.verdict.undecided);
      return;
    }
    for (const std::size_t i : statements) {
      ++result_.statements;
      if (i < hard_.nearest.size())
        check(hard_.nearest[i], trial);
      else
        check(hard_.worst[i - hard_.nearest.size()], trial);
    }
  }

  void check(const Nearest& n, const judge::Trial& trial) {
    const std::string what = fmt::format("{} {}", spec::info(n.clause).id, name_in(kOutcomes, n.outcome));
    const auto least = least_margin(trial.run, n.clause, n.outcome);
    if (!least)
      fail(n.c, what + " is not reached");
    else if (least->margin != n.margin)
      fail(n.c, fmt::format("{}: the margin is {}, the manifest states {}", what, least->margin, n.margin));
    else if (least->line != n.line)
      fail(n.c, fmt::format("{}: decided in line {}, the manifest states {}", what, least->line, n.line));
    if (const int finest_there = fuzz::finest(fuzz::Numbers(n.c).values()); finest_there != n.decimals)
      fail(n.c, fmt::format("{} decimals, the manifest states {}", finest_there, n.decimals));
  }

  void check(const Worst& w, const judge::Trial& trial) {
    const double now = w.of == Deviation::ulp ? trial.verdict.worst_ulp : trial.verdict.worst_um;
    const std::string text = rounded_up(Rational(now), kDeviationDigits);
    if (text == w.value) return;
    const double stated = std::stod(w.value);
    if (now > stated)
      fail(w.c, fmt::format("{} {} off, the manifest states {}", text, name_in(kDeviations, w.of), w.value));
    else
      ++result_.lower;
  }

  const HardCases& hard_;
  const std::vector<std::string>& sections_;
  const std::function<void(std::uint64_t)>& progress_;
  HardCheck result_;
};

}  // namespace

fs::path hard_folder() { return default_folder().parent_path() / "hard"; }

std::string rounded_up(const Rational& value, int digits) {
  if (value == 0) return "0";
  int exponent = 0;
  const Integer n = numerator(value);
  const Integer d = denominator(value);
  // n/d >= 10^exponent
  const auto reaches = [&](int e) {
    return e >= 0 ? n >= d * power_of_ten(static_cast<unsigned>(e)) : n * power_of_ten(static_cast<unsigned>(-e)) >= d;
  };
  while (reaches(exponent + 1)) ++exponent;
  while (!reaches(exponent)) --exponent;
  // Digits in front of the point, the quotient upwards.
  const int shift = digits - 1 - exponent;
  const Integer top = shift >= 0 ? Integer(n * power_of_ten(static_cast<unsigned>(shift))) : n;
  const Integer bottom = shift >= 0 ? d : Integer(d * power_of_ten(static_cast<unsigned>(-shift)));
  Integer mantissa = (top + bottom - 1) / bottom;
  if (mantissa == power_of_ten(static_cast<unsigned>(digits))) {
    mantissa /= 10;
    ++exponent;
  }
  std::string text = mantissa.str();
  while (text.size() > 1 && text.back() == '0') text.pop_back();
  if (text.size() > 1) text.insert(1, 1, '.');
  return exponent == 0 ? text : fmt::format("{}e{}", text, exponent);
}

HardCases read_hard(const fs::path& folder) {
  const fs::path file = folder / "manifest.json";
  HardCases hard;
  try {
    const Json json = Json::parse(spec::read_file(file));
    if (json.at("hard") != 1) throw spec::InputError(file.string(), 0, 0, "hard: expected format 1");
    std::map<std::string, spec::Case> cases;
    for (const Json& entry : json.at("sections")) {
      const auto section = entry.at("section").get<std::string>();
      hard.sections.insert(section);
      for (spec::Case& c : read_cases(folder / (section + ".jsonl"))) {
        if (vector_id(c) != c.id)
          throw spec::InputError(section + ".jsonl", 0, 0, c.id + ": the id of its content is " + vector_id(c));
        cases[c.id] = std::move(c);
      }
    }
    const auto case_of = [&](const Json& id) {
      const auto c = cases.find(id.get<std::string>());
      if (c == cases.end()) throw spec::InputError(file.string(), 0, 0, "there is no case " + id.dump());
      return c->second;
    };
    for (const Json& entry : json.at("nearest"))
      hard.nearest.push_back({clause_of(entry.at("clause"), file), value_in(kOutcomes, entry.at("outcome"), file),
                              entry.at("decimals").get<int>(), entry.at("margin").get<std::string>(),
                              entry.at("line").get<std::uint64_t>(), case_of(entry.at("case"))});
    for (const Json& entry : json.at("worst"))
      hard.worst.push_back({entry.at("section").get<std::string>(), value_in(kDeviations, entry.at("of"), file),
                            entry.at("value").get<std::string>(), case_of(entry.at("case"))});
  } catch (const nlohmann::json::exception& error) {
    throw spec::InputError(file.string(), 0, 0, error.what());
  }
  return hard;
}

HardCheck check_hard(const HardCases& hard, const std::vector<std::string>& sections,
                     const std::function<void(std::uint64_t)>& progress) {
  return Checker(hard, sections, progress).run();
}

}  // namespace toolcomp::corpus
