// SPDX-License-Identifier: Apache-2.0
// Turns the clause files into C++: `toolcomp_clauses CLAUSE_FOLDER OUTPUT_FOLDER` writes clauses.h and clauses.cpp.
#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "spec/generated_source.h"

namespace {

using toolcomp::spec::fail;
using toolcomp::spec::literal;
using toolcomp::spec::write_changed;

struct ClauseText {
  std::string id, enumerator, section, file, kind, known, document, edition, page, words, text, formula, outcomes;
  std::string positive, negative, tie, reason, unreachable_reason, replaced_by;
  std::vector<std::string> notation;
  std::vector<std::string> parameters, alternatives, unreachable;
  bool testable = true;
  bool makes_value = false;
};

std::string text_of(const toml::table& table, std::string_view key) { return table[key].value_or(std::string()); }

std::vector<std::string> list_of(const toml::table& table, std::string_view key) {
  std::vector<std::string> list;
  if (const auto* array = table[key].as_array())
    for (const auto& item : *array) list.push_back(item.value_or(std::string()));
  return list;
}

std::string joined(const std::vector<std::string>& list) { return fmt::format("{}", fmt::join(list, "\n")); }

// A line of a file's [notation] table: the symbols as written there ("t1, t2", "N(t)"), and what they mean.
struct Symbols {
  std::string written, meaning;
  toml::source_region place;
};
using Notation = std::vector<Symbols>;

bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '\''; }

// The names in a text: letters, digits, _ and '. In prose not the article "a"; in the head of a notation not what is in
// brackets, an argument.
enum class In { prose, formula, head };
std::set<std::string> names_in(std::string_view text, In where) {
  const bool prose = where == In::prose;
  std::set<std::string> names;
  std::string name;
  int depth = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : ' ';
    if (in_name(c)) {
      name += c;
      continue;
    }
    // The id of a clause.
    if (prose && c == '.' && (name == "fanuc" || name == "heidenhain")) {
      i = std::min(text.find_first_of(" ,;:()", i), text.size());
      name.clear();
    }
    const bool begins = i == name.size() || (i > 2 && text[i - 3] == '.');
    const bool article = prose && c == ' ' && i + 1 < text.size() && (name == "a" || (name == "A" && begins)) &&
                         std::islower(static_cast<unsigned char>(text[i + 1])) != 0;
    if (!name.empty() && !article && (where != In::head || depth == 0)) names.insert(name);
    name.clear();
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
  }
  return names;
}

Notation read_notation(const std::filesystem::path& file, const toml::table& root) {
  Notation notation;
  const auto* table = root["notation"].as_table();
  if (table == nullptr) return notation;
  for (const auto& [key, value] : *table) {
    notation.push_back({std::string(key.str()), value.value_or(std::string()), key.source()});
    if (notation.back().meaning.empty()) fail(file, key.source(), "a symbol needs its meaning, a text");
  }
  // In the order of the file: the table is sorted by name.
  std::ranges::sort(notation, {}, [](const Symbols& symbols) { return symbols.place.begin.line; });
  return notation;
}

// Those of which the text or the formula of the clause has a symbol, "SYMBOLS: MEANING".
void explain_symbols(ClauseText& clause, const Notation& notation, std::set<const Symbols*>& used) {
  std::set<std::string> names = names_in(clause.text, In::prose);
  names.merge(names_in(clause.formula, In::formula));
  for (const Symbols& symbols : notation)
    if (std::ranges::any_of(names_in(symbols.written, In::head),
                            [&](const std::string& n) { return names.contains(n); })) {
      clause.notation.push_back(fmt::format("{}: {}", symbols.written, symbols.meaning));
      used.insert(&symbols);
    }
}

constexpr std::string_view kKeys[] = {
    "id",         "kind",         "source",   "text",   "formula",     "parameters",         "alternatives",
    "outcomes",   "outcome_text", "testable", "reason", "unreachable", "unreachable_reason", "replaced_by",
    "makes_value"};
constexpr std::string_view kKinds[] = {"normative", "parameter", "alarm", "open", "note"};
constexpr std::string_view kKnown[] = {"manual", "sister", "recollection", "ours"};
constexpr std::string_view kSourceKeys[] = {"known", "document", "edition", "page", "words"};
constexpr std::string_view kOutcomes[] = {"sign", "fact", "reach"};

