// SPDX-License-Identifier: Apache-2.0
#include "host/file_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#include "spec/language/input_error.h"

namespace toolcomp::host {

namespace {

// The bytes into a new file of that name, and 0, or why not (errno).
int write_new(const std::string& name, std::string_view bytes) {
  const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) return errno;
  int why = 0;
  while (why == 0 && !bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      why = errno;
  }
  if (::close(descriptor) != 0 && why == 0) why = errno;
  return why;
}

[[noreturn]] void fail(const std::filesystem::path& path, int why) {
  throw spec::InputError(path.string(), 0, 0, "cannot be written: " + std::generic_category().message(why));
}

// A file on the disk under a name of its own, until it is given the one that it is for.
class NewFile {
 public:
  NewFile(std::filesystem::path path, std::string_view bytes) : path_(std::move(path)) {
    namespace fs = std::filesystem;
    std::error_code error;
    if (path_.has_parent_path()) fs::create_directories(path_.parent_path(), error);
    const fs::file_status there = fs::symlink_status(path_, error);
    if (fs::exists(there) && !fs::is_regular_file(there) && !fs::is_symlink(there))
      throw spec::InputError(path_.string(), 0, 0, "cannot be written: it is not a regular file");
    // Nobody can know that name before, so that nothing lies there.
    std::random_device random;
    beside_ = path_.string() + "." + std::to_string(random()) + std::to_string(random()) + ".part";
    const int why = write_new(beside_, bytes);
    if (why == 0) return;
    if (why != EEXIST) ::unlink(beside_.c_str());
    fail(path_, why);
  }
  NewFile(NewFile&& other) noexcept : path_(std::move(other.path_)), beside_(std::exchange(other.beside_, {})) {}
  NewFile(const NewFile&) = delete;
  ~NewFile() {
    if (!beside_.empty()) ::unlink(beside_.c_str());
  }

  void show() {
    if (::rename(beside_.c_str(), path_.c_str()) != 0) fail(path_, errno);
    beside_.clear();
  }

 private:
  std::filesystem::path path_;
  std::string beside_;  // empty: it has its name
};

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view bytes) { NewFile(path, bytes).show(); }

void write_files(const std::vector<FileText>& files) {
  std::vector<NewFile> written;
  written.reserve(files.size());
  for (const auto& [path, text] : files) written.emplace_back(path, text);
  for (NewFile& file : written) file.show();
}

}  // namespace toolcomp::host
