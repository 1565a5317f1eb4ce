// SPDX-License-Identifier: Apache-2.0
#include "model/kinematics/mechanism.h"

#include <string>

#include "model/basis/number.h"
#include "spec/language/input_error.h"

namespace toolcomp::model {
namespace {

[[noreturn]] void refuse(std::uint32_t number, const std::string& why) {
  throw spec::InputError("setup", 0, 0, "parameters." + std::to_string(number) + ": " + why);
}

// A whole number of a parameter, from `least` to `greatest`.
std::size_t whole(const spec::Setup& setup, std::uint32_t number, int least, int greatest, int otherwise = 0) {
  const Rational given = setup.parameter(number) ? plain(*setup.parameter(number)) : Rational(otherwise);
  if (denominator(given) != 1 || given < least || given > greatest)
    refuse(number, "expected a whole number from " + std::to_string(least) + " to " + std::to_string(greatest));
  return static_cast<std::size_t>(numerator(given));
}

std::size_t rotary_axis(const spec::Setup& setup, std::uint32_t number) {
  const std::size_t axis = whole(setup, number, 1, static_cast<int>(setup.axes.size()));
  if (!spec::is_rotary_axis(setup.axes.letter(axis - 1))) refuse(number, "this controlled axis is not a rotary axis");
  return axis - 1;
}

// A linear axis X, Y or Z by its controlled axis number; 0, 1, 2.
std::size_t linear_axis(const spec::Setup& setup, std::uint32_t number) {
  const std::size_t axis = whole(setup, number, 1, static_cast<int>(setup.axes.size()));
  const char letter = setup.axes.letter(axis - 1);
  if (!is_space_axis(letter)) refuse(number, "this controlled axis is not X, Y or Z");
  return space_index(letter);
}

Turn about_axis(std::size_t i) {
  Turn turn;
  turn.about = i;
  turn.line = Vector();
  component(turn.line, i) = 1;
  return turn;
}

MachineType machine_type(const spec::Setup& setup) {
  const Rational type = parameter(setup, 19680);
  if (type == 0) return MachineType::none;
  if (type == 2) return MachineType::head;
  if (type == 12) return MachineType::table;
  if (type == 21) return MachineType::mixed;
  refuse(19680, "expected 0 (none), 2 (tool rotation), 12 (table rotation) or 21 (mixed)");
}

// V = R(work-side axis) R(tool-side axis) reference direction, the table's turns taken backwards.
void read_19680(const spec::Setup& setup, Mechanism& mechanism) {
  const bool head = mechanism.type == MachineType::head;
  const bool table = mechanism.type == MachineType::table;
  const auto axis = [&setup](std::uint32_t first, int hypothetical_bit, bool of_table) {
    const std::size_t code = whole(setup, first + 1, 1, 6);
    Turn turn;
    if (code <= 3) {
      turn = about_axis(code - 1);
    } else {
      // 4: X turned toward Y by the inclination, 5: Y toward Z, 6: Z toward X.
      const Rational inclination = parameter(setup, first + 2);
      turn.about = 3;
      turn.line = Vector();
      component(turn.line, code - 4) = exact::cos_degrees(inclination);
      component(turn.line, (code - 3) % 3) = exact::sin_degrees(inclination);
    }
    if (setup.bit(19696, hypothetical_bit)) {
      if (parameter(setup, first) != 0) refuse(first, "expected 0 for a hypothetical axis");
      turn.offset = parameter(setup, first + 4);
    } else {
      turn.axis = rotary_axis(setup, first);
    }
    const bool left_handed = whole(setup, first + 3, 0, 1) == 1;
    turn.sense = left_handed != of_table ? -1 : 1;
    return turn;
  };
  const Turn first = axis(19681, 0, table);
  const Turn second = axis(19686, 1, !head);
  if (first.axis && first.axis == second.axis) refuse(19686, "both rotary axes are the same");
  // The tool-side axis is the slave of a head, the master of a table, the head's axis of a mixed machine.
  mechanism.turns = head ? std::vector{second, first} : std::vector{first, second};

  const std::size_t third = whole(setup, 19697, 1, 3, 3) - 1;
  const Vector leaning = about_axis((third + 1) % 3).apply(about_axis(third).line, parameter(setup, 19698));
  mechanism.reference = about_axis((third + 2) % 3).apply(leaning, parameter(setup, 19699));
}

// V = R2(second group) R1(first group) reference direction, each from its reference angle.
void read_19610(const spec::Setup& setup, Mechanism& mechanism) {
  const auto group = [&setup](std::uint32_t first, std::uint32_t reference_angle) {
    const std::size_t axis = rotary_axis(setup, first);
    const std::size_t one = linear_axis(setup, first + 1);
    const std::size_t two = linear_axis(setup, first + 2);
    if (one == two) refuse(first + 2, "linear axes 1 and 2 are the same");
    const bool right_handed = two == (one + 1) % 3;
    const Rational inclination = parameter(setup, first + 4);
    const bool third_given = inclination != 0 || parameter(setup, first + 3) != 0;
    if (third_given && linear_axis(setup, first + 3) != 3 - one - two)
      refuse(first + 3, "linear axes 1, 2 and 3 are not three axes");
    // Turns linear axis 1 toward linear axis 2.
    Turn turn = about_axis(3 - one - two);
    if (inclination == 0) {
      turn.sense = right_handed ? 1 : -1;
    } else {
      if (!right_handed) refuse(first + 3, "linear axes 1, 2 and 3 of an inclined rotary axis must be right-handed");
      turn.about = 3;
      component(turn.line, one) = exact::sin_degrees(inclination);
      component(turn.line, 3 - one - two) = exact::cos_degrees(inclination);
    }
    turn.axis = axis;
    turn.offset = -parameter(setup, reference_angle);
    return turn;
  };
  mechanism.turns.push_back(group(19610, 19620));
  if (parameter(setup, 19615) != 0) {
    mechanism.turns.push_back(group(19615, 19621));
    if (mechanism.turns[0].axis == mechanism.turns[1].axis) refuse(19615, "both rotary axes are the same");
  }
  const Rational ra = parameter(setup, 19622);
  const Rational rb = parameter(setup, 19623);
  const Real cos_ra = exact::cos_degrees(ra);
  mechanism.reference = {cos_ra * exact::sin_degrees(rb), -exact::sin_degrees(ra), cos_ra * exact::cos_degrees(rb)};
}

}  // namespace

Mechanism read_mechanism(const spec::Setup& setup) {
  Mechanism mechanism;
  mechanism.type = machine_type(setup);
  if (mechanism.type != MachineType::none)
    read_19680(setup, mechanism);
  else if (parameter(setup, 19610) != 0)
    read_19610(setup, mechanism);
  return mechanism;
}

Rational parameter(const spec::Setup& setup, std::uint32_t number) {
  const std::optional<spec::Decimal> given = setup.parameter(number);
  return given ? plain(*given) : Rational(0);
}

}  // namespace toolcomp::model
