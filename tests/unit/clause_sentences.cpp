// SPDX-License-Identifier: Apache-2.0
// The model reads like the manual: above a rule stands the sentence of its clause, as the clause file says it.
//
//   // fanuc.cutter-b.number-zero: Number 0 is a number of the value 0: vectors of length 0 are made with it, the
//   // start-up included.
//
// is such a sentence: the text of the clause, or its first sentences. A line `//` ends it; what stands behind is ours.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "spec/clauses/clauses.h"

namespace {

namespace fs = std::filesystem;
namespace spec = toolcomp::spec;

// A rules.cpp has not more lines.
constexpr std::size_t kLines = 220;

struct Sentence {
  std::string id;
  std::string said;
  std::size_t line = 0;  // of the file, from 0
  std::size_t indent = 0;
};

// A function of a rules.cpp, from the comment above it to its last line.
struct Function {
  std::string head;
  std::size_t begin = 0;
  std::size_t end = 0;
  bool helper = false;  // in an unnamed namespace
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<Sentence> sentences(const std::vector<std::string>& lines) {
  static const std::regex kBegin(R"(( *)// ((?:fanuc|heidenhain)\.[a-z0-9.-]+):(?: (.*))?)");
  static const std::regex kMore(R"( *// (.*))");
  std::vector<Sentence> found;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::smatch match;
    if (!std::regex_match(lines[i], match, kBegin)) continue;
    Sentence sentence{match[2].str(), match[3].str(), i, match[1].str().size()};
    while (i + 1 < lines.size() && !std::regex_match(lines[i + 1], kBegin) &&
           std::regex_match(lines[i + 1], match, kMore)) {
      sentence.said += " " + match[1].str();
      ++i;
    }
    found.push_back(std::move(sentence));
  }
  return found;
}

// The comment as it must stand, at most 120 characters a line.
std::string as_comment(const Sentence& sentence, std::string_view text) {
  const std::string margin(sentence.indent, ' ');
  std::string all;
  std::string line = margin + "// " + sentence.id + ":";
  std::istringstream in{std::string(text)};
  for (std::string word; in >> word;) {
    if (line.size() + 1 + word.size() > 120) {
      all += line + "\n";
      line = margin + "//";
    }
    line += " " + word;
  }
  return all + line;
}

// Whether it is the text, or sentences from its beginning.
bool is_said(std::string_view text, std::string_view said) {
  if (said == text) return true;
  const bool number = said == "No." || said.ends_with(" No.");  // of a parameter: the sentence goes on
  return said.ends_with('.') && !number && text.starts_with(said) && text[said.size()] == ' ';
}

std::vector<std::string> drifts(const std::vector<std::string>& lines) {
  std::vector<std::string> faults;
  for (const Sentence& sentence : sentences(lines)) {
    const auto clause = spec::find_clause(sentence.id);
    if (!clause) {
      faults.push_back(fmt::format("line {}: no clause has the id {}", sentence.line + 1, sentence.id));
    } else if (const std::string_view text = spec::info(*clause).text; !is_said(text, sentence.said)) {
      faults.push_back(fmt::format("line {}: {} says here\n{}\nand in {}\n{}", sentence.line + 1, sentence.id,
                                   sentence.said, spec::info(*clause).file, as_comment(sentence, text)));
    }
  }
  return faults;
}

// In the style of the house a function begins at the left margin and ends there with a brace.
std::vector<Function> functions(const std::vector<std::string>& lines) {
  static const std::regex kOther(R"((namespace|using|#|//|\}|$).*)");
  std::vector<Function> found;
  bool unnamed = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] == "namespace {") unnamed = true;
    if (lines[i] == "}  // namespace") unnamed = false;
    if (lines[i].starts_with(' ') || std::regex_match(lines[i], kOther)) continue;
    Function function{"", i, i, unnamed};
    while (i < lines.size() && lines[i].find_first_of("{;") == std::string::npos) function.head += lines[i++];
    if (i == lines.size()) break;
    function.head += lines[i];
    if (!lines[i].ends_with('}') && !lines[i].ends_with(';'))
      while (i + 1 < lines.size() && !lines[i].starts_with('}')) ++i;
    function.end = i;
    const std::string before = function.head.substr(0, function.head.find_first_of("{;="));
    if (before.find('(') == std::string::npos || function.head.find('{') == std::string::npos) continue;
    while (function.begin > 0 && lines[function.begin - 1].starts_with("//")) --function.begin;
    found.push_back(std::move(function));
  }
  return found;
}

