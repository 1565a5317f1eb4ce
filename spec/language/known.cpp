// SPDX-License-Identifier: Apache-2.0
#include "spec/language/known.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <stdexcept>

namespace toolcomp::spec {
namespace {

constexpr std::array<std::string_view, kKnownKinds> kKnownNames{"manual", "sister", "recollection", "ours"};

}  // namespace

std::string_view known_name(Known known) { return kKnownNames.at(static_cast<std::size_t>(known)); }

std::optional<Known> find_known(std::string_view name) {
  const std::span names(kKnownNames);
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Known>(found - names.begin());
}

std::string cited(const ClauseInfo& clause) {
  std::string text(known_name(clause.known));
  if (!clause.document.empty()) text += fmt::format(": {}", clause.document);
  if (!clause.edition.empty()) text += fmt::format(" ({})", clause.edition);
  // A number is that of a page; the rest says itself what it is.
  const bool number = !clause.page.empty() && clause.page.front() >= '0' && clause.page.front() <= '9';
  if (!clause.page.empty()) text += fmt::format(", {}{}", number ? "page " : "", clause.page);
  if (!clause.words.empty()) text += fmt::format(" ({})", clause.words);
  return text;
}

KnownSet KnownSet::of(const std::vector<std::string>& names) {
  KnownSet set;
  set.chosen_.fill(false);
  for (const std::string& name : names) {
    const auto known = find_known(name);
    if (!known) throw std::invalid_argument(fmt::format("\"{}\" is not one of {}", name, fmt::join(kKnownNames, ", ")));
    set.chosen_.at(static_cast<std::size_t>(*known)) = true;
  }
  if (names.empty())
    throw std::invalid_argument(fmt::format("expected at least one of {}", fmt::join(kKnownNames, ", ")));
  return set;
}

std::vector<std::string> KnownSet::names() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kKnownNames.size(); ++i)
    if (chosen_.at(i)) names.emplace_back(kKnownNames.at(i));
  return names;
}

void KnownCounts::add(const KnownCounts& more) {
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_.at(i) += more.counts_.at(i);
}

std::uint64_t KnownCounts::total() const { return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0}); }

std::string KnownCounts::words() const {
  return fmt::format("{} from the manual, {} from a sister manual, {} from recollection, {} ours", of(Known::manual),
                     of(Known::sister), of(Known::recollection), of(Known::ours));
}

KnownCounts sum_of(const std::vector<std::pair<std::string_view, KnownCounts>>& sections) {
  KnownCounts sum;
  for (const auto& [section, counts] : sections) sum.add(counts);
  return sum;
}

}  // namespace toolcomp::spec
