// SPDX-License-Identifier: Apache-2.0
// Mistakes that are made in setting up a control or in writing one: the case as it runs with them. Findings of a
// controller and of a recording are compared with these.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "spec/language/case.h"

namespace toolcomp::certify {

struct Mistake {
  const char* words;  // "offsets have the opposite sign"
  void (*make)(spec::Case&);

  [[nodiscard]] spec::Case made_in(spec::Case c) const {
    make(c);
    return c;
  }
};
// Mistakes that are possible in any case.
extern const std::array<Mistake, 8> kMistakes;

struct OtherCase {
  std::string cause;  // "D1 has the value of D2"
  spec::Case c;
};

// Every offset that the program calls: with the value of another offset, with 0, with the opposite sign, without its
// wear. Then the mistakes above, if they change this case.
std::vector<OtherCase> with_mistakes(const spec::Case& c);

// One number that is off by an unknown amount, in setup units or degrees.
struct OtherValue {
  std::string cause;  // "D1 is larger"
  bool angle = false;
  // Values up to this far off are tried, as a multiple of the distance of the recording from the path.
  double reach = 2;
  std::function<spec::Case(double)> by;
};

// Every offset that the program calls, and every length of the machine's geometry.
std::vector<OtherValue> other_values(const spec::Case& c);

}  // namespace toolcomp::certify
