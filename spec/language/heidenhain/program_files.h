// SPDX-License-Identifier: Apache-2.0
// Files in which a Klartext program finds those it calls.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "spec/language/reader_options.h"

namespace toolcomp::spec::klartext {

// The file in this folder that a CALL PGM names, with or without the ending .h, in upper or lower case. std::nullopt if
// there is none, and for a name with a path.
std::optional<std::filesystem::path> file_beside(const std::filesystem::path& folder, std::string_view name);
// Gives the texts of the files that file_beside finds.
CalledProgram programs_beside(std::filesystem::path folder);

}  // namespace toolcomp::spec::klartext
