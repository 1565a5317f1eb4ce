// SPDX-License-Identifier: Apache-2.0
#include "spec/language/split.h"

namespace toolcomp::spec {

std::vector<std::string_view> split(std::string_view list, char separator) {
  std::vector<std::string_view> items;
  while (!list.empty()) {
    const std::size_t end = list.find(separator);
    items.push_back(list.substr(0, end));
    list.remove_prefix(end == std::string_view::npos ? list.size() : end + 1);
  }
  return items;
}

}  // namespace toolcomp::spec
