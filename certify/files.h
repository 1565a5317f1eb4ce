// Files read whole and written so that no half of one is ever seen.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace toolcomp::certify {

// The bytes of a file. Throws spec::InputError (naming the file) if it cannot be read or is longer than `limit`.
std::string read_file(const std::filesystem::path& path, std::size_t limit = std::size_t{256} << 20);

// Writes beside `path` and renames, so that a reader sees the old file or the whole new one. Makes the folder. Throws
// std::runtime_error naming the file; nothing is left behind then.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace toolcomp::certify
