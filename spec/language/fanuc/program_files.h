// SPDX-License-Identifier: Apache-2.0
// Called programs in files of the same folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "spec/language/reader_options.h"

namespace toolcomp::spec {

// The file in `folder` that is named after a program ("O1000", or the name in < >). Its ending and the case of its
// letters do not matter, nor do zeros before the number, nor whether the O is there. std::nullopt if there is no such
// file. Throws InputError if there are two.
std::optional<std::filesystem::path> file_beside(const std::filesystem::path& folder, std::string_view name);
// Gives the texts of the files that file_beside finds.
CalledProgram programs_beside(std::filesystem::path folder);

}  // namespace toolcomp::spec
