// SPDX-License-Identifier: Apache-2.0
// Suggestions for a name that is not known.
#pragma once

#include <algorithm>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::spec {

// The known names nearest to a word, at most three, in their order: the names with the smallest edit_distance() (case,
// and - for _, do not count), if that is less than about a third of the length of the word; or the names that begin
// with the word. Empty if no name is near.
std::vector<std::string_view> nearest_names(std::string_view word, const std::vector<std::string_view>& known);

// The same as the end of a message: "; did you mean a, b or c?", or an empty text.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known);

template <std::ranges::input_range Names>
std::string did_you_mean(std::string_view word, const Names& known) {
  return did_you_mean(word, std::vector<std::string_view>(std::ranges::begin(known), std::ranges::end(known)));
}

}  // namespace toolcomp::spec
