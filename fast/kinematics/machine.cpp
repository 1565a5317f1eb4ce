// SPDX-License-Identifier: Apache-2.0
#include "fast/kinematics/machine.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "fast/kinematics/unit_angle.h"
#include "spec/language/input_error.h"

namespace toolcomp::fast {
namespace {

Count parameter(const spec::Setup& setup, std::uint32_t number) {
  const auto value = setup.parameter(number);
  if (!value) return {};
  if (!fits_count(*value))
    throw spec::InputError("setup", 0, 0, "parameters.\"" + std::to_string(number) + "\": is too large");
  return Count::of(*value);
}

DoubleDouble fine(const Count& count) {
  return to_double_double(count.units()) / DoubleDouble{static_cast<double>(Count::kRestPerOne), 0};
}

Vector3<DoubleDouble> three(const spec::Setup& setup, std::uint32_t first) {
  return {fine(parameter(setup, first)), fine(parameter(setup, first + 1)), fine(parameter(setup, first + 2))};
}

Vector3<DoubleDouble> vector(const FineVector& v) { return {v[0], v[1], v[2]}; }
Vector3<double> rounded(const Vector3<DoubleDouble>& v) { return {v.x.hi, v.y.hi, v.z.hi}; }

// Positions nearer than this are the same: 8e-18 degrees.
constexpr Int128 kSlack = 1024;
constexpr Int128 kTurn = 360 * Count::kRestPerOne;

// Whole turns that bring `value` nearest to `near`; of two equally near the one below.
Int128 turns_to(Int128 value, Int128 near) {
  const Int128 shifted = near - value + kTurn / 2;
  Int128 n = shifted / kTurn;
  if (shifted < 0 && n * kTurn != shifted) --n;
  return n;
}

}  // namespace

Machine::Machine(const spec::Setup& setup, Kinematics& kinematics) : kinematics_(kinematics), type_(kinematics.type()) {
  holder_offset_ = parameter(setup, 19666);  // counts without kinematics too
  if (type_ == 0) return;
  tool_side_ = type_ == 2 ? 1 : 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const RotaryAxis& rotary = i == tool_side_ ? kinematics.inner() : kinematics.outer();
    Axis& axis = axis_[i];
    axis.index = rotary.index;
    axis.sense = rotary.reversed ? -1 : 1;
    const bool table = type_ == 12 || (type_ == 21 && i == 1);
    axis.mechanical = table ? -axis.sense : axis.sense;
    axis.fine_line = vector(rotary.axis);
    axis.line = rounded(axis.fine_line);
    for (std::size_t j = 0; j < 3; ++j)
      if (axis.line[j] == 1 && axis.line[(j + 1) % 3] == 0 && axis.line[(j + 2) % 3] == 0) axis.along = j;
    axis.fixed = -rotary.reference;
    axis.upper = parameter(setup, i == 0 ? 19741 : 19743);
    axis.lower = parameter(setup, i == 0 ? 19742 : 19744);
    axis.least = axis.lower.nearest();
    axis.most = axis.upper.nearest();
    axis.limited = !axis.upper.is_zero() || !axis.lower.is_zero();
    if (axis.limited && axis.upper < axis.lower) ranges_valid_ = false;
  }
  polar_ = PolarFrame(kinematics.inner().axis, kinematics.outer().axis, kinematics.zero_direction());
  const bool reversed_order = setup.bit(19608, 5);
  judged_first_ = (type_ == 21) == reversed_order ? 0 : 1;
  workpiece_frame_ = setup.bit(19696, 5);
  const auto set = [](Vectors& vectors, const Vector3<DoubleDouble>& v) { vectors = {v, rounded(v)}; };
  set(table_, three(setup, 19700));
  set(second_table_, three(setup, 19703));
  set(tool_offset_, three(setup, 19709));
  set(head_offset_, three(setup, 19712));
  set(zero_, vector(kinematics.zero_direction()));
  const auto nowhere = [](const Vectors& v) { return v.rough.x == 0 && v.rough.y == 0 && v.rough.z == 0; };
  along_tool_ = type_ == 2 && nowhere(tool_offset_) && nowhere(head_offset_);
}

