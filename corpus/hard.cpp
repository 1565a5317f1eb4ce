// SPDX-License-Identifier: Apache-2.0
#include "corpus/hard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "corpus/hard_files.h"
#include "corpus/vector.h"
#include "fuzz/gen/generator.h"
#include "fuzz/gen/numbers.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"

namespace toolcomp::corpus {
namespace {

namespace fs = std::filesystem;
using exact::Integer;
using exact::power_of_ten;
using exact::Rational;
using exact::Sign;

constexpr int kMarginDigits = 3;
constexpr int kDeviationDigits = 4;

// |quantity| / scale from above.
Rational ratio(const model::Decision& d) {
  if (d.scale.sign() == Sign::zero) return 1;
  const exact::Real r = d.quantity / d.scale;
  const exact::Enclosure e = r.enclosure();
  return std::max(abs(e.lower), abs(e.upper));
}

class Checker {
 public:
  Checker(const fs::path& folder, const std::vector<std::string>& sections,
          const std::function<void(std::uint64_t)>& progress)
      : folder_(folder), sections_(sections), progress_(progress), hard_(read_hard(folder)) {}

  HardCheck run() {
    for (const std::string& section : sections_)
      if (!hard_.sections.contains(section))
        throw spec::InputError(folder_.string(), 0, 0, "no hard cases of section " + section);
    files();
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

  void files() {
    for (const auto& [name, text] : hard_files(hard_)) {
      const std::string there = fs::exists(folder_ / name) ? spec::read_file(folder_ / name) : "";
      if (there != text) result_.failures.push_back(name + ": not as the writer writes it");
    }
  }

  void try_one(const spec::Case& c, const std::vector<std::size_t>& statements) {
    const fuzz::Trial trial = fuzz::try_case(c);
    if (trial.verdict.outcome != fuzz::Outcome::agrees) {
      fail(c, trial.verdict.difference ? fuzz::explain(*trial.verdict.difference)
                                       : "could not be judged: " + trial.verdict.undecided);
      return;
    }
    if (c.has_expect)
      if (const std::string wrong = verify(c, trial); !wrong.empty()) fail(c, wrong);
    for (const std::size_t i : statements) {
      ++result_.statements;
      if (i < hard_.nearest.size())
        check(hard_.nearest[i], trial);
      else
        check(hard_.worst[i - hard_.nearest.size()], trial);
    }
  }

  void check(const Nearest& n, const fuzz::Trial& trial) {
    const std::string what = fmt::format("{} {}", spec::info(n.clause).id, name_of(n.outcome));
    const auto least = least_margin(trial.run, n.clause, n.outcome);
    if (!least)
      fail(n.c, what + " is not reached");
    else if (least->margin != n.margin)
      fail(n.c, fmt::format("{}: the margin is {}, {} is stated", what, least->margin, n.margin));
    else if (least->line != n.line)
      fail(n.c, fmt::format("{}: decided in line {}, {} is stated", what, least->line, n.line));
    if (const int finest_there = fuzz::finest(fuzz::Numbers(n.c).values()); finest_there != n.decimals)
      fail(n.c, fmt::format("{} decimals, {} are stated", finest_there, n.decimals));
  }

  void check(const Worst& w, const fuzz::Trial& trial) {
    const double now = deviation(trial.verdict, w.of);
    const std::string text = deviation_text(now);
    if (text == w.value) return;
    const double stated = std::stod(w.value);
    if (now > stated)
      fail(w.c, fmt::format("{} {} off, {} is stated", text, name_of(w.of), w.value));
    else
      ++result_.lower;
  }

  fs::path folder_;
  const std::vector<std::string>& sections_;
  const std::function<void(std::uint64_t)>& progress_;
  HardCases hard_;
  HardCheck result_;
};

}  // namespace

fs::path hard_folder() { return default_folder().parent_path() / "hard"; }

bool is_usual(const Nearest& nearest) { return nearest.decimals <= fuzz::usual_decimals(nearest.c.setup.control); }

std::optional<MarginFound> least_margin(const fuzz::ModelRun& run, spec::Clause clause, Sign outcome) {
  const model::Decision* least = nullptr;
  for (const model::Decision& d : run.recorder.decisions())
    if (d.clause == clause && d.outcome == outcome && (least == nullptr || fuzz::margin(d) < fuzz::margin(*least)))
      least = &d;
  if (least == nullptr) return std::nullopt;
  if (outcome == Sign::zero) return MarginFound{"0", least->line};
  return MarginFound{rounded_up(ratio(*least), kMarginDigits), least->line};
}

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

std::string deviation_text(double value) { return rounded_up(Rational(value), kDeviationDigits); }

double deviation(const fuzz::Verdict& verdict, Deviation of) {
  return of == Deviation::ulp ? verdict.worst_ulp : verdict.worst_um;
}

HardCheck check_hard(const fs::path& folder, const std::vector<std::string>& sections,
                     const std::function<void(std::uint64_t)>& progress) {
  return Checker(folder, sections, progress).run();
}

}  // namespace toolcomp::corpus
