// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/fanuc/commanded_direction.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "judge/laws/fanuc/machine.h"
#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {
namespace {

bool may_change_ends(const FanucScene& s, const FanucBlock& b) {
  const auto near = s.c.setup.parameter(19738);
  return b.posture && b.length == kG43_5 && near && !near->negative && !near->is_zero();
}

// A component without a point, which 3401#0 = 0 reads in least increments.
bool counts(const spec::Word& w) { return w.address >= 'I' && w.address <= 'K' && !w.value.point; }

Real number_of(const FanucBlock& b, char letter) {
  const spec::Decimal* value = b.value(letter);
  return value != nullptr ? Real(rational(*value)) : Real(0);
}

bool is_zero(const Vector& v) { return std::ranges::none_of(v, certainly_not_zero); }
Vector unit(const Vector& v) { return Real(1) / length(v) * v; }

bool is_end_of_block(const Pose& pose) {
  const spec::Cause cause = pose.event->cause;
  return !pose.is_sample() &&
         (cause == spec::Cause::programmed || cause == spec::Cause::start_up || cause == spec::Cause::cancel);
}

// Where the block of this pose began; nothing where the run begins with it.
const Pose* start_of(const Run& run, const Pose& pose) {
  for (auto i = static_cast<std::size_t>(&pose - run.poses.data()); i-- > 0;)
    if (!run.poses[i].is_sample()) return &run.poses[i];
  return nullptr;
}

// Direction of travel at the end of a block; nothing where laws do not know it.
std::optional<Vector> travel(const FanucScene& s, const Pose& start, const Pose& end) {
  const FanucBlock& b = s.program.blocks()[end.block];
  const auto from = xyz(s.c.setup.axes, start.event->programmed);
  const auto to = xyz(s.c.setup.axes, end.event->programmed);
  if (!from || !to) return std::nullopt;
  const bool arc = end.event->type == spec::MoveType::arc;
  // An arc may have lost its centre to a head, and run straight.
  if (arc != (b.motion > kG01)) return std::nullopt;
  if (!arc) return *to - *from;
  const auto& given = end.event->arc;
  if (b.compensation != kG40 || !given || given->radius || !given->sweep) return std::nullopt;
  // G45 to G48 displace both ends, and the centre with them.
  const auto tip = xyz(s.c.setup.axes, end.event->point);
  const auto first = xyz(s.c.setup.axes, start.event->point);
  if (!tip || !first) return std::nullopt;
  const Vector apart = (*tip - *to) - (*first - *from);
  if (std::ranges::any_of(apart, certainly_not_zero)) return std::nullopt;
  Vector radius;  // from the centre
  Vector normal;
  const std::size_t across = b.plane == kG19 ? 0 : b.plane == kG18 ? 1 : 2;
  normal.at(across) = 1;
  for (std::size_t i = 0; i < radius.size(); ++i)
    if (i != across) radius.at(i) = tip->at(i) - given->center[s.c.setup.axes.index("XYZ"[i])];
  Vector tangent = Real(b.motion == kG03 ? 1 : -1) * cross(normal, radius);
  const Real pitch = to->at(across) - from->at(across);
  if (!certainly_not_zero(pitch)) return tangent;
  constexpr int half_turn = 180;
  return *given->sweep * exact::pi() / Real(half_turn) * tangent + pitch * normal;
}

bool says_direction(const FanucBlock& b) { return b.has('I') || b.has('J') || b.has('K'); }

// I J K that count for this block, the latest of the mode; the tool where the mode began, if there are none. Nothing
// where they are not read.
std::optional<Vector> latest_direction(const FanucScene& s, const Run& run, std::size_t block) {
  for (std::size_t k = block + 1; k-- > run.mode.block;) {
    const FanucBlock& b = s.program.blocks()[k];
    if (!says_direction(b)) continue;
    if (!s.c.setup.bit(3401, 0, true) && std::ranges::any_of(b.words, counts)) return std::nullopt;
    return Vector{number_of(b, 'I'), number_of(b, 'J'), number_of(b, 'K')};
  }
  return run.poses.front().event->tool_axis;
}

// What a G43.5 block commands of its end.
struct Command {
  Vector given;                   // I J K, or the vector kept
  std::optional<Vector> towards;  // the travel, where Q leans the tool
  Real lean;                      // degrees
};
std::optional<Command> command(const FanucScene& s, const Run& run, const Pose& pose) {
  const FanucBlock& b = s.program.blocks()[pose.block];
  if (b.length != kG43_5 || !is_end_of_block(pose) || !pose.event->tool_axis) return std::nullopt;
  const Pose* start = start_of(run, pose);
  const Real lean = number_of(s.program.blocks()[run.mode.block], 'Q');
  const bool leans = certainly_not_zero(lean);
  if (leans && (pose.block == run.mode.block || start == nullptr)) return std::nullopt;
  std::optional<Vector> given;
  if (says_direction(b) || (leans && !may_change_ends(s, b)))
    given = latest_direction(s, run, pose.block);
  else if (!leans && start != nullptr)
    given = start->event->tool_axis;
  if (!given || is_zero(*given)) return std::nullopt;
  Command command{*given, std::nullopt, lean};
  if (!leans) return command;
  command.towards = travel(s, *start, pose);
  if (!command.towards || is_zero(cross(command.given, *command.towards))) return std::nullopt;
  return command;
}
// As a unit vector.
Vector direction_of(const Command& command) {
  Vector given = unit(command.given);
  if (!command.towards) return given;
  return turn_about(unit(cross(command.given, *command.towards)), command.lean) * given;
}

// 19738 and 19739, degrees, and whether 19741 to 19744 bound the axes.
struct Limits {
  exact::Rational near;
  exact::Rational error;
  bool ranges = false;
};
Limits limits_of(const FanucScene& s) {
  const auto number = [&](std::uint32_t parameter) {
    const auto value = s.c.setup.parameter(parameter);
    return value ? rational(*value) : exact::Rational(0);
  };
  constexpr std::array ranges{19741U, 19742U, 19743U, 19744U};
  return {number(19738), number(19739),
          std::ranges::any_of(ranges, [&](std::uint32_t parameter) { return number(parameter) != 0; })};
}

// The turn from one direction to another, the shorter way.
struct Turning {
  Vector from, to, normal;
  Turning(const Vector& start, const Vector& end) : from(start), to(end), normal(cross(start, end)) {}
};

// Positive where the turn comes nearer to `singular` than 19738, negative where it does not. fanuc.tool-posture.near.
Real nearness(const Limits& limits, const Turning& turning, const Vector& singular) {
  const Vector& normal = turning.normal;
  const Real height = dot(normal, singular);
  const Vector foot = dot(normal, normal) * singular - height * normal;
  if (!certainly_negative(dot(cross(turning.from, foot), normal)) &&
      !certainly_negative(dot(cross(foot, turning.to), normal))) {
    const Real sine = exact::sin_degrees(limits.near);
    return sine * sine * dot(normal, normal) - height * height;
  }
  const Real cosine = exact::cos_degrees(limits.near);
  const Real at_start = dot(turning.from, singular) - cosine;
  const Real at_end = dot(turning.to, singular) - cosine;
  return certainly_positive(at_start - at_end) ? at_start : at_end;
}

// The cosine of 19739; more is allowed from half a turn on, nothing below 0.
Real cosine_of_error(const Limits& limits) {
  constexpr int half_turn = 180;
  if (limits.error >= half_turn) return -1;
  return limits.error < 0 ? Real(1) : exact::cos_degrees(limits.error);
}

constexpr int kRightAngle = 90;

// Without the component along a unit vector.
Vector across(const Vector& v, const Vector& axis) { return v - dot(v, axis) * axis; }

void ask_changed(const Machine& machine, const Limits& limits, const Turning& turning, const Vector& singular,
                 const Pose& start, const Pose& end, Holding& holding) {
  const std::size_t work = machine.work_side();
  const std::size_t tool = machine.tool_side();
  const Vector& reached = *end.event->tool_axis;
  holding.zero(end.degrees.at(work) - start.degrees.at(work), end.index,
               "work-side position at a changed end, less that of the start");
  holding.zero(dot(reached - turning.to, singular), end.index,
               "lean against the singular posture at a changed end, less that of the commanded direction");
  holding.not_negative(-(machine.side(start.degrees.at(tool)) * machine.side(end.degrees.at(tool))), end.index,
                       "a changed end beyond the singular posture: product of the sides");
  holding.holds(!is_zero(turning.normal), end.index, "an end is changed only where the tool turns in a plane");
  if (limits.near < kRightAngle)
    holding.holds(!certainly_negative(nearness(limits, turning, singular)) ||
                      !certainly_negative(nearness(limits, turning, Real(-1) * singular)),
                  end.index, "an end is changed only where the tool comes near a singular posture");
  if (!machine.is_orthogonal()) return;
  const Vector commanded = across(turning.to, singular);
  holding.not_negative(dot(across(reached, singular), commanded) - cosine_of_error(limits) * dot(commanded, commanded),
                       end.index, "a changed end within 19739 of the commanded one: cosine of what 19739 leaves");
}

void ask_unchanged(const Machine& machine, const Limits& limits, const Turning& turning, const Vector& singular,
                   const Pose& end, Holding& holding) {
  if (!machine.is_orthogonal() || limits.ranges || limits.near >= kRightAngle || limits.error < 0) return;
  if (!certainly_not_zero(dot(turning.normal, singular))) return;
  // With both singular postures in reach the nearer counts: not asked.
  const Real one = nearness(limits, turning, singular);
  const Real other = nearness(limits, turning, Real(-1) * singular);
  const bool near_one = certainly_positive(one) && certainly_negative(other);
  if (!near_one && !(certainly_negative(one) && certainly_positive(other))) return;
  // Beyond the singular posture the tool would lean away from where it leant.
  const Vector started = across(turning.from, singular);
  const Vector commanded = across(turning.to, singular);
  holding.holds(
      !certainly_positive(-dot(started, commanded) - cosine_of_error(limits) * length(started) * length(commanded)),
      end.index, "an end near a singular posture is changed within 19739");
}

}  // namespace

