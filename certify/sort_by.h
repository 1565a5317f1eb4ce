// SPDX-License-Identifier: Apache-2.0
// Sorting that keeps what is equal in its order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace toolcomp::certify {

// By what `key` gives of a value, ascending. std::stable_sort of this library uses what C++17 has deprecated, and clang
// says so.
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
