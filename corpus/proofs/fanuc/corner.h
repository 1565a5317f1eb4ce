// What lemmas about corners read from a program: the modal state at a line, and programmed points.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>

#include "corpus/proofs/fanuc/tool.h"

namespace toolcomp::corpus {

// Codes of one side of compensation.
using SideCodes = std::initializer_list<const char*>;

// What is in force at the end of a line.
struct Modal {
  bool straight = true;  // G00, G01
  int side = 0;          // 1 left, -1 right
  Rational value;        // of the D number
};
Modal modal_at(const spec::Case& c, const Blocks& blocks, std::uint64_t line, SideCodes left, SideCodes right);

// Does a block of the program have a code that lemmas about corners know nothing of? `also`: further ones.
bool is_beyond_corners(const Blocks& blocks, std::initializer_list<const char*> also = {});

// The programmed end of a move in the first N of X, Y and Z, where it is recorded as fractions.
template <std::size_t N>
std::optional<std::array<Rational, N>> programmed_point(const spec::Case& c, const spec::TextEvent& event) {
  std::array<Rational, N> place;
  for (std::size_t i = 0; i < N; ++i) {
    const std::size_t axis = c.setup.axes.index("XYZ"[i]);
    if (axis == spec::Axes::kNone || event.kind != spec::EventKind::move || !event.programmed.has(axis))
      return std::nullopt;
    const auto value = fraction_of(event.programmed[axis]);
    if (!value) return std::nullopt;
    place[i] = *value;
  }
  return place;
}

}  // namespace toolcomp::corpus
