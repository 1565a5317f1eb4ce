// SPDX-License-Identifier: Apache-2.0
#include "spec/language/heidenhain/klartext_bytes.h"

#include <string_view>

#include "spec/language/input_error.h"

namespace toolcomp::spec::klartext {

void ByteCheck::refuse(unsigned byte, std::uint64_t column) const {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  const std::string name = {'0', 'x', kHex[byte >> 4U & 15U], kHex[byte & 15U]};
  throw InputError(file_, line_, column,
                   byte >= 0x80 ? "byte " + name + " outside comments and strings; a program is ASCII text"
                                : "control character " + name + "; a program is ASCII text");
}

bool ByteCheck::take_minus(unsigned byte) {
  switch (minus_) {
    case Minus::none:
      if (byte != 0xE2) return false;
      minus_ = Minus::first;
      minus_column_ = column_;
      return true;
    case Minus::first:
      if (byte != 0x88 && byte != 0x80) refuse(0xE2, minus_column_);
      minus_ = byte == 0x88 ? Minus::second : Minus::second_of_dash;
      return true;
    case Minus::second:
    case Minus::second_of_dash:
      if (byte != (minus_ == Minus::second ? 0x92U : 0x93U)) refuse(0xE2, minus_column_);
      minus_ = Minus::none;
      return true;
  }
  return false;
}

void ByteCheck::take(char character) {
  const auto byte = static_cast<unsigned char>(character);
  const bool free = any_ || in_comment_ || in_string_;
  if (!free && (byte >= 0x80 || minus_ != Minus::none)) {
    if (!take_minus(byte)) refuse(byte, column_);
    last_ = character;
    ++column_;
    return;
  }
  if (byte == '\n') {
    ++line_;
    column_ = 1;
    in_comment_ = in_string_ = false;
    last_ = 0;
    return;
  }
  if (byte != '\t' && byte != '\r' && (byte < 0x20 || byte == 0x7F)) refuse(byte, column_);
  if (byte == '"' && !in_comment_) in_string_ = !in_string_;
  if (byte == ';' && !in_string_) in_comment_ = true;
  if (byte != ' ' && byte != '\t' && byte != '\r') last_ = character;
  ++column_;
}

}  // namespace toolcomp::spec::klartext
