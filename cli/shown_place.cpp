// SPDX-License-Identifier: Apache-2.0
#include "cli/shown_place.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string_view>

namespace toolcomp::cli {

std::string line_of(std::istream& text, std::uint64_t number) {
  for (std::uint64_t before = 1; before < number && text; ++before)
    text.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  std::string line;
  std::getline(text, line);
  return line;
}

std::string line_of(const std::string& file, std::uint64_t number) {
  std::error_code none;
  if (number == 0 || !std::filesystem::is_regular_file(file, none)) return {};
  std::ifstream text(file, std::ios::binary);
  return line_of(text, number);
}

std::uint64_t character_column(const std::string& file, std::uint64_t line, std::uint64_t column) {
  if (column < 2) return column;
  const std::string text = line_of(file, line);
  if (text.size() < column - 1) return column;
  const auto continued = std::ranges::count_if(std::string_view(text).substr(0, static_cast<std::size_t>(column - 1)),
                                               [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; });
  return column - static_cast<std::uint64_t>(continued);
}

spec::InputError in_characters(const spec::InputError& error) {
  return {error.file(), error.line(), character_column(error.file(), error.line(), error.column()), error.message()};
}

}  // namespace toolcomp::cli
