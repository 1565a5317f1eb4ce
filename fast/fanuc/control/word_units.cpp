// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/control/word_units.h"

namespace toolcomp::fast {

WordUnits::WordUnits(const spec::Setup& setup)
    : inch_setup_(setup.units == spec::Units::inch),
      counts_increments_(!setup.bit(3401, 0, true)),
      increment_places_(2 + static_cast<int>(setup.increment)),
      inch_program_(inch_setup_),
      plain_(!counts_increments_) {}

void WordUnits::select(Code units) {
  inch_program_ = units == kG20;
  plain_ = !counts_increments_ && inch_program_ == inch_setup_;
}

Factor WordUnits::factor(bool inch) const {
  if (inch == inch_setup_) return Factor::one;
  return inch ? Factor::inch_to_mm : Factor::mm_to_inch;
}

Count WordUnits::converted(const spec::Decimal& word, bool linear, bool inch) const {
  int places = 0;
  if (counts_increments_ && !word.point) places = increment_places_ + (linear && inch ? 1 : 0);
  return Count::of(word, linear ? factor(inch) : Factor::one, places);
}

double WordUnits::feed(const spec::Decimal& word) const { return Count::of(word, factor(inch_program_)).nearest(); }

}  // namespace toolcomp::fast
