// Files of the corpus, read and written whole.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace toolcomp::corpus {

// The bytes of a file; throws spec::InputError if it cannot be read.
std::string read_file(const std::filesystem::path& file);

// Writes beside the file and renames, so that nobody sees half of one; makes its folder. Throws std::runtime_error if
// it cannot.
void write_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace toolcomp::corpus
