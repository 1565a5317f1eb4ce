// SPDX-License-Identifier: Apache-2.0
// How a controller rounds the numbers that it reports.
#pragma once

#include <cmath>
#include <cstdint>

namespace toolcomp::judge {

enum class Rounding : std::uint8_t { unknown, nearest, down, toward_zero };

// The least increments of its numbers; 0: they are doubles.
struct Resolution {
  double mm = 0;
  double inch = 0;
  double degrees = 0;
  double vectors = 0;  // components of unit vectors
  Rounding rounding = Rounding::unknown;

  [[nodiscard]] bool any() const { return mm > 0 || inch > 0 || degrees > 0 || vectors > 0; }
};

// How far a number rounded to the increment r may be from `exact`, on the side of `off` (reported less exact).
inline double rounded_off(Rounding rounding, double r, double exact, double off) {
  switch (rounding) {
    case Rounding::nearest:
      return r / 2;
    case Rounding::down:
      return off < 0 ? r : 0;
    case Rounding::toward_zero:
      return off * exact < 0 ? r : 0;
    case Rounding::unknown:
      break;
  }
  return r;
}

// The distribution of rounded lengths around the exact ones, in micrometres. Correct rounding has a mean of at most
// half an increment.
struct Bias {
  std::uint64_t count = 0;
  double sum = 0;
  double worst = 0;  // the farthest one, with its sign

  void add(double off) {
    ++count;
    sum += off;
    if (std::fabs(off) > std::fabs(worst)) worst = off;
  }
  void add(const Bias& more) {
    count += more.count;
    sum += more.sum;
    if (std::fabs(more.worst) > std::fabs(worst)) worst = more.worst;
  }
  [[nodiscard]] double mean() const { return count == 0 ? 0 : sum / static_cast<double>(count); }
};

}  // namespace toolcomp::judge
