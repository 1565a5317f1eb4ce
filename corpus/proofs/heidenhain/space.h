// Klartext programs as the proofs read them: what is in force at each move. Independent of the engines' interpretation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corpus/proofs/numbers.h"
#include "corpus/proofs/proofs.h"

namespace toolcomp::corpus {

// A move of its own, in millimetres, and what is in force at its end.
struct SpaceMove {
  const spec::TextEvent* event = nullptr;
  Exact3 programmed;
  std::optional<Exact3> tool;    // its direction, of any length; nothing where rotary words made it
  std::optional<Exact3> normal;  // as written
  int side = 0;                  // RL 1, RR -1, R0 0
  bool tcpm = false;
  bool center = false;   // CNT-CNT
  bool contour = false;  // IS CONTOUR
  bool has_table = false;
  Rational radius, corner, dl, dr, dr2;
};

// The moves of a program in their order; nothing where it uses more than this covers: inches, parameters, datum shifts,
// blocks that cannot be read, moves that are missing.
std::optional<std::vector<SpaceMove>> space_moves(const spec::Case& c);

// What the formal files call nominal tool, deltas and reference point.
std::string tool_text(const SpaceMove& move);
std::string deltas_text(const SpaceMove& move);
std::string reference_text(const SpaceMove& move);

// That the recorded point of the move is the vector `value` of Coq: exactly in the components that are recorded as
// fractions, within their radius in the others. `computed` proves it where all lengths are rational, else intervals do.
Lemma recorded_point(const spec::Case& c, const SpaceMove& move, const std::string& value,
                     const std::optional<std::string>& computed);

// That of a block with a normal.
Lemma contact_lemma(const spec::Case& c, const SpaceMove& move);
// That of the block at `i` under RL or RR, where its directions exist.
std::optional<Lemma> flank_lemma(const spec::Case& c, const std::vector<SpaceMove>& moves, std::size_t i);

}  // namespace toolcomp::corpus