// v turned by the mechanical rotation of axis i.
template <class T>
[[gnu::always_inline]] inline Vector3<T> Machine::turn(std::size_t i, const Vector3<T>& v, const SineCosine<T>& by,
                                                       bool back) const {
  const Axis& axis = axis_[i];
  const bool reversed = (axis.mechanical < 0) != back;
  const T& c = by.cosine;
  const T s = reversed ? -by.sine : by.sine;
  switch (axis.along) {
    case 0:
      return {v.x, v.y * c - v.z * s, v.z * c + v.y * s};
    case 1:
      return {v.x * c + v.z * s, v.y, v.z * c - v.x * s};
    case 2:
      return {v.x * c - v.y * s, v.y * c + v.x * s, v.z};
    default:
      break;
  }
  const auto& line = [&axis]() -> const Vector3<T>& {
    if constexpr (std::is_same_v<T, double>)
      return axis.line;
    else
      return axis.fine_line;
  }();
  const Vector3<T> on_line = line * dot(line, v);
  return on_line + (v - on_line) * c + cross(line, v) * s;
}

// --- poses ---

void Machine::set_zeros(const std::array<Count, spec::kMaxAxes>& zero) {
  for (Axis& axis : axis_) {
    if (axis.index == kNone) continue;
    axis.zero = zero[axis.index];
    axis.zero_degrees = axis.zero.nearest();
  }
}

void Machine::attitude(const std::array<Count, spec::kMaxAxes>& position, std::uint16_t rounded_axes, Pose& pose) {
  for (std::size_t i = 0; i < 2; ++i) {
    RotaryPosition& rotary = pose.axis[i];
    const std::size_t index = axis_[i].index;
    rotary.count = index == kNone ? axis_[i].fixed : position[index] + axis_[i].zero;
    rotary.degrees = rotary.count.nearest();
    rotary.kind = index != kNone && (rounded_axes >> index & 1U) != 0 ? RotaryPosition::Kind::rounded
                                                                      : RotaryPosition::Kind::exact;
  }
  kinematics_.direct(position, pose.tool);
  // The angles of the direction are these positions, or their opposites.
  const SineCosine<double> inner = kinematics_.turned(0);
  const SineCosine<double> outer = kinematics_.turned(1);
  if (rounded_axes != 0) pose.tool.fine_error += 4 * RotaryPosition::kRounded;
  pose.axis[tool_side_].turn = {inner.sine * axis_[tool_side_].sense, inner.cosine};
  pose.axis[work_side()].turn = {outer.sine * axis_[work_side()].sense, outer.cosine};
  if (!frozen_) return;
  Direction& direction = pose.tool;
  if (reports_machine_directions()) {
    const Vector3<double> v =
        in_machine(Vector3<double>{direction.unit[0], direction.unit[1], direction.unit[2]}, turns(pose));
    direction.unit = {v.x, v.y, v.z};
    return;
  }
  const Kinematics::Frame& frame = kinematics_.frame();
  if (!frame.turned) return;
  const Vector3<double> v = in_frame({direction.unit[0], direction.unit[1], direction.unit[2]});
  direction.unit = {v.x, v.y, v.z};
  direction.error = 3 * direction.error + 6 * 0x1p-53;
  direction.fine_error = 3 * (direction.refined_error() + frame.fine_error);
  direction.zero = 0;
  direction.is_whole = false;
  direction.framed = true;
}

