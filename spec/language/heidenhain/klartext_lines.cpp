// SPDX-License-Identifier: Apache-2.0
#include "spec/language/heidenhain/klartext_lines.h"

#include <string_view>

#include "spec/language/column_number.h"
#include "spec/language/digits.h"

namespace toolcomp::spec::klartext {
namespace {

constexpr ColumnForm kCoordinate{5, 5, 6};
constexpr ColumnForm kComponent{1, 8, 8};
constexpr std::string_view kLetters = "XYZ";

// Past the blank after a word, or to the end of the line; nullptr: something else comes.
[[gnu::always_inline]] inline const char* past_gap(const char* at) {
  if (*at == ' ') return at + 1;
  return *at == '\r' || *at == '\n' ? at : nullptr;
}

// NX NY NZ or TX TY TZ, not all 0.
[[gnu::always_inline]] inline const char* read_vector(const char* at, char first, std::size_t place, LineColumns& to) {
  bool zero = true;
  for (std::size_t i = 0; i < kLetters.size(); ++i) {
    if (at[0] != first || at[1] != kLetters[i]) return nullptr;
    double& component = to.columns[place + i][to.size];
    at = read_column_number<kComponent>(at + 2, component);
    if (at == nullptr) return nullptr;
    at = past_gap(at);
    if (at == nullptr) return nullptr;
    zero = zero && component == 0;
  }
  return zero ? nullptr : at;
}

}  // namespace

const char* read_usual_line(const char* at, LineColumns& to) {
  const char* const begin = at;
  const Digits n = digits_at(at);
  const bool numbered = n.count != 0;
  if (to.size == 0) to.numbered = numbered;
  if (numbered != to.numbered || n.count > 7) return nullptr;
  if (numbered) {
    to.n[to.size] = n.number;
    at += n.count;
    if (*at++ != ' ') return nullptr;
  }
  to.column[to.size] = static_cast<std::uint8_t>(at - begin + 1);
  if (at[0] != 'L' || at[1] != 'N' || at[2] != ' ') return nullptr;
  at += 3;
  std::uint32_t words = 0;
  for (const char letter : kLetters) {
    if (*at != letter) return nullptr;
    at = read_column_number<kCoordinate>(at + 1, to.columns[word_place(letter)][to.size]);
    if (at == nullptr) return nullptr;
    at = past_gap(at);
    if (at == nullptr) return nullptr;
    words |= place_bit(word_place(letter));
  }
  at = read_vector(at, 'N', kNormalPlace, to);
  if (at == nullptr) return nullptr;
  words |= 0b111U << kNormalPlace;
  if (*at == 'T') {
    at = read_vector(at, 'T', kToolVectorPlace, to);
    if (at == nullptr) return nullptr;
    words |= 0b111U << kToolVectorPlace;
  }
  if (to.size == 0) to.words = words;
  if (words != to.words) return nullptr;
  if (*at == '\r') ++at;
  return *at == '\n' ? at + 1 : nullptr;
}

}  // namespace toolcomp::spec::klartext
