// SPDX-License-Identifier: Apache-2.0
// A text that comes a few bytes at a time, as a pipe gives it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "spec/language/byte_source.h"

namespace toolcomp::fuzz {

class Pieces final : public spec::ByteSource {
 public:
  Pieces(std::string_view text, std::size_t size) : text_(text), size_(size) {}
  std::size_t read(char* buffer, std::size_t size) override {
    const std::size_t count = text_.copy(buffer, std::min(size, size_));
    text_.remove_prefix(count);
    return count;
  }

 private:
  std::string_view text_;
  std::size_t size_;
};

}  // namespace toolcomp::fuzz
