// SPDX-License-Identifier: Apache-2.0
// Writes files in such a way that a reader never sees half of one.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace toolcomp::host {

// Writes a file next to `path` and renames it, so that a reader sees the old file or the whole new one. Makes the
// folder. A link is replaced, not followed. Anything other than a regular file (a device, a folder) is refused. Throws
// spec::InputError with the file and the reason; no part of the new file is left then.
void write_file(const std::filesystem::path& path, std::string_view bytes);

// The same for files that belong together: all of them are on the disk before the first of them is renamed, so that a
// full disk leaves the old files.
using FileText = std::pair<std::filesystem::path, std::string>;
void write_files(const std::vector<FileText>& files);

}  // namespace toolcomp::host
