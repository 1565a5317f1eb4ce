// SPDX-License-Identifier: Apache-2.0
// Mistakes of whoever sets up a control, or writes one: the case as it runs with them. Findings of a pipe and of a
// recording are held against these.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "spec/language/case.h"

namespace toolcomp::certify {

struct Mistake {
  const char* words;  // "offsets have the other sign"
  void (*make)(spec::Case&);

  [[nodiscard]] spec::Case made_in(spec::Case c) const {
    make(c);
    return c;
  }
};
// What may be wrong in any case.
extern const std::array<Mistake, 8> kMistakes;

struct OtherCase {
  std::string cause;  // "D1 has the value of D2"
  spec::Case c;
};

// Every offset that the program calls with the value of another one, with none, with the other sign, without its wear;
// then the mistakes above, where they change this case.
std::vector<OtherCase> with_mistakes(const spec::Case& c);

// One number off by what is not known: setup units, or degrees.
struct OtherValue {
  std::string cause;  // "D1 is larger"
  bool angle = false;
  // Values this much off are tried, as multiples of how far the recording is off the path.
  double reach = 2;
  std::function<spec::Case(double)> by;
};

// Every offset that the program calls, and the lengths of the machine's geometry.
std::vector<OtherValue> other_values(const spec::Case& c);

}  // namespace toolcomp::certify
