// SPDX-License-Identifier: Apache-2.0
#include "spec/language/byte_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "spec/language/input_error.h"

namespace toolcomp::spec {
namespace {

class StreamSource final : public ByteSource {
 public:
  explicit StreamSource(std::istream& stream) : stream_(stream) {}
  std::size_t read(char* buffer, std::size_t size) override {
    stream_.read(buffer, static_cast<std::streamsize>(size));
    return static_cast<std::size_t>(stream_.gcount());
  }

 private:
  std::istream& stream_;
};

class TextSource final : public ByteSource {
 public:
  explicit TextSource(std::string_view text) : text_(text) {}
  std::size_t read(char* buffer, std::size_t size) override {
    const std::size_t count = text_.copy(buffer, size);
    text_.remove_prefix(count);
    return count;
  }

 private:
  std::string_view text_;
};

[[noreturn]] void cannot_be_read(const std::string& path) {
  throw InputError(display_name(path), 0, 0, "cannot be read: " + std::generic_category().message(errno));
}

// A plain file, or what this process was given open already: a device or a pipe of that name may never end, or wait for
// a writer for ever.
std::FILE* opened(const std::string& path) {
  const bool given = path == "/dev/stdin" || path.starts_with("/dev/fd/");
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | (given ? 0 : O_NONBLOCK));
  if (descriptor < 0) cannot_be_read(path);
  struct stat what{};
  if (::fstat(descriptor, &what) == 0 && !given && !S_ISREG(what.st_mode) && !S_ISDIR(what.st_mode)) {
    ::close(descriptor);
    throw InputError(path, 0, 0, "cannot be read: it is not a regular file; use - for standard input");
  }
  return ::fdopen(descriptor, "rb");
}

class FileSource final : public ByteSource {
 public:
  explicit FileSource(const std::string& path) : path_(path), file_(path == "-" ? stdin : opened(path)) {
    if (file_ == nullptr) cannot_be_read(path_);
  }
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;
  ~FileSource() override {
    if (file_ != stdin) (void)std::fclose(file_);  // read only: nothing is lost
  }
  std::size_t read(char* buffer, std::size_t size) override {
    if (ended_) return 0;
    const std::size_t count = std::fread(buffer, 1, size, file_);
    ended_ = count < size;
    if (ended_ && std::ferror(file_) != 0) cannot_be_read(path_);  // a folder, for one, opens but cannot be read
    return count;
  }

 private:
  std::string path_;
  std::FILE* file_;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<ByteSource> stream_source(std::istream& stream) { return std::make_unique<StreamSource>(stream); }
std::unique_ptr<ByteSource> text_source(std::string_view text) { return std::make_unique<TextSource>(text); }
std::unique_ptr<ByteSource> file_source(const std::string& path) { return std::make_unique<FileSource>(path); }

void expect_plain_file(const std::string& path) {
  FileSource source(path);
  std::array<char, 1> byte{};
  source.read(byte.data(), byte.size());  // a folder opens, and cannot be read
}

std::string read_file(const std::string& path, std::size_t limit) {
  FileSource source(path);
  std::string text;
  std::array<char, 1 << 16> buffer;
  while (const std::size_t count = source.read(buffer.data(), buffer.size())) {
    if (count > limit - text.size())
      throw InputError(display_name(path), 0, 0, "is longer than " + std::to_string(limit) + " bytes");
    text.append(buffer.data(), count);
  }
  return text;
}

std::string display_name(const std::string& path) { return path == "-" ? "standard input" : path; }

}  // namespace toolcomp::spec
