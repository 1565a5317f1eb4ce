// SPDX-License-Identifier: Apache-2.0
// Program text as lines of words, for changing it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::fuzz {

// A changed program is no longer than this.
inline constexpr std::size_t kMostLines = 64;

inline bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

using WordTexts = std::vector<std::string>;  // "G01", "X-1.5"; text that is no word keeps its place

std::vector<std::string> lines(std::string_view program);
std::string joined(const std::vector<std::string>& lines);
// A word begins at each letter.
WordTexts words(std::string_view line);
// Words stand between blanks: Klartext.
WordTexts words_between_blanks(std::string_view line);
std::string joined_words(const WordTexts& words);

}  // namespace toolcomp::fuzz
