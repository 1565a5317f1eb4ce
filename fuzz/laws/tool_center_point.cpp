#include "fuzz/laws/tool_center_point.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "fuzz/laws/machine.h"

namespace toolcomp::fuzz::laws {
namespace {

constexpr int kByPositions = 434;
constexpr int kByDirection = 435;

bool frame_is_workpiece(const Scene& s) { return s.c.setup.bit(19696, 5); }

// Tip in the coordinates of the table at its zero pose.
std::optional<Vector> tip_on_table(const Machine& machine, const Run& run, const Pose& pose) {
  if (!run.mode.length) return std::nullopt;
  return machine.on_table(pose.turns, pose.control_point - machine.holder(pose.turns, *run.mode.length));
}

bool is_sample(const Pose& pose) { return pose.event->kind == spec::EventKind::sample; }

// The samples of one block with the moves before and after them.
struct Block {
  const Pose* start = nullptr;
  std::span<const Pose> samples;
  const Pose* end = nullptr;
};
std::vector<Block> sampled_blocks(const Run& run) {
  std::vector<Block> blocks;
  for (std::size_t i = 1; i < run.poses.size(); ++i) {
    if (!is_sample(run.poses[i]) || is_sample(run.poses[i - 1])) continue;
    std::size_t end = i;
    while (end < run.poses.size() && is_sample(run.poses[end])) ++end;
    if (end == run.poses.size()) break;
    const bool one = std::all_of(run.poses.begin() + static_cast<std::ptrdiff_t>(i),
                                 run.poses.begin() + static_cast<std::ptrdiff_t>(end),
                                 [&](const Pose& p) { return p.block == run.poses[end].block; });
    if (one) blocks.push_back({&run.poses[i - 1], {&run.poses[i], end - i}, &run.poses[end]});
  }
  return blocks;
}

Real fraction(const Pose& pose) { return Real(exact::Rational(pose.event->t_numerator, pose.event->t_denominator)); }

bool has_warning(const Scene& s, std::uint64_t line) {
  return std::ranges::any_of(
      s.events, [line](const model::Event& e) { return e.kind == spec::EventKind::warning && e.line == line; });
}

bool may_change_ends(const Scene& s, const FanucBlock& b) {
  const auto near = s.c.setup.parameter(19738);
  return b.posture && b.length == kByDirection && near && !near->negative && !near->is_zero();
}

template <class Ask>
void in_each_run(const Scene& s, const Ask& ask) {
  for (const Run& run : s.runs) ask(*s.machine, run);
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
  return !is_sample(pose) &&
         (cause == spec::Cause::programmed || cause == spec::Cause::start_up || cause == spec::Cause::cancel);
}

// Where the block of pose i began; nothing where the run begins with it.
const Pose* start_of(const Run& run, std::size_t i) {
  while (i-- > 0)
    if (!is_sample(run.poses[i])) return &run.poses[i];
  return nullptr;
}

// Direction of travel at the end of a block; nothing where laws do not know it.
std::optional<Vector> travel(const Scene& s, const Pose& start, const Pose& end) {
  const FanucBlock& b = s.program.blocks()[end.block];
  const auto from = xyz(s.c.setup.axes, start.event->programmed);
  const auto to = xyz(s.c.setup.axes, end.event->programmed);
  if (!from || !to) return std::nullopt;
  const bool arc = end.event->type == spec::MoveType::arc;
  // An arc may have lost its centre to a head, and run straight.
  if (arc != (b.motion > 10)) return std::nullopt;
  if (!arc) return *to - *from;
  const auto& given = end.event->arc;
  if (b.compensation != 400 || !given || given->radius || !given->sweep) return std::nullopt;
  Vector radius;  // from the centre
  Vector normal;
  const std::size_t across = b.plane == 190 ? 0 : b.plane == 180 ? 1 : 2;
  normal.at(across) = 1;
  for (std::size_t i = 0; i < radius.size(); ++i)
    if (i != across) radius.at(i) = to->at(i) - given->center[s.c.setup.axes.index("XYZ"[i])];
  const Vector tangent = Real(b.motion == 30 ? 1 : -1) * cross(normal, radius);
  const Real pitch = to->at(across) - from->at(across);
  if (!certainly_not_zero(pitch)) return tangent;
  constexpr int half_turn = 180;
  return *given->sweep * exact::pi() / Real(half_turn) * tangent + pitch * normal;
}

bool says_direction(const FanucBlock& b) { return b.has('I') || b.has('J') || b.has('K'); }

// I J K that count for this block, the latest of the mode; the tool where the mode began, if there are none. Nothing
// where they are not read.
std::optional<Vector> latest_direction(const Scene& s, const Run& run, std::size_t block) {
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
std::optional<Command> command(const Scene& s, const Run& run, std::size_t i) {
  const Pose& pose = run.poses[i];
  const FanucBlock& b = s.program.blocks()[pose.block];
  if (b.length != kByDirection || !is_end_of_block(pose) || !pose.event->tool_axis) return std::nullopt;
  const Pose* start = start_of(run, i);
  const Real lean = number_of(s.program.blocks()[run.mode.block], 'Q');
  const bool leans = certainly_not_zero(lean);
  if (leans && (pose.block == run.mode.block || start == nullptr)) return std::nullopt;
  std::optional<Vector> given;
  if (says_direction(b) || (leans && !may_change_ends(s, b)))
    given = latest_direction(s, run, pose.block);
  else if (!leans && start != nullptr)
    given = start->event->tool_axis;
  if (!given) return std::nullopt;
  Command command{*given, std::nullopt, lean};
  if (!leans) return command;
  command.towards = travel(s, *start, pose);
  if (!command.towards || is_zero(cross(command.given, *command.towards))) return std::nullopt;
  return command;
}
// As a unit vector.
Vector direction_of(const Command& command) {
  const Vector given = unit(command.given);
  if (!command.towards) return given;
  return turn_about(unit(cross(command.given, *command.towards)), command.lean) * given;
}

// The end of a P1 block with 19738 > 0 may be another than the commanded one.
enum class End : std::uint8_t { commanded, changed, unknown };
End end_of(const Scene& s, const Run& run, std::size_t i) {
  const Pose& pose = run.poses[i];
  if (!may_change_ends(s, s.program.blocks()[pose.block])) return End::commanded;
  const auto given = command(s, run, i);
  if (!given) return End::unknown;
  return is_zero(*pose.event->tool_axis - direction_of(*given)) ? End::commanded : End::changed;
}
End end_of(const Scene& s, const Run& run, const Pose& end) {
  return end_of(s, run, static_cast<std::size_t>(&end - run.poses.data()));
}

// The turn from one direction to another, and how near it comes to a third.
struct Arc {
  Vector from, to, normal;
};
// Positive where the arc comes nearer to `singular` than the angle of this sine and cosine, negative where it does not.
Real nearness(const Arc& arc, const Vector& singular, const Real& sine, const Real& cosine) {
  const Real height = dot(arc.normal, singular);
  const Vector foot = dot(arc.normal, arc.normal) * singular - height * arc.normal;
  if (!certainly_negative(dot(cross(arc.from, foot), arc.normal)) &&
      !certainly_negative(dot(cross(foot, arc.to), arc.normal)))
    return sine * sine * dot(arc.normal, arc.normal) - height * height;
  const Real at_start = dot(arc.from, singular) - cosine;
  const Real at_end = dot(arc.to, singular) - cosine;
  return certainly_positive(at_start - at_end) ? at_start : at_end;
}

// Without the component along a unit vector.
Vector across(const Vector& v, const Vector& axis) { return v - dot(v, axis) * axis; }

}  // namespace

void axis_of_the_positions(const Scene& s, Holding& holding) {
  in_each_run(s, [&](const Machine& machine, const Run& run) {
    const Turn begun = machine.table(run.mode.turns);
    for (const Pose& pose : run.poses) {
      if (!pose.event->tool_axis) continue;
      const Vector in_machine = machine.tool(pose.turns);
      const Vector expected =
          frame_is_workpiece(s) ? in_machine : begun * (inverse(machine.table(pose.turns)) * in_machine);
      holding.zero(*pose.event->tool_axis - expected, pose.index, "tool axis, less that of the rotary positions");
    }
  });
}

void tip_of_the_axes(const Scene& s, Holding& holding) {
  in_each_run(s, [&](const Machine& machine, const Run& run) {
    for (std::size_t i = 0; i < run.poses.size(); ++i) {
      const Pose& pose = run.poses[i];
      const auto q = tip_on_table(machine, run, pose);
      const auto point = xyz(s.c.setup.axes, pose.event->point);
      if (!q || !point) continue;
      const auto& turns = frame_is_workpiece(s) ? pose.turns : run.mode.turns;
      holding.zero(machine.in_machine(turns, *q) - run.mode.origin - *point, pose.index,
                   "tip that belongs to the axes, less the point");
    }
  });
}

void tip_on_the_path(const Scene& s, Holding& holding) {
  in_each_run(s, [&](const Machine& machine, const Run& run) {
    for (const Block& block : sampled_blocks(run)) {
      const auto at = [&](const Pose& pose) -> std::optional<Vector> {
        if (!frame_is_workpiece(s)) return xyz(s.c.setup.axes, pose.event->point);
        return tip_on_table(machine, run, pose);
      };
      const bool arc = block.end->event->type == spec::MoveType::arc;
      if (arc && (frame_is_workpiece(s) || !block.end->event->arc || block.end->event->arc->radius)) continue;
      const auto from = at(*block.start);
      const auto to = at(*block.end);
      if (!from || !to) continue;
      if (!arc) {
        for (const Pose& sample : block.samples)
          if (const auto p = at(sample))
            holding.zero(*p - *from - fraction(sample) * (*to - *from), sample.index,
                         "tip, less its place on the line");
        continue;
      }
      if (block.samples.size() + 1 != block.samples.front().event->t_denominator) continue;
      std::optional<Real> chord;
      Vector before = *from;
      for (std::size_t k = 0; k <= block.samples.size(); ++k) {
        const Pose& pose = k < block.samples.size() ? block.samples[k] : *block.end;
        const auto p = at(pose);
        if (!p) break;
        const Vector step = *p - before;
        const Real square = dot(step, step);
        if (chord) holding.zero(square - *chord, pose.index, "square of a chord of the arc, less that of the first");
        if (!chord) chord = square;
        before = *p;
      }
    }
  });
}

void commanded_direction(const Scene& s, Holding& holding) {
  in_each_run(s, [&](const Machine&, const Run& run) {
    for (std::size_t i = 0; i < run.poses.size(); ++i) {
      const auto given = command(s, run, i);
      if (!given || end_of(s, run, i) != End::commanded) continue;
      const Pose& pose = run.poses[i];
      const Vector& axis = *pose.event->tool_axis;
      if (!given->towards) {
        holding.zero(cross(axis, given->given), pose.index, "tool axis across the commanded direction");
        holding.not_negative(dot(axis, given->given), pose.index, "tool axis along the commanded direction");
        continue;
      }
      holding.zero(dot(axis, cross(given->given, *given->towards)), pose.index,
                   "tool axis across the plane of direction and travel");
      holding.zero(axis - direction_of(*given), pose.index, "tool axis, less the direction leant toward the travel");
    }
  });
}

void changed_end(const Scene& s, Holding& holding) {
  const auto near = s.c.setup.parameter(19738);
  const auto far = s.c.setup.parameter(19739);
  constexpr int right_angle = 90;
  constexpr int half_turn = 180;
  if (!near || rational(*near) <= 0) return;
  const exact::Rational range = rational(*near);
  const exact::Rational error = far ? rational(*far) : exact::Rational(0);
  const bool has_ranges = std::ranges::any_of(std::array{19741U, 19742U, 19743U, 19744U}, [&](std::uint32_t n) {
    const auto limit = s.c.setup.parameter(n);
    return limit && !limit->is_zero();
  });
  in_each_run(s, [&](const Machine& machine, const Run& run) {
    const Vector singular = machine.table(run.mode.turns) * machine.singular();
    for (std::size_t i = 0; i < run.poses.size(); ++i) {
      const Pose& end = run.poses[i];
      const Pose* start = start_of(run, i);
      if (start == nullptr || !start->event->tool_axis || !may_change_ends(s, s.program.blocks()[end.block])) continue;
      const auto given = command(s, run, i);
      if (!given) continue;
      const Vector commanded = direction_of(*given);
      const Vector& reached = *end.event->tool_axis;
      const bool changed = !is_zero(reached - commanded);
      const Arc arc{*start->event->tool_axis, commanded, cross(*start->event->tool_axis, commanded)};
      bool is_near = false;
      bool is_far = is_zero(arc.normal);
      if (!is_far && range < right_angle) {
        const Real sine = exact::sin_degrees(range);
        const Real cosine = exact::cos_degrees(range);
        const Real one = nearness(arc, singular, sine, cosine);
        const Real other = nearness(arc, Real(-1) * singular, sine, cosine);
        is_far = certainly_negative(one) && certainly_negative(other);
        // With both in reach the nearer counts: not asked.
        is_near = (certainly_positive(one) && certainly_negative(other)) ||
                  (certainly_negative(one) && certainly_positive(other));
      }
      const Vector aside = across(commanded, singular);
      const Real cosine = error < half_turn ? exact::cos_degrees(error < 0 ? exact::Rational(0) : error) : Real(-1);
      if (changed) {
        const std::size_t work = machine.work_side();
        const std::size_t tool = machine.tool_side();
        holding.zero(end.degrees.at(work) - start->degrees.at(work), end.index,
                     "work-side position at a changed end, less that of the start");
        holding.zero(dot(reached, singular) - dot(commanded, singular), end.index,
                     "lean against the singular posture at a changed end, less that of the commanded direction");
        holding.not_negative(-(machine.side(start->degrees.at(tool)) * machine.side(end.degrees.at(tool))), end.index,
                             "a changed end beyond the singular posture: product of the sides");
        holding.holds(!is_far, end.index, "an end is changed only where the tool comes near a singular posture");
        if (machine.is_orthogonal())
          holding.not_negative(dot(across(reached, singular), aside) - cosine * dot(aside, aside), end.index,
                               "a changed end within 19739 of the commanded one: cosine of what 19739 leaves");
      } else if (machine.is_orthogonal() && !has_ranges && is_near && error >= 0 &&
                 certainly_not_zero(dot(arc.normal, singular))) {
        // From behind the singular posture the work-side axis would turn by all but half a turn.
        const Vector behind = across(arc.from, singular);
        holding.holds(!certainly_positive(-dot(behind, aside) - cosine * length(behind) * length(aside)), end.index,
                      "an end near a singular posture is changed within 19739");
      }
    }
  });
}

void great_circle(const Scene& s, Holding& holding) {
  if (frame_is_workpiece(s)) return;
  in_each_run(s, [&](const Machine& machine, const Run& run) {
    if (!machine.leans_any_way()) return;
    for (const Block& block : sampled_blocks(run)) {
      const FanucBlock& b = s.program.blocks()[block.end->block];
      if (!b.posture || has_warning(s, b.line) || end_of(s, run, *block.end) != End::commanded) continue;
      if (!block.start->event->tool_axis || !block.end->event->tool_axis) continue;
      const Vector& from = *block.start->event->tool_axis;
      const Vector& to = *block.end->event->tool_axis;
      const Vector normal = cross(from, to);
      if (!std::ranges::any_of(normal, certainly_not_zero)) continue;
      const bool whole = block.samples.size() + 1 == block.samples.front().event->t_denominator;
      std::optional<Real> step;
      const Vector* before = &from;
      for (std::size_t k = 0; k <= block.samples.size(); ++k) {
        const Pose& pose = k < block.samples.size() ? block.samples[k] : *block.end;
        if (!pose.event->tool_axis) break;
        const Vector& axis = *pose.event->tool_axis;
        holding.zero(dot(axis, normal), pose.index, "tool axis across the plane of both ends");
        const Real cosine = dot(*before, axis);
        if (whole && step)
          holding.zero(cosine - *step, pose.index, "cosine of a step of the tool, less that of the first");
        if (!step) step = cosine;
        before = &axis;
      }
    }
  });
}

void positions_in_proportion(const Scene& s, Holding& holding) {
  in_each_run(s, [&](const Machine&, const Run& run) {
    for (const Block& block : sampled_blocks(run)) {
      const bool changed = end_of(s, run, *block.end) == End::changed;
      if (s.program.blocks()[block.end->block].posture && !changed) continue;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const Real& from = block.start->degrees.at(axis);
        const Real& to = block.end->degrees.at(axis);
        for (const Pose& sample : block.samples)
          holding.zero(sample.degrees.at(axis) - from - fraction(sample) * (to - from), sample.index,
                       "rotary position, less its place between those of both ends");
      }
    }
  });
}

void positions_as_programmed(const Scene& s, Holding& holding) {
  in_each_run(s, [&](const Machine& machine, const Run& run) {
    for (std::size_t i = 0; i < run.poses.size(); ++i) {
      const Pose& pose = run.poses[i];
      const FanucBlock& b = s.program.blocks()[pose.block];
      const bool last = i + 1 == run.poses.size() || run.poses[i + 1].block != pose.block;
      if (b.length != kByPositions || !b.absolute || is_sample(pose) || !last) continue;
      if (pose.event->cause == spec::Cause::corner) continue;
      for (const std::size_t axis : machine.axes()) {
        const spec::Decimal* word = b.value(s.c.setup.axes.letter(axis));
        if (word == nullptr || !word->point || !pose.event->axes.has(axis)) continue;
        holding.zero(pose.event->axes[axis] - Real(rational(*word)), pose.index, "rotary axis, less its word");
      }
    }
  });
}

}  // namespace toolcomp::fuzz::laws
