// SPDX-License-Identifier: Apache-2.0
// The shape of a shrunk program: the program without its numbers. It distinguishes two bugs that show at one clause.
#pragma once

#include <string>

#include "spec/language/case.h"

namespace toolcomp::certify::fuzzing {

// The blocks as codes and letters, "G43 H X|G49". Sequence numbers and comments are left out. Letters of one kind of
// axis become the same (X Y Z U V W become X, A B C become A, I J K become I). Words are sorted, each once in a block.
// Blocks that repeat the block before are left out. Two minimal programs of one bug usually have the same shape.
std::string shape_of(const spec::Case& c);

}  // namespace toolcomp::certify::fuzzing
