// SPDX-License-Identifier: Apache-2.0
// Ways a bug shows, put together: one mistake shows at several clauses and in many programs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::certify::fuzzing {

// Whether the blocks of one shape (shape.h) stand in another one, in their order, each with at least its words:
// "G44 H X" in "G43 H X|G44 H X Y|G49". An offset number (D, H) is a word of the blocks after it too, as for a control:
// "G44 H" in "H|G44".
bool contains(std::string_view shape, std::string_view simpler);

struct Way {
  std::string section;
  std::string shape;
  std::string core;  // dossier.h; empty: not known, and the way is one of its own
};

// The ways of one finding, as places in the list they were given in; `first` is the one to look at.
struct Family {
  std::size_t first = 0;
  std::vector<std::size_t> others;
};

// Each way is in one family, with the least core of its section that its own contains. That two are in one family does
// not prove that they are one mistake: what is fixed has to be searched again.
std::vector<Family> families(const std::vector<Way>& ways);

}  // namespace toolcomp::certify::fuzzing
