// SPDX-License-Identifier: Apache-2.0
#include "corpus/hard_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>
#include <vector>

#include "corpus/sha256.h"
#include "corpus/vector.h"
#include "fuzz/gen/generator.h"
#include "fuzz/gen/numbers.h"
#include "fuzz/gen/program_text.h"
#include "fuzz/oracle/policy.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/file_writer.h"
#include "spec/language/input_error.h"

namespace toolcomp::corpus {
namespace {

namespace fs = std::filesystem;
using exact::Sign;
using Json = nlohmann::ordered_json;

constexpr std::string_view kOutcomes[] = {"positive", "negative", "tie"};
constexpr Sign kSigns[] = {Sign::positive, Sign::negative, Sign::zero};
constexpr std::string_view kManifest = "manifest.json";

std::size_t place(Sign sign) { return static_cast<std::size_t>(std::ranges::find(kSigns, sign) - std::begin(kSigns)); }

std::string file_of(const std::string& section) { return section + ".jsonl"; }

// Lists of one entry a line.
std::string list(const std::vector<Json>& entries) {
  std::string text = "[";
  for (const Json& entry : entries) text += (&entry == entries.data() ? "\n    " : ",\n    ") + entry.dump();
  return text + "\n  ]";
}

std::string manifest(const HardCases& hard, const std::map<std::string, std::string>& files,
                     const std::map<std::string, std::size_t>& counts) {
  std::vector<Json> sections;
  for (const std::string_view section : fuzz::sections())
    if (const auto at = hard.sections.find(std::string(section)); at != hard.sections.end()) {
      const std::string file = file_of(at->first);
      const bool there = files.contains(file);
      sections.push_back({{"section", section},
                          {"runs", at->second.runs},
                          {"searches", at->second.searches},
                          {"cases", there ? counts.at(file) : 0},
                          {"sha256", there ? sha256(files.at(file)) : ""}});
    }
  std::vector<Json> predicates;
  predicates.reserve(hard.predicates.size());
  for (const auto& [clause, searched] : hard.predicates)
    predicates.push_back({{"clause", spec::info(clause).id}, {"runs", searched.runs}, {"searches", searched.searches}});
  std::vector<Json> nearest;
  nearest.reserve(hard.nearest.size());
  for (const Nearest& n : hard.nearest)
    nearest.push_back({{"clause", spec::info(n.clause).id},
                       {"outcome", name_of(n.outcome)},
                       {"margin", n.margin},
                       {"decimals", n.decimals},
                       {"case", n.c.id},
                       {"line", n.line},
                       {"found", n.found}});
  std::vector<Json> worst;
  worst.reserve(hard.worst.size());
  for (const Worst& w : hard.worst)
    worst.push_back(
        {{"section", w.section}, {"of", name_of(w.of)}, {"value", w.value}, {"case", w.c.id}, {"found", w.found}});
  return fmt::format(
      "{{\n  \"hard\": 1,\n  \"seeds\": {},\n  \"sections\": {},\n  \"predicates\": {},\n  \"nearest\": {},\n  "
      "\"worst\": {}\n}}\n",
      Json(hard.seeds).dump(), list(sections), list(predicates), list(nearest), list(worst));
}

const Nearest* find(const HardCases& hard, spec::Clause clause, Sign outcome, bool usual) {
  for (const Nearest& n : hard.nearest)
    if (n.clause == clause && n.outcome == outcome && is_usual(n) == usual) return &n;
  return nullptr;
}

std::string cell(const Nearest* n) { return n == nullptr ? "" : n->margin; }

std::string page(const HardCases& hard) {
  std::string text = fmt::format(
      R"(# Hard cases

Written by `toolcomp corpus mine`; a test keeps it so, and `toolcomp corpus hard` runs every case again.

For each decision by sign the programs nearest to its boundary, and for each section the programs on which the fast engine
lies farthest off. Every line of a `.jsonl` file is a case, and every verb that takes cases takes them; the largest
deviations are vectors, with what is expected. `manifest.json` says what each case is there for, and how it was found.

Searched: programs of at most {} lines, numbers of at most {} (mm, inches, degrees) and {} digits. The search begins with
the golden corpus and with generated programs. It follows the margin of a decision, as the exact model reports it, along one
number of program or setup to neighbouring decimals around zero; then it varies a second number and computes at which of
its values the first comes nearest to zero. Only cases count in which both engines agree within the policy.

## Nearest to a boundary

|quantity| / scale of the decision, rounded up. *Usual*: with no number of more than {} decimals in a FANUC program or
setup, {} in Klartext; *any*: up to {} digits. A tie is a quantity of exactly zero; without an entry none was met.

| predicate | + usual | + any | - usual | - any | tie | decided in runs | searches |
|---|---|---|---|---|---|---|---|
)",
      fuzz::kMostLines, fuzz::kSearchedMagnitude, fuzz::kSearchedDigits, fuzz::usual_decimals(spec::Control::fanuc),
      fuzz::usual_decimals(spec::Control::heidenhain), fuzz::kSearchedDigits);
  for (std::size_t i = 0; i < spec::kClauseCount; ++i) {
    if (spec::clauses()[i].outcomes != spec::ClauseOutcomes::sign) continue;
    const auto clause = static_cast<spec::Clause>(i);
    const auto searched = hard.predicates.find(clause);
    const Searched s = searched == hard.predicates.end() ? Searched{} : searched->second;
    const bool tie =
        find(hard, clause, Sign::zero, true) != nullptr || find(hard, clause, Sign::zero, false) != nullptr;
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} |\n", spec::clauses()[i].id,
                        cell(find(hard, clause, Sign::positive, true)), cell(find(hard, clause, Sign::positive, false)),
                        cell(find(hard, clause, Sign::negative, true)), cell(find(hard, clause, Sign::negative, false)),
                        tie ? "tie" : "", s.runs, s.searches);
  }
  text += R"(
