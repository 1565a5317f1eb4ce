// SPDX-License-Identifier: Apache-2.0
// Files written so that no half of one is ever seen.
#pragma once

#include <filesystem>
#include <string_view>

namespace toolcomp::spec {

// Writes beside `path` and renames, so that a reader sees the old file or the whole new one. Makes the folder. A link
// is replaced, not followed; what is no plain file (a device, a folder) is refused. Throws InputError naming the file
// and why; nothing is left then.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace toolcomp::spec
