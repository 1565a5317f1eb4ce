// SPDX-License-Identifier: Apache-2.0
// The search for the place where a quantity is zero, or as near to it as decimals allow.
#pragma once

#include <functional>
#include <optional>

#include "fuzz/gen/choices.h"
#include "fuzz/gen/numbers.h"

namespace toolcomp::corpus {

// A signed quantity at a point; nothing where it is not defined. It sees every point that is tried: who searches keeps
// what is worth keeping there.
using Quantity = std::function<std::optional<double>(const fuzz::Point&)>;

struct ApproachOptions {
  int decimals = 0;            // first with so many, then with all digits a number may have
  std::function<bool()> stop;  // comes to an end
};

// Follows `quantity` from the values of `numbers` to where it is zero. First along one number, by secants and, between
// two signs, by halves, down to neighbouring decimals. Then a second number is varied along: by how much the first must
// follow is a smooth function of it, of which three values are measured; where that function comes nearest to a whole
// number of steps, among as many as a hundred thousand, quantity is tried again. All that with several pairs of
// numbers, chosen by `choose`.
void approach(const fuzz::Numbers& numbers, const Quantity& quantity, fuzz::Choices& choose,
              const ApproachOptions& options);

// Climbs from the values of `numbers`: changes one number at a time, by steps of any size, and keeps a change after
// which `height` is no smaller. Ends after `patience` changes in a row that did not raise it. The highest point.
fuzz::Point climb(const fuzz::Numbers& numbers, const Quantity& height, fuzz::Choices& choose,
                  const ApproachOptions& options, int patience);

}  // namespace toolcomp::corpus
