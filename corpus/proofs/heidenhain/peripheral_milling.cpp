// Lemmas about peripheral milling: end points beside the movement, and mitres.
#include "corpus/proofs/heidenhain/space.h"

namespace toolcomp::corpus {

// Blocks under RL and RR, without IS CONTOUR; and blocks with a normal at right angles to the tool.
std::vector<Lemma> peripheral_milling_lemmas(const spec::Case& c) {
  std::vector<Lemma> lemmas;
  const auto moves = space_moves(c);
  if (!moves) return lemmas;
  for (std::size_t i = 0; i < moves->size(); ++i) {
    const SpaceMove& move = (*moves)[i];
    if (move.contour) continue;
    if (auto lemma = flank_lemma(c, *moves, i)) lemmas.push_back(std::move(*lemma));
    if (move.normal && move.tool && !move.has_table && dot(*move.normal, *move.tool) == 0)
      lemmas.push_back(contact_lemma(c, move));
  }
  return lemmas;
}

}  // namespace toolcomp::corpus
