// SPDX-License-Identifier: Apache-2.0
// Whether this build can still tell right from wrong.
#pragma once

#include <string>

namespace toolcomp::certify {

// Judges a small case whose answer is known: the model's own events must agree, and must not once one is dropped or a
// coordinate is off by a micrometre. What went wrong, or empty.
std::string self_check();

}  // namespace toolcomp::certify
