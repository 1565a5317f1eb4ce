// SPDX-License-Identifier: Apache-2.0
// Collects text in one long buffer, for programs with many events.
#pragma once

#include <cstddef>
#include <cstring>
#include <string_view>
#include <vector>

namespace toolcomp::spec {

// The text that was written and not yet passed on.
class TextBuffer {
 public:
  [[nodiscard]] std::string_view view() const { return {bytes_.data(), size_}; }
  void clear() { size_ = 0; }

 private:
  friend class TextCursor;
  std::vector<char> bytes_;
  std::size_t size_ = 0;
};

// The end of a buffer while one event is written there. It takes text as std::string does, but makes room for a whole
// event before its first character, so that it need not test or move anything in between. If the functions that write
// the event are inlined (gnu::flatten), the place stays in a register.
class TextCursor {
 public:
  // Room for what += and write() write. An event has at most 72 numbers (five maps of nine axes, the tool axis, sweep,
  // two radii, feed, value, six vectors, an angle), none with more than 60 characters including its key, and fewer than
  // 900 other characters.
  static constexpr std::size_t kRoom = 6144;

  // `more`: room besides, for many events.
  explicit TextCursor(TextBuffer& buffer, std::size_t more = 0)
      : buffer_(buffer), at_(room_behind(buffer.size_ + more) - more) {}
  TextCursor(const TextCursor&) = delete;
  TextCursor& operator=(const TextCursor&) = delete;
  ~TextCursor() { buffer_.size_ = size(); }

  TextCursor& operator+=(char c) {
    *at_++ = c;
    return *this;
  }
  TextCursor& operator+=(std::string_view text) {
    std::memcpy(at_, text.data(), text.size());
    at_ += text.size();
    return *this;
  }
  // write_at(to) writes at `to` and returns the end.
  template <class WriteAt>
  void write(const WriteAt& write_at) {
    at_ = write_at(at_);
  }
  // Appends text of any length, and makes room again after it.
  void append(std::string_view text) {
    const std::size_t before = size();
    at_ = room_behind(before + text.size()) - text.size();
    *this += text;
  }

 private:
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(at_ - buffer_.bytes_.data()); }
  [[nodiscard]] char* room_behind(std::size_t size) const {
    if (buffer_.bytes_.size() < size + kRoom) [[unlikely]]
      buffer_.bytes_.resize(2 * size + kRoom);
    return buffer_.bytes_.data() + size;
  }

  TextBuffer& buffer_;
  char* at_;
};

}  // namespace toolcomp::spec
