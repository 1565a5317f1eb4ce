// A difference, for people.
#pragma once

#include <string>

#include "fuzz/oracle/verdict.h"

namespace toolcomp::cli {

// What differs in `path`, the two values, and the clause in words, on standard output.
void print_difference(const fuzz::Difference& difference, const std::string& path);

}  // namespace toolcomp::cli
