// SPDX-License-Identifier: Apache-2.0
#include "certify/input/called_files.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "spec/language/byte_source.h"
#include "spec/language/fanuc/program_files.h"
#include "spec/language/heidenhain/program_files.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::input {

namespace fs = std::filesystem;

spec::CalledProgram CalledFiles::finder() {
  if (main_ == "-") return {};
  return [this](std::string_view name, std::uint64_t line) -> std::optional<std::string> {
    const fs::path folder = fs::path(main_).parent_path();
    const std::optional<fs::path> file = control_ == spec::Control::heidenhain
                                             ? spec::klartext::file_beside(folder, name)
                                             : spec::file_beside(folder, name);
    if (!file) return std::nullopt;
    const fs::path home = fs::canonical(folder.empty() ? "." : folder);
    if (const fs::path real = fs::canonical(*file); std::ranges::mismatch(home, real).in1 != home.end())
      throw spec::InputError(file->string(), 0, 0,
                             "is a link to a place outside the folder of the program; toolcomp does not follow it");
    begins_.insert_or_assign(line, *file);
    return spec::read_file(file->string());
  };
}

Place CalledFiles::place(std::uint64_t line, std::uint64_t column) const {
  const auto behind = begins_.upper_bound(line);
  if (behind == begins_.begin()) return {main_, line, column};
  const auto& [first, file] = *std::prev(behind);
  return {file.string(), line - first + 1, column};
}

}  // namespace toolcomp::certify::input
