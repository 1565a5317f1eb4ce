// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/fanuc/machine.h"

#include "judge/laws/fanuc/fanuc_program.h"
#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {
namespace {

struct SineCosine {
  Real sine;
  Real cosine;
};
SineCosine of_degrees(const Real& degrees) {
  if (degrees.is_rational()) return {exact::sin_degrees(degrees.rational()), exact::cos_degrees(degrees.rational())};
  return {exact::sin_real_degrees(degrees), exact::cos_real_degrees(degrees)};
}

Vector unit(std::size_t axis) {
  Vector v;
  v.at(axis) = 1;
  return v;
}

Real number(const spec::Setup& setup, std::uint32_t parameter) {
  const auto value = setup.parameter(parameter);
  return value ? Real(rational(*value)) : Real(0);
}
Vector vector(const spec::Setup& setup, std::uint32_t first) {
  return {number(setup, first), number(setup, first + 1), number(setup, first + 2)};
}

std::uint64_t code(const spec::Setup& setup, std::uint32_t parameter) {
  const auto value = setup.parameter(parameter);
  return value && !value->negative && value->is_integer() ? value->digits : 0;
}

// 19682, 19687: X, Y, Z, or tilted from one to the next by an angle.
std::optional<Vector> direction(std::uint64_t code, const Real& inclination) {
  if (code >= 1 && code <= 3) return unit(code - 1);
  const SineCosine a = of_degrees(inclination);
  if (code == 4) return Vector{a.cosine, a.sine, 0};
  if (code == 5) return Vector{0, a.cosine, a.sine};
  if (code == 6) return Vector{a.sine, 0, a.cosine};
  return std::nullopt;
}

}  // namespace

Vector operator*(const Turn& turn, const Vector& v) { return v[0] * turn[0] + v[1] * turn[1] + v[2] * turn[2]; }
Turn operator*(const Turn& first, const Turn& second) {
  return {first * second[0], first * second[1], first * second[2]};
}
Turn inverse(const Turn& turn) {
  Turn t;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) t.at(i).at(j) = turn.at(j).at(i);
  return t;
}

Turn turn_about(const Vector& axis, const Real& degrees) {
  const SineCosine a = of_degrees(degrees);
  Turn turn;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector e = unit(i);
    turn.at(i) = a.cosine * e + a.sine * cross(axis, e) + (dot(axis, e) * (Real(1) - a.cosine)) * axis;
  }
  return turn;
}

std::optional<Machine> Machine::of(const spec::Setup& setup) {
  Machine m;
  switch (code(setup, 19680)) {
    case 2:
      m.type_ = MachineType::tool;
      break;
    case 12:
      m.type_ = MachineType::table;
      break;
    case 21:
      m.type_ = MachineType::mixed;
      break;
    default:
      return std::nullopt;
  }
  if (setup.bit(19696, 0) || setup.bit(19696, 1)) return std::nullopt;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto base = static_cast<std::uint32_t>(19681 + 5 * i);
    const std::uint64_t axis = code(setup, base);
    if (axis == 0 || axis > setup.axes.size()) return std::nullopt;
    m.axis_.at(i) = axis - 1;
    const auto u = direction(code(setup, base + 1), number(setup, base + 2));
    if (!u) return std::nullopt;
    m.direction_.at(i) = *u;
    m.sense_.at(i) = code(setup, base + 3) == 1 ? -1 : 1;
  }
  const std::uint64_t along = setup.parameter(19697) ? code(setup, 19697) : 3;
  if (along < 1 || along > 3) return std::nullopt;
  const std::size_t third = along - 1;
  m.reference_ = turn_about(unit((third + 2) % 3), number(setup, 19699)) *
                 (turn_about(unit((third + 1) % 3), number(setup, 19698)) * unit(third));
  m.table_ = vector(setup, 19700);
  m.between_ = vector(setup, 19703);
  m.tool_to_axis_ = vector(setup, 19709);
  m.axis_to_first_ = vector(setup, 19712);
  m.holder_offset_ = number(setup, 19666);
  return m;
}

bool Machine::leans_any_way() const {
  const Vector& tilting = direction_.at(tool_side());
  const Vector by_axis = cross(tilting, reference_);
  const Vector between = cross(direction_[0], direction_[1]);
  return certainly_positive(dot(by_axis, by_axis)) && certainly_positive(dot(between, between));
}

bool Machine::is_orthogonal() const {
  const Vector& tilting = direction_.at(tool_side());
  return !certainly_not_zero(dot(tilting, reference_)) && !certainly_not_zero(dot(tilting, singular()));
}

Real Machine::side(const Real& degrees) const {
  const Vector& tilting = direction_.at(tool_side());
  const int sense = sense_.at(tool_side()) * (type_ == MachineType::table ? -1 : 1);
  return dot(singular(), cross(tilting, turn_about(tilting, Real(sense) * degrees) * reference_));
}

std::array<Turn, 2> Machine::turns(const std::array<Real, 2>& degrees) const {
  return {turn_about(direction_[0], Real(sense_[0]) * degrees[0]),
          turn_about(direction_[1], Real(sense_[1]) * degrees[1])};
}

Turn Machine::table(const std::array<Turn, 2>& turns) const {
  if (type_ == MachineType::table) return turns[0] * turns[1];
  if (type_ == MachineType::mixed) return turns[1];
  return {unit(0), unit(1), unit(2)};
}

Vector Machine::tool(const std::array<Turn, 2>& turns) const {
  if (type_ == MachineType::table) return reference_;
  if (type_ == MachineType::mixed) return turns[0] * reference_;
  return turns[0] * (turns[1] * reference_);
}

Vector Machine::holder(const std::array<Turn, 2>& turns, const Real& length) const {
  Vector along = length * tool(turns);
  if (type_ == MachineType::table) return along;
  if (type_ == MachineType::mixed) return along + turns[0] * tool_to_axis_;
  return along + turns[0] * (turns[1] * tool_to_axis_) + turns[0] * axis_to_first_;
}

Vector Machine::on_table(const std::array<Turn, 2>& turns, const Vector& p) const {
  if (type_ == MachineType::table) return inverse(turns[1]) * (inverse(turns[0]) * (p - table_) - between_);
  if (type_ == MachineType::mixed) return inverse(turns[1]) * (p - table_);
  return p;
}

Vector Machine::in_machine(const std::array<Turn, 2>& turns, const Vector& q) const {
  if (type_ == MachineType::table) return table_ + turns[0] * (between_ + turns[1] * q);
  if (type_ == MachineType::mixed) return table_ + turns[1] * q;
  return q;
}

}  // namespace toolcomp::judge::laws
