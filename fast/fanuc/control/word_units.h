// SPDX-License-Identifier: Apache-2.0
// What a number of the program counts in: G20 G21 and the least increments of 3401#0 (clauses fanuc.program.units,
// least-increments).
#pragma once

#include "fast/arithmetic/count.h"
#include "fast/fanuc/program/words.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

class WordUnits {
 public:
  explicit WordUnits(const spec::Setup& setup);

  void select(Code units);  // G20, G21
  [[nodiscard]] bool inch() const { return inch_program_; }
  // A word counts as written: no conversion, no least increments.
  [[nodiscard]] bool plain() const { return plain_; }

  // A word in setup units; `linear`: a length, not an angle. With `inch` as in a block that selects its own units.
  [[nodiscard]] Count value(const spec::Decimal& word, bool linear) const { return value(word, linear, inch_program_); }
  [[nodiscard]] Count value(const spec::Decimal& word, bool linear, bool inch) const {
    if (!counts_increments_ && inch == inch_setup_) [[likely]]
      return Count::of(word);
    return converted(word, linear, inch);
  }
  // A length into `to`: the usual word without a copy (read_words.h).
  void read(Count& to, const spec::Decimal& word) const;
  [[nodiscard]] double feed(const spec::Decimal& word) const;

 private:
  [[nodiscard]] Count converted(const spec::Decimal& word, bool linear, bool inch) const;
  [[nodiscard]] Factor factor(bool inch) const;

  bool inch_setup_;
  bool counts_increments_;  // 3401#0 = 0
  int increment_places_;
  bool inch_program_;
  bool plain_;
};

}  // namespace toolcomp::fast