## Largest deviations of the fast engine

How far a number lies outside the exact enclosure, in the unit that the policy multiplies by k (`fuzz/oracle/policy.h`; k of
coordinates, rotary axes, tool axis and sweep stands beside it), and in micrometres for lengths. Cases with a value that is
granted more than a micrometre are left out. Another compiler or another mathematical library may give less.

| section | worst, ulp | k | worst, µm | runs | searches |
|---|---|---|---|---|---|
)";
  for (const std::string_view section : fuzz::sections()) {
    const auto searched = hard.sections.find(std::string(section));
    if (searched == hard.sections.end()) continue;
    const auto of = [&](Deviation d) -> std::string {
      for (const Worst& w : hard.worst)
        if (w.section == section && w.of == d) return fmt::format("{} (`{}`)", w.value, w.c.id);
      return "";
    };
    const fuzz::policy::Budget& k = fuzz::policy::budget(section);
    text += fmt::format("| {} | {} | {}, {}, {}, {} | {} | {} | {} |\n", section, of(Deviation::ulp), k.coordinate,
                        k.rotary, k.tool_axis, k.sweep, of(Deviation::um), searched->second.runs,
                        searched->second.searches);
  }
  return text;
}

template <class T, std::size_t N>
T one_of(const Json& name, const T (&values)[N], const fs::path& file) {
  for (const T& value : values)
    if (name == name_of(value)) return value;
  throw spec::InputError(file.string(), 0, 0, name.dump() + " is not known");
}

spec::Clause clause_of(const Json& id, const fs::path& file) {
  const auto clause = spec::find_clause(id.get<std::string>());
  if (!clause) throw spec::InputError(file.string(), 0, 0, "there is no clause " + id.dump());
  return *clause;
}

}  // namespace

std::string_view name_of(Sign outcome) { return kOutcomes[place(outcome)]; }
std::string_view name_of(Deviation of) { return of == Deviation::ulp ? "ulp" : "µm"; }

