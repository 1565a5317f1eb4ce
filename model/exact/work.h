// SPDX-License-Identifier: Apache-2.0
// The work a decision may cost, counted in operations so that the outcome is the same on every machine and run.
#pragma once

#include <cstdint>

namespace toolcomp::exact {

/// Thrown inside this folder when a decision has used up its work; never leaves it.
struct OutOfWork {};

/// A budget of work. One unit is about 50 ns on a machine of 2024: one operation on 128-bit enclosures.
class Work {
 public:
  explicit Work(std::int64_t units) : left_(units) {}

  /// Takes `units` from the budget; throws OutOfWork if they are not left.
  void spend(std::int64_t units) {
    left_ -= units;
    if (left_ < 0) throw OutOfWork{};
  }

 private:
  std::int64_t left_;
};

}  // namespace toolcomp::exact
