#include "model/kinematics/tool_direction.h"

#include <algorithm>
#include <string>

#include "model/program/number.h"
#include "spec/language/input_error.h"

namespace toolcomp::model {
namespace {

[[noreturn]] void refuse(std::uint32_t parameter, const std::string& why) {
  throw spec::InputError("setup", 0, 0, "parameters." + std::to_string(parameter) + ": " + why);
}

Rational value(const spec::Setup& setup, std::uint32_t parameter, const Rational& otherwise = 0) {
  const std::optional<spec::Decimal> given = setup.parameter(parameter);
  return given ? plain(*given) : otherwise;
}

// A whole number of a parameter, from `least` to `greatest`.
std::size_t whole(const spec::Setup& setup, std::uint32_t parameter, int least, int greatest, int otherwise = 0) {
  const Rational given = value(setup, parameter, otherwise);
  if (denominator(given) != 1 || given < least || given > greatest)
    refuse(parameter,
           "a whole number from " + std::to_string(least) + " to " + std::to_string(greatest) + " must stand here");
  return static_cast<std::size_t>(numerator(given));
}

std::size_t rotary_axis(const spec::Setup& setup, std::uint32_t parameter) {
  const std::size_t number = whole(setup, parameter, 1, static_cast<int>(setup.axes.size()));
  if (!spec::is_rotary_axis(setup.axes.letter(number - 1)))
    refuse(parameter, "this controlled axis is not a rotary axis");
  return number - 1;
}

// A linear axis X, Y or Z by its controlled axis number; 0, 1, 2.
std::size_t linear_axis(const spec::Setup& setup, std::uint32_t parameter) {
  const std::size_t number = whole(setup, parameter, 1, static_cast<int>(setup.axes.size()));
  const char letter = setup.axes.letter(number - 1);
  if (!is_space_axis(letter)) refuse(parameter, "this controlled axis is not X, Y or Z");
  return space_index(letter);
}

Vector coordinate_axis(std::size_t i) {
  Vector e;
  component(e, i) = 1;
  return e;
}

// Rotation about coordinate axis `about` by an angle of this cosine and sine.
Vector turned(const Vector& v, std::size_t about, const Real& cosine, const Real& sine) {
  const std::size_t j = (about + 1) % 3;
  const std::size_t k = (about + 2) % 3;
  Vector result = v;
  component(result, j) = cosine * component(v, j) - sine * component(v, k);
  component(result, k) = sine * component(v, j) + cosine * component(v, k);
  return result;
}
Vector turned(const Vector& v, std::size_t about, const Rational& degrees) {
  return turned(v, about, exact::cos_degrees(degrees), exact::sin_degrees(degrees));
}

}  // namespace

Direction Direction::of(const Vector& vector) {
  const Real norm2 = squared_norm(vector);
  return {vector, norm2, vector / sqrt(norm2), true};
}

Kinematics::Kinematics(const spec::Setup& setup) {
  const Rational type = value(setup, 19680);
  if (type != 0 && type != 2 && type != 12 && type != 21)
    refuse(19680, "0 (none), 2 (tool rotation), 12 (table rotation) or 21 (mixed) must stand here");
  tip_control_built_ = type == 0 || type == 2;
  for (const std::uint32_t offset : {19666U, 19709U, 19710U, 19711U, 19712U, 19713U, 19714U})
    if (value(setup, offset) != 0) tip_control_built_ = false;
  if (type != 0)
    read_19680(setup);
  else if (value(setup, 19610) != 0)
    read_19610(setup);
}

// V = R(work-side axis) · R(tool-side axis) · reference direction, the table's turns taken backwards.
void Kinematics::read_19680(const spec::Setup& setup) {
  const bool head = value(setup, 19680) == 2;
  const bool table = value(setup, 19680) == 12;
  const auto axis = [&setup, head](std::uint32_t first, int hypothetical_bit, bool of_table) {
    Turn turn;
    if (setup.bit(19696, hypothetical_bit)) {
      if (head) refuse(first, "a tool rotation head with a hypothetical axis is not supported");
      if (value(setup, first) != 0) refuse(first, "0 must stand here for a hypothetical axis");
      turn.offset = value(setup, first + 4);
    } else {
      turn.axis = rotary_axis(setup, first);
    }
    const std::size_t code = whole(setup, first + 1, 1, 6);
    const bool left_handed = whole(setup, first + 3, 0, 1) == 1;
    turn.sense = left_handed != of_table ? -1 : 1;
    turn.about = code <= 3 ? code - 1 : 3;
    if (code > 3) {
      // 4: X turned toward Y by the inclination, 5: Y toward Z, 6: Z toward X.
      const Rational inclination = value(setup, first + 2);
      component(turn.line, code - 4) = exact::cos_degrees(inclination);
      component(turn.line, (code - 3) % 3) = exact::sin_degrees(inclination);
    }
    return turn;
  };
  const Turn first = axis(19681, 0, table);
  const Turn second = axis(19686, 1, !head);
  if (first.axis && first.axis == second.axis) refuse(19686, "both rotary axes are the same");
  // The tool-side axis is the slave of a head, the master of a table, the head's axis of a mixed machine.
  turns_ = head ? std::vector{second, first} : std::vector{first, second};

  const std::size_t third = whole(setup, 19697, 1, 3, 3) - 1;
  const Vector leaning = turned(coordinate_axis(third), (third + 1) % 3, value(setup, 19698));
  reference_ = turned(leaning, (third + 2) % 3, value(setup, 19699));
}

// V = R2(second group) · R1(first group) · reference direction, each from its reference angle.
void Kinematics::read_19610(const spec::Setup& setup) {
  const auto group = [&setup](std::uint32_t first, std::uint32_t reference_angle) {
    Turn turn;
    turn.axis = rotary_axis(setup, first);
    turn.offset = -value(setup, reference_angle);
    const std::size_t one = linear_axis(setup, first + 1);
    const std::size_t two = linear_axis(setup, first + 2);
    if (one == two) refuse(first + 2, "linear axes 1 and 2 are the same");
    const bool right_handed = two == (one + 1) % 3;
    const Rational inclination = value(setup, first + 4);
    const bool third_given = inclination != 0 || value(setup, first + 3) != 0;
    if (third_given && linear_axis(setup, first + 3) != 3 - one - two)
      refuse(first + 3, "linear axes 1, 2 and 3 are not three axes");
    if (inclination == 0) {
      // Turns linear axis 1 toward linear axis 2.
      turn.about = 3 - one - two;
      turn.sense = right_handed ? 1 : -1;
      return turn;
    }
    if (!right_handed) refuse(first + 3, "linear axes 1, 2 and 3 of an inclined rotary axis must be right-handed");
    turn.about = 3;
    component(turn.line, one) = exact::sin_degrees(inclination);
    component(turn.line, 3 - one - two) = exact::cos_degrees(inclination);
    return turn;
  };
  turns_.push_back(group(19610, 19620));
  if (value(setup, 19615) != 0) {
    turns_.push_back(group(19615, 19621));
    if (turns_[0].axis == turns_[1].axis) refuse(19615, "both rotary axes are the same");
  }
  const Rational ra = value(setup, 19622);
  const Rational rb = value(setup, 19623);
  const Real cos_ra = exact::cos_degrees(ra);
  reference_ = {cos_ra * exact::sin_degrees(rb), -exact::sin_degrees(ra), cos_ra * exact::cos_degrees(rb)};
}

bool Kinematics::turns(std::size_t axis) const {
  return std::ranges::any_of(turns_, [axis](const Turn& turn) { return turn.axis == axis; });
}

Vector Kinematics::Turn::apply(const Vector& v, const Position& position) const {
  // A rotary position is rational: only lengths can have an irrational rest.
  const Rational at = (axis ? position.at(*axis).value().rational() : Rational(0)) + offset;
  const Rational degrees = sense * at;
  const Real cosine = exact::cos_degrees(degrees);
  const Real sine = exact::sin_degrees(degrees);
  if (about < 3) return turned(v, about, cosine, sine);
  return cosine * v + sine * cross(line, v) + (dot(line, v) * (1 - cosine)) * line;
}

Direction Kinematics::direction(const Position& position) const {
  Direction result;
  if (!present()) return result;
  result.vector = reference_;
  for (const Turn& turn : turns_) result.vector = turn.apply(result.vector, position);
  result.unit = result.vector;  // turns keep its length 1
  result.reported = true;
  return result;
}

}  // namespace toolcomp::model
