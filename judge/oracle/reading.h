// SPDX-License-Identifier: Apache-2.0
// Reads the texts of a controller's events as exact rationals.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "judge/oracle/compare.h"
#include "judge/oracle/verdict.h"

namespace toolcomp::judge {

class Reading {
 public:
  // Both are kept by reference.
  Reading(const spec::Axes& axes, const Rules& rules) : axes_(axes), rules_(rules) {}

  // A text that is not a number reads as 0. bad() gives the first judged field with such a text.
  spec::Event<exact::Rational> event(const spec::TextEvent& e);
  [[nodiscard]] const std::optional<Difference>& bad() const { return bad_; }

 private:
  using TextTable = spec::AxisValues<spec::NumberText>;
  using RationalTable = spec::AxisValues<exact::Rational>;

  exact::Rational number(std::string_view field, const spec::NumberText& text);
  std::array<exact::Rational, 3> vector(std::string_view field, const std::array<spec::NumberText, 3>& from);
  void space(const spec::SpaceCompensation<spec::NumberText>& from, spec::SpaceCompensation<exact::Rational>& to);
  void table(std::string_view field, const TextTable& from, RationalTable& to);

  const spec::Axes& axes_;
  const Rules& rules_;
  std::optional<Difference> bad_;
};

}  // namespace toolcomp::judge
