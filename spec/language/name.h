// SPDX-License-Identifier: Apache-2.0
// A short name stored inline, so that events can be copied without allocating.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <string_view>

namespace toolcomp::spec {

// At most kCapacity characters. Longer text is cut (no name of the specification is longer, which a test checks).
class Name {
 public:
  static constexpr std::size_t kCapacity = 63;

  constexpr Name() = default;
  constexpr Name(std::string_view text)  // NOLINT(google-explicit-constructor): a name is text
      : size_(static_cast<unsigned char>(std::min(text.size(), kCapacity))) {
    std::copy_n(text.begin(), size_, text_.begin());
  }
  constexpr Name(const char* text) : Name(std::string_view(text)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] constexpr std::string_view view() const { return {text_.data(), size_}; }
  [[nodiscard]] constexpr bool empty() const { return size_ == 0; }
  friend constexpr bool operator==(const Name& a, const Name& b) { return a.view() == b.view(); }
  friend constexpr auto operator<=>(const Name& a, const Name& b) { return a.view() <=> b.view(); }

 private:
  std::array<char, kCapacity> text_{};
  unsigned char size_ = 0;
};

}  // namespace toolcomp::spec
