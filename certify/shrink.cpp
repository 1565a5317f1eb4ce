// SPDX-License-Identifier: Apache-2.0
#include "certify/shrink.h"

#include <algorithm>
#include <set>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "certify/program_text.h"
#include "spec/language/alarm.h"
#include "spec/language/decimal.h"

namespace toolcomp::certify {
namespace {

constexpr std::size_t kFewestAxes = 3;

// Everything a candidate is made of; the case is put together from it.
struct Candidate {
  TextProgram program;
  spec::Setup setup;
  std::uint32_t samples = 0;
};

std::string table_key(const spec::AxisTable& table) {
  std::string key;
  for (const auto& [axis, value] : table) key += axis + to_string(value) + ' ';
  return key + '|';
}

// Two candidates with one key are one case: only the parts that shrinking changes count.
std::string key_of(const Candidate& c) {
  std::string key = join_program(c.program) + '|' + std::to_string(c.samples) + '|' + c.setup.axes.letters() + '|';
  for (const auto& [id, value] : c.setup.parameters)
    key += std::to_string(id.number) + '#' + std::to_string(id.bit) + to_string(value) + ' ';
  for (const auto* offsets : {&c.setup.h, &c.setup.d}) {
    key += '|';
    for (const auto& [number, entry] : *offsets)
      key += std::to_string(number) + ':' + to_string(entry.geometry) + '/' + to_string(entry.wear) + ' ';
  }
  key += '|';
  for (const auto& table : c.setup.workpiece) key += table_key(table);
  key += table_key(c.setup.position);
  for (const auto& [number, table] : c.setup.additional_workpiece) key += std::to_string(number) + table_key(table);
  key += '|';
  for (const auto& [number, table] : c.setup.reference) key += std::to_string(number) + table_key(table);
  for (const spec::ToolRow& tool : c.setup.tools) {
    key += '|' + std::to_string(tool.number) + ' ' + tool.name + ' ' + tool.dr2_table;
    for (const spec::Decimal& d : {tool.r, tool.r2, tool.dl, tool.dr, tool.dr2, tool.l.value_or(spec::Decimal{})})
      key += ' ' + to_string(d);
    key += tool.l ? "L" : "";
  }
  for (const auto& [cause, shown] : c.setup.alarms) key += std::string(info(cause).name) + ':' + shown + ' ';
  for (const auto& [number, row] : c.setup.tcs)
    key += '|' + std::to_string(number) + ' ' + to_string(row.dl) + ' ' + to_string(row.dr) + ' ' + to_string(row.dr2);
  for (const auto& [name, points] : c.setup.dr2_tables) {
    key += '|' + name;
    for (const auto& [angle, deviation] : points) key += ' ' + to_string(angle) + ' ' + to_string(deviation);
  }
  return key + table_key(c.setup.floating_reference) + table_key(c.setup.measurement);
}

class Shrinker {
 public:
  Shrinker(const spec::Case& failing, const StillFails& still_fails, const ShrinkOptions& options)
      : case_(failing), still_fails_(still_fails), options_(options) {
    case_.expect.clear();
    case_.has_expect = false;
    best_ = {split_program(failing.program, failing.dialect), failing.setup, failing.samples};
    tried_.insert(key_of(best_));
  }

  Shrunk run() {
    tidy();
    do {
      changed_ = false;
      blocks();
      words();
      joined_blocks();
      exchanged_words();
      setup_entries();
      digits();
    } while (changed_ && !exhausted());
    return {accepted_ ? build(best_) : case_, runs_, !exhausted()};
  }

 private:
  [[nodiscard]] bool exhausted() const { return runs_ >= options_.max_runs; }

  [[nodiscard]] spec::Case build(const Candidate& candidate) const {
    spec::Case c = case_;
    c.program = join_program(candidate.program);
    c.setup = candidate.setup;
    c.samples = candidate.samples;
    return c;
  }

