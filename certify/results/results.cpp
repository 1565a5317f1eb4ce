// SPDX-License-Identifier: Apache-2.0
#include "certify/results/results.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "certify/judge.h"
#include "fuzz/gen/generator.h"
#include "spec/clauses/clauses.h"
#include "spec/language/byte_source.h"
#include "spec/language/document.h"
#include "spec/language/input_error.h"
#include "spec/language/known.h"
#include "spec/language/printable.h"

namespace toolcomp::certify::results {
namespace {

using spec::document::Kind;
using spec::document::Member;
using spec::document::Node;
using spec::document::Reader;

constexpr std::uint64_t kMostCount = 1'000'000'000'000;
constexpr std::size_t kLongestName = 80;
constexpr std::size_t kLongestText = 500;

// Text of a certificate, fit to be shown.
std::string shown(const Reader& read, const Node& table, std::string_view key, std::size_t most = kLongestText) {
  return spec::printable(read.string(read.needed(table, key), key), most);
}

std::uint64_t count(const Reader& read, const Node& table, std::string_view key) {
  return read.integer(read.needed(table, key), key, 0, kMostCount);
}

const Node& table_of(const Reader& read, const Node& root, std::string_view key) {
  const Node& node = read.needed(root, key);
  read.expect(node, Kind::table, key);
  return node;
}

const Node& array_of(const Reader& read, const Node& root, std::string_view key) {
  const Node& node = read.needed(root, key);
  read.expect(node, Kind::array, key);
  return node;
}

// A section that is built in, or "" for programs of the user's own.
std::string section_of(const Reader& read, const Node& table) {
  const Node& node = read.needed(table, "section");
  const std::string& section = read.string(node, "section");
  if (!section.empty() && std::ranges::find(fuzz::sections(), section) == fuzz::sections().end())
    read.fail(node.at, "section: " + spec::document::in_quotes(section) +
                           " is none of this toolcomp; `toolcomp spec sections` lists them");
  return section;
}

void add_differences(const Reader& read, const Node& root, Controller& controller) {
  const Node* const known = root.find("known_differences");
  if (known == nullptr) return;
  read.expect(*known, Kind::table, "known_differences");
  for (const Member& member : known->members)
    controller.differences[spec::printable(member.name, kLongestName)] =
        spec::printable(read.string(member.value, "known_differences"), kLongestText);
}

int status_of(const Reader& read, const Node& root) {
  const Node& node = read.needed(root, "exit_status");
  const auto status = static_cast<int>(read.integer(node, "exit_status", 0, 4));
  if (status == 2) read.fail(node.at, "exit_status: no certificate is written with 2");
  return status;
}

// What was counted in a section, beside its cell.
struct Counted {
  std::uint64_t undecided = 0;
  std::uint64_t partly = 0;  // cases
  std::uint64_t not_run = 0;
  std::uint64_t wide = 0;      // values
  std::uint64_t left_out = 0;  // events
  bool judged = false;
  bool failed = false;  // the harness, by its own check
};

std::string several(std::uint64_t n, std::string_view what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

// And why no more than this was judged.
std::pair<Standing, std::string> standing_of(const Cell& cell, const Counted& counted) {
  if (cell.findings > 0) return {Standing::finding, ""};
  if (counted.failed) return {Standing::not_decided, "the harness failed its own check"};
  if (counted.undecided > 0)
    return {Standing::not_decided, several(counted.undecided, "case") + " could not be decided"};
  const Standing whole = cell.known_differences.empty() ? Standing::conforms : Standing::by_design;
  if (cell.cases == 0) return {whole == Standing::conforms ? Standing::not_applicable : whole, ""};
  if (counted.left_out > 0)
    return {Standing::partly_judged, several(counted.left_out, "event") + " left out by --known"};
  if (!counted.judged) return {Standing::not_decided, "no value was judged"};
  if (counted.not_run > 0) return {Standing::partly_judged, several(counted.not_run, "case") + " not run"};
  if (counted.partly > 0) return {Standing::partly_judged, several(counted.partly, "case") + " judged in part"};
  if (too_many_wide(cell.values, counted.wide))
    return {Standing::partly_judged, words_on_wide(cell.values, counted.wide)};
  return {whole, ""};
}

void settle(Cell& cell, const Counted& counted) { std::tie(cell.standing, cell.why) = standing_of(cell, counted); }

void add_section(const Reader& read, const Node& node, Controller& controller) {
  read.expect(node, Kind::table, "a section");
  const std::string section = section_of(read, node);
  if (controller.cells.contains(section))
    read.fail(node.at, "sections: " + spec::document::in_quotes(section) + " twice");
  Cell& cell = controller.cells[section];
  const Node& results = table_of(read, node, "results");
  Counted counted;
  counted.failed = controller.exit_status == 4;
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < kResultCount; ++i) {
    const auto result = static_cast<Result>(i);
    const std::uint64_t cases = count(read, results, certify::name(result));
    all += cases;
    if (result == Result::agrees) cell.agree = cases;
    if (result == Result::undecided) counted.undecided = cases;
    if (result == Result::partly_judged) counted.partly = cases;
    if (result == Result::not_run) counted.not_run = cases;
    if (result == Result::not_applicable) cell.not_applicable = cases;
    if (result != Result::differs || cases == 0) continue;
    const bool told =
        std::ranges::any_of(controller.findings, [&](const ToldFinding& f) { return f.section == section; });
    if (!told && controller.findings.size() < kMostFindings)
      read.fail(node.at, fmt::format("sections: {} cases of {} differ, and no finding is of them", cases,
                                     spec::document::in_quotes(section)));
  }
  cell.cases = all - cell.not_applicable;
  cell.values = count(read, node, "values");
  counted.judged = cell.values > 0;
  counted.wide = count(read, node, "values_not_judged");
  counted.left_out = count(read, node, "events_left_out");
  if (const Node* known = node.find("known_differences")) {
    read.expect(*known, Kind::table, "known_differences");
    for (const Member& member : known->members)
      cell.known_differences[spec::printable(member.name, kLongestName)] =
          read.integer(member.value, member.name, 1, kMostCount);
  }
  settle(cell, counted);
}

// "coordinate: line 3: axes.X is 5 and should be 4".
std::string what_of(const Reader& read, const Node& node) {
  std::string what = shown(read, node, "kind", kLongestName);
  if (const std::uint64_t line = count(read, node, "line"); line > 0) what += fmt::format(", line {}", line);
  const std::string field = shown(read, node, "field", kLongestName);
  const std::string expected = shown(read, node, "expected");
  const std::string actual = shown(read, node, "actual");
  if (!field.empty()) return what + ": " + field + " is " + actual + " and should be " + expected;
  if (!actual.empty()) what += ": " + actual;
  return expected.empty() ? what : what + ", expected " + expected;
}

void add_findings(const Reader& read, const Node& root, Controller& controller,
                  std::map<std::string, std::uint64_t>& of) {
  for (const Node& node : array_of(read, root, "findings").items) {
    read.expect(node, Kind::table, "a finding");
    ToldFinding finding;
    finding.section = section_of(read, node);
    ++of[finding.section];
    if (controller.findings.size() >= kMostFindings) continue;
    const auto text = [&](std::string_view key) {
      return read.needed(node, key).kind == Kind::null ? std::string() : shown(read, node, key);
    };
    finding.clause = text("clause");
    finding.source = text("source");
    finding.what = what_of(read, node);
    finding.cases = count(read, node, "occurrences");
    controller.findings.push_back(std::move(finding));
  }
}

void add_causes(const Reader& read, const Node& root, Controller& controller) {
  const Node* const causes = root.find("causes");
  if (causes == nullptr) return;
  read.expect(*causes, Kind::array, "causes");
  for (const Node& node : causes->items) {
    if (controller.causes.size() >= kMostFindings) return;
    controller.causes.push_back(
        {shown(read, node, "cause"), array_of(read, node, "findings").items.size(), count(read, node, "cases")});
  }
}

// By section; clauses of rules that sections share (fanuc/program) belong to none of them.
void add_clauses(const Reader& read, const Node& root, Controller& controller) {
  for (const Member& member : table_of(read, root, "clauses").members) {
    const auto clause = spec::find_clause(member.name);
    if (!clause) continue;  // of another set of clauses, which this one cannot say anything of
    const auto cell = controller.cells.find(std::string(spec::info(*clause).section));
    if (cell != controller.cells.end()) cell->second.clauses.emplace_back(member.name);
  }
}

// Of a controller that answers.
Controller of_answers(const Reader& read, const Node& root) {
  static_cast<void>(read.integer(read.needed(root, "certificate"), "certificate", 1, 1));
  Controller c;
  c.exit_status = status_of(read, root);
  const Node& controller = table_of(read, root, "controller");
  const Node& identity = table_of(read, root, "identity");
  c.name = shown(read, controller, "name", kLongestName);
  c.version = shown(read, controller, "version", kLongestName);
  for (const std::string& field : read.strings(read.needed(controller, "fields_not_judged"), "fields_not_judged"))
    c.fields_not_judged.push_back(spec::printable(field, kLongestName));
  c.tool = shown(read, identity, "tool", kLongestName);
  c.corpus = shown(read, identity, "corpus", kLongestName);
  if (c.corpus == "none") c.corpus.clear();
  const std::vector<std::string> judged =
      read.strings(read.needed(table_of(read, root, "left_out"), "judged"), "judged");
  if (judged.size() < spec::kAllKnown.size()) c.judged_by = spec::printable(fmt::format("{}", fmt::join(judged, ", ")));
  std::map<std::string, std::uint64_t> findings;
  add_findings(read, root, c, findings);
  if ((c.exit_status == 1) == findings.empty() && c.exit_status != 4)
    read.fail(read.needed(root, "exit_status").at,
              fmt::format("exit_status: is {}, and there are {} findings", c.exit_status,
                          read.needed(root, "findings").items.size()));
  add_causes(read, root, c);
  add_differences(read, root, c);
  for (const Node& section : array_of(read, root, "sections").items) add_section(read, section, c);
  for (const auto& [section, number] : findings) {
    Cell& cell = c.cells[section];
    cell.findings = number;
    settle(cell, {});
  }
  if (c.exit_status == 0)
    for (const auto& [section, cell] : c.cells)
      if (cell.standing == Standing::not_decided)
        read.fail(read.needed(root, "exit_status").at,
                  "exit_status: is 0, and of " + spec::document::in_quotes(section) + " " + cell.why);
  add_clauses(read, root, c);
  return c;
}

// Of a controller that an adapter recorded: a program each.
Controller of_recordings(const Reader& read, const Node& root) {
  Controller c;
  c.exit_status = status_of(read, root);
  c.name = shown(read, root, "adapter", kLongestName);
  c.tool = shown(read, root, "tool", kLongestName);
  add_differences(read, root, c);
  std::map<std::string, Counted> counted;
  bool differs = false;
  for (const Node& run : array_of(read, root, "runs").items) {
    read.expect(run, Kind::table, "a run");
    const std::string section = run.find("section") == nullptr ? std::string() : section_of(read, run);
    const std::string& outcome = read.string(read.needed(run, "outcome"), "outcome");
    Cell& cell = c.cells[section];
    Counted& sum = counted[section];
    if (outcome == "not applicable") {
      ++cell.not_applicable;
      continue;
    }
    ++cell.cases;
    if (outcome == "conforms" || outcome == "both refuse") {
      ++cell.agree;
      sum.judged = true;
    } else if (outcome == "known difference") {
      sum.judged = true;
      for (const std::string& id : read.strings(read.needed(run, "known"), "known"))
        ++cell.known_differences[spec::printable(id, kLongestName)];
    } else if (outcome == "differs") {
      differs = true;
      ++cell.findings;
      if (c.findings.size() < kMostFindings)
        c.findings.push_back(
            {section, "", "", shown(read, run, "id", kLongestName) + ": " + shown(read, run, "why"), 1});
    } else if (outcome == "undecided" || outcome == "failed") {
      ++sum.undecided;
    } else if (outcome == "not run") {
      ++sum.not_run;
    } else {
      read.fail(read.needed(run, "outcome").at, "outcome: " + spec::document::in_quotes(outcome) + " is unknown");
    }
  }
  if ((c.exit_status == 1) != differs)
    read.fail(read.needed(root, "exit_status").at,
              fmt::format("exit_status: is {}, and {} run differs", c.exit_status, differs ? "a" : "no"));
  for (auto& [section, cell] : c.cells) settle(cell, counted[section]);
  return c;
}

}  // namespace

std::string_view name(Standing standing) {
  constexpr std::array<std::string_view, kStandings> names{
      "finding", "not decided", "partly judged", "differs by design", "conforms", "not applicable", "not asked"};
  return names.at(static_cast<std::size_t>(standing));
}

std::string Controller::title() const {
  const std::string called = name.empty() ? "a controller without a name" : name;
  return version.empty() ? called : called + " " + version;
}

const Cell& Controller::cell(std::string_view section) const {
  static const Cell kNone;
  const auto found = cells.find(std::string(section));
  return found == cells.end() ? kNone : found->second;
}

Controller read_certificate(std::string_view text, const std::string& file) {
  const Node root = spec::document::parse_json(text, file);
  const Reader read(file);
  read.expect(root, Kind::table, "a certificate");
  const auto other = [&](const char* key, const char* what) {
    if (root.find(key) != nullptr)
      read.fail(root.at, fmt::format("is the certificate of {}, which names no controller; the results take those of "
                                     "certify --controller",
                                     what));
  };
  other("trace", "one recording");
  other("kit_certificate", "a kit");
  const bool recorded = root.find("adapter") != nullptr && root.find("runs") != nullptr;
  if (!recorded && root.find("certificate") == nullptr)
    read.fail(root.at,
              "is no certificate: \"certificate\", or \"adapter\" and \"runs\", as certify --report writes them, "
              "are expected");
  Controller c = recorded ? of_recordings(read, root) : of_answers(read, root);
  c.verdict = shown(read, root, "verdict");
  const Node& occasion = table_of(read, root, "occasion");
  c.date = shown(read, occasion, "date", kLongestName);
  c.serial = shown(read, occasion, "serial", kLongestName);
  return c;
}

Controller read_certificate(const std::filesystem::path& folder) {
  const std::string file = (folder / "certificate.json").string();
  spec::expect_plain_file(file);
  Controller c = read_certificate(spec::read_file(file, kLongestFile), file);
  c.folder = spec::printable(folder.string());
  return c;
}

std::vector<std::string> rows(std::span<const Controller> controllers) {
  std::vector<std::string> sections(fuzz::sections().begin(), fuzz::sections().end());
  if (std::ranges::any_of(controllers, [](const Controller& c) { return c.cells.contains(""); }))
    sections.emplace_back();
  return sections;
}

std::string words(const Cell& cell) {
  if (cell.standing != Standing::finding) return std::string(name(cell.standing));
  return fmt::format("{} finding{}", cell.findings, cell.findings == 1 ? "" : "s");
}

}  // namespace toolcomp::certify::results
