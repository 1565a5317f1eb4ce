// SPDX-License-Identifier: Apache-2.0
#include "spec/coverage/lint.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "spec/language/input_error.h"
#include "spec/language/known.h"
#include "spec/language/name.h"

namespace toolcomp::spec {
namespace {

namespace fs = std::filesystem;

struct Entry {
  fs::path file;
  const toml::table* table = nullptr;
  std::string id;
};

std::string text(const toml::table& table, std::string_view key) { return table[key].value_or(std::string()); }

std::vector<std::string> list(const toml::table& table, std::string_view key) {
  std::vector<std::string> items;
  if (const toml::array* array = table[key].as_array())
    for (const toml::node& item : *array) items.push_back(item.value_or(std::string()));
  return items;
}

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::vector<std::string_view> split(std::string_view line, std::string_view separators) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = line.find_first_of(separators);
    parts.push_back(line.substr(0, end));
    if (end == std::string_view::npos) return parts;
    line.remove_prefix(end + 1);
  }
}

// Words of lower-case letters and digits, joined by single hyphens.
bool is_slug(std::string_view part) {
  return std::ranges::all_of(split(part, "-"), [](std::string_view word) {
    return !word.empty() && std::ranges::all_of(word, [](char c) { return is_lower(c) || is_digit(c); });
  });
}

// "5001" or "5001#2".
bool is_parameter(std::string_view name) {
  const auto parts = split(name, "#");
  const bool number = !parts[0].empty() && parts[0].size() <= 5 && std::ranges::all_of(parts[0], is_digit);
  return number &&
         (parts.size() == 1 || (parts.size() == 2 && parts[1].size() == 1 && parts[1][0] >= '0' && parts[1][0] <= '7'));
}

std::vector<std::string> outcomes_of(std::string_view outcomes) {
  if (outcomes == "sign") return {"positive", "negative", "tie"};
  if (outcomes == "fact") return {"true", "false"};
  return {};
}

bool one_of(std::string_view value, std::initializer_list<std::string_view> values) {
  return std::ranges::find(values, value) != values.end();
}

class Linter {
 public:
  Linter(fs::path folder, fs::path published) : folder_(std::move(folder)), published_(std::move(published)) {}

  std::vector<std::string> run() {
    read();
    for (const Entry& entry : entries_) check(entry);
    check_published();
    return std::move(breaches_);
  }

 private:
  void read() {
    std::vector<fs::path> files;
    if (!fs::is_directory(folder_)) throw InputError(folder_.string(), 0, 0, "is not a folder of clause files");
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::ranges::sort(files);
    documents_.reserve(files.size());
    for (const fs::path& file : files) {
      try {
        documents_.push_back(toml::parse_file(file.string()));
      } catch (const toml::parse_error& error) {
        throw InputError(file.string(), error.source().begin.line, error.source().begin.column,
                         std::string(error.description()));
      }
      if (const toml::array* clauses = documents_.back()["clause"].as_array())
        for (const toml::node& node : *clauses)
          if (const toml::table* table = node.as_table()) entries_.push_back({file, table, text(*table, "id")});
    }
    for (const Entry& entry : entries_) {
      if (by_id_.emplace(entry.id, entry.table).second) continue;
      breach(entry, "this id is used twice");
    }
  }

  void breach(const Entry& entry, std::string_view what) {
    const auto where = entry.table->source().begin;
    breaches_.push_back(fmt::format("{}:{}:{}: {}: {}", entry.file.string(), where.line, where.column, entry.id, what));
  }
  void require(const Entry& entry, bool holds, std::string_view what) {
    if (!holds) breach(entry, what);
  }

  void check(const Entry& entry) {
    check_id(entry);
    check_source(entry);
    check_outcomes(entry);
    const toml::table& table = *entry.table;
    const std::string kind = text(table, "kind");
    const bool testable = table["testable"].value_or(true);
    require(entry, one_of(kind, {"normative", "parameter", "alarm", "open", "note"}), "unknown kind");
    require(entry, text(table, "text").ends_with('.'), "the text must end with a full stop");
    require(entry, kind != "open" || !testable || !list(table, "alternatives").empty(),
            "an open clause must list its alternatives");
    require(entry, testable || !text(table, "reason").empty(), "testable = false needs a reason");
    require(entry, !testable || text(table, "reason").empty(), "a reason is given without testable = false");
    for (const std::string& parameter : list(table, "parameters"))
      require(entry, is_parameter(parameter), fmt::format("{} is not a parameter number", parameter));
    check_replacement(entry);
  }

