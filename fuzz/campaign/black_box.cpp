// SPDX-License-Identifier: Apache-2.0
#include "fuzz/campaign/black_box.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <new>
#include <stdexcept>

namespace toolcomp::fuzz {
namespace {

constexpr std::uint64_t kMark = 0x786f626b63616c62;  // "blackbox"
constexpr std::size_t kInput = std::size_t{1} << 16U;
constexpr std::size_t kKept = std::size_t{1} << 18U;

}  // namespace

struct BlackBox::Layout {
  std::uint64_t mark = kMark;
  std::uint64_t process = static_cast<std::uint64_t>(::getpid());
  std::atomic<std::uint64_t> executions{0};
  std::atomic<std::uint64_t> size{0};       // of the input
  std::atomic<std::uint64_t> kept_size{0};  // texts, each behind its size
  std::array<char, kInput> input{};
  std::array<char, kKept> kept{};
};

BlackBox::BlackBox(const std::filesystem::path& file) {
  const auto fail = [&file](int error) {
    throw std::runtime_error(file.string() + ": cannot be written: " + std::strerror(error));
  };
  const int fd = ::open(file.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (fd < 0) fail(errno);
  const int full = ::posix_fallocate(fd, 0, sizeof(Layout));
  void* const memory =
      full == 0 ? ::mmap(nullptr, sizeof(Layout), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0) : MAP_FAILED;
  const int error = full == 0 ? errno : full;
  ::close(fd);
  if (memory == MAP_FAILED) fail(error);
  box_ = new (memory) Layout;
}

BlackBox::~BlackBox() { ::munmap(box_, sizeof(Layout)); }

void BlackBox::begin(std::string_view input) {
  // In this order, so that an input is never read with the size of another that is longer than it.
  box_->size = 0;
  if (input.size() <= kInput) {
    std::memcpy(box_->input.data(), input.data(), input.size());
    box_->size = input.size();
  }
  ++box_->executions;
}

bool BlackBox::keep(std::string_view text) {
  const std::uint64_t size = text.size();
  const std::uint64_t at = box_->kept_size;
  if (at + sizeof(size) + size > kKept) return false;
  std::memcpy(box_->kept.data() + at, &size, sizeof(size));
  std::memcpy(box_->kept.data() + at + sizeof(size), text.data(), size);
  box_->kept_size = at + sizeof(size) + size;
  return true;
}

std::optional<BlackBox::Contents> BlackBox::read(const std::filesystem::path& file) {
  std::string bytes(sizeof(Layout), '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return std::nullopt;
  const auto number = [&bytes](std::size_t at) {
    std::uint64_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof(value));
    return value;
  };
  if (number(offsetof(Layout, mark)) != kMark) return std::nullopt;
  Contents contents;
  contents.process = static_cast<std::int64_t>(number(offsetof(Layout, process)));
  contents.executions = number(offsetof(Layout, executions));
  contents.input = bytes.substr(offsetof(Layout, input), std::min<std::size_t>(number(offsetof(Layout, size)), kInput));
  const std::size_t end = std::min<std::size_t>(number(offsetof(Layout, kept_size)), kKept);
  for (std::size_t at = 0; at + sizeof(std::uint64_t) <= end;) {
    const std::uint64_t size = number(offsetof(Layout, kept) + at);
    at += sizeof(std::uint64_t);
    if (size > end - at) break;
    contents.kept.push_back(bytes.substr(offsetof(Layout, kept) + at, size));
    at += size;
  }
  return contents;
}

}  // namespace toolcomp::fuzz
