// SPDX-License-Identifier: Apache-2.0
// Groups the ways in which a bug shows: one mistake shows at several clauses and in many programs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::certify::fuzzing {

// Whether the blocks of one shape (shape.h) are in another one, in the same order, each with at least its words:
// "G44 H X" in "G43 H X|G44 H X Y|G49". An offset number (D, H) also counts as a word of the blocks after it, as in a
// control: "G44 H" in "H|G44".
bool contains(std::string_view shape, std::string_view simpler);

struct Way {
  std::string section;
  std::string shape;
  std::string core;  // dossier.h; empty: not known, and the way is a family by itself
};

// The ways of one finding, as indices in the given list. `first` is the one to examine first.
struct Family {
  std::size_t first = 0;
  std::vector<std::size_t> others;
};

// Each way is in one family: that of the smallest core of its section that its own core contains. Two ways in one
// family need not be one mistake, so search again after a fix.
std::vector<Family> families(const std::vector<Way>& ways);

}  // namespace toolcomp::certify::fuzzing
