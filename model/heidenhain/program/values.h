// SPDX-License-Identifier: Apache-2.0
// What the numbers of a Klartext program and of its tables are worth: Q parameters and units.
#pragma once

#include <cstdint>
#include <map>

#include "model/basis/recorder.h"
#include "model/exact/real.h"
#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/setup.h"

namespace toolcomp::model::klartext {

// Clauses: heidenhain.program.units, heidenhain.program.parameter-value.
class Values {
 public:
  Values(const spec::Setup& setup, Recorder& recorder);

  // MM or INCH of BEGIN PGM; the units of the setup before.
  void program_units(spec::Units units) { program_ = units; }
  [[nodiscard]] bool inch() const { return program_ == spec::Units::inch; }

  // A word as it stands: a literal, or the value of a parameter with its sign.
  [[nodiscard]] Real word(const spec::klartext::Value& value) const;
  void assign(const spec::klartext::Parameter& target, const spec::klartext::Value& value);

  // A length of the tool table, the compensation table or a table of deviations, in units of the program.
  [[nodiscard]] Real of_table(const spec::Decimal& mm) const;
  // A length of the setup, in units of the program.
  [[nodiscard]] Real of_setup(const spec::Decimal& length) const;

 private:
  using Key = std::uint32_t;
  static Key key(const spec::klartext::Parameter& parameter);

  Recorder& recorder_;
  spec::Units setup_;
  spec::Units program_;
  std::map<Key, Real> parameters_;
};

}  // namespace toolcomp::model::klartext
