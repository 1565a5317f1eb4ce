// SPDX-License-Identifier: Apache-2.0
// Usual lines as columns. What is not usual stays for read_block().
#include <algorithm>

#include "spec/language/column_number.h"
#include "spec/language/digits.h"
#include "spec/language/fanuc/block_reader.h"

namespace toolcomp::spec {
namespace {

constexpr ColumnForm kNumber{7, 6, 6};
constexpr unsigned kMostCode = 1;  // G00 and G01

// Of a block that lacks them, axis words keep their position; other words do not.
bool may_lack(char letter) { return letter != 'I' && letter != 'J' && letter != 'K'; }

}  // namespace

void BlockReader::lines(LineColumns& to, std::size_t most) {
  to.size = 0;
  to.words = 0;
  to.code = LineColumns::kNoCode;
  to.line = line_;
  if (done_ || jump_ != Jump::none || scanning_ || offset() != line_start_) return;
  LineShape shape;
  for (const char* at = position_; to.size < most; ++to.size) {
    at = read_line(at, to, shape);
    if (at == nullptr) break;
    line_end_[to.size] = at;
  }
}

void BlockReader::pass_lines(std::size_t count) {
  position_ = line_end_[count - 1];
  line_ += count;
  line_start_ = offset();
}

const char* BlockReader::read_line(const char* at, LineColumns& to, LineShape& shape) const {
  const bool numbered = *at == 'N';
  if (to.size == 0) to.numbered = numbered;
  if (numbered != to.numbered) return nullptr;
  const char* const begin = at;
  if (numbered) {
    const Digits n = digits_at(++at);
    if (n.count == 0 || n.count > 7) return nullptr;
    to.n[to.size] = n.number;
    at += n.count;
    if (*at == ' ') ++at;
  }
  to.column[to.size] = static_cast<std::uint8_t>(at - begin + 1);
  at = read_line_words(at, to, shape);
  if (at == nullptr) return nullptr;
  if (*at == '\r') ++at;
  return *at == '\n' ? at + 1 : nullptr;
}

const char* BlockReader::read_line_words(const char* at, LineColumns& to, LineShape& shape) const {
  const std::size_t row = to.size;
  bool moves = false;
  std::size_t next = 0;  // of the shape
  const auto lacks = [&] {
    const char letter = shape.letter[next++];
    if (letter == 'G') return true;
    auto& column = to.columns[word_place(letter)];
    column[row] = column[row - 1];
    return may_lack(letter);
  };
  while (*at >= 'A' && *at <= 'Z') {
    const char letter = *at++;
    if (row == 0) {
      const bool known = letter == 'G' ? next == 0 : line_letters_ >> word_place(letter) & 1U;
      if (!known || (to.words & place_bit(word_place(letter))) != 0 || next == shape.letter.size()) return nullptr;
      shape.letter[shape.size++] = letter;
      if (letter != 'G') to.words |= place_bit(word_place(letter));
    } else {
      while (next < shape.size && shape.letter[next] != letter)
        if (!lacks()) return nullptr;
      if (next == shape.size) return nullptr;
    }
    ++next;
    if (letter == 'G') {
      const Digits code = digits_at(at);
      at += code.count;
      if (code.count == 0 || code.count > 2 || code.number > kMostCode || *at == '.') return nullptr;
      if (to.code != LineColumns::kNoCode && to.code != static_cast<int>(code.number)) return nullptr;
      to.code = static_cast<int>(code.number);
    } else {
      at = read_column_number<kNumber>(at, to.columns[word_place(letter)][row]);
      if (at == nullptr || *at == '.' || *at == '-') return nullptr;
      moves = true;
    }
    if (*at == ' ') ++at;
  }
  while (next < shape.size)
    if (!lacks()) return nullptr;
  return moves ? at : nullptr;
}

}  // namespace toolcomp::spec
