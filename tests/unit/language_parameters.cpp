// SPDX-License-Identifier: Apache-2.0
// The registry of parameters: what it must keep, against the clauses and by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "spec/clauses/clauses.h"
#include "spec/language/decimal_order.h"
#include "spec/language/edit_distance.h"
#include "spec/language/parameter.h"

namespace toolcomp::spec {
namespace {

std::vector<std::string> lines(std::string_view list) {
  std::vector<std::string> items;
  while (!list.empty()) {
    const std::size_t end = list.find('\n');
    items.emplace_back(list.substr(0, end));
    list.remove_prefix(end == std::string_view::npos ? list.size() : end + 1);
  }
  return items;
}

TEST(Parameters, AscendAndOccurOnce) {
  ASSERT_FALSE(parameters().empty());
  for (std::size_t i = 1; i < parameters().size(); ++i)
    EXPECT_LT(parameters()[i - 1].id, parameters()[i].id) << to_string(parameters()[i].id);
}

TEST(Parameters, ANumberIsOneValueOrBits) {
  for (const ParameterInfo& p : parameters()) {
    EXPECT_EQ(p.id.bit >= 0, p.type == ParameterType::bit) << to_string(p.id);
    EXPECT_TRUE(p.id.bit < 0 || find_parameter({p.id.number, -1}) == nullptr) << to_string(p.id);
  }
}

TEST(Parameters, DefaultsAndExamplesAreInTheRange) {
  const Axes axes("XYZBC");
  for (const ParameterInfo& p : parameters()) {
    EXPECT_TRUE(compare(p.least, p.greatest) <= 0) << to_string(p.id);
    EXPECT_TRUE(!p.default_value || allows(p.id, *p.default_value, axes)) << to_string(p.id);
    if (p.example.empty()) continue;
    const auto example = parse_decimal(p.example);
    EXPECT_TRUE(example && allows(p.id, *example, axes)) << to_string(p.id);
  }
}

TEST(Parameters, HaveTextsOfWholeSentencesThatFitATable) {
  for (const ParameterInfo& p : parameters()) {
    EXPECT_TRUE(p.text.ends_with('.')) << to_string(p.id);
    EXPECT_EQ(p.text.find_first_of("|\n"), std::string_view::npos) << to_string(p.id);
  }
}

TEST(Parameters, NameClausesInForce) {
  for (const ParameterInfo& p : parameters()) {
    EXPECT_FALSE(p.clauses.empty()) << to_string(p.id);
    for (const std::string& id : lines(p.clauses)) {
      const auto clause = find_clause(id);
      ASSERT_TRUE(clause) << to_string(p.id) << ": " << id;
      EXPECT_TRUE(info(*clause).replaced_by.empty()) << to_string(p.id) << ": " << id;
    }
  }
}

TEST(Parameters, AreNamedByEveryClauseThatNamesThem) {
  for (const ClauseInfo& clause : clauses()) {
    if (!clause.replaced_by.empty()) continue;
    for (const std::string& name : lines(clause.parameters)) {
      const auto p =
          std::ranges::find_if(parameters(), [&](const ParameterInfo& other) { return to_string(other.id) == name; });
      ASSERT_NE(p, parameters().end()) << clause.id << " names " << name;
      const std::vector<std::string> ids = lines(p->clauses);
      EXPECT_NE(std::ranges::find(ids, clause.id), ids.end()) << name << " does not name " << clause.id;
    }
  }
}

// Of the manuals: normal values of 19631 and 3401#0, +Z as reference direction, 20 mm and 5 mm of G37.
TEST(Parameters, Defaults) {
  EXPECT_EQ(default_value({19631, -1}, Units::mm), decimal(1));
  EXPECT_EQ(default_value({3401, 0}, Units::inch), decimal(1));
  EXPECT_EQ(default_value({19697, -1}, Units::inch), decimal(3));
  EXPECT_EQ(default_value({6251, -1}, Units::mm), decimal(20));
  EXPECT_EQ(default_value({6254, -1}, Units::mm), decimal(5));
  EXPECT_EQ(default_value({6251, -1}, Units::inch), std::nullopt);  // 20/25.4 inch is no decimal
  EXPECT_EQ(default_value({5010, -1}, Units::inch), decimal(0));
  EXPECT_EQ(default_value({6241, -1}, Units::mm), std::nullopt);
  EXPECT_EQ(default_value({1, -1}, Units::mm), std::nullopt);
}

TEST(Parameters, KnownBits) {
  EXPECT_EQ(known_bits(5001), 0x7FU);
  EXPECT_EQ(known_bits(19605), 0x20U);
  EXPECT_EQ(known_bits(19631), 0U);
  EXPECT_EQ(known_bits(19607), 0x20U);
  EXPECT_EQ(free_bits(19607), 0U);
  EXPECT_EQ(free_bits(5008), 0xBU);
  EXPECT_TRUE(is_known({5001, -1}));
  EXPECT_FALSE(is_known({5001, 7}));
  EXPECT_FALSE(is_known({19631, 0}));
}

TEST(Parameters, AllowedAreThoseOfASetupThatCanBeRead) {
  spec::Setup setup;  // Setup alone is a member of testing::Test
  EXPECT_TRUE(has_allowed_parameters(setup));
  setup.parameters[{19681, -1}] = decimal(3);
  EXPECT_TRUE(has_allowed_parameters(setup));
  setup.axes = Axes("XY");
  EXPECT_FALSE(has_allowed_parameters(setup));
  setup.parameters = {{{19860, -1}, decimal(0)}};
  EXPECT_FALSE(has_allowed_parameters(setup));
}

TEST(DecimalOrder, IsThatOfTheValues) {
  const auto order = [](std::string_view a, std::string_view b) {
    return compare(*parse_decimal(a), *parse_decimal(b));
  };
  const std::vector<std::string_view> ascending{
      "-10",  "-2.5", "-2.499999999999999", "-0.000000000000000001", "0", "0.000000000000000001",
      "9.99", "10",   "999999999999999999"};
  for (std::size_t i = 0; i < ascending.size(); ++i)
    for (std::size_t j = 0; j < ascending.size(); ++j)
      EXPECT_TRUE(order(ascending[i], ascending[j]) == (i <=> j)) << i << ' ' << j;
  EXPECT_TRUE(order("-0", "0.00") == 0);
  EXPECT_TRUE(order("1.50", "1.5") == 0);
}

TEST(EditDistance, CountsExchangesOfNeighboursAsOne) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("19860", "19680"), 1U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("same", "same"), 0U);
}

}  // namespace
}  // namespace toolcomp::spec
