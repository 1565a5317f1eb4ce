// SPDX-License-Identifier: Apache-2.0
// A tool that leans out of a wavy ring and turns as it goes around.
#pragma once

#include <cmath>

#include "tests/bench/fanuc/rings.h"

namespace toolcomp::bench {

// A point of the ring, its height, and a tool that leans out of it by 10 to 30 degrees.
struct Place {
  std::string position;
  std::int64_t b = 0;  // thousandths of a degree
  std::int64_t c = 0;
};
inline std::vector<Place> places() {
  std::vector<Place> list;
  for (const Point p : ring(kBlocks, 60, 3, 5)) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(list.size()) / kBlocks;
    list.push_back({words(p) + " Z" + number(std::llround(4000 * std::sin(3 * angle))),
                    std::llround(20'000 + 10'000 * std::sin(2 * angle)), std::llround(40'000 * std::cos(angle))});
  }
  return list;
}

// The pose by rotary words, and the same direction by I J K.
inline std::string rotary_words(const Place& place) {
  return fmt::format(" B{} C{}", number(place.b), number(place.c));
}
inline std::string vector_words(const Place& place) {
  const double b = static_cast<double>(place.b) * std::numbers::pi / 180'000;
  const double c = static_cast<double>(place.c) * std::numbers::pi / 180'000;
  return fmt::format(" I{} J{} K1.", number(std::llround(1000 * std::tan(b) * std::cos(c))),
                     number(std::llround(1000 * std::tan(b) * std::sin(c))));
}

}  // namespace toolcomp::bench
