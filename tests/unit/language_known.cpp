// SPDX-License-Identifier: Apache-2.0
// How well clauses are known: names, sets, sums, citations. Expectations are written by hand.
#include "spec/language/known.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace toolcomp::spec {
namespace {

TEST(Known, NamesAreThoseOfTheClauseFiles) {
  EXPECT_EQ(known_name(Known::manual), "manual");
  EXPECT_EQ(known_name(Known::ours), "ours");
  EXPECT_EQ(find_known("sister"), Known::sister);
  EXPECT_EQ(find_known("recollection"), Known::recollection);
  EXPECT_EQ(find_known("Manual"), std::nullopt);
  EXPECT_EQ(find_known(""), std::nullopt);
}

TEST(Known, ASetOfThem) {
  EXPECT_TRUE(KnownSet().is_all());
  const KnownSet set = KnownSet::of({"sister", "manual", "sister"});
  EXPECT_TRUE(set.has(Known::manual));
  EXPECT_TRUE(set.has(Known::sister));
  EXPECT_FALSE(set.has(Known::recollection));
  EXPECT_FALSE(set.has(Known::ours));
  EXPECT_EQ(set.names(), (std::vector<std::string>{"manual", "sister"}));
  EXPECT_TRUE(KnownSet::of({"manual", "sister", "recollection", "ours"}).is_all());
  EXPECT_THROW(KnownSet::of({}), std::invalid_argument);
  EXPECT_THROW(KnownSet::of({"manual", ""}), std::invalid_argument);
  EXPECT_THROW(KnownSet::of({"rumour"}), std::invalid_argument);
}

TEST(Known, Sums) {
  KnownCounts counts;
  counts.add(Known::manual, 61);
  counts.add(Known::sister, 40);
  counts.add(Known::recollection, 70);
  counts.add(Known::ours);
  KnownCounts more;
  more.add(Known::ours, 42);
  counts.add(more);
  EXPECT_EQ(counts.total(), 214U);
  EXPECT_EQ(counts.words(), "61 from the manual, 40 from a sister manual, 70 from recollection, 43 ours");
}

TEST(Known, CitationsNamePagesAndSections) {
  ClauseInfo clause{};
  clause.known = Known::ours;
  EXPECT_EQ(cited(clause), "ours");
  clause.known = Known::sister;
  clause.document = "TNC 320 ISO";
  clause.edition = "10/2017";
  clause.page = "124";
  EXPECT_EQ(cited(clause), "sister: TNC 320 ISO (10/2017), page 124");
  clause.edition = {};
  clause.page = "section 14.3";
  clause.words = "the page: this; that is ours";
  EXPECT_EQ(cited(clause), "sister: TNC 320 ISO, section 14.3 (the page: this; that is ours)");
}

// Every clause is in one section and of one kind.
TEST(Known, SectionsAddUp) {
  const auto sections = known_by_section([](Clause) { return true; });
  EXPECT_EQ(sum_of(sections).total(), kClauseCount);
  std::set<std::string_view> names;
  for (const auto& [section, counts] : sections) EXPECT_TRUE(names.insert(section).second) << section;
  const auto one = known_by_section([](Clause clause) { return clause == Clause::fanuc_leading_edge_sign; });
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].first, "fanuc/leading-edge-offset");
  EXPECT_EQ(one[0].second.of(Known::manual), 1U);
}

}  // namespace
}  // namespace toolcomp::spec