void Machine::pose(const std::array<Count, spec::kMaxAxes>& position, std::uint16_t rounded_axes, Pose& pose) {
  attitude(position, rounded_axes, pose);
  set_branch(pose);
  // c(psi) turned by the work-side axis: near a singular posture as accurate as the sines.
  const PolarFrame::Constants<double>& c = polar_.constants();
  if (polar_.invertible()) {
    SineCosine<double> psi = kinematics_.turned(0);
    if (!polar_.phase().is_zero()) {
      const Count& turned = pose.axis[tool_side_].count;
      psi = sine_cosine((axis_[tool_side_].sense < 0 ? -turned : turned) - polar_.phase());
    }
    const auto [sin_psi, cos_psi] = psi;
    const auto [sin_work, cos_work] = kinematics_.turned(1);
    const double away = cos_psi > 0 ? sin_psi * sin_psi / (1 + cos_psi) : 1 - cos_psi;
    const double toward = cos_psi < 0 ? sin_psi * sin_psi / (1 - cos_psi) : 1 + cos_psi;
    const double hx = away <= toward ? c.skew + c.sc * away : c.sum - c.sc * toward;
    const double hy = -c.sa * sin_psi;
    pose.seen = {hx * cos_work - hy * sin_work, hx * sin_work + hy * cos_work, c.cc + c.ss * cos_psi};
    pose.relative = (polar_.has_plus() && cos_psi > 0) || (polar_.has_minus() && cos_psi < 0);
  }
}

void Machine::set_branch(Pose& pose) const {
  const RotaryPosition& rotary = pose.axis[tool_side_];
  const double degrees = axis_[tool_side_].sense * rotary.degrees - polar_.phase_degrees();
  pose.psi = degrees - 360 * nearest_whole(degrees * (1.0 / 360));
  // Well above the rounding of a position. One many turns from 0 has lost the digits that psi needs.
  const double distance = std::min(std::abs(pose.psi), 180 - std::abs(pose.psi));
  constexpr double kWide = 512;
  if (distance > 1e-9 && std::abs(degrees) < kWide) {
    pose.branch = pose.psi > 0 ? 1 : -1;
    return;
  }
  const Int128 units = count(pose, tool_side_).units();
  const Int128 exact = (axis_[tool_side_].sense < 0 ? -units : units) - polar_.phase().units();
  const Int128 psi = exact - kTurn * turns_to(0, exact);
  const Int128 slack = rotary.kind == RotaryPosition::Kind::exact && polar_.phase().units() % Count::kRestPerOne == 0
                           ? Int128{0}
                           : kSlack;
  pose.psi = Count::of_units(psi).nearest();
  const Int128 magnitude = psi < 0 ? -psi : psi;
  pose.branch = magnitude <= slack || magnitude >= kTurn / 2 - slack ? 0 : (psi > 0 ? 1 : -1);
}

void Machine::set_branch(Pose& pose, int branch) const {
  set_branch(pose);
  constexpr double kRightAngle = 90;
  const bool ahead = std::abs(pose.psi) < kRightAngle;
  if (pose.branch == 0 && (ahead ? polar_.has_plus() : polar_.has_minus())) pose.branch = branch;
}

Count Machine::count(const Pose& pose, std::size_t i) const {
  const RotaryPosition& rotary = pose.axis[i];
  if (rotary.kind != RotaryPosition::Kind::inverse) return rotary.count;
  PolarRoots roots;
  (void)polar_.solve(fine_seen(pose.tool), roots);
  const Count principal = fine_pair(roots, pose.branch)[i];
  const double n = std::nearbyint((rotary.degrees - principal.nearest()) / 360);
  return Count::of_units(principal.units() + kTurn * static_cast<Int128>(n));
}

Turns<DoubleDouble> Machine::fine_turns(const Pose& pose) const {
  Turns<DoubleDouble> result;
  PolarRoots roots;
  bool solved = false;
  for (std::size_t i = 0; i < 2; ++i) {
    const RotaryPosition& rotary = pose.axis[i];
    if (rotary.kind != RotaryPosition::Kind::inverse) {
      result[i] = fine_sine_cosine(rotary.count);
      continue;
    }
    if (!solved) (void)polar_.solve(fine_seen(pose.tool), roots);
    solved = true;
    const DoubleDouble sine = pose.branch < 0 ? -roots.sin_psi : roots.sin_psi;
    result[i] = turns_of<DoubleDouble>({sine, roots.cos_psi}, roots.work[pose.branch < 0 ? 1 : 0])[i];
  }
  return result;
}

// --- the programming coordinate system ---

