// Lemmas about blocks under IS CONTOUR: the tip of the tool that touches the programmed point, or stands beside it.
#include "corpus/proofs/heidenhain/space.h"

namespace toolcomp::corpus {

std::vector<Lemma> programmed_contour_lemmas(const spec::Case& c) {
  std::vector<Lemma> lemmas;
  const auto moves = space_moves(c);
  if (!moves) return lemmas;
  for (std::size_t i = 0; i < moves->size(); ++i) {
    const SpaceMove& move = (*moves)[i];
    if (!move.contour) continue;
    if (move.normal && move.tool && !move.has_table) lemmas.push_back(contact_lemma(c, move));
    if (auto lemma = flank_lemma(c, *moves, i)) lemmas.push_back(std::move(*lemma));
  }
  return lemmas;
}

}  // namespace toolcomp::corpus