  // Keeps the candidate if it still fails.
  bool attempt(Candidate candidate) {
    if (exhausted() || candidate.program.empty() || !tried_.insert(key_of(candidate)).second) return false;
    // A table of deviations has a point at least.
    for (const auto& [name, points] : candidate.setup.dr2_tables)
      if (points.empty()) return false;
    ++runs_;
    if (!still_fails_(build(candidate))) return false;
    best_ = std::move(candidate);
    changed_ = true;
    accepted_ = true;
    return true;
  }

  // Everything nobody misses, at once: empty lines, comments, sequence numbers, blanks. If that changes the failure,
  // the words stay and are tried one by one later; a different line count alone must not lose the text as written.
  void tidy() {
    Candidate plain = best_;
    for (TextLine& line : plain.program) case_.dialect == "klartext" ? bare_klartext(line) : bare_iso(line);
    drop_empty_lines(plain);
    if (attempt(std::move(plain))) return;
    Candidate spaced = best_;
    drop_empty_lines(spaced);
    // Its key is that of the original, which may differ from it in blanks and empty lines only.
    tried_.erase(key_of(spaced));
    attempt(std::move(spaced));
  }

  static void bare_iso(TextLine& line) {
    std::erase_if(line.words, [](const std::string& word) {
      return word.front() == '(' || word.front() == 'N' || word.front() == 'n';
    });
  }

  // The mark of a line that goes on stays.
  static void bare_klartext(TextLine& line) {
    auto& words = line.words;
    const bool goes_on = !words.empty() && words.back().ends_with('~');
    const auto comment = std::ranges::find_if(words, [](const std::string& word) { return word.front() == ';'; });
    if (comment != words.end()) {
      words.erase(comment, words.end());
      if (goes_on) words.emplace_back("~");
    }
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    if (words.size() > 1 && std::ranges::all_of(words.front(), is_digit)) words.erase(words.begin());
  }

  static void drop_empty_lines(Candidate& candidate) {
    std::erase_if(candidate.program, [](const TextLine& line) { return line.words.empty(); });
  }

  // Leaves out runs of elements, long runs first, from the end: `count` elements now, `without` a candidate with the
  // elements [begin, begin + size) left out.
  template <class Count, class Without>
  void leave_out(Count count, Without without) {
    for (std::size_t size = count(); size > 0; size /= 2) {
      for (std::size_t end = count(); end > 0 && !exhausted();) {
        const std::size_t begin = end > size ? end - size : 0;
        attempt(without(begin, end - begin));
        end = std::min(begin, count());
      }
    }
  }

  void blocks() {
    leave_out([this] { return best_.program.size(); },
              [this](std::size_t begin, std::size_t size) {
                Candidate candidate = best_;
                const auto first = candidate.program.begin() + static_cast<std::ptrdiff_t>(begin);
                candidate.program.erase(first, first + static_cast<std::ptrdiff_t>(size));
                return candidate;
              });
  }

  void words() {
    for (std::size_t line = best_.program.size(); line-- > 0;) {
      const std::size_t lines = best_.program.size();
      leave_out([this, line, lines] { return best_.program.size() == lines ? best_.program[line].words.size() : 0; },
                [this, line](std::size_t begin, std::size_t size) {
                  Candidate candidate = best_;
                  auto& list = candidate.program[line].words;
                  const auto first = list.begin() + static_cast<std::ptrdiff_t>(begin);
                  list.erase(first, first + static_cast<std::ptrdiff_t>(size));
                  drop_empty_lines(candidate);
                  return candidate;
                });
    }
  }

  // A block with the next one in it. A block of Klartext is one command.
  void joined_blocks() {
    if (case_.dialect == "klartext") return;
    for (std::size_t line = best_.program.size(); line-- > 1 && !exhausted();) {
      Candidate candidate = best_;
      auto& words = candidate.program[line - 1].words;
      words.insert(words.end(), best_.program[line].words.begin(), best_.program[line].words.end());
      candidate.program.erase(candidate.program.begin() + static_cast<std::ptrdiff_t>(line));
      attempt(std::move(candidate));
    }
  }

