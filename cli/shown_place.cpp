// SPDX-License-Identifier: Apache-2.0
#include "cli/shown_place.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>

namespace toolcomp::cli {

std::uint64_t character_column(const std::string& file, std::uint64_t line, std::uint64_t column) {
  std::error_code none;
  if (line == 0 || column < 2 || !std::filesystem::is_regular_file(file, none)) return column;
  std::ifstream in(file, std::ios::binary);
  for (std::uint64_t before = 1; before < line && in; ++before)
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  std::string text(static_cast<std::size_t>(column - 1), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.gcount() < static_cast<std::streamsize>(text.size())) return column;
  const auto continued =
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; });
  return column - static_cast<std::uint64_t>(continued);
}

spec::InputError in_characters(const spec::InputError& error) {
  return {error.file(), error.line(), character_column(error.file(), error.line(), error.column()), error.message()};
}

}  // namespace toolcomp::cli