// Every rule has a sentence, and they stand in the order of the clause file.
std::vector<std::string> unruly(const std::vector<std::string>& lines) {
  std::vector<std::string> faults;
  std::map<std::string_view, spec::Clause> latest;
  const std::vector<Sentence> said = sentences(lines);
  for (const Function& function : functions(lines)) {
    if (function.helper) continue;
    const auto first = std::ranges::find_if(
        said, [&](const Sentence& s) { return s.line >= function.begin && s.line <= function.end; });
    if (first == said.end()) {
      faults.push_back(fmt::format("line {}: no clause's sentence at {}", function.begin + 1, function.head));
      continue;
    }
    const auto clause = spec::find_clause(first->id);
    if (!clause) continue;
    const auto [before, is_first] = latest.emplace(spec::info(*clause).section, *clause);
    if (!is_first && before->second > *clause)
      faults.push_back(fmt::format("line {}: {} stands before {} in {}", function.begin + 1, first->id,
                                   spec::info(before->second).id, spec::info(*clause).file));
    before->second = *clause;
  }
  return faults;
}

// The clauses that a text marks, and those that it says.
std::set<std::string> marked(const std::string& text) {
  static const std::regex kMark(R"(Clause::([a-z0-9_]+))");
  std::set<std::string> ids;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), kMark); it != std::sregex_iterator(); ++it)
    for (const spec::ClauseInfo& clause : spec::clauses()) {
      std::string enumerator(clause.id);
      std::ranges::replace_if(enumerator, [](char c) { return c == '.' || c == '-'; }, '_');
      if (enumerator == (*it)[1].str()) ids.emplace(clause.id);
    }
  return ids;
}

std::set<std::string> said(const std::string& text) {
  std::set<std::string> ids;
  for (const Sentence& sentence : sentences(lines_of(text))) ids.insert(sentence.id);
  return ids;
}

// A clause that is marked is said.
std::vector<std::string> unsaid(const std::set<std::string>& marked, const std::set<std::string>& said) {
  std::vector<std::string> faults;
  for (const std::string& id : marked)
    if (!said.contains(id))
      faults.push_back(fmt::format("marked, but not said:\n{}",
                                   as_comment({id, "", 0, 0}, spec::info(*spec::find_clause(id)).text)));
  return faults;
}

std::vector<std::string> faults_of_rules(const std::string& text) {
  static const std::regex kState(R"(\b(Step|Move|Pass|StepWords)\b)");
  const std::vector<std::string> lines = lines_of(text);
  std::vector<std::string> faults = unruly(lines);
  for (std::string& fault : unsaid(marked(text), said(text))) faults.push_back(std::move(fault));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string code = lines[i].substr(0, lines[i].find("//"));
    if (std::smatch match; std::regex_search(code, match, kState))
      faults.push_back(fmt::format("line {}: a rule knows no {}", i + 1, match[1].str()));
  }
  if (lines.size() > kLines) faults.push_back(fmt::format("{} lines, more than {}", lines.size(), kLines));
  return faults;
}

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Architecture, ClauseSentencesAreThoseOfTheClauseFiles) {
  std::size_t seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(TOOLCOMP_SOURCE_DIR) / "model")) {
    if (!entry.is_regular_file()) continue;
    const std::vector<std::string> lines = lines_of(read(entry.path()));
    seen += sentences(lines).size();
    for (const std::string& fault : drifts(lines)) ADD_FAILURE() << entry.path().string() << ", " << fault;
  }
  EXPECT_GT(seen, 10U);
}

TEST(Architecture, RulesStandInTheOrderOfTheClauses) {
  std::size_t seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(TOOLCOMP_SOURCE_DIR) / "model")) {
    if (entry.path().filename() != "rules.cpp") continue;
    ++seen;
    for (const std::string& fault : faults_of_rules(read(entry.path())))
      ADD_FAILURE() << entry.path().string() << ", " << fault;
  }
  EXPECT_GT(seen, 0U);
}

