// SPDX-License-Identifier: Apache-2.0
// How well clauses are known: names, sets and counts of these kinds, and the citation of a source.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spec/clauses/clauses.h"

namespace toolcomp::spec {

inline constexpr std::size_t kKnownKinds = 4;
inline constexpr std::array<Known, kKnownKinds> kAllKnown{Known::manual, Known::sister, Known::recollection,
                                                          Known::ours};

// "manual", "sister", "recollection", "ours".
std::string_view known_name(Known known);
std::optional<Known> find_known(std::string_view name);

// "manual: A-78438E, page 23 (the page: …)".
std::string cited(const ClauseInfo& clause);

// A set of these kinds. At first it has all of them.
class KnownSet {
 public:
  KnownSet() = default;
  // Throws std::invalid_argument for an unknown name, and if there are no names.
  static KnownSet of(const std::vector<std::string>& names);

  [[nodiscard]] bool has(Known known) const { return chosen_.at(static_cast<std::size_t>(known)); }
  [[nodiscard]] bool is_all() const { return *this == KnownSet(); }
  // The names, the best known kind first.
  [[nodiscard]] std::vector<std::string> names() const;
  friend bool operator==(const KnownSet&, const KnownSet&) = default;

 private:
  std::array<bool, kKnownKinds> chosen_{true, true, true, true};
};

// Counts of clauses by how well they are known.
class KnownCounts {
 public:
  void add(Known known, std::uint64_t clauses = 1) { counts_.at(static_cast<std::size_t>(known)) += clauses; }
  void add(const KnownCounts& more);
  [[nodiscard]] std::uint64_t of(Known known) const { return counts_.at(static_cast<std::size_t>(known)); }
  [[nodiscard]] std::uint64_t total() const;
  // "61 from the manual, 40 from a sister manual, 70 from recollection, 43 ours".
  [[nodiscard]] std::string words() const;

 private:
  std::array<std::uint64_t, kKnownKinds> counts_{};
};

// Counts the clauses for which `counted` is true, by section in the order of the files.
template <class Counted>
std::vector<std::pair<std::string_view, KnownCounts>> known_by_section(Counted counted) {
  std::vector<std::pair<std::string_view, KnownCounts>> sections;
  for (std::size_t i = 0; i < clauses().size(); ++i) {
    if (!counted(static_cast<Clause>(i))) continue;
    const ClauseInfo& clause = clauses()[i];
    if (sections.empty() || sections.back().first != clause.section)
      sections.emplace_back(clause.section, KnownCounts());
    sections.back().second.add(clause.known);
  }
  return sections;
}

// Their sum.
KnownCounts sum_of(const std::vector<std::pair<std::string_view, KnownCounts>>& sections);

}  // namespace toolcomp::spec
