// SPDX-License-Identifier: Apache-2.0
// How an arc says where its centre is.
#pragma once

#include <string_view>

#include "fuzz/gen/fanuc/contour.h"
#include "fuzz/gen/fanuc/program_writer.h"

namespace toolcomp::fuzz {

// R of an arc by radius, or its centre by two of I J K: `letters`, of the first and the second axis of its plane. A
// zero is mostly left out.
void arc_words(Choices& choose, ProgramWriter& write, const Segment& arc, std::string_view letters);

// The same where I J K are the tool's (G43.5): R, too, for an arc with a centre, of the whole count next to its radius.
void arc_words_by_radius(ProgramWriter& write, const Segment& arc);

// Of the letters of I J K those in the plane across X Y Z's component `normal`.
constexpr std::string_view center_letters(std::size_t normal) {
  constexpr std::string_view letters[] = {"JK", "KI", "IJ"};
  return letters[normal];
}

}  // namespace toolcomp::fuzz
