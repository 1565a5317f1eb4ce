// SPDX-License-Identifier: Apache-2.0
#include "certify/bundle/plain_name.h"

#include <algorithm>

namespace toolcomp::certify::bundle {

bool is_plain_name(std::string_view name) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
           c == '-';
  };
  const auto part = [&](std::string_view text) {
    return !text.empty() && text.front() != '.' && std::ranges::all_of(text, plain);
  };
  constexpr std::size_t kLongestName = 120;
  if (name.size() > kLongestName) return false;
  const std::size_t slash = name.find('/');
  if (slash == std::string_view::npos) return part(name);
  return part(name.substr(0, slash)) && part(name.substr(slash + 1));
}

}  // namespace toolcomp::certify::bundle