void Machine::freeze(Pose& pose) {
  release();
  frozen_ = true;
  if (!has_table()) return;
  if (!workpiece_frame_) {
    frozen_fine_ = fine_turns(pose);
    const auto at_zero = [](const SineCosine<DoubleDouble>& turn) { return turn.sine.hi == 0 && turn.cosine.hi == 1; };
    frozen_at_zero_ = at_zero(frozen_fine_[0]) && at_zero(frozen_fine_[1]);
    for (std::size_t i = 0; i < 2; ++i) frozen_rough_[i] = {frozen_fine_[i].sine.hi, frozen_fine_[i].cosine.hi};
    std::array<FineVector, 3> rows{};
    for (std::size_t j = 0; j < 3; ++j) {
      Vector3<DoubleDouble> unit{};
      (j == 0 ? unit.x : (j == 1 ? unit.y : unit.z)) = {1, 0};
      Vector3<DoubleDouble> column = turn(1, unit, frozen_fine_[1]);
      if (type_ == 12) column = turn(0, column, frozen_fine_[0]);
      for (std::size_t i = 0; i < 3; ++i) rows[i][j] = column[i];
    }
    const bool exact =
        pose.axis[0].kind == RotaryPosition::Kind::exact && pose.axis[1].kind == RotaryPosition::Kind::exact;
    kinematics_.set_frame(rows, exact ? 0x1p-96 : 4 * RotaryPosition::kRounded);
  }
  // The pose again, in the new system.
  std::array<Count, spec::kMaxAxes> position;
  std::uint16_t rounded_axes = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    if (axis_[i].index == kNone) continue;
    position[axis_[i].index] = programmed(pose, i);
    if (pose.axis[i].kind != RotaryPosition::Kind::exact)
      rounded_axes = static_cast<std::uint16_t>(rounded_axes | 1U << axis_[i].index);
  }
  Pose again;
  this->pose(position, rounded_axes, again);
  if (rounded_axes != 0) set_branch(again, pose.branch);
  pose = again;
}

void Machine::release() {
  frozen_ = false;
  kinematics_.clear_frame();
  frozen_rough_ = {SineCosine<double>{0, 1}, SineCosine<double>{0, 1}};
  const SineCosine<DoubleDouble> zero{{0, 0}, {1, 0}};
  frozen_fine_ = {zero, zero};
  frozen_at_zero_ = true;
}

Vector3<double> Machine::in_turned_frame(const Vector3<double>& on_table) const {
  const Kinematics::Frame& frame = kinematics_.frame();
  const auto row = [&](std::size_t i) {
    return frame.rough[i][0] * on_table.x + frame.rough[i][1] * on_table.y + frame.rough[i][2] * on_table.z;
  };
  return {row(0), row(1), row(2)};
}

FineVector Machine::fine_in_frame(const Vector3<DoubleDouble>& on_table) const {
  const Kinematics::Frame& frame = kinematics_.frame();
  if (!frame.turned) return {on_table.x, on_table.y, on_table.z};
  FineVector result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = dot(vector(frame.fine[i]), on_table);
  return result;
}

Vector3<double> Machine::tool_at(const Turns<double>& turns) const {
  const auto report = [&](const Vector3<double>& on_table) {
    return reports_machine_directions() ? in_machine(on_table, turns) : in_frame(on_table);
  };
  if (kinematics_.has_one_term()) [[likely]] {
    const auto seen = [&](std::size_t i) {
      return SineCosine<double>{turns[i].sine * axis_[i].sense, turns[i].cosine};
    };
    return report(kinematics_.one_term_direction(seen(tool_side_), seen(work_side())));
  }
  // A table turns the work, so the direction seen from it turns the other way.
  const auto turned = [&](std::size_t i, const Vector3<double>& v) {
    return turn(i, v, turns[i], axis_[i].sense != axis_[i].mechanical);
  };
  return report(turned(work_side(), turned(tool_side_, zero_.rough)));
}

