// SPDX-License-Identifier: Apache-2.0
#include "certify/bundle/spool.h"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkstemp
#include <unistd.h>

#include <stdexcept>

#include "certify/bundle/refused.h"

namespace toolcomp::certify::bundle {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 16;
constexpr std::size_t kLongestLine = std::size_t{256} << 20;

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(std::string("a temporary file cannot be ") + what);
}

}  // namespace

Spool::Spool(const std::filesystem::path& folder) {
  std::string name = (folder / ".toolcomp-XXXXXX").string();
  const int fd = ::mkstemp(name.data());
  if (fd < 0) throw std::runtime_error(folder.string() + ": cannot make a temporary file in this folder");
  static_cast<void>(::unlink(name.c_str()));
  file_.reset(::fdopen(fd, "w+b"));
  if (!file_) {
    static_cast<void>(::close(fd));
    fail("opened");
  }
}

void Spool::append(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) fail("written");
  digest_.update(bytes);
  size_ += bytes.size();
}

std::string Spool::finish() {
  if (std::fflush(file_.get()) != 0) fail("written");
  rewind();
  return digest_.hex();
}

void Spool::rewind() {
  if (std::fseek(file_.get(), 0, SEEK_SET) != 0) fail("read");
  buffer_.clear();
  at_ = 0;
}

std::string_view Spool::read(std::size_t most) {
  buffer_.resize(most);
  buffer_.resize(std::fread(buffer_.data(), 1, most, file_.get()));
  if (std::ferror(file_.get()) != 0) fail("read");
  return buffer_;
}

bool Spool::next_line(std::string& line) {
  line.clear();
  while (true) {
    if (at_ == buffer_.size()) {
      at_ = 0;
      if (read(kPiece).empty()) return !line.empty();
    }
    const std::size_t end = buffer_.find('\n', at_);
    line.append(buffer_, at_, end == std::string::npos ? std::string::npos : end - at_);
    at_ = end == std::string::npos ? buffer_.size() : end + 1;
    if (line.size() > kLongestLine) throw Refused("a line is too long");
    if (end != std::string::npos) return true;
  }
}

}  // namespace toolcomp::certify::bundle
