// SPDX-License-Identifier: Apache-2.0
// Paths of straight movements with a tool direction each, written as programs with I J K under G43.5.
#pragma once

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "tests/property/support.h"

namespace toolcomp::laws {

using Vector = std::array<std::int64_t, 3>;  // thousandths

// Blocks of a path: a movement that is not zero, and I J K or none.
struct Leg {
  Vector movement{};
  Vector tool{};
};

inline std::string decimal_of(std::int64_t thousandths) {
  const std::int64_t magnitude = thousandths < 0 ? -thousandths : thousandths;
  return fmt::format("{}{}.{:03}", thousandths < 0 ? "-" : "", magnitude / 1000, magnitude % 1000);
}

inline std::string words(const char* letters, const Vector& v) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) text += fmt::format(" {}{}", letters[i], decimal_of(v[i]));
  return text;
}

inline rc::Gen<std::int64_t> coordinate() {
  return rc::gen::weightedOneOf<std::int64_t>(
      {{2, rc::gen::just<std::int64_t>(0)},
       {5, rc::gen::map(rc::gen::inRange<std::int64_t>(-40, 41), [](std::int64_t n) { return n * 1000; })},
       {3, rc::gen::inRange<std::int64_t>(-90'000, 90'001)}});
}

inline rc::Gen<Vector> not_zero() {
  return rc::gen::suchThat(
      rc::gen::map(rc::gen::tuple(coordinate(), coordinate(), coordinate()),
                   [](const auto& t) { return Vector{std::get<0>(t), std::get<1>(t), std::get<2>(t)}; }),
      [](const Vector& v) { return v != Vector{}; });
}

// What a compensated head is away from its programmed point.
inline Real vector_of(const model::Event& e, std::size_t axis) { return e.point[axis] - e.programmed[axis]; }

inline Table identity(const spec::Axes&, const Table& t) { return t; }

}  // namespace toolcomp::laws
