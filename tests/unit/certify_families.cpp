// SPDX-License-Identifier: Apache-2.0
// Ways a bug shows, as one finding. Expectations by hand.
#include "certify/fuzzing/families.h"

#include <gtest/gtest.h>

#include "certify/fuzzing/shape.h"

namespace toolcomp::certify::fuzzing {
namespace {

TEST(Families, AShapeContainsBlocksInTheirOrder) {
  EXPECT_TRUE(contains("G43 H X|G44 H X Y|G49", "G44 H X"));
  EXPECT_TRUE(contains("G43 H X|G44 H X Y|G49", "G43|G49"));
  EXPECT_TRUE(contains("G44", "G44"));
  EXPECT_FALSE(contains("G43 H X|G44 H X Y|G49", "G49|G43")) << "the other way round";
  EXPECT_FALSE(contains("G44 X|G44 H", "G44 H X")) << "spread over two blocks";
  EXPECT_FALSE(contains("G44 H", "G44 H|G44 H")) << "once, not twice";
  EXPECT_TRUE(contains("G10 H L P R|G44", "G44 H")) << "an offset number stays in force";
  EXPECT_FALSE(contains("G44|H", "G44 H")) << "not before its block";
  EXPECT_FALSE(contains("G4 X", "G44")) << "words, not letters";
}

TEST(Families, ShapesHaveNoNumbers) {
  spec::Case c;
  c.program = "N10 G43 H1 Z10. (up)\nN20 G44 H2 Y-3\nG44 X4 H3\nG4.0\n";
  EXPECT_EQ(shape_of(c), "G43 H X|G44 H X|G4");
}

TEST(Families, WaysWithOneCoreAreOneFinding) {
  const std::string length = "fanuc/tool-length-offset";
  const std::vector<Family> all = families({{"fanuc/tool-offset", "G45 X|G44 H", "G45 X|G44 H"},
                                            {length, "G43 H X|G44 H X", "G44 H"},
                                            {length, "G44 H X", "G44 H"},
                                            {length, "G44 H", ""},
                                            {length, "G44 H", "G44 H"},
                                            {length, "G49", "G49"},
                                            {length, "G44 H X|G49", "G44 H|G40"}});
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].first, 3U) << "a core that is not known is in nothing";
  EXPECT_TRUE(all[0].others.empty());
  EXPECT_EQ(all[1].first, 5U);
  EXPECT_TRUE(all[1].others.empty());
  EXPECT_EQ(all[2].first, 4U) << "the simplest";
  EXPECT_EQ(all[2].others, (std::vector<std::size_t>{2, 1, 6})) << "the last one contains their core";
  EXPECT_EQ(all[3].first, 0U);
  EXPECT_TRUE(all[3].others.empty()) << "another section";
}

}  // namespace
}  // namespace toolcomp::certify::fuzzing
