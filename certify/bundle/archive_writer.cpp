// SPDX-License-Identifier: Apache-2.0
#include "certify/bundle/archive_writer.h"

#include <archive.h>
#include <archive_entry.h>
#include <unistd.h>

#include <stdexcept>
#include <system_error>
#include <utility>

#include "certify/bundle/seal.h"

namespace toolcomp::certify::bundle {

ArchiveWriter::ArchiveWriter(std::filesystem::path file)
    : file_(std::move(file)), beside_(file_.string() + "." + std::to_string(::getpid()) + ".part") {
  out_ = std::fopen(beside_.c_str(), "wb");
  expect(out_ != nullptr);
  archive_ = archive_write_new();
  expect(archive_ != nullptr && archive_write_add_filter_zstd(archive_) == ARCHIVE_OK &&
         archive_write_set_format_pax_restricted(archive_) == ARCHIVE_OK &&
         archive_write_set_bytes_in_last_block(archive_, 1) == ARCHIVE_OK &&
         archive_write_open(archive_, this, nullptr, &ArchiveWriter::on_write, nullptr) == ARCHIVE_OK);
}

ArchiveWriter::~ArchiveWriter() {
  if (archive_ != nullptr) static_cast<void>(archive_write_free(archive_));
  if (out_ == nullptr) return;
  static_cast<void>(std::fclose(out_));
  std::error_code ignored;
  std::filesystem::remove(beside_, ignored);
}

void ArchiveWriter::expect(bool well) const {
  if (!well) throw std::runtime_error(file_.string() + ": cannot be written");
}

long ArchiveWriter::on_write(struct archive* /*archive*/, void* writer, const void* bytes, std::size_t size) {
  auto* const self = static_cast<ArchiveWriter*>(writer);
  if (std::fwrite(bytes, 1, size, self->out_) != size) return -1;
  self->digest_.update({static_cast<const char*>(bytes), size});
  return static_cast<long>(size);
}

void ArchiveWriter::begin(const std::string& name, std::uint64_t size) {
  constexpr int kMode = 0644;
  const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(), archive_entry_free);
  archive_entry_set_pathname(entry.get(), name.c_str());
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), kMode);
  archive_entry_set_mtime(entry.get(), 0, 0);
  archive_entry_set_size(entry.get(), static_cast<la_int64_t>(size));
  expect(archive_write_header(archive_, entry.get()) == ARCHIVE_OK);
}

void ArchiveWriter::write(std::string_view bytes) {
  expect(archive_write_data(archive_, bytes.data(), bytes.size()) == static_cast<la_ssize_t>(bytes.size()));
}

void ArchiveWriter::add(const std::string& name, std::string_view bytes) {
  begin(name, bytes.size());
  write(bytes);
}

void ArchiveWriter::add(const std::string& name, Spool& bytes) {
  constexpr std::size_t kPiece = std::size_t{1} << 16;
  begin(name, bytes.size());
  bytes.rewind();
  for (std::string_view piece = bytes.read(kPiece); !piece.empty(); piece = bytes.read(kPiece)) write(piece);
}

void ArchiveWriter::finish() {
  expect(archive_write_close(archive_) == ARCHIVE_OK);
  const std::string frame = seal(digest_.hex());
  expect(std::fwrite(frame.data(), 1, frame.size(), out_) == frame.size());
  expect(std::fflush(out_) == 0 && ::fsync(::fileno(out_)) == 0);
  std::error_code error;
  std::filesystem::rename(beside_, file_, error);
  expect(!error);
  static_cast<void>(std::fclose(std::exchange(out_, nullptr)));
}

}  // namespace toolcomp::certify::bundle