ClauseText read_clause(const std::filesystem::path& file, const std::string& section, const toml::table& table) {
  for (const auto& [key, value] : table)
    if (std::ranges::find(kKeys, key.str()) == std::end(kKeys))
      fail(file, key.source(), fmt::format("unknown key {}", key.str()));
  ClauseText clause;
  clause.section = section;
  clause.file = file.filename().string();
  clause.id = text_of(table, "id");
  clause.kind = text_of(table, "kind");
  clause.text = text_of(table, "text");
  clause.formula = text_of(table, "formula");
  clause.outcomes = table["outcomes"].value_or(std::string("reach"));
  clause.testable = table["testable"].value_or(true);
  clause.makes_value = table["makes_value"].value_or(false);
  clause.reason = text_of(table, "reason");
  clause.unreachable_reason = text_of(table, "unreachable_reason");
  clause.replaced_by = text_of(table, "replaced_by");
  clause.parameters = list_of(table, "parameters");
  clause.alternatives = list_of(table, "alternatives");
  clause.unreachable = list_of(table, "unreachable");
  if (const auto* source = table["source"].as_table()) {
    for (const auto& [key, value] : *source)
      if (std::ranges::find(kSourceKeys, key.str()) == std::end(kSourceKeys))
        fail(file, key.source(), fmt::format("unknown key {}", key.str()));
    clause.known = text_of(*source, "known");
    clause.document = text_of(*source, "document");
    clause.edition = text_of(*source, "edition");
    clause.page = text_of(*source, "page");
    clause.words = text_of(*source, "words");
  }
  if (const auto* outcome = table["outcome_text"].as_table()) {
    const bool fact = clause.outcomes == "fact";
    clause.positive = text_of(*outcome, fact ? "true" : "positive");
    clause.negative = text_of(*outcome, fact ? "false" : "negative");
    clause.tie = text_of(*outcome, "tie");
  }
  if (clause.id.empty() || !std::ranges::all_of(clause.id, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
      }))
    fail(file, table.source(), "a clause needs an id of lower-case letters, digits, '.' and '-'");
  if (std::ranges::find(kKinds, clause.kind) == std::end(kKinds))
    fail(file, table.source(), fmt::format("{}: kind must be normative, parameter, alarm, open or note", clause.id));
  if (std::ranges::find(kKnown, clause.known) == std::end(kKnown))
    fail(file, table.source(), fmt::format("{}: known must be manual, sister, recollection or ours", clause.id));
  if (std::ranges::find(kOutcomes, clause.outcomes) == std::end(kOutcomes))
    fail(file, table.source(), fmt::format("{}: outcomes must be sign, fact or reach", clause.id));
  if (clause.text.empty()) fail(file, table.source(), fmt::format("{}: a clause needs a text", clause.id));
  clause.enumerator = clause.id;
  std::ranges::replace_if(clause.enumerator, [](char c) { return c == '.' || c == '-'; }, '_');
  return clause;
}

std::vector<ClauseText> read_folder(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::ranges::sort(files);
  std::map<std::filesystem::path, Notation> notations;
  for (const auto& file : files) notations[file] = read_notation(file, toml::parse_file(file.string()));
  std::vector<ClauseText> clauses;
  std::set<std::string> enumerators;
  std::set<const Symbols*> used;
  for (const auto& file : files) {
    const toml::table root = toml::parse_file(file.string());
    std::vector<std::filesystem::path> letters_of{file};
    for (const std::string& other : list_of(root, "letters_of")) {
      letters_of.push_back(file.parent_path() / other);
      if (!notations.contains(letters_of.back()))
        fail(file, root["letters_of"].node()->source(), fmt::format("no file {}", other));
    }
    const std::string section = text_of(root, "section");
    if (section.empty()) fail(file, root.source(), "a clause file begins with section = \"…\"");
    const auto* array = root["clause"].as_array();
    if (array == nullptr) continue;
    for (const auto& item : *array) {
      if (!item.is_table()) fail(file, item.source(), "[[clause]] must be a table");
      clauses.push_back(read_clause(file, section, *item.as_table()));
      for (const auto& from : letters_of) explain_symbols(clauses.back(), notations.at(from), used);
      if (!enumerators.insert(clauses.back().enumerator).second)
        fail(file, item.source(), fmt::format("{}: this id is used twice", clauses.back().id));
    }
  }
  for (const auto& [file, notation] : notations)
    for (const Symbols& symbols : notation)
      if (!used.contains(&symbols))
        fail(file, symbols.place, fmt::format("no clause has the symbol {}", symbols.written));
  return clauses;
}

constexpr std::string_view kHeader = R"(// Generated from the clause files. Do not edit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace toolcomp::spec {{

enum class Clause : std::uint16_t {{
{}}};

