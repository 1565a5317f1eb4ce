// SPDX-License-Identifier: Apache-2.0
// States as bytes: what is the same, and what is not although its value is.
#include "spec/language/state_writer.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/exact/state.h"

namespace toolcomp {
namespace {

using exact::Rational;
using exact::Real;

template <class... Values>
std::string state_of(const Values&... values) {
  spec::StateWriter out;
  out(values...);
  return out.take();
}

TEST(StateWriter, TellsValuesApart) {
  EXPECT_EQ(state_of(std::optional<int>(1), std::vector{1, 2}), state_of(std::optional<int>(1), std::vector{1, 2}));
  EXPECT_NE(state_of(std::optional<int>(0)), state_of(std::optional<int>()));
  EXPECT_NE(state_of(std::vector{1}, std::vector{2, 3}), state_of(std::vector{1, 2}, std::vector{3}));
  EXPECT_NE(state_of(std::string("a"), std::string("bc")), state_of(std::string("ab"), std::string("c")));
  EXPECT_NE(state_of(0.0), state_of(-0.0));
}

// Two objects that are equal are not one.
TEST(StateWriter, TellsWhatIsShared) {
  const auto one = std::make_shared<int>(5);
  const auto other = std::make_shared<int>(5);
  EXPECT_NE(state_of(one, one), state_of(one, other));
  EXPECT_EQ(state_of(one, other), state_of(other, one));
}

TEST(StateWriter, WhatIsNotWrittenIsEqualToNothing) {
  const auto state = [] {
    spec::StateWriter out;
    out.incomparable();
    return out.take();
  };
  EXPECT_NE(state(), state());
}

Real diagonal(int side) { return sqrt(Real(side * side + 1)); }

TEST(StateWriter, TellsHowNumbersWereMade) {
  EXPECT_EQ(state_of(Real(Rational(2, 4))), state_of(Real(Rational(1, 2))));
  EXPECT_EQ(state_of(Real(), Real(0)), state_of(Real(0), Real()));
  EXPECT_NE(state_of(Real(1)), state_of(Real(2)));
  EXPECT_EQ(state_of(diagonal(2) + diagonal(3)), state_of(diagonal(2) + diagonal(3)));
  EXPECT_NE(state_of(diagonal(2) + diagonal(3)), state_of(diagonal(2) + diagonal(4)));
  EXPECT_NE(state_of(diagonal(2) * Real(3)), state_of(diagonal(2) + Real(3)));
  EXPECT_NE(state_of(exact::sin_degrees(Rational(7))), state_of(exact::cos_degrees(Rational(7))));
}

TEST(StateWriter, TellsWhichNumbersAreOne) {
  const Real one = diagonal(2);
  EXPECT_NE(state_of(one, one), state_of(one, diagonal(2)));
}

// Later enclosures are made of it.
TEST(StateWriter, TellsHowFarANumberIsRefined) {
  const Real plain = diagonal(2);
  const Real refined = diagonal(2);
  static_cast<void>(refined.decimal(100));
  EXPECT_NE(state_of(plain), state_of(refined));
}

}  // namespace
}  // namespace toolcomp
