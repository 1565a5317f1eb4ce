// SPDX-License-Identifier: Apache-2.0
// What is left of a shrunk program when its numbers go: what tells two bugs apart that show at one clause.
#pragma once

#include <string>

#include "spec/language/case.h"

namespace toolcomp::certify::fuzzing {

// The blocks as codes and letters, "G43 H X|G49": sequence numbers and comments left out, letters of one kind of axis
// alike (X Y Z U V W are X, A B C are A, I J K are I), words in order and each once in a block, blocks that repeat the
// one before left out. Two minimal programs of one bug mostly differ in nothing else.
std::string shape_of(const spec::Case& c);

}  // namespace toolcomp::certify::fuzzing
