// SPDX-License-Identifier: Apache-2.0
#include "spec/language/file_writer.h"

#include <unistd.h>

#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace toolcomp::spec {

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  // The process id keeps two processes that write the same report apart.
  const std::filesystem::path beside = path.string() + "." + std::to_string(::getpid()) + ".part";
  std::ofstream stream(beside, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(beside, path, error);
  if (!stream || error) {
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    throw std::runtime_error(path.string() + ": cannot be written");
  }
}

}  // namespace toolcomp::spec
