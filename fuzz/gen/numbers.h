// SPDX-License-Identifier: Apache-2.0
// The numbers of a case, each of which can be changed by itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "spec/language/case.h"

namespace toolcomp::fuzz {

// What is searched: beyond it lie kilometres, and digits that no control reads.
inline constexpr std::uint64_t kSearchedMagnitude = 10'000;  // magnitude, in the units of the case
inline constexpr int kSearchedDigits = 15;                   // the 16th raises PS0003

// Decimals that programs of this control have: least increments of at most a tenth of a micrometre, seven in the
// components of a direction of a Klartext program.
int usual_decimals(spec::Control control);

// A value for each of the numbers.
using Point = std::vector<spec::Decimal>;

// Of a program the numbers of coordinates, directions, radii and deltas; of a setup offsets, tools, positions, and
// parameters that are lengths or angles.
class Numbers {
 public:
  explicit Numbers(spec::Case c);

  [[nodiscard]] const Point& values() const { return values_; }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  // "X", "NX", "D1", "parameter 19631".
  [[nodiscard]] const std::string& name(std::size_t i) const { return names_[i]; }
  // The line of the program it stands in, from 1; of a number of the setup 0.
  [[nodiscard]] std::uint64_t line(std::size_t i) const { return lines_[i]; }
  // Without a point this number means something else: it stays whole.
  [[nodiscard]] bool is_whole(std::size_t i) const { return whole_[i]; }
  // The case with these values; a number that has not changed stays as it was written.
  [[nodiscard]] spec::Case with(const Point& values) const;

 private:
  void read_program();

  spec::Case case_;
  Point values_;
  std::vector<std::string> names_;
  std::vector<std::uint64_t> lines_;
  std::vector<bool> whole_;
  std::vector<std::string> text_;     // of the program: before each number, and behind the last one
  std::vector<std::string> written_;  // each number
};

// The value `steps` of 10^-decimals further (of its own last digit, where it has more decimals); nothing where that
// would be larger, or have more digits, than what is searched.
std::optional<spec::Decimal> moved(const spec::Decimal& value, std::int64_t steps, int decimals);

// The most decimals that one of the values has.
int finest(const Point& values);

// Whether program and setup are no larger than what is searched.
bool is_searched(const spec::Case& c);

}  // namespace toolcomp::fuzz
