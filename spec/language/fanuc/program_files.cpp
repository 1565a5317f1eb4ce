// SPDX-License-Identifier: Apache-2.0
#include "spec/language/fanuc/program_files.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <system_error>
#include <utility>

#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"

namespace toolcomp::spec {
namespace {

namespace fs = std::filesystem;

// What names of one program have in common.
std::string common_name(std::string_view name) {
  std::string text(name);
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const bool number = text.find_first_not_of("0123456789", text.starts_with('O') ? 1 : 0) == std::string::npos;
  if (!number) return text;
  text.erase(0, std::min(text.find_first_not_of("O0"), text.size()));
  return 'O' + text;
}

}  // namespace

std::optional<fs::path> file_beside(const fs::path& folder, std::string_view name) {
  const std::string wanted = common_name(name);
  fs::path found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.empty() ? "." : folder, error)) {
    const auto is_wanted = [&wanted](const fs::path& file) { return common_name(file.string()) == wanted; };
    if (!is_wanted(entry.path().stem()) && !is_wanted(entry.path().filename())) continue;
    if (!entry.is_regular_file(error)) continue;
    // A setup or a table is no program.
    const fs::path ending = entry.path().extension();
    if (ending == ".toml" || ending == ".json" || ending == ".csv") continue;
    if (!found.empty())
      throw InputError(found.string(), 0, 0, "program " + std::string(name) + " is also in " + entry.path().string());
    found = entry.path();
  }
  if (found.empty()) return std::nullopt;
  return found;
}

CalledProgram programs_beside(fs::path folder) {
  return [folder = std::move(folder)](std::string_view name, std::uint64_t /*line*/) {
    const std::optional<fs::path> file = file_beside(folder, name);
    return file ? std::optional(read_file(file->string())) : std::nullopt;
  };
}

}  // namespace toolcomp::spec
