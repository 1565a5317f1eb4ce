// SPDX-License-Identifier: Apache-2.0
// A controller's events with their texts read as the exact rationals they are.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "fuzz/oracle/compare.h"
#include "fuzz/oracle/verdict.h"

namespace toolcomp::fuzz {

class Reading {
 public:
  // Both are kept by reference.
  Reading(const spec::Axes& axes, const Rules& rules) : axes_(axes), rules_(rules) {}

  // A text that is no number reads as 0; the field of the first such that is judged goes to bad().
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

}  // namespace toolcomp::fuzz
