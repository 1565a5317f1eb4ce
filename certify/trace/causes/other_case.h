// SPDX-License-Identifier: Apache-2.0
// Cases with one thing otherwise than stated: what whoever sets up a control gets wrong.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "spec/language/case.h"

namespace toolcomp::certify {

struct OtherCase {
  std::string cause;  // "D1 has the value of D2"
  spec::Case c;
};

// Every offset that the program calls with the value of another one, with none, with the other sign, without its wear;
// a sense of rotation reversed; a tool without its delta values.
std::vector<OtherCase> other_cases(const spec::Case& c);

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
