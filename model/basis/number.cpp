// SPDX-License-Identifier: Apache-2.0
#include "model/basis/number.h"

#include <cstdint>
#include <numeric>

namespace toolcomp::model {
namespace {

// Of up to spec::Decimal::kMaxDigits digits.
std::uint64_t power_of_ten(unsigned exponent) {
  std::uint64_t power = 1;
  while (exponent-- != 0) power *= 10;
  return power;
}

Rational least_increment(spec::IncrementSystem system) {
  switch (system) {
    case spec::IncrementSystem::is_a:
      return {1, 100};
    case spec::IncrementSystem::is_b:
      return {1, 1000};
    case spec::IncrementSystem::is_c:
      return {1, 10000};
  }
  return {1, 1000};
}

}  // namespace

Rational plain(const spec::Decimal& value) {
  const std::uint64_t divisor = power_of_ten(value.decimals);
  const std::uint64_t common = std::gcd(value.digits, divisor);
  Rational result;
  exact::set_whole(mpq_numref(result.raw()), value.digits / common);
  exact::set_whole(mpq_denref(result.raw()), divisor / common);
  return value.negative ? -result : result;
}

Numbers::Numbers(const spec::Setup& setup, Recorder& recorder)
    : recorder_(recorder),
      setup_(setup.units),
      program_(setup.units),
      as_written_(setup.bit(3401, 0, true)),
      increment_(least_increment(setup.increment)) {}

Rational Numbers::counted(const spec::Decimal& word, const Rational& increment) const {
  const bool counts = !word.point && !as_written_;
  // fanuc.program.least-increments: With 3401#0 = 0 a number without decimal point in X Y Z A B C U V W I J K R counts
  // least input increments. The increment is 0.01 (IS-A), 0.001 (IS-B) or 0.0001 (IS-C) mm or degrees. In inch input
  // the increment of a linear word is a tenth of that number, in inches.
  return recorder_.decide(Clause::fanuc_program_least_increments, counts) ? plain(word) * increment : plain(word);
}

Rational Numbers::converted(const Rational& value) const {
  // fanuc.program.units: If the units of the program differ from those of the setup, a linear word is converted by the
  // exact factor 25.4.
  if (!recorder_.decide(Clause::fanuc_program_units, program_ != setup_)) return value;
  const Rational mm_in_an_inch(254, 10);
  return setup_ == spec::Units::mm ? value * mm_in_an_inch : value / mm_in_an_inch;
}

Rational Numbers::length(const spec::Decimal& word) const {
  return converted(counted(word, program_ == spec::Units::mm ? increment_ : increment_ / 10));
}

Rational Numbers::angle(const spec::Decimal& word) const { return counted(word, increment_); }

Rational Numbers::feed(const spec::Decimal& word) const { return converted(plain(word)); }

}  // namespace toolcomp::model
