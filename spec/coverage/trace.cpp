// SPDX-License-Identifier: Apache-2.0
#include "spec/coverage/trace.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "spec/language/case_format.h"
#include "spec/language/input_error.h"

namespace toolcomp::spec {
namespace {

namespace fs = std::filesystem;

// Ids and enumerators are words of these characters.
bool is_id(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '_'; }

// Calls `found` with every maximal word of such characters.
void words(std::string_view line, const std::function<void(std::string_view)>& found) {
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t begin = i;
    while (i < line.size() && is_id(line[i])) ++i;
    if (i == begin) {
      ++i;
      continue;
    }
    std::string_view word = line.substr(begin, i - begin);
    while (word.ends_with('.')) word.remove_suffix(1);  // the end of a sentence
    found(word);
  }
}

// The files below `folder` with one of these extensions, by name; none if there is no such folder.
std::vector<fs::path> files_below(const fs::path& folder, std::initializer_list<std::string_view> extensions) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (std::ranges::find(extensions, entry.path().extension().string()) != extensions.end())
      files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

void each_line(const fs::path& file, const std::function<void(std::size_t, const std::string&)>& take) {
  std::ifstream in(file);
  if (!in) throw InputError(file.string(), 0, 0, "cannot be read");
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) take(number, line);
}

class Tracer {
 public:
  explicit Tracer(fs::path source) : source_(std::move(source)), table_(kClauseCount) {
    for (std::size_t i = 0; i < kClauseCount; ++i) {
      const std::string_view id = clauses()[i].id;
      by_id_[std::string(id)] = i;
      std::string enumerator(id);
      std::ranges::replace_if(enumerator, [](char c) { return c == '.' || c == '-'; }, '_');
      by_enumerator_[enumerator] = i;
    }
  }

  std::vector<ClauseTrace> run() {
    if (!fs::is_directory(source_ / "spec" / "clauses"))
      throw InputError(source_.string(), 0, 0, "is not a source tree of toolcomp; name one with --dir");
    mentions("model", &ClauseTrace::model);
    mentions("tests", &ClauseTrace::tests);
    theorems();
    vectors();
    return std::move(table_);
  }

 private:
  [[nodiscard]] std::string relative(const fs::path& file) const {
    return file.lexically_relative(source_).generic_string();
  }

  // Enumerators behind "Clause::", and ids.
  void mentions(std::string_view folder, std::vector<Mention> ClauseTrace::* where) {
    for (const fs::path& file : files_below(source_ / folder, {".cpp", ".h"})) {
      const std::string name = relative(file);
      each_line(file, [&](std::size_t number, const std::string& line) {
        words(line, [&](std::string_view word) {
          const std::string key(word);
          auto found = by_enumerator_.find(key);
          if (found == by_enumerator_.end()) {
            found = by_id_.find(key);
            if (found == by_id_.end()) return;
          }
          auto& list = table_[found->second].*where;
          if (list.empty() || list.back().file != name) list.push_back({name, number});
        });
      });
    }
  }

  // A docstring that begins with clause ids, "(** a.b, c.d: …", belongs to the theorem that follows it.
  void theorems() {
    for (const fs::path& file : files_below(source_ / "spec" / "formal", {".v"})) {
      std::vector<std::string> ids;
      each_line(file, [&](std::size_t, const std::string& line) {
        std::istringstream in(line);
        std::string word;
        in >> word;
        if (word == "(**") ids = ids_at_head(in);
        if (word != "Theorem") return;
        in >> word;
        for (const std::string& id : std::exchange(ids, {}))
          if (const auto found = by_id_.find(id); found != by_id_.end())
            table_[found->second].theorems.push_back(file.stem().string() + "." + word);
      });
    }
  }

  // Ids with commas between them, the last with a colon; none where the text begins otherwise.
  static std::vector<std::string> ids_at_head(std::istream& in) {
    std::vector<std::string> ids;
    for (std::string word; in >> word;) {
      const char end = word.back();
      if (end != ',' && end != ':') break;
      ids.push_back(word.substr(0, word.size() - 1));
      if (end == ':') return ids;
    }
    return {};
  }

  void vectors() {
    for (const fs::path& file : files_below(source_ / "corpus" / "golden", {".jsonl"}))
      each_line(file, [&](std::size_t number, const std::string& line) {
        if (line.empty()) return;
        const Case c = read_case(line, relative(file) + ":" + std::to_string(number));
        std::set<std::size_t> named;
        for (const std::string& id : c.clauses)
          if (const auto found = by_id_.find(id); found != by_id_.end()) named.insert(found->second);
        for (const TextEvent& event : c.expect)
          for (const spec::Clause clause : event.clauses) named.insert(static_cast<std::size_t>(clause));
        for (const std::size_t clause : named) table_[clause].vectors.push_back(c.id);
      });
  }

  fs::path source_;
  std::vector<ClauseTrace> table_;
  std::map<std::string, std::size_t> by_id_;
  std::map<std::string, std::size_t> by_enumerator_;
};

}  // namespace

std::filesystem::path default_source() { return TOOLCOMP_SOURCE_DIR; }

std::vector<ClauseTrace> trace(const std::filesystem::path& source) { return Tracer(source).run(); }

bool needs_mark(const ClauseInfo& clause) {
  return clause.testable && clause.kind != ClauseKind::note && clause.replaced_by.empty();
}

}  // namespace toolcomp::spec