Vector3<double> Machine::seen(const Direction& tool, bool& relative) const {
  Vector3<double> v{tool.unit[0], tool.unit[1], tool.unit[2]};
  const Kinematics::Frame& frame = kinematics_.frame();
  relative = polar_.along_axes() && frame.along_axes && tool.is_whole;
  if (frame.turned) {
    const auto column = [&](std::size_t j) {
      return frame.rough[0][j] * v.x + frame.rough[1][j] * v.y + frame.rough[2][j] * v.z;
    };
    v = {column(0), column(1), column(2)};
  }
  return seen_from(polar_.constants(), v);
}

Vector3<DoubleDouble> Machine::fine_seen(const Direction& tool) const {
  return seen_from(polar_.fine_constants(), vector(kinematics_.refine_on_table(tool)));
}

// --- inverse ---

bool Machine::in_limits(const Pose& pose, std::size_t i) const {
  const Axis& axis = axis_[i];
  const double lower = axis.least;
  const double upper = axis.most;
  const double value = pose.axis[i].degrees;
  const double near = 1e-9 * (1 + std::abs(value));
  if (value > lower + near && value < upper - near) return true;
  if (value < lower - near || value > upper + near) return false;
  const Int128 slack = pose.axis[i].kind == RotaryPosition::Kind::exact ? Int128{0} : kSlack;
  const Int128 units = count(pose, i).units();
  return units >= axis.lower.units() - slack && units <= axis.upper.units() + slack;
}

void Machine::set_direction(const Direction& tool, Pose& pose) const {
  pose.tool = tool;
  pose.seen = seen(tool, pose.relative);
}

void Machine::set_direction(const Direction& tool, const Vector3<DoubleDouble>& seen, Pose& pose) {
  pose.tool = tool;
  pose.seen = nearest(seen);
  // Rounded once, from an error of 2^-98.
  constexpr double kSmall = 0x1p-40;
  pose.relative = (seen.x.hi == 0 || std::abs(seen.x.hi) > kSmall) && (seen.y.hi == 0 || std::abs(seen.y.hi) > kSmall);
}

std::array<Count, 2> Machine::fine_pair(const PolarRoots& roots, int branch) const {
  const Int128 psi = fine_arctangent(roots.sin_psi, roots.cos_psi).units();
  const Int128 tool = polar_.phase().units() + (branch < 0 ? -psi : psi);
  const SineCosine<DoubleDouble>& turned = roots.work[branch < 0 ? 1 : 0];
  const Int128 work = fine_arctangent(turned.sine, turned.cosine).units();
  std::array<Count, 2> pair;
  pair[tool_side_] = Count::of_units(axis_[tool_side_].sense < 0 ? -tool : tool);
  pair[work_side()] = Count::of_units(axis_[work_side()].sense < 0 ? -work : work);
  return pair;
}

void Machine::set_rounded(Pose& pose, std::size_t i, const Count& count) const {
  RotaryPosition& rotary = pose.axis[i];
  rotary.kind = RotaryPosition::Kind::rounded;
  rotary.count = count;
  rotary.degrees = count.nearest();
  rotary.turn = sine_cosine(count);
}

namespace {

// The values that are `basic` modulo a turn and nearest to `present`, below and above, inside the range.
struct Values {
  std::array<Int128, 2> value{};
  std::size_t size = 0;
  void add(Int128 v) {
    if (size == 0 || value[0] != v) value[size++] = v;
  }
};

Values values_near(Int128 basic, Int128 present, bool limited, Int128 lower, Int128 upper) {
  Int128 low = basic + kTurn * turns_to(basic, present);
  // Of those within a rounding of the present position there is one.
  if (low > present + kSlack) low -= kTurn;
  Int128 high = low < present - kSlack ? low + kTurn : low;
  Values values;
  if (limited) {
    while (low > upper + kSlack && low >= lower - kSlack) low -= kTurn;
    while (high < lower - kSlack && high <= upper + kSlack) high += kTurn;
  }
  const auto inside = [&](Int128 v) { return !limited || (v >= lower - kSlack && v <= upper + kSlack); };
  if (inside(low)) values.add(low);
  if (inside(high)) values.add(high);
  return values;
}

Int128 magnitude(Int128 x) { return x < 0 ? -x : x; }

// The distance of a position from 0 modulo a turn.
Int128 from_zero(Int128 x) { return magnitude(x - kTurn * turns_to(0, x)); }

}  // namespace