// Whoever reads a folder finds there the sentence of every clause that it marks.
TEST(Architecture, MarkedClausesAreSaidInTheirFolder) {
  std::map<fs::path, std::string> folders;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(TOOLCOMP_SOURCE_DIR) / "model"))
    if (entry.is_regular_file()) folders[entry.path().parent_path()] += read(entry.path()) + "\n";
  std::size_t seen = 0;
  for (const auto& [folder, text] : folders) {
    const std::set<std::string> ids = marked(text);
    seen += ids.size();
    for (const std::string& fault : unsaid(ids, said(text))) ADD_FAILURE() << folder.string() << ", " << fault;
  }
  EXPECT_GT(seen, 100U);
}

// The text of a clause, which no test types in a second time.
std::string text_of(std::string_view id) { return std::string(spec::info(*spec::find_clause(id)).text); }

TEST(ClauseSentences, DriftIsSeen) {
  const std::string id = "fanuc.cutter-b.number-zero";
  const std::string text = text_of(id);
  const auto count = [&](const std::string& said) { return drifts(lines_of("// " + id + ": " + said)).size(); };
  EXPECT_EQ(count(text), 0U);
  EXPECT_EQ(
      count("Number 0 is a number of the value 0: vectors of length 0 are made\n// with it, the start-up included."),
      0U);
  EXPECT_EQ(count(text + "\n//\n// What is ours."), 0U);
  EXPECT_EQ(count(text + "\n// What is ours."), 1U);
  EXPECT_EQ(count("Number 0 is a number of the value 0:"), 1U) << "not a whole sentence";
  EXPECT_EQ(count("Number 1 is a number of the value 0: vectors of length 0 are made with it, the start-up included."),
            1U);
  EXPECT_EQ(count(""), 1U);
  EXPECT_EQ(drifts({"// fanuc.tool-side.type-b: No."}).size(), 1U) << "No. 5003";
  EXPECT_EQ(
      drifts(
          {"// fanuc.cutter-c.value-zero: If r = 0, the group is the zero vector alone, whatever the corner and No."})
          .size(),
      1U);
  EXPECT_EQ(drifts({"// fanuc.cutter-b.no-such: Text."}).size(), 1U);
}

TEST(ClauseSentences, TheFormOfRulesIsWatched) {
  const auto comment = [](const std::string& id) { return "// " + id + ": " + text_of(id) + "\n"; };
  const std::string vector = comment("fanuc.cutter-b.vector") + "Vector f(int a,\n         int b) {\n  return a;\n}\n";
  const std::string zero =
      comment("fanuc.cutter-b.number-zero") + "bool g() { return Clause::fanuc_cutter_b_number_zero; }\n";
  const std::string bare = "bool h() { return false; }\n";
  EXPECT_TRUE(faults_of_rules(vector + zero).empty());
  EXPECT_TRUE(faults_of_rules("namespace {\n" + bare + "}  // namespace\n" + vector + zero).empty());
  EXPECT_EQ(faults_of_rules(zero + vector).size(), 1U) << "the order";
  EXPECT_EQ(faults_of_rules(vector + bare + zero).size(), 1U) << "no sentence";
  EXPECT_EQ(faults_of_rules(vector + "bool h(\n    int a) {\n" + "  return a;\n}\n").size(), 1U) << "no sentence";
  EXPECT_EQ(faults_of_rules(vector + "constexpr " + bare).size(), 1U) << "no sentence";
  EXPECT_TRUE(faults_of_rules(vector + "struct Pair {\n  int f() const;\n};\nconstexpr Pair kPair{1};\n").empty());
  EXPECT_EQ(faults_of_rules(vector + "// " + text_of("fanuc.cutter-b.kept") + "\n" + bare).size(), 1U) << "no id";
  EXPECT_EQ(faults_of_rules(vector + "int k = Clause::fanuc_cutter_b_kept;\n").size(), 1U) << "marked, not said";
  EXPECT_EQ(faults_of_rules(vector + "const Step* step = nullptr;\n").size(), 1U) << "a rule knows no step";
  EXPECT_EQ(faults_of_rules(vector + std::string(kLines, '\n')).size(), 1U) << "too long";
}

}  // namespace
