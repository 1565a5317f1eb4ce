// SPDX-License-Identifier: Apache-2.0
#include "spec/language/suggestion.h"

#include <cctype>
#include <cstddef>
#include <limits>

#include "spec/language/edit_distance.h"

namespace toolcomp::spec {
namespace {

constexpr std::size_t kSuggested = 3;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

std::string plain(std::string_view name) {
  std::string text(name);
  for (char& c : text) c = c == '_' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// A name cut short is one slip away from it; where every letter is another, there is none.
std::size_t slips(const std::string& word, const std::string& name) {
  const std::size_t most = (word.size() + 2) / 3;
  const std::size_t distance = edit_distance(word, name);
  if (distance == 0) return 0;
  if (word.size() > 1 && name.starts_with(word)) return 1;
  return distance <= most && distance < word.size() ? distance : kNone;
}

}  // namespace

std::vector<std::string_view> nearest_names(std::string_view word, const std::vector<std::string_view>& known) {
  std::vector<std::string_view> nearest;
  std::size_t least = kNone;
  const std::string written = plain(word);
  for (const std::string_view name : known) {
    const std::size_t distance = slips(written, plain(name));
    if (distance == kNone || distance > least) continue;
    if (distance < least) nearest.clear();
    least = distance;
    nearest.push_back(name);
  }
  if (nearest.size() > kSuggested) nearest.resize(kSuggested);
  return nearest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known) {
  const std::vector<std::string_view> nearest = nearest_names(word, known);
  std::string text;
  for (std::size_t i = 0; i < nearest.size(); ++i)
    text.append(i == 0 ? "; did you mean " : i + 1 == nearest.size() ? " or " : ", ").append(nearest[i]);
  return text.empty() ? text : text + '?';
}

}  // namespace toolcomp::spec
