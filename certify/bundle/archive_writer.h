// SPDX-License-Identifier: Apache-2.0
// Writes a tar archive, compressed by zstd and sealed. The same members give the same bytes.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "certify/bundle/spool.h"
#include "host/sha256.h"

struct archive;

namespace toolcomp::certify::bundle {

// The file has another name until it is finished, and is removed if it is never finished. Members have no date and no
// owner. All functions throw std::runtime_error with the name of the file if it cannot be written.
class ArchiveWriter {
 public:
  explicit ArchiveWriter(std::filesystem::path file);
  ~ArchiveWriter();
  ArchiveWriter(const ArchiveWriter&) = delete;
  ArchiveWriter& operator=(const ArchiveWriter&) = delete;

  void add(const std::string& name, std::string_view bytes);
  void add(const std::string& name, Spool& bytes);
  void finish();

 private:
  void begin(const std::string& name, std::uint64_t size);
  void write(std::string_view bytes);
  void expect(bool well) const;
  static long on_write(struct archive* archive, void* writer, const void* bytes, std::size_t size);

  std::filesystem::path file_;
  std::filesystem::path beside_;
  std::FILE* out_ = nullptr;
  struct archive* archive_ = nullptr;
  host::Sha256 digest_;
};

}  // namespace toolcomp::certify::bundle
