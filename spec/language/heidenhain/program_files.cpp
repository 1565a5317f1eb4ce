// SPDX-License-Identifier: Apache-2.0
#include "spec/language/heidenhain/program_files.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "spec/language/byte_source.h"
#include "spec/language/heidenhain/joined_program.h"

namespace toolcomp::spec::klartext {

std::optional<std::filesystem::path> file_beside(const std::filesystem::path& folder, std::string_view name) {
  if (has_path(name)) return {};
  namespace fs = std::filesystem;
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path& path = entry->path();
    if (entry->is_regular_file(error) && program_key(path.filename().string()) == program_key(name))
      found.push_back(path);
  }
  if (found.empty()) return {};
  std::ranges::sort(found);
  const auto exact =
      std::ranges::find_if(found, [name](const fs::path& path) { return path.filename().string() == name; });
  return exact == found.end() ? found.front() : *exact;
}

CalledProgram programs_beside(std::filesystem::path folder) {
  return [folder = std::move(folder)](std::string_view name, std::uint64_t /*line*/) {
    const std::optional<std::filesystem::path> file = file_beside(folder, name);
    return file ? std::optional(read_file(file->string())) : std::nullopt;
  };
}

}  // namespace toolcomp::spec::klartext