End end_of(const FanucScene& s, const Run& run, const Pose& end) {
  if (!may_change_ends(s, s.program.blocks()[end.block])) return End::commanded;
  const auto given = command(s, run, end);
  const Pose* start = start_of(run, end);
  if (!given || start == nullptr) return End::unknown;
  if (!is_zero(*end.event->tool_axis - direction_of(*given))) return End::changed;
  // Where the tool-side axis is inclined, the changed end may have the commanded direction.
  const Machine& machine = *s.machine;
  const bool stands = !certainly_not_zero(end.degrees.at(machine.work_side()) - start->degrees.at(machine.work_side()));
  return stands && !machine.is_orthogonal() ? End::unknown : End::commanded;
}

void commanded_direction(const FanucScene& s, Holding& holding) {
  for (const Run& run : s.runs)
    for (const Pose& pose : run.poses) {
      const auto given = command(s, run, pose);
      if (!given || end_of(s, run, pose) != End::commanded) continue;
      const Vector& axis = *pose.event->tool_axis;
      if (!given->towards) {
        // As a unit vector, as end_of() compared it: a long one would show what that did not.
        const Vector commanded = unit(given->given);
        holding.zero(cross(axis, commanded), pose.index, "tool axis across the commanded direction");
        holding.not_negative(dot(axis, commanded), pose.index, "tool axis along the commanded direction");
        continue;
      }
      holding.zero(dot(axis, cross(given->given, *given->towards)), pose.index,
                   "tool axis across the plane of direction and travel");
      holding.zero(axis - direction_of(*given), pose.index, "tool axis, less the direction leant toward the travel");
    }
}

void changed_end(const FanucScene& s, Holding& holding) {
  const Limits limits = limits_of(s);
  if (limits.near <= 0) return;
  for (const Run& run : s.runs)
    for (const Pose& end : run.poses) {
      const Pose* start = start_of(run, end);
      if (start == nullptr || !start->event->tool_axis || !may_change_ends(s, s.program.blocks()[end.block])) continue;
      const auto given = command(s, run, end);
      if (!given) continue;
      const Vector singular = s.machine->table(run.mode.turns) * s.machine->singular();
      const Turning turning(*start->event->tool_axis, direction_of(*given));
      if (is_zero(*end.event->tool_axis - turning.to))
        ask_unchanged(*s.machine, limits, turning, singular, end, holding);
      else
        ask_changed(*s.machine, limits, turning, singular, *start, end, holding);
    }
}

}  // namespace toolcomp::judge::laws
