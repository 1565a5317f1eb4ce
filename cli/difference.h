// SPDX-License-Identifier: Apache-2.0
// A difference, for people.
#pragma once

#include "certify/input/called_files.h"
#include "judge/oracle/verdict.h"

namespace toolcomp::cli {

// What differs at a place, the two values, and the clause in words, on standard output.
void print_difference(const judge::Difference& difference, const certify::input::Place& place);

}  // namespace toolcomp::cli
