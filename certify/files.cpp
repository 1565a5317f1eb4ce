#include "certify/files.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "spec/language/input_error.h"

namespace toolcomp::certify {

std::string read_file(const std::filesystem::path& path, std::size_t limit) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw spec::InputError(path.string(), 0, 0, "is a folder");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw spec::InputError(path.string(), 0, 0, std::strerror(errno));
  std::string bytes;
  std::string piece(std::size_t{1} << 16, '\0');
  while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) || stream.gcount() > 0) {
    bytes.append(piece, 0, static_cast<std::size_t>(stream.gcount()));
    if (bytes.size() > limit)
      throw spec::InputError(path.string(), 0, 0, "is longer than " + std::to_string(limit) + " bytes");
  }
  if (stream.bad()) throw spec::InputError(path.string(), 0, 0, "cannot be read");
  return bytes;
}

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

}  // namespace toolcomp::certify
