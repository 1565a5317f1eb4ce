// SPDX-License-Identifier: Apache-2.0
#include "corpus/mine/harvest.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "corpus/vector.h"
#include "fuzz/gen/numbers.h"
#include "fuzz/gen/program_text.h"
#include "fuzz/oracle/compare.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"

namespace toolcomp::corpus {
namespace {

using exact::Sign;

// What is nearer by less is not tried by both engines.
constexpr double kNearer = 0.9;
constexpr double kWorse = 1.001;

// The case alone, as it is written and read again; nothing where no reader takes it.
std::optional<spec::Case> as_written(const spec::Case& c) {
  spec::Case bare;
  bare.section = c.section;
  bare.dialect = c.dialect;
  bare.setup = c.setup;
  bare.program = c.program;
  bare.samples = c.samples;
  bare.id = vector_id(bare);
  try {
    spec::Case read = spec::read_case(spec::write_case_line(bare), "case");
    if (read.setup != bare.setup || read.program != bare.program) return std::nullopt;
    return read;
  } catch (const spec::InputError&) {
    return std::nullopt;
  }
}

bool has_usual_numbers(const spec::Case& c) {
  return fuzz::finest(fuzz::Numbers(c).values()) <= fuzz::usual_decimals(c.setup.control);
}

// The clause at which a run of the model ends undecided although no clause leaves it open.
std::optional<std::string> not_decided(const fuzz::ModelRun& run) {
  if (run.events.empty()) return std::nullopt;
  const model::Event& last = run.events.back();
  if (last.kind != spec::EventKind::undecided || fuzz::left_open(last)) return std::nullopt;
  return std::string(last.number.view());
}

// The case with fewer lines for which `holds` still holds.
spec::Case with_fewer_lines(spec::Case c, const std::function<bool(const spec::Case&)>& holds) {
  std::vector<std::string> lines = fuzz::lines(c.program);
  for (std::size_t at = lines.size(); at-- > 0 && lines.size() > 1;) {
    std::vector<std::string> fewer = lines;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(at));
    spec::Case candidate = c;
    candidate.program = fuzz::joined(fewer);
    if (!holds(candidate)) continue;
    c = std::move(candidate);
    lines = std::move(fewer);
  }
  return c;
}

}  // namespace

std::optional<fuzz::ModelRun> Harvest::look(const spec::Case& c, const std::string& found) {
  if (!fuzz::is_searched(c)) {
    ++not_searched_;
    return std::nullopt;
  }
  ++runs_;
  std::optional<fuzz::ModelRun> run;
  try {
    run = fuzz::run_model(c);
  } catch (const spec::InputError&) {
    return std::nullopt;
  } catch (const std::exception& error) {
    differ_.try_emplace(fmt::format("{} exception", c.section), Met{c, error.what()});
    return std::nullopt;
  }
  take(*run, c, found);
  return run;
}

std::optional<fuzz::Verdict> Harvest::judge(const spec::Case& c, const std::string& found) {
  if (!fuzz::is_searched(c)) {
    ++not_searched_;
    return std::nullopt;
  }
  ++runs_;
  const fuzz::Trial trial = fuzz::try_case(c);
  take(trial.run, c, found);
  if (!agrees(trial, c) || trial.verdict.wide != 0) return std::nullopt;
  worse(trial.verdict, c, found);
  return trial.verdict;
}

void Harvest::take(const fuzz::ModelRun& run, const spec::Case& c, const std::string& found) {
  if (const auto clause = not_decided(run)) {
    undecided_.try_emplace(c.section + ' ' + *clause, Met{c, *clause});
    return;
  }
  const auto& counts = run.recorder.counts();
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i].reached != 0 && spec::clauses()[i].outcomes == spec::ClauseOutcomes::sign)
      ++decided_[static_cast<spec::Clause>(i)];
  std::optional<bool> usual;
  std::map<Key, double> nearer;
  for (const model::Decision& d : run.recorder.decisions()) {
    const double margin = fuzz::margin(d);
    if (!usual) usual = has_usual_numbers(c);
    const Key key{d.clause, d.outcome, *usual};
    const auto kept = kept_.find(key);
    if (kept != kept_.end() && !(margin < kept->second.margin * kNearer)) continue;
    const auto [at, first] = nearer.try_emplace(key, margin);
    if (!first) at->second = std::min(at->second, margin);
  }
  if (nearer.empty()) return;
  const auto written = as_written(c);
  if (!written || !agrees(fuzz::try_case(*written), *written)) return;
  for (const auto& [key, margin] : nearer) kept_[key] = {margin, *written, found};
}