Machine::FinePairs Machine::fine_pairs(const PolarRoots& roots, Reach reach, const std::array<Int128, 2>& from) const {
  FinePairs pairs;
  const int branches = reach == Reach::two_pairs ? 2 : 1;
  for (int b = 0; b < branches; ++b) {
    std::array<Values, 2> values;
    std::array<Count, 2> basic;
    if (reach == Reach::singular) {
      const Int128 psi = roots.cos_psi.hi > 0 ? 0 : kTurn / 2;
      const Int128 position = polar_.phase().units() + psi;
      basic[tool_side_] = Count::of_units(axis_[tool_side_].sense < 0 ? -position : position);
    } else {
      basic = fine_pair(roots, b == 0 ? 1 : -1);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const Axis& axis = axis_[i];
      const Int128 lower = axis.lower.units();
      const Int128 upper = axis.upper.units();
      if (reach == Reach::singular && i == work_side()) {
        // Any position: it stays, or goes to the nearest limit.
        Int128 stays = from[i];
        if (axis.limited && stays > upper) stays = upper;
        if (axis.limited && stays < lower) stays = lower;
        values[i].add(stays);
      } else {
        values[i] = values_near(basic[i].units(), from[i], axis.limited, lower, upper);
      }
    }
    for (std::size_t i = 0; i < values[0].size; ++i)
      for (std::size_t j = 0; j < values[1].size; ++j)
        pairs.pair[pairs.size++] = {{values[0].value[i], values[1].value[j]}, b == 0 ? 1 : -1};
  }
  return pairs;
}

bool Machine::choose_fine(const Direction& tool, const Pose& present, Pose& end) const {
  const Vector3<DoubleDouble> fine = fine_seen(tool);
  set_direction(tool, fine, end);
  PolarRoots roots;
  const Reach reach = polar_.solve(fine, roots);
  if (reach == Reach::none) return false;

  const std::array<Int128, 2> from{count(present, 0).units(), count(present, 1).units()};
  FinePairs pairs = fine_pairs(roots, reach, from);
  if (pairs.size == 0) return false;

  // Keeps the pairs with the smallest measure.
  const auto keep = [&](const auto& measure) {
    Int128 least = measure(pairs.pair[0]);
    for (std::size_t i = 1; i < pairs.size; ++i) least = std::min(least, measure(pairs.pair[i]));
    std::size_t kept = 0;
    for (std::size_t i = 0; i < pairs.size; ++i)
      if (measure(pairs.pair[i]) <= least + 2 * kSlack) pairs.pair[kept++] = pairs.pair[i];
    pairs.size = kept;
  };
  const std::size_t first = judged_first_;
  const std::array<std::size_t, 2> order{first, 1 - first};
  for (const std::size_t i : order) keep([&](const FinePair& p) { return magnitude(p.value[i] - from[i]); });
  for (const std::size_t i : order) keep([&](const FinePair& p) { return from_zero(p.value[i]); });
  for (const std::size_t i : order) keep([&](const FinePair& p) { return -p.value[i]; });
  const FinePair& chosen = pairs.pair[0];
  for (std::size_t i = 0; i < 2; ++i) {
    const bool stays = reach == Reach::singular && i == work_side() && chosen.value[i] == from[i];
    if (stays && present.axis[i].kind == RotaryPosition::Kind::exact)
      end.axis[i] = present.axis[i];
    else
      set_rounded(end, i, Count::of_units(chosen.value[i]));
  }
  if (reach == Reach::two_pairs)
    set_branch(end, chosen.branch);
  else
    set_branch(end);
  return true;
}

// --- tip and control point ---

template <class T>
const Turns<T>& Machine::frozen_turns() const {
  if constexpr (std::is_same_v<T, double>)
    return frozen_rough_;
  else
    return frozen_fine_;
}

