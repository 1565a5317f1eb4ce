// SPDX-License-Identifier: Apache-2.0
// The error of a bundle that is not accepted.
#pragma once

#include <stdexcept>

namespace toolcomp::certify::bundle {

// what() names the file in the bundle, or the case, and the reason.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace toolcomp::certify::bundle
