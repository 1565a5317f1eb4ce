// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/fanuc/tool_center_point.h"

#include <algorithm>

#include "judge/laws/fanuc/commanded_direction.h"
#include "judge/laws/fanuc/machine.h"
#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {
namespace {

bool frame_is_workpiece(const FanucScene& s) { return s.c.setup.bit(19696, 5); }

// Tip in the coordinates of the table at its zero pose.
std::optional<Vector> tip_on_table(const Machine& machine, const Run& run, const Pose& pose) {
  if (!run.mode.length) return std::nullopt;
  return machine.on_table(pose.turns, pose.control_point - machine.holder(pose.turns, *run.mode.length));
}

// The samples of one block with the moves before and after them.
struct Block {
  const Pose* start = nullptr;
  std::span<const Pose> samples;
  const Pose* end = nullptr;
};
std::vector<Block> sampled_blocks(const Run& run) {
  std::vector<Block> blocks;
  for (std::size_t i = 1; i < run.poses.size(); ++i) {
    if (!run.poses[i].is_sample() || run.poses[i - 1].is_sample()) continue;
    std::size_t end = i;
    while (end < run.poses.size() && run.poses[end].is_sample()) ++end;
    if (end == run.poses.size()) break;
    const bool one = std::all_of(run.poses.begin() + static_cast<std::ptrdiff_t>(i),
                                 run.poses.begin() + static_cast<std::ptrdiff_t>(end),
                                 [&](const Pose& p) { return p.block == run.poses[end].block; });
    if (one) blocks.push_back({&run.poses[i - 1], {&run.poses[i], end - i}, &run.poses[end]});
  }
  return blocks;
}

Real fraction(const Pose& pose) {
  const exact::Rational t(pose.event->t_numerator, pose.event->t_denominator);
  return {t};
}

bool has_warning(const FanucScene& s, std::uint64_t line) {
  return std::ranges::any_of(
      s.events, [line](const model::Event& e) { return e.kind == spec::EventKind::warning && e.line == line; });
}

template <class Ask>
void in_each_run(const FanucScene& s, const Ask& ask) {
  for (const Run& run : s.runs) ask(*s.machine, run);
}

}  // namespace

void axis_of_the_positions(const FanucScene& s, Holding& holding) {
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

void tip_of_the_axes(const FanucScene& s, Holding& holding) {
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

void offset_taken_back(const FanucScene& s, Holding& holding) {
  if (s.c.setup.tip_control_cancel != spec::TipControlCancel::moves) return;
  constexpr std::string_view words = "XYZUVWABCIJKRH";
  in_each_run(s, [&](const Machine& machine, const Run& run) {
    if (run.poses.empty() || run.poses.back().index + 1 >= s.events.size()) return;
    const Pose& last = run.poses.back();
    const model::Event& event = s.events[last.index + 1];
    const std::size_t block = s.program.index(event.line);
    if (event.kind != spec::EventKind::move || block >= s.program.blocks().size()) return;
    const FanucBlock& b = s.program.blocks()[block];
    if (b.length != kG49 || !b.has_code(kG49) || b.compensation != kG40) return;
    if (b.has_code(kG43_4) || b.has_code(kG43_5) ||
        std::ranges::any_of(words, [&](char letter) { return b.has(letter); }))
      return;
    for (std::size_t i = last.block + 1; i < block; ++i)
      if (s.program.blocks()[i].has_code(kG49)) return;
    const auto q = tip_on_table(machine, run, last);
    const auto axes = xyz(s.c.setup.axes, event.axes);
    if (q && axes)
      holding.zero(machine.in_machine(last.turns, *q) - run.mode.origin - *axes, last.index + 1,
                   "tip before G49, less the axes after it");
  });
}

void tip_on_the_path(const FanucScene& s, Holding& holding) {
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

void great_circle(const FanucScene& s, Holding& holding) {
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

void positions_in_proportion(const FanucScene& s, Holding& holding) {
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

void positions_as_programmed(const FanucScene& s, Holding& holding) {
  in_each_run(s, [&](const Machine& machine, const Run& run) {
    for (std::size_t i = 0; i < run.poses.size(); ++i) {
      const Pose& pose = run.poses[i];
      const FanucBlock& b = s.program.blocks()[pose.block];
      const bool last = i + 1 == run.poses.size() || run.poses[i + 1].block != pose.block;
      if (b.length != kG43_4 || !b.absolute || pose.is_sample() || !last) continue;
      if (pose.event->cause == spec::Cause::corner) continue;
      for (const std::size_t axis : machine.axes()) {
        const spec::Decimal* word = b.value(s.c.setup.axes.letter(axis));
        if (word == nullptr || !word->point || !pose.event->axes.has(axis)) continue;
        holding.zero(pose.event->axes[axis] - Real(rational(*word)), pose.index, "rotary axis, less its word");
      }
    }
  });
}

}  // namespace toolcomp::judge::laws
