// SPDX-License-Identifier: Apache-2.0
#include "certify/bundle/archive_reader.h"

#include <archive.h>
#include <archive_entry.h>

#include <array>

#include "certify/bundle/plain_name.h"
#include "certify/bundle/refused.h"

namespace toolcomp::certify::bundle {
namespace {

constexpr std::size_t kReadAtATime = std::size_t{1} << 16;

std::string words(struct archive* archive) {
  const char* const text = archive_error_string(archive);
  return text == nullptr ? "it is damaged" : text;
}

}  // namespace

ArchiveReader::ArchiveReader(const std::filesystem::path& file) : archive_(archive_read_new()) {
  if (archive_ == nullptr || archive_read_support_filter_zstd(archive_) != ARCHIVE_OK ||
      archive_read_support_format_tar(archive_) != ARCHIVE_OK ||
      archive_read_open_filename(archive_, file.c_str(), kReadAtATime) != ARCHIVE_OK) {
    const std::string why = archive_ == nullptr ? "out of memory" : words(archive_);
    static_cast<void>(archive_read_free(archive_));
    throw Refused("the archive cannot be read: " + why);
  }
}

ArchiveReader::~ArchiveReader() { static_cast<void>(archive_read_free(archive_)); }

std::optional<ArchiveReader::Member> ArchiveReader::next() {
  const int result = archive_read_next_header(archive_, &entry_);
  if (result == ARCHIVE_EOF) return std::nullopt;
  if (result != ARCHIVE_OK) throw Refused("the archive cannot be read: " + words(archive_));
  const char* const name = archive_entry_pathname(entry_);
  if (name == nullptr || !is_plain_name(name)) throw Refused("a member has a name that is not allowed in a bundle");
  const bool plain = archive_entry_filetype(entry_) == AE_IFREG && archive_entry_hardlink(entry_) == nullptr &&
                     archive_entry_symlink(entry_) == nullptr && archive_entry_sparse_count(entry_) == 0 &&
                     archive_entry_size_is_set(entry_) != 0 && archive_entry_size(entry_) >= 0;
  if (!plain) throw Refused(std::string(name) + ": is not a regular file");
  member_ = {name, static_cast<std::uint64_t>(archive_entry_size(entry_))};
  return member_;
}

void ArchiveReader::read(const std::function<void(std::string_view)>& take) {
  std::array<char, kReadAtATime> buffer{};
  std::uint64_t left = member_.size;
  while (true) {
    const la_ssize_t size = archive_read_data(archive_, buffer.data(), buffer.size());
    if (size < 0) throw Refused(member_.name + ": cannot be read: " + words(archive_));
    if (static_cast<std::uint64_t>(size) > left) throw Refused(member_.name + ": is longer than its header says");
    if (size == 0) break;
    left -= static_cast<std::uint64_t>(size);
    take({buffer.data(), static_cast<std::size_t>(size)});
  }
  if (left > 0) throw Refused(member_.name + ": is truncated");
}

}  // namespace toolcomp::certify::bundle
