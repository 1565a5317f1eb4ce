// SPDX-License-Identifier: Apache-2.0
// Where the words of a FANUC program have its holes: positions followed from block to block, through moves and holes.
// Every event that says where the axes stand is a new beginning, so what is wrong is wrong once.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "judge/laws/fanuc/scene.h"
#include "judge/laws/hole_counts.h"

namespace toolcomp::judge::laws {

// By axis of the setup, where they are known.
using Places = spec::AxisValues<Real>;

// A hole in a block of which it is clear that it drills.
struct HoleByWords {
  std::size_t event = 0;
  std::size_t block = 0;
  Places position;     // as commanded: all axes but the drilling axis
  Places shift;        // of G45 to G48, as it stands: linear axes
  bool shifts = true;  // whether it is known
  // Where the drilling axis stood when the mode began, before a shift.
  std::optional<Real> initial_level;
};

// The end of a move behind a hole.
struct EndByWords {
  std::size_t event = 0;
  Places position;  // as commanded
};

struct HolesByWords {
  std::vector<HoleByWords> holes;
  std::vector<EndByWords> ends;
  std::vector<HolesOfBlock> blocks;
};

// Up to M02, M30 or an event that belongs to no block. Unknown are all places behind a block that goes elsewhere or
// names a place (G28 to G30, G37, G39, G52, G53, G92), or may rename coordinates, until a word or an event says them
// again, and those of lines with more than one block. Nothing for programs with G43.4 or G43.5.
HolesByWords holes_by_words(const FanucScene& scene);

}  // namespace toolcomp::judge::laws