  // For a word a lesser one: another of the program, or the code before it (G43 for G44 and
  // for G43.4, RL for RR). M128 for the longer code of the same.
  void exchanged_words() {
    for (std::size_t line = 0; line < best_.program.size(); ++line) {
      if (best_.program[line].words.size() > 1 && best_.program[line].words[0] == "FUNCTION" &&
          best_.program[line].words[1] == "TCPM") {
        Candidate candidate = best_;
        candidate.program[line].words = {"M128"};
        attempt(std::move(candidate));
      }
      for (std::size_t word = 0; word < best_.program[line].words.size(); ++word)
        for (const std::string& lesser : lesser_words(best_.program[line].words[word])) {
          Candidate candidate = best_;
          candidate.program[line].words[word] = lesser;
          if (attempt(std::move(candidate))) break;
        }
    }
  }

  [[nodiscard]] std::vector<std::string> lesser_words(const std::string& word) const {
    std::set<std::string> lesser;
    for (const TextLine& line : best_.program)
      for (const std::string& other : line.words)
        if (other < word) lesser.insert(other);
    std::vector<std::string> list(lesser.begin(), lesser.end());
    if (case_.dialect == "klartext" && word == "RR") list.emplace_back("RL");
    if (case_.dialect == "klartext" || word[0] != 'G') return list;
    if (const std::size_t point = word.find('.'); point != std::string::npos)
      list.push_back(word.substr(0, point));
    else if (word.size() == 3 && word[2] > '0' && word[2] <= '9')
      list.push_back({word[0], word[1], static_cast<char>(word[2] - 1)});
    return list;
  }

  // The entries of one map of the setup.
  template <class Member>
  void entries(Member member) {
    leave_out([this, member] { return member(best_.setup).size(); },
              [this, member](std::size_t begin, std::size_t size) {
                Candidate candidate = best_;
                auto& table = member(candidate.setup);
                const auto first = std::next(table.begin(), static_cast<std::ptrdiff_t>(begin));
                table.erase(first, std::next(first, static_cast<std::ptrdiff_t>(size)));
                return candidate;
              });
  }

  // Axes from the last on, so that the others keep their numbers, down to the three of any machine.
  void axes() {
    while (best_.setup.axes.size() > kFewestAxes) {
      Candidate candidate = best_;
      const std::string& letters = best_.setup.axes.letters();
      // A table that still names the axis would be refused.
      const auto& origins = best_.setup.additional_workpiece;
      if (std::ranges::any_of(origins, [&](const auto& origin) { return origin.second.contains(letters.back()); }))
        return;
      candidate.setup.axes = spec::Axes(std::string_view(letters).substr(0, letters.size() - 1));
      if (!attempt(std::move(candidate))) return;
    }
  }

  void setup_entries() {
    if (best_.samples > 0) {
      Candidate candidate = best_;
      candidate.samples = 0;
      attempt(std::move(candidate));
    }
    entries([](spec::Setup& s) -> auto& { return s.parameters; });
    entries([](spec::Setup& s) -> auto& { return s.alarms; });
    entries([](spec::Setup& s) -> auto& { return s.h; });
    entries([](spec::Setup& s) -> auto& { return s.d; });
    for (std::size_t i = 0; i < best_.setup.workpiece.size(); ++i)
      entries([i](spec::Setup& s) -> auto& { return s.workpiece.at(i); });
    entries([](spec::Setup& s) -> auto& { return s.additional_workpiece; });
    entries([](spec::Setup& s) -> auto& { return s.position; });
    entries([](spec::Setup& s) -> auto& { return s.reference; });
    entries([](spec::Setup& s) -> auto& { return s.floating_reference; });
    entries([](spec::Setup& s) -> auto& { return s.measurement; });
    entries([](spec::Setup& s) -> auto& { return s.tools; });
    entries([](spec::Setup& s) -> auto& { return s.tcs; });
    tool_entries();
    // Behind the tools that name them.
    entries([](spec::Setup& s) -> auto& { return s.dr2_tables; });
    for (std::size_t i = 0; i < best_.setup.dr2_tables.size(); ++i)
      entries([i](spec::Setup& s) -> auto& {
        return std::next(s.dr2_tables.begin(), static_cast<std::ptrdiff_t>(i))->second;
      });
    axes();
  }

