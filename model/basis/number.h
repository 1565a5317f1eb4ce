// SPDX-License-Identifier: Apache-2.0
// The values of the decimals of a program and of a setup.
#pragma once

#include "model/basis/recorder.h"
#include "model/exact/real.h"
#include "spec/language/decimal.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

using exact::Rational;

// The value of the decimal as it is written.
Rational plain(const spec::Decimal& value);

// A whole number of this range, both ends included.
inline bool is_whole(const Rational& number, const Rational& first, const Rational& last) {
  return denominator(number) == 1 && number >= first && number <= last;
}

// Values of program words in setup units: inch or mm input (G20, G21), and least input increments if a number is
// written without decimal point (parameter 3401#0). Clauses: fanuc.program.units, fanuc.program.least-increments.
class Numbers {
 public:
  Numbers(const spec::Setup& setup, Recorder& recorder);

  // Units of program words from here on.
  void program_units(spec::Units units) { program_ = units; }

  // Linear words (X Y Z U V W I J K R).
  [[nodiscard]] Rational length(const spec::Decimal& word) const;
  // 0 where there is no such word.
  [[nodiscard]] Rational length(const spec::Decimal* word) const { return word == nullptr ? 0 : length(*word); }
  // Rotary words (A B C): degrees.
  [[nodiscard]] Rational angle(const spec::Decimal& word) const;
  // The word of this axis.
  [[nodiscard]] Rational of_axis(char letter, const spec::Decimal& word) const {
    return spec::is_linear_axis(letter) ? length(word) : angle(word);
  }
  // F: never least increments.
  [[nodiscard]] Rational feed(const spec::Decimal& word) const;

 private:
  [[nodiscard]] Rational counted(const spec::Decimal& word, const Rational& increment) const;
  [[nodiscard]] Rational converted(const Rational& value) const;

  Recorder& recorder_;
  spec::Units setup_;
  spec::Units program_;
  bool as_written_;     // parameter 3401#0
  Rational increment_;  // least input increment, mm or degrees
};

}  // namespace toolcomp::model
