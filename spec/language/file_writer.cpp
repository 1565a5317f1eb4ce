// SPDX-License-Identifier: Apache-2.0
#include "spec/language/file_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <random>
#include <string>
#include <system_error>

#include "spec/language/input_error.h"

namespace toolcomp::spec {

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

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  const fs::file_status there = fs::symlink_status(path, error);
  if (fs::exists(there) && !fs::is_regular_file(there) && !fs::is_symlink(there))
    throw InputError(path.string(), 0, 0, "cannot be written: it is no plain file");
  // Nobody can know that name before, so that nothing lies there.
  std::random_device random;
  const std::string beside = path.string() + "." + std::to_string(random()) + std::to_string(random()) + ".part";
  int why = write_new(beside, bytes);
  if (why == 0 && ::rename(beside.c_str(), path.c_str()) != 0) why = errno;
  if (why == 0) return;
  if (why != EEXIST) ::unlink(beside.c_str());
  throw InputError(path.string(), 0, 0, "cannot be written: " + std::generic_category().message(why));
}

}  // namespace toolcomp::spec
