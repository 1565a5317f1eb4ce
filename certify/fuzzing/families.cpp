// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/families.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

#include "spec/language/split.h"

namespace toolcomp::certify::fuzzing {
namespace {

std::set<std::string_view> words_of(std::string_view block) {
  const std::vector<std::string_view> words = spec::split(block, ' ');
  return {words.begin(), words.end()};
}

}  // namespace

bool contains(std::string_view shape, std::string_view simpler) {
  const std::vector<std::string_view> wanted = spec::split(simpler, '|');
  auto next = wanted.begin();
  std::set<std::string_view> in_force;
  for (const std::string_view block : spec::split(shape, '|')) {
    std::set<std::string_view> words = words_of(block);
    for (const char* const number : {"D", "H"})
      if (words.contains(number)) in_force.insert(number);
    words.insert(in_force.begin(), in_force.end());
    if (next != wanted.end() && std::ranges::includes(words, words_of(*next))) ++next;
  }
  return next == wanted.end();
}

std::vector<Family> families(const std::vector<Way>& ways) {
  std::vector<std::size_t> order(ways.size());
  std::iota(order.begin(), order.end(), 0);
  // With its place: clang warns of what std::stable_sort is made of.
  std::ranges::sort(order, {}, [&](std::size_t i) {
    const Way& way = ways[i];
    return std::tuple(way.core.size(), std::string_view(way.core), way.shape.size(), std::string_view(way.shape), i);
  });
  std::vector<Family> all;
  for (const std::size_t i : order) {
    const auto home = std::ranges::find_if(all, [&](const Family& family) {
      const Way& first = ways[family.first];
      return !first.core.empty() && first.section == ways[i].section && contains(ways[i].core, first.core);
    });
    if (home == all.end())
      all.push_back({i, {}});
    else
      home->others.push_back(i);
  }
  return all;
}

}  // namespace toolcomp::certify::fuzzing
