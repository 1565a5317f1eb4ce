// SPDX-License-Identifier: Apache-2.0
// Reads the members of an archive from outside.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

struct archive;
struct archive_entry;

namespace toolcomp::certify::bundle {

// Reads a tar archive compressed by zstd, in bounded memory, without making files. Throws Refused for members that are
// not regular files or have no plain names (plain_name.h), and for bytes that are not such an archive.
class ArchiveReader {
 public:
  explicit ArchiveReader(const std::filesystem::path& file);
  ~ArchiveReader();
  ArchiveReader(const ArchiveReader&) = delete;
  ArchiveReader& operator=(const ArchiveReader&) = delete;

  struct Member {
    std::string name;
    std::uint64_t size = 0;  // bytes
  };
  // std::nullopt at the end.
  std::optional<Member> next();
  // Gives all bytes of the member, piece by piece; exactly as many as its size says.
  void read(const std::function<void(std::string_view)>& take);

 private:
  struct archive* archive_ = nullptr;
  struct archive_entry* entry_ = nullptr;
  Member member_;
};

}  // namespace toolcomp::certify::bundle