template <class T>
Vector3<T> Machine::in_machine(const Vector3<T>& on_table, const Turns<T>& turns) const {
  if (type_ == 2) return on_table;
  const Vector3<T> second = turn(1, on_table, turns[1]);
  return type_ == 12 ? turn(0, second, turns[0]) : second;
}
template Vector3<double> Machine::in_machine(const Vector3<double>&, const Turns<double>&) const;
template Vector3<DoubleDouble> Machine::in_machine(const Vector3<DoubleDouble>&, const Turns<DoubleDouble>&) const;

// Where a point of the table stands in the machine.
template <class T>
[[gnu::always_inline]] inline Vector3<T> Machine::on_machine(const Vector3<T>& table_tip, const Turns<T>& turns,
                                                             const Vector3<T>& origin) const {
  const Turns<T>& frozen = frozen_turns<T>();
  const Vector3<T>& a = table_.get<T>();
  const Vector3<T> from_a = origin + table_tip - a;
  if (type_ == 21) return a + turn(1, frozen_at_zero_ ? from_a : turn(1, from_a, frozen[1], true), turns[1]);
  const Vector3<T>& d = second_table_.get<T>();
  const Vector3<T> q = frozen_at_zero_ ? from_a - d : turn(1, turn(0, from_a, frozen[0], true) - d, frozen[1], true);
  return a + turn(0, d + turn(1, q, turns[1]), turns[0]);
}

template <class T>
Vector3<T> Machine::from_table(const Vector3<T>& table_tip, const Turns<T>& turns, const Vector3<T>& origin) const {
  return has_table() ? on_machine(table_tip, turns, origin) - origin : table_tip;
}

template <class T>
Vector3<T> Machine::to_table(const Vector3<T>& tip, const Turns<T>& turns, const Vector3<T>& origin) const {
  if (!has_table()) return tip;
  const Turns<T>& frozen = frozen_turns<T>();
  const Vector3<T>& a = table_.get<T>();
  const Vector3<T> from_a = origin + tip - a;
  if (type_ == 21) return a + turn(1, turn(1, from_a, turns[1], true), frozen[1]) - origin;
  const Vector3<T>& d = second_table_.get<T>();
  const Vector3<T> q = turn(1, turn(0, from_a, turns[0], true) - d, turns[1], true);
  return a + turn(0, d + turn(1, q, frozen[1]), frozen[0]) - origin;
}

template <class T>
Vector3<T> Machine::control_point(const Vector3<T>& table_tip, const Turns<T>& turns, const T& length,
                                  const Vector3<T>& origin) const {
  const Vector3<T> tool = zero_.get<T>() * length;
  const Vector3<T>& de = tool_offset_.get<T>();
  if (type_ == 2) {
    const Vector3<T>& ef = head_offset_.get<T>();
    return table_tip + turn(0, turn(1, tool + de, turns[1]) + ef, turns[0]);
  }
  const Vector3<T> tip = on_machine(table_tip, turns, origin) - origin;
  if (type_ == 12) return tip + tool;
  return tip + turn(0, tool + de, turns[0]);
}

template Vector3<double> Machine::control_point(const Vector3<double>&, const Turns<double>&, const double&,
                                                const Vector3<double>&) const;
template Vector3<DoubleDouble> Machine::control_point(const Vector3<DoubleDouble>&, const Turns<DoubleDouble>&,
                                                      const DoubleDouble&, const Vector3<DoubleDouble>&) const;
template Vector3<double> Machine::to_table(const Vector3<double>&, const Turns<double>&, const Vector3<double>&) const;
template Vector3<DoubleDouble> Machine::to_table(const Vector3<DoubleDouble>&, const Turns<DoubleDouble>&,
                                                 const Vector3<DoubleDouble>&) const;
template Vector3<double> Machine::from_table(const Vector3<double>&, const Turns<double>&,
                                             const Vector3<double>&) const;
template Vector3<DoubleDouble> Machine::from_table(const Vector3<DoubleDouble>&, const Turns<DoubleDouble>&,
                                                   const Vector3<DoubleDouble>&) const;

}  // namespace toolcomp::fast
