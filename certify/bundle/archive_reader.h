// SPDX-License-Identifier: Apache-2.0
// Members of an archive that anybody may have made.
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

// Reads a tar archive compressed by zstd, in bounded memory; makes no file. Throws Refused for members that are no
// plain files or have no plain names (plain_name.h), and for bytes that are no such archive.
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
  // Nothing at the end.
  std::optional<Member> next();
  // All bytes of the member, piece by piece; as many as its size says.
  void read(const std::function<void(std::string_view)>& take);

 private:
  struct archive* archive_ = nullptr;
  struct archive_entry* entry_ = nullptr;
  Member member_;
};

}  // namespace toolcomp::certify::bundle
