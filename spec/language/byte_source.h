// SPDX-License-Identifier: Apache-2.0
// Where input bytes come from: text, streams, files by name, standard input.
#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <string>
#include <string_view>

namespace toolcomp::spec {

// A sequence of bytes, read once.
class ByteSource {
 public:
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;
  // Up to `size` bytes into `buffer`; 0 at the end.
  virtual std::size_t read(char* buffer, std::size_t size) = 0;
};

// The stream must outlive the source.
std::unique_ptr<ByteSource> stream_source(std::istream& stream);
// The text must outlive the source.
std::unique_ptr<ByteSource> text_source(std::string_view text);
// The file of this name, or standard input for "-". Throws InputError if it cannot be opened or, later, read.
std::unique_ptr<ByteSource> file_source(const std::string& path);

// Throws InputError if this is not a regular file that can be read. A device or a pipe may never end.
void expect_plain_file(const std::string& path);

// The whole content of a file, or of standard input for "-". Throws InputError if it cannot be read or is longer than
// `limit` bytes.
std::string read_file(const std::string& path, std::size_t limit = std::size_t{1} << 30);
// The name of a file in messages: "-" is "standard input".
std::string display_name(const std::string& path);

}  // namespace toolcomp::spec
