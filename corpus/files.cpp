#include "corpus/files.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "spec/language/input_error.h"

namespace toolcomp::corpus {

std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw spec::InputError(file.string(), 0, 0, "cannot be read");
  return bytes;
}

void write_file(const std::filesystem::path& file, std::string_view bytes) {
  std::filesystem::create_directories(file.parent_path());
  std::filesystem::path beside = file;
  beside += ".tmp";
  std::ofstream out(beside, std::ios::binary);
  out << bytes;
  out.close();
  if (!out) {
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    throw std::runtime_error(file.string() + ": cannot be written");
  }
  std::filesystem::rename(beside, file);
}

}  // namespace toolcomp::corpus
