// Which findings to look at first: one mistake shows in many programs, and the simplest of them is in most of the
// others.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::certify::fuzzing {

// Whether the blocks of one shape (shape.h) stand in another one, in their order, each with at least its words:
// "G44 H X" in "G43 H X|G44 H X Y|G49".
bool contains(std::string_view shape, std::string_view simpler);

struct Shaped {
  std::string section;
  std::string shape;  // empty: not known
};

// A finding and those whose programs contain its own, as places in the list they were given in.
struct Family {
  std::size_t simplest = 0;
  std::vector<std::size_t> others;
};

// Each finding is in one family, with the simplest of its section that is in it; the simplest ones first. That two are
// in one family does not say that they are one mistake.
std::vector<Family> families(const std::vector<Shaped>& findings);

}  // namespace toolcomp::certify::fuzzing
