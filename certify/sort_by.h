// SPDX-License-Identifier: Apache-2.0
// Stable sorting: equal values keep their order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace toolcomp::certify {

// Sorts by `key` of a value, ascending. It replaces std::stable_sort, which in this standard library uses a function
// that C++17 has deprecated, and clang warns about that.
template <class T, class Key>
void sort_by(std::vector<T>& values, Key key) {
  using Keys = std::decay_t<std::invoke_result_t<Key&, const T&>>;
  std::vector<std::pair<Keys, std::size_t>> order;
  order.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) order.emplace_back(std::invoke(key, std::as_const(values[i])), i);
  std::ranges::sort(order);
  std::vector<T> sorted;
  sorted.reserve(values.size());
  for (const auto& place : order) sorted.push_back(std::move(values[place.second]));
  values = std::move(sorted);
}

}  // namespace toolcomp::certify
