// SPDX-License-Identifier: Apache-2.0
// Checks whether this build still tells right answers from wrong ones.
#pragma once

#include <string>

namespace toolcomp::certify {

// Judges a small case whose answer is known: the model's own events must agree, and must not agree after one is dropped
// or a coordinate is off by a micrometre. Returns what went wrong, or an empty text.
std::string self_check();

}  // namespace toolcomp::certify
