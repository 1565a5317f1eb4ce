// SPDX-License-Identifier: Apache-2.0
// What pictures of a recording keep of it.
#include "certify/trace/deviations.h"

#include <gtest/gtest.h>

#include <numeric>

namespace toolcomp::certify {
namespace {

PlaceOnPath place(std::uint64_t line, double linear, double rotary = 0) {
  PlaceOnPath p;
  p.kind = SampleKind::followed;
  p.exact = AxisPoint{};
  p.line = line;
  p.distance = {linear, rotary};
  return p;
}

TEST(Deviations, SamplesByDistance) {
  Deviations d({0.01, 0.5});
  d.take({}, place(1, 0));
  d.take({}, place(1, 0.0051));      // 51 % of the tolerance: the eleventh twentieth
  d.take({}, place(1, 0.001, 0.4));  // 80 % of the rotary one
  d.take({}, place(1, 0.01));        // all of it counts to the last
  d.take({}, {});
  PlaceOnPath free;
  free.kind = SampleKind::not_judged;
  d.take({}, free);
  d.take({}, free);
  EXPECT_EQ(d.histogram()[0], 1U);
  EXPECT_EQ(d.histogram()[10], 1U);
  EXPECT_EQ(d.histogram()[16], 1U);
  EXPECT_EQ(d.histogram()[19], 1U);
  EXPECT_EQ(d.off(), 1U);
  EXPECT_EQ(d.not_judged(), 2U);
  EXPECT_EQ(std::accumulate(d.histogram().begin(), d.histogram().end(), std::uint64_t{0}), 4U);
}

TEST(Deviations, TheLargestOfEachMove) {
  Deviations d({1, 1});
  d.take({}, place(3, 0.1));
  d.take({}, place(3, 0.3, 0.2));
  d.take({}, place(5, 0.2));
  PlaceOnPath lost = place(5, 4);
  lost.kind = SampleKind::off;
  d.take({}, lost);
  ASSERT_EQ(d.moves().size(), 2U);
  EXPECT_EQ(d.moves()[0].line, 3U);
  EXPECT_EQ(d.moves()[0].largest.linear, 0.3);
  EXPECT_EQ(d.moves()[0].largest.rotary, 0.2);
  EXPECT_FALSE(d.moves()[0].off);
  EXPECT_EQ(d.moves()[1].largest.linear, 0.2);
  EXPECT_TRUE(d.moves()[1].off);
}

TEST(Deviations, LongOnesAreThinned) {
  Deviations d({1, 1});
  constexpr std::uint64_t samples = 1'000'000;
  for (std::uint64_t i = 0; i < samples; ++i)
    d.take({static_cast<double>(i)}, place(i / 100, i == 777'777 ? 0.9 : 0.1));
  EXPECT_LT(d.points().size(), Deviations::kMostPoints);
  EXPECT_GE(d.points().size(), Deviations::kMostPoints / 2);
  EXPECT_EQ(d.points().front().recorded[0], 0);
  const double step = d.points()[1].recorded[0];
  for (std::size_t i = 1; i < d.points().size(); ++i)
    EXPECT_EQ(d.points()[i].recorded[0] - d.points()[i - 1].recorded[0], step);
  EXPECT_LT(d.moves().size(), Deviations::kMostMoves);
  EXPECT_GE(d.moves().size(), Deviations::kMostMoves / 4);
  std::size_t large = 0;
  for (const Deviations::Move& move : d.moves()) large += move.largest.linear == 0.9 ? 1 : 0;
  EXPECT_EQ(large, 1U);
  EXPECT_EQ(std::accumulate(d.histogram().begin(), d.histogram().end(), std::uint64_t{0}), samples);
}

}  // namespace
}  // namespace toolcomp::certify