  // What a row of the tool table need not say.
  void tool_entries() {
    for (std::size_t i = 0; i < best_.setup.tools.size(); ++i) {
      const auto without = [this, i](auto change) {
        Candidate candidate = best_;
        change(candidate.setup.tools[i]);
        attempt(std::move(candidate));
      };
      without([](spec::ToolRow& tool) { tool.l.reset(); });
      without([](spec::ToolRow& tool) { tool.name.clear(); });
      without([](spec::ToolRow& tool) { tool.dr2_table.clear(); });
    }
  }

  void tool_digits() {
    using Row = spec::ToolRow;
    for (std::size_t i = 0; i < best_.setup.tools.size(); ++i)
      for (const auto member : {&Row::r, &Row::r2, &Row::dl, &Row::dr, &Row::dr2})
        decimal_digits([i, member](spec::Setup& s) -> auto& { return s.tools[i].*member; });
    using Correction = spec::CorrectionRow;
    for (std::size_t i = 0; i < best_.setup.tcs.size(); ++i)
      for (const auto member : {&Correction::dl, &Correction::dr, &Correction::dr2})
        decimal_digits([i, member](spec::Setup& s) -> auto& {
          return std::next(s.tcs.begin(), static_cast<std::ptrdiff_t>(i))->second.*member;
        });
  }

  void digits() {
    for (std::size_t line = 0; line < best_.program.size(); ++line)
      for (std::size_t word = 0; word < best_.program[line].words.size(); ++word) {
        const NumberInWord parts = number_in(best_.program[line].words[word], case_.dialect);
        if (parts.number.empty()) continue;
        for (const std::string& number : simpler_numbers(parts.number)) {
          Candidate candidate = best_;
          candidate.program[line].words[word] = parts.prefix + number + parts.suffix;
          if (attempt(std::move(candidate))) break;
        }
      }
    tool_digits();
    for (std::size_t i = 0; i < best_.setup.h.size(); ++i)
      offset_digits(
          [i](spec::Setup& s) -> auto& { return std::next(s.h.begin(), static_cast<std::ptrdiff_t>(i))->second; });
    for (std::size_t i = 0; i < best_.setup.d.size(); ++i)
      offset_digits(
          [i](spec::Setup& s) -> auto& { return std::next(s.d.begin(), static_cast<std::ptrdiff_t>(i))->second; });
  }

  template <class Entry>
  void offset_digits(Entry entry) {
    decimal_digits([entry](spec::Setup& s) -> auto& { return entry(s).geometry; });
    decimal_digits([entry](spec::Setup& s) -> auto& { return entry(s).wear; });
  }

  template <class Value>
  void decimal_digits(Value value) {
    for (const std::string& number : simpler_numbers(to_string(value(best_.setup)))) {
      const auto simpler = spec::parse_decimal(number);
      if (!simpler) continue;
      Candidate candidate = best_;
      value(candidate.setup) = *simpler;
      if (attempt(std::move(candidate))) break;
    }
  }

  spec::Case case_;
  const StillFails& still_fails_;
  ShrinkOptions options_;
  Candidate best_;
  std::unordered_set<std::string> tried_;
  std::size_t runs_ = 0;
  bool changed_ = false;
  bool accepted_ = false;
};

}  // namespace

Shrunk shrink(const spec::Case& failing, const StillFails& still_fails, const ShrinkOptions& options) {
  return Shrinker(failing, still_fails, options).run();
}

}  // namespace toolcomp::certify