std::map<std::string, std::string> hard_files(HardCases& hard) {
  for (Nearest& n : hard.nearest) n.c.id = vector_id(n.c);
  for (Worst& w : hard.worst) w.c.id = vector_id(w.c);
  std::ranges::sort(hard.nearest, {},
                    [](const Nearest& n) { return std::tuple(n.clause, place(n.outcome), n.decimals, n.c.id); });
  std::ranges::sort(hard.worst, {}, [](const Worst& w) {
    return std::tuple(std::ranges::find(fuzz::sections(), w.section) - fuzz::sections().begin(), w.of, w.c.id);
  });
  std::map<std::string, std::map<std::string, const spec::Case*>> by_section;
  for (const Nearest& n : hard.nearest) by_section[n.c.section][n.c.id] = &n.c;
  for (const Worst& w : hard.worst) by_section[w.c.section][w.c.id] = &w.c;
  std::map<std::string, std::string> files;
  std::map<std::string, std::size_t> counts;
  for (const auto& [section, cases] : by_section) {
    std::string& text = files[file_of(section)];
    counts[file_of(section)] = cases.size();
    for (const auto& [id, c] : cases) text += spec::write_case_line(*c) + '\n';
  }
  std::string listed = manifest(hard, files, counts);
  files["README.md"] = page(hard);
  files[std::string(kManifest)] = std::move(listed);
  return files;
}

HardCases read_hard(const fs::path& folder) {
  const fs::path file = folder / kManifest;
  HardCases hard;
  try {
    const Json json = Json::parse(spec::read_file(file));
    if (json.at("hard") != 1) throw spec::InputError(file.string(), 0, 0, "hard: 1 is the format that is known");
    hard.seeds = json.at("seeds").get<std::set<std::uint64_t>>();
    std::map<std::string, spec::Case> cases;
    for (const Json& entry : json.at("sections")) {
      const auto section = entry.at("section").get<std::string>();
      hard.sections[section] = {entry.at("runs").get<std::uint64_t>(), entry.at("searches").get<std::uint64_t>()};
      if (entry.at("cases") == 0) continue;
      for (spec::Case& c : read_cases(folder / file_of(section))) cases[c.id] = std::move(c);
    }
    const auto case_of = [&](const Json& id) {
      const auto c = cases.find(id.get<std::string>());
      if (c == cases.end()) throw spec::InputError(file.string(), 0, 0, "there is no case " + id.dump());
      return c->second;
    };
    for (const Json& entry : json.at("predicates"))
      hard.predicates[clause_of(entry.at("clause"), file)] = {entry.at("runs").get<std::uint64_t>(),
                                                              entry.at("searches").get<std::uint64_t>()};
    for (const Json& entry : json.at("nearest"))
      hard.nearest.push_back({clause_of(entry.at("clause"), file), one_of(entry.at("outcome"), kSigns, file),
                              entry.at("decimals").get<int>(), entry.at("margin").get<std::string>(),
                              entry.at("line").get<std::uint64_t>(), entry.at("found").get<std::string>(),
                              case_of(entry.at("case"))});
    constexpr Deviation kDeviations[] = {Deviation::ulp, Deviation::um};
    for (const Json& entry : json.at("worst"))
      hard.worst.push_back({entry.at("section").get<std::string>(), one_of(entry.at("of"), kDeviations, file),
                            entry.at("value").get<std::string>(), entry.at("found").get<std::string>(),
                            case_of(entry.at("case"))});
  } catch (const nlohmann::json::exception& error) {
    throw spec::InputError(file.string(), 0, 0, error.what());
  }
  return hard;
}

void write_hard(const fs::path& folder, HardCases hard) {
  const std::map<std::string, std::string> files = hard_files(hard);
  for (const auto& [name, text] : files) spec::write_file(folder / name, text);
  for (const std::string_view section : fuzz::sections())
    if (const std::string file = file_of(std::string(section)); !files.contains(file)) fs::remove(folder / file);
}

}  // namespace toolcomp::corpus
