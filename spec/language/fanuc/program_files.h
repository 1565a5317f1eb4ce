// SPDX-License-Identifier: Apache-2.0
// Programs in files beside one that calls them.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "spec/language/reader_options.h"

namespace toolcomp::spec {

// The file in `folder` that is named after a program ("O1000", or the name in < >): whatever the ending and the case of
// its letters, with zeros before the number or not, with O or without. nullopt where there is none. Throws InputError
// where there are two.
std::optional<std::filesystem::path> file_beside(const std::filesystem::path& folder, std::string_view name);
// The texts of the files that it finds.
CalledProgram programs_beside(std::filesystem::path folder);

}  // namespace toolcomp::spec