  void check_id(const Entry& entry) {
    const auto parts = split(entry.id, ".");
    require(entry, parts.size() >= 3 && std::ranges::all_of(parts, is_slug),
            "an id must be three or more slugs, joined by points");
    require(entry, parts[0] == entry.file.parent_path().filename().string(),
            "an id must begin with the name of its folder");
    if (text(*entry.table, "outcomes") == "sign")
      require(entry, entry.id.size() <= Name::kCapacity, "the id is too long for an `undecided` event");
    const auto words = split(entry.id, ".-");
    const toml::table* source = (*entry.table)["source"].as_table();
    const std::string page = source != nullptr ? text(*source, "page") : std::string();
    require(entry,
            std::ranges::none_of(
                words, [&](std::string_view word) { return word == "page" || (word == page && !page.empty()); }),
            "an id must not name a page");
  }

  void check_source(const Entry& entry) {
    const toml::table* source = (*entry.table)["source"].as_table();
    if (source == nullptr) {
      breach(entry, "the source is missing");
      return;
    }
    const std::string known = text(*source, "known");
    require(entry, find_known(known).has_value(),
            "the source must say how well the clause is known: manual, sister, recollection or ours");
    if (one_of(known, {"manual", "sister"}))
      require(entry, !text(*source, "document").empty() && !text(*source, "page").empty(),
              "a manual must be named with document and page");
    if (known == "ours") {
      require(entry, text(*source, "document").empty() && text(*source, "page").empty(),
              "a definition of ours must not name a document or page");
      require(entry, text(*entry.table, "kind") != "normative" || text(*source, "words").starts_with("geometry"),
              "a definition of ours must not be normative, unless it is geometry");
    }
  }

  void check_outcomes(const Entry& entry) {
    const toml::table& table = *entry.table;
    const std::string outcomes = table["outcomes"].value_or(std::string("reach"));
    require(entry, one_of(outcomes, {"sign", "fact", "reach"}), "outcomes must be sign, fact or reach");
    const std::vector<std::string> names = outcomes_of(outcomes);
    const toml::table* texts = table["outcome_text"].as_table();
    for (const std::string& name : names)
      require(entry, texts != nullptr && !text(*texts, name).empty(), fmt::format("no outcome text for {}", name));
    if (texts != nullptr)
      for (const auto& [key, value] : *texts)
        require(entry, std::ranges::find(names, key.str()) != names.end(), fmt::format("{} is no outcome", key.str()));
    const std::vector<std::string> unreachable = list(table, "unreachable");
    for (const std::string& name : unreachable)
      require(entry, std::ranges::find(names, name) != names.end(), fmt::format("{} is no outcome", name));
    require(entry, unreachable.empty() == text(table, "unreachable_reason").empty(),
            "unreachable outcomes need a reason, and a reason needs unreachable outcomes");
  }

  void check_replacement(const Entry& entry) {
    const std::string replaced_by = text(*entry.table, "replaced_by");
    for (const std::string_view id : split(replaced_by, " ")) {
      if (id.empty()) continue;
      const auto found = by_id_.find(std::string(id));
      if (found == by_id_.end())
        breach(entry, fmt::format("replaced by {}, which does not exist", id));
      else
        require(entry, text(*found->second, "replaced_by").empty(),
                fmt::format("replaced by {}, which is itself replaced", id));
    }
  }

  void check_published() {
    std::ifstream in(published_);
    if (!in) throw InputError(published_.string(), 0, 0, "cannot be read");
    std::string id;
    for (std::uint64_t line = 1; std::getline(in, id); ++line)
      if (!id.empty() && !by_id_.contains(id))
        breaches_.push_back(fmt::format("{}:{}:1: {}: was published and is missing; keep it with replaced_by",
                                        published_.string(), line, id));
  }

  fs::path folder_;
  fs::path published_;
  std::vector<toml::table> documents_;
  std::vector<Entry> entries_;
  std::map<std::string, const toml::table*> by_id_;
  std::vector<std::string> breaches_;
};

}  // namespace

std::vector<std::string> lint_clauses(const std::filesystem::path& folder, const std::filesystem::path& published) {
  return Linter(folder, published).run();
}

}  // namespace toolcomp::spec
