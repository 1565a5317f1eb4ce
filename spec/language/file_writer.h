// SPDX-License-Identifier: Apache-2.0
// Files written so that no half of one is ever seen.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace toolcomp::spec {

// Writes beside `path` and renames, so that a reader sees the old file or the whole new one. Makes the folder. A link
// is replaced, not followed; what is no plain file (a device, a folder) is refused. Throws InputError naming the file
// and why; nothing is left then.
void write_file(const std::filesystem::path& path, std::string_view bytes);

// The same of files that belong together: all are on the disk before the first of them is seen, so that a disk that is
// full leaves those of before.
using FileText = std::pair<std::filesystem::path, std::string>;
void write_files(const std::vector<FileText>& files);

}  // namespace toolcomp::spec