inline constexpr std::size_t kClauseCount = {};

enum class ClauseKind : std::uint8_t {{ normative, parameter, alarm, open, note }};
// How well a clause is known: a page of a manual of its control was seen; one of a sister series, or of another vendor
// with the same rule; the text of a section, from memory; our definition.
enum class Known : std::uint8_t {{ manual, sister, recollection, ours }};
enum class ClauseOutcomes : std::uint8_t {{ sign, fact, reach }};

// A clause as its file states it. Lists are separated by line feeds.
struct ClauseInfo {{
  std::string_view id, section, file;
  ClauseKind kind;
  Known known;
  std::string_view document, edition, page;
  std::string_view words;  // on the source: which part of the clause is the page's
  std::string_view text, formula;
  std::string_view notation;  // the symbols in both, "SYMBOLS: MEANING"
  std::string_view parameters, alternatives;
  ClauseOutcomes outcomes;
  std::string_view positive, negative, tie;  // what each outcome means; a fact has true as positive, false as negative
  bool testable;
  std::string_view reason, unreachable, unreachable_reason, replaced_by;
  bool makes_value;  // the position of a move comes from it; other clauses of the event say where it applies
}};

const ClauseInfo& info(Clause clause);
std::span<const ClauseInfo> clauses();
std::optional<Clause> find_clause(std::string_view id);
// The items of a list that is separated by line feeds.
std::vector<std::string_view> items(std::string_view list);

}}  // namespace toolcomp::spec
)";

constexpr std::string_view kSource = R"(// Generated from the clause files. Do not edit.
#include "spec/clauses/clauses.h"

#include <array>

namespace toolcomp::spec {{
namespace {{
using namespace std::string_view_literals;  // NOLINT(google-build-using-namespace)
constexpr std::array<ClauseInfo, kClauseCount> kClauses{{{{
{}}}}};
}}  // namespace

const ClauseInfo& info(Clause clause) {{ return kClauses.at(static_cast<std::size_t>(clause)); }}
std::span<const ClauseInfo> clauses() {{ return kClauses; }}
std::optional<Clause> find_clause(std::string_view id) {{
  for (std::size_t i = 0; i < kClauses.size(); ++i)
    if (kClauses[i].id == id) return static_cast<Clause>(i);
  return std::nullopt;
}}
std::vector<std::string_view> items(std::string_view list) {{
  std::vector<std::string_view> all;
  while (!list.empty()) {{
    const std::size_t end = list.find('\n');
    all.push_back(list.substr(0, end));
    list.remove_prefix(end == std::string_view::npos ? list.size() : end + 1);
  }}
  return all;
}}

}}  // namespace toolcomp::spec
)";

// With its length: a compiler that counts the letters of all texts gives up (clang after a million steps).
std::string view(std::string_view text) { return literal(text) + "sv"; }

void generate(const std::filesystem::path& folder, const std::filesystem::path& output) {
  const std::vector<ClauseText> clauses = read_folder(folder);
  std::string enumerators;
  std::string rows;
  for (const ClauseText& c : clauses) {
    enumerators += fmt::format("  {},\n", c.enumerator);
    rows += fmt::format(
        "    ClauseInfo{{{}, {}, {}, ClauseKind::{}, Known::{}, {}, {}, {}, {},\n      {}, {}, {},\n      {}, {}, "
        "ClauseOutcomes::{},\n      {}, {}, {}, {}, {}, {}, {}, {}, {}}},\n",
        view(c.id), view(c.section), view(c.file), c.kind, c.known, view(c.document), view(c.edition), view(c.page),
        view(c.words), view(c.text), view(c.formula), view(joined(c.notation)), view(joined(c.parameters)),
        view(joined(c.alternatives)), c.outcomes, view(c.positive), view(c.negative), view(c.tie), c.testable,
        view(c.reason), view(joined(c.unreachable)), view(c.unreachable_reason), view(c.replaced_by), c.makes_value);
  }
  write_changed(output / "clauses.h", fmt::format(kHeader, enumerators, clauses.size()));
  write_changed(output / "clauses.cpp", fmt::format(kSource, rows));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: toolcomp_clauses CLAUSE_FOLDER OUTPUT_FOLDER\n";
    return 2;
  }
  try {
    generate(argv[1], argv[2]);
  } catch (const toml::parse_error& error) {
    const auto& where = error.source();
    std::cerr << (where.path ? *where.path : std::string("clauses")) << ':' << where.begin.line << ':'
              << where.begin.column << ": " << error.description() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
