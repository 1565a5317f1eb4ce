// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/program/values.h"

#include "model/basis/number.h"

namespace toolcomp::model::klartext {
namespace {

const Rational& inches_in_a_mm() {
  static const Rational factor(5, 127);
  return factor;
}

}  // namespace

Values::Values(const spec::Setup& setup, Recorder& recorder)
    : recorder_(recorder), setup_(setup.units), program_(setup.units) {}

Values::Key Values::key(const spec::klartext::Parameter& parameter) {
  return static_cast<Key>(parameter.kind) << 16U | parameter.index;
}

Real Values::word(const spec::klartext::Value& value) const {
  if (value.parameter.kind == spec::klartext::ParameterKind::none) return plain(value.number);
  const auto found = parameters_.find(key(value.parameter));
  // heidenhain.program.parameter-value: A word may take its value from a Q, QL or QR parameter, with the sign written
  // before it. A parameter that was never assigned counts as 0.
  if (!recorder_.decide(Clause::heidenhain_program_parameter_value, found != parameters_.end())) return {};
  return value.number.negative ? -found->second : found->second;
}

void Values::assign(const spec::klartext::Parameter& target, const spec::klartext::Value& value) {
  parameters_[key(target)] = word(value);
}

Real Values::of_table(const spec::Decimal& mm) const {
  return inch() ? inches_in_a_mm() * Real(plain(mm)) : Real(plain(mm));
}

Real Values::of_setup(const spec::Decimal& length) const {
  Real value = plain(length);
  if (program_ == setup_) return value;
  return inch() ? inches_in_a_mm() * value : value / inches_in_a_mm();
}

}  // namespace toolcomp::model::klartext
