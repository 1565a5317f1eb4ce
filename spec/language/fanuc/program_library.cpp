// SPDX-License-Identifier: Apache-2.0
#include "spec/language/fanuc/program_library.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"

namespace toolcomp::spec {
namespace {

constexpr std::uint64_t kNumbers = 10000;  // a program number has four digits, what stands before them is how often

bool is_digit(char c) { return c >= '0' && c <= '9'; }

const Decimal* last(const Block& block, char address) {
  const Decimal* found = nullptr;
  for (const Word& word : block.words())
    if (word.address == address) found = &word.value;
  return found;
}

std::string_view trimmed(std::string_view line) {
  for (;;) {
    const std::size_t first = line.find_first_not_of(" \t\r%");
    if (first == std::string_view::npos) return {};
    line.remove_prefix(first);
    if (line.front() != '(') return line;
    line.remove_prefix(std::min(line.find(')'), line.size() - 1) + 1);
  }
}

// "O" and the number, without zeros before it; empty where it is none.
std::string numbered(std::string_view digits) {
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  const std::string number(digits.begin(), std::ranges::find_if_not(digits, is_digit));
  return number.empty() ? std::string() : 'O' + number;
}

// A name such as O0012 is that of program 12.
std::string common_name(std::string_view name) {
  const bool number = name.starts_with('O') && std::ranges::all_of(name.substr(1), is_digit);
  const std::string program = number ? numbered(name.substr(1)) : std::string();
  return program.empty() ? std::string(name) : program;
}

// The program whose head a line is: O and its number, or a name in < >.
std::string head(std::string_view line) {
  line = trimmed(line);
  if (line.empty()) return {};
  if (line.front() == '<') {
    const std::size_t end = line.find('>');
    return end == std::string_view::npos ? std::string() : common_name(line.substr(1, end - 1));
  }
  if (line.front() != 'O' && line.front() != 'o' && line.front() != ':') return {};
  line.remove_prefix(std::min(line.find_first_not_of(" \t", 1), line.size()));
  return numbered(line);
}

// What stands around the programs of a file taken away, its last line ended.
std::string lines_of(std::string text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  while (text.ends_with('\x1A')) text.pop_back();
  if (!text.empty() && text.back() != '\n') text += '\n';
  return text;
}

// Before the first block of a text, in its line: the head that makes it this program.
void add_head(std::string& text, const std::string& program) {
  std::string_view rest = text;
  while (!rest.empty() && trimmed(rest.substr(0, rest.find('\n'))).empty())
    rest.remove_prefix(std::min(rest.find('\n'), rest.size() - 1) + 1);
  const std::string_view first = trimmed(rest);
  const bool number = program.starts_with('O') && std::ranges::all_of(std::string_view(program).substr(1), is_digit);
  text.insert(first.empty() ? 0 : text.size() - first.size(), (number ? program : '<' + program + '>') + ';');
  text = lines_of(std::move(text));
}

// A text cut where the heads of programs stand.
std::vector<ProgramLibrary::Piece> pieces(std::string_view text, std::uint64_t first_line) {
  std::vector<ProgramLibrary::Piece> all{{{}, text, first_line}};
  std::uint64_t line = first_line;
  for (std::string_view rest = text; !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
    if (std::string name = head(rest.substr(0, end)); !name.empty()) {
      all.back().text.remove_suffix(rest.size());
      all.push_back({std::move(name), rest, line});
    }
    rest.remove_prefix(end);
  }
  return all;
}

}  // namespace

ProgramCall program_call(const Block& block, const BlockReader& reader) {
  ProgramCall call;
  if (reader.jump() == BlockReader::Jump::macro) {
    if (const std::uint64_t program = reader.macro_call().program; program != 0)
      call.program = 'O' + std::to_string(program);
    return call;
  }
  const Decimal* const p = last(block, 'P');
  const Decimal* const l = last(block, 'L');
  std::uint64_t number = 0;
  if (p != nullptr && p->decimals == 0 && !p->point && !p->negative) number = p->digits;
  if (!reader.called_name().empty()) {
    call.program = common_name(reader.called_name());
  } else if (l == nullptr && number >= kNumbers) {
    call.times = number / kNumbers;
    number %= kNumbers;
  }
  if (call.program.empty() && number != 0) call.program = 'O' + std::to_string(number);
  if (l != nullptr) call.times = std::max<std::uint64_t>(l->digits, 1);
  return call;
}

std::string_view ProgramLibrary::add(std::string text, std::uint64_t first_line, const std::string& program) {
  next_line_ = first_line;
  const std::vector<Piece> all = keep(std::move(text), {});
  join(program);
  for (const Piece& piece : all) join_called(piece.text);
  return all.front().text;
}

// A text that was asked for as `program` is that one, also where no head in it says so.
std::vector<ProgramLibrary::Piece> ProgramLibrary::keep(std::string text, const std::string& program) {
  text = lines_of(std::move(text));
  const auto is_wanted = [&program](const Piece& piece) { return piece.name == program; };
  if (std::ranges::none_of(pieces(text, next_line_), is_wanted)) add_head(text, program);
  const std::string_view kept = texts_.emplace_back(std::move(text));
  std::vector<Piece> all = pieces(kept, next_line_);
  for (const Piece& piece : all)
    if (!piece.name.empty()) programs_.try_emplace(piece.name, Program{piece.text, piece.line});
  next_line_ += static_cast<std::uint64_t>(std::ranges::count(kept, '\n'));
  return all;
}

void ProgramLibrary::join_called(std::string_view text) {
  MacroVariables variables;
  BlockReader reader(text, axes_, options_, variables);
  reader.scan();
  Block block;
  try {
    while (reader.next(block))
      if (reader.calls() && !block.alarm) join(program_call(block, reader).program);
  } catch (const InputError&) {  // NOLINT(bugprone-empty-catch): it is told where the text runs
  }
}

void ProgramLibrary::join(const std::string& program) {
  if (program.empty() || programs_.contains(program) || !options_.called_program) return;
  if (std::optional<std::string> text = options_.called_program(program, next_line_))
    for (const Piece& piece : keep(std::move(*text), program)) join_called(piece.text);
}

std::optional<ProgramLibrary::Program> ProgramLibrary::find(const std::string& program) const {
  const auto found = programs_.find(program);
  return found == programs_.end() ? std::nullopt : std::optional(found->second);
}

std::string ProgramLibrary::joined() const {
  std::string all;
  for (const std::string& text : texts_) all += text;
  return all;
}

}  // namespace toolcomp::spec
