// SPDX-License-Identifier: Apache-2.0
// Checks the bytes of a Klartext program. Internal to the reader.
#pragma once

#include <cstdint>
#include <string>

namespace toolcomp::spec::klartext {

// Takes the bytes of a logical block one by one. Throws InputError at the first byte that is not text: a control
// character, or a byte from 0x80 on outside a comment, a string and a minus sign (U+2212, U+2013).
class ByteCheck {
 public:
  // `any`: a structure block or a program name, in which every byte from 0x80 on is permitted.
  ByteCheck(const std::string& file, std::uint64_t line, bool any) : file_(file), line_(line), any_(any) {}

  void take(char character);
  // The byte order mark that a text may begin with.
  void take_byte_order_mark() { column_ += 3; }
  // Whether the line continues in the next one: its last byte, without blanks, is a ~.
  [[nodiscard]] bool is_continued() const { return last_ == '~'; }
  // The line of the next byte.
  [[nodiscard]] std::uint64_t line() const { return line_; }

 private:
  enum class Minus : std::uint8_t { none, first, second, second_of_dash };

  // Whether the byte belongs to a minus sign of three bytes.
  bool take_minus(unsigned byte);
  [[noreturn]] void refuse(unsigned byte, std::uint64_t column) const;

  const std::string& file_;
  std::uint64_t line_;
  std::uint64_t column_ = 1;
  bool any_;
  bool in_comment_ = false;
  bool in_string_ = false;
  Minus minus_ = Minus::none;
  std::uint64_t minus_column_ = 0;
  char last_ = 0;  // last byte of this line other than a blank
};

}  // namespace toolcomp::spec::klartext
