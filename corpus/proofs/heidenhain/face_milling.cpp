// Lemmas about contacts of face milling: where the tip of the effective tool is.
#include "corpus/proofs/heidenhain/space.h"

namespace toolcomp::corpus {

// Blocks with a normal, without IS CONTOUR and without a table of deviations.
std::vector<Lemma> face_milling_lemmas(const spec::Case& c) {
  std::vector<Lemma> lemmas;
  const auto moves = space_moves(c);
  if (!moves) return lemmas;
  for (const SpaceMove& move : *moves)
    if (move.normal && move.tool && !move.contour && !move.has_table) lemmas.push_back(contact_lemma(c, move));
  return lemmas;
}

}  // namespace toolcomp::corpus
