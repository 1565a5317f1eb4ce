// SPDX-License-Identifier: Apache-2.0
// What somebody may have meant who wrote a name that is not known.
#pragma once

#include <algorithm>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::spec {

// The known names nearest to a word, three at most, in their order: those with the fewest slips of the hand
// (edit_distance(); case, and - for _, count as none), where these are fewer than about a third of the word; or those
// that begin with the word. None where nothing is near.
std::vector<std::string_view> nearest_names(std::string_view word, const std::vector<std::string_view>& known);

// The same as the end of a message: "; did you mean a, b or c?", or nothing.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known);

template <std::ranges::input_range Names>
std::string did_you_mean(std::string_view word, const Names& known) {
  return did_you_mean(word, std::vector<std::string_view>(std::ranges::begin(known), std::ranges::end(known)));
}

}  // namespace toolcomp::spec