bool Harvest::agrees(const fuzz::Trial& trial, const spec::Case& c) {
  const fuzz::Verdict& v = trial.verdict;
  if (trial.found()) {
    const std::string kind = v.difference->kind == "law" ? v.difference->field : v.difference->kind;
    const std::string clause = v.difference->clause ? std::string(spec::info(*v.difference->clause).id) : "";
    differ_.try_emplace(fmt::format("{} {} {}", c.section, kind, clause), Met{c, fuzz::explain(*v.difference)});
    return false;
  }
  if (v.outcome == fuzz::Outcome::undecided) undecided_.try_emplace(c.section + ' ' + v.undecided, Met{c, v.undecided});
  return v.outcome == fuzz::Outcome::agrees;
}

void Harvest::worse(const fuzz::Verdict& verdict, const spec::Case& c, const std::string& found) {
  for (const Deviation of : {Deviation::ulp, Deviation::um}) {
    const double value = deviation(verdict, of);
    const auto kept = worst_.find(of);
    // Where all is exact it is zero, and that is stated too.
    if (kept != worst_.end() && !(value > kept->second.margin * kWorse)) continue;
    if (const auto written = as_written(c)) worst_[of] = {value, *written, found};
  }
}

void Harvest::shorten() {
  for (auto& [key, kept] : kept_) {
    const spec::Clause clause = std::get<0>(key);
    const Sign outcome = std::get<1>(key);
    const bool usual = std::get<2>(key);
    const auto margin = [&](const fuzz::Trial& trial) -> std::string {
      if (trial.verdict.outcome != fuzz::Outcome::agrees) return "";
      const auto least = least_margin(trial.run, clause, outcome);
      return least ? least->margin : "";
    };
    ++runs_;
    const std::string before = margin(fuzz::try_case(kept.c));
    kept.c = with_fewer_lines(kept.c, [&](const spec::Case& c) {
      ++runs_;
      return has_usual_numbers(c) == usual && margin(fuzz::try_case(c)) == before;
    });
  }
  // Any program has a deviation of zero or more.
  for (auto& [deviates, kept] : worst_) {
    if (kept.margin == 0) continue;
    const Deviation of = deviates;
    kept.c = with_fewer_lines(kept.c, [&, least = kept.margin](const spec::Case& c) {
      ++runs_;
      const fuzz::Verdict v = fuzz::try_case(c).verdict;
      return v.outcome == fuzz::Outcome::agrees && v.wide == 0 && deviation(v, of) >= least;
    });
  }
}

std::vector<Nearest> Harvest::nearest() const {
  std::vector<Nearest> list;
  for (const auto& [key, kept] : kept_) {
    const auto [clause, outcome, usual] = key;
    // More digits that lead no nearer say nothing more.
    const auto in_usual = kept_.find({clause, outcome, true});
    if (!usual && in_usual != kept_.end() && in_usual->second.margin <= kept.margin) continue;
    const auto least = least_margin(fuzz::run_model(kept.c), clause, outcome);
    if (!least) continue;
    list.push_back({clause, outcome, fuzz::finest(fuzz::Numbers(kept.c).values()), least->margin, least->line,
                    kept.found, kept.c});
  }
  return list;
}

std::vector<Worst> Harvest::worst() const {
  std::vector<Worst> list;
  for (const auto& [of, kept] : worst_) {
    spec::Case c = kept.c;
    // Both engines agreed on it; digits that cannot be certified would leave it a case alone.
    if (!complete(c).empty()) c = kept.c;
    list.push_back(
        {kept.c.section, of, deviation_text(deviation(fuzz::try_case(kept.c).verdict, of)), kept.found, std::move(c)});
  }
  return list;
}

std::vector<Met> Harvest::values(const std::map<std::string, Met>& met) {
  std::vector<Met> list;
  list.reserve(met.size());
  for (const auto& [key, value] : met) list.push_back(value);
  return list;
}

}  // namespace toolcomp::corpus
