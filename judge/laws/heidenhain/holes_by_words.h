// SPDX-License-Identifier: Apache-2.0
// Where the words of a Klartext program have its holes: positions, datum shifts and Q parameters followed from block to
// block. What the words do not say is taken from the events of moves, where they do.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "judge/laws/heidenhain/scene.h"
#include "judge/laws/hole_counts.h"

namespace toolcomp::judge::laws {

// By axis of the setup, where they are known; linear axes.
using LinearPlaces = spec::AxisValues<Real>;

// What a drilling cycle takes when it is called; nothing where no word gave it a value that can be known.
struct CycleByWords {
  std::optional<Rational> clearance;         // Q200
  std::optional<Rational> depth;             // Q201
  std::optional<Rational> surface;           // Q203
  std::optional<Rational> second_clearance;  // Q204
  std::optional<Rational> datum;             // shift of the datum along the tool axis
};

struct KlartextHole {
  std::size_t event = 0;
  const KlartextBlock* block = nullptr;
  std::size_t axis = 0;  // the tool axis
  LinearPlaces position;
  CycleByWords cycle;
  // Axes less point along the tool axis, of the last move without TCPM with the same tool and corrections.
  std::optional<Real> length;
};

// The first move behind a hole.
struct MoveBehindHole {
  std::size_t event = 0;
  std::size_t axis = 0;   // along which the hole was
  LinearPlaces position;  // as programmed
};

struct KlartextHoles {
  std::vector<KlartextHole> holes;
  std::vector<MoveBehindHole> moves;
  std::vector<HolesOfBlock> blocks;
};

// Up to M2, M30 or END PGM. Unknown are places of words under M91 and M92, behind a departure and M140, or by a
// parameter that no word gave a value; and the shift of the datum behind cycle 247 and blocks that may be PRESET
// SELECT, where there was one. Nothing for programs without a call or a hole, and where calls of programs and labels or
// repeats lead back.
KlartextHoles holes_by_words(const KlartextScene& scene);

}  // namespace toolcomp::judge::laws
