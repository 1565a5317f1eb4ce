// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/fanuc/holes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "judge/laws/fanuc/holes_by_words.h"
#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {
namespace {

Real value_of(const FanucScene& s, const CycleLength& length) {
  return {length_of(s.c.setup, length.inches, length.value)};
}

void ask_position(const FanucScene& s, const HoleByWords& hole, Holding& holding) {
  const spec::Axes& axes = s.c.setup.axes;
  const model::Event& event = s.events[hole.event];
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!hole.position.has(i)) continue;
    if (!spec::is_linear_axis(axes.letter(i))) {
      if (event.axes.has(i))
        holding.zero(event.axes[i] - hole.position[i], hole.event, "rotary axis at a hole, less its command");
      continue;
    }
    if (!hole.shifts) continue;
    holding.holds(event.point.has(i), hole.event,
                  "a hole has a position in every linear axis except the drilling axis");
    if (event.point.has(i))
      holding.zero(event.point[i] - hole.shift[i] - hole.position[i], hole.event,
                   "position of the hole, less the commanded one and the shift");
  }
}

// Axes less the point, or less the level of a hole; nothing where they do not say it in all linear axes.
std::optional<Places> offset_of(const spec::Axes& axes, const model::Event& event) {
  Places offset;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!spec::is_linear_axis(axes.letter(i))) continue;
    const bool along = event.hole && event.hole->axis == i;
    if (!event.axes.has(i) || (!along && !event.point.has(i))) return std::nullopt;
    offset.set(i, event.axes[i] - (along ? event.hole->level : event.point[i]));
  }
  return offset;
}

char across(int plane) { return plane == kG19 ? 'X' : plane == kG18 ? 'Y' : 'Z'; }

// Whether a length offset of type A or B can never act along this axis.
bool is_free_of_offsets(const FanucScene& s, char axis) {
  if (s.c.setup.bit(5001, 0)) return false;
  if (!s.c.setup.bit(5001, 1)) return axis != 'Z';
  return axis != 'Z' &&
         std::ranges::none_of(s.program.blocks(), [axis](const FanucBlock& b) { return across(b.plane) == axis; });
}

std::ptrdiff_t length_codes(const FanucBlock& b) {
  return std::ranges::count_if(std::array{kG43, kG44, kG49}, [&b](int code) { return b.has_code(code); });
}

void ask_offset(const FanucScene& s, std::size_t event, const FanucBlock& b, const Places& offset, Holding& holding) {
  const spec::Axes& axes = s.c.setup.axes;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!offset.has(i)) continue;
    if (b.length == kG49)
      holding.zero(offset[i], event, "axis after a hole, less position or level, without a length offset");
    else if (is_free_of_offsets(s, axes.letter(i)))
      holding.zero(offset[i], event, "axis after a hole that no length offset acts on, less position or level");
  }
  if (s.c.setup.bit(5001, 0) || (b.length != kG43 && b.length != kG44) || length_codes(b) != 1 || !b.has('H') || !b.h)
    return;
  const auto value = length_value(s.c.setup, *b.h);
  const std::size_t axis = axes.index(s.c.setup.bit(5001, 1) ? across(b.plane) : 'Z');
  if (!value || axis == spec::Axes::kNone) return;
  holding.zero(offset[axis] - (b.length == kG43 ? Real(*value) : -Real(*value)), event,
               "axis after a hole, less position or level and the offset of its block");
}

// Where the axes stand, and in which block.
struct Offset {
  std::size_t block = 0;
  bool hole = false;
  Places value;
};

// Whether one of the blocks behind `from`, up to `to`, may say of another length offset, or rename coordinates.
bool may_differ(const FanucScene& s, std::size_t from, std::size_t to) {
  for (std::size_t k = from + 1; k <= to; ++k) {
    const FanucBlock& b = s.program.blocks()[k];
    if (b.has('H') || length_codes(b) > 0 || s.program.renames_at(k)) return true;
  }
  return false;
}

}  // namespace

void hole_where_commanded(const FanucScene& s, Holding& holding) {
  const HolesByWords words = holes_by_words(s);
  hold_counts(words.blocks, holding);
  for (const HoleByWords& hole : words.holes) ask_position(s, hole, holding);
  for (const EndByWords& end : words.ends)
    for (std::size_t i = 0; i < s.c.setup.axes.size(); ++i)
      if (end.position.has(i) && s.events[end.event].programmed.has(i))
        holding.zero(s.events[end.event].programmed[i] - end.position[i], end.event,
                     "programmed point after a hole, less the commanded one");
}

void hole_levels(const FanucScene& s, Holding& holding) {
  for (const HoleByWords& given : holes_by_words(s).holes) {
    const model::Event& event = s.events[given.event];
    const FanucBlock& b = s.program.blocks()[given.block];
    const DrillingMode& mode = *b.drilling;
    const spec::Hole<Real>& hole = *event.hole;
    const std::size_t axis = s.c.setup.axes.index(mode.axis);
    if (axis == spec::Axes::kNone) continue;
    holding.holds(hole.axis == axis, given.event, "the drilling axis");
    // Of a shift along the drilling axis nobody says whether it acts on what is absolute.
    const bool in_place = given.shifts && !certainly_not_zero(given.shift[axis]);
    if (mode.point_r && (mode.point_r->absolute ? in_place : given.initial_level.has_value())) {
      const Real from = mode.point_r->absolute ? Real(0) : *given.initial_level;
      holding.zero(hole.point_r - from - value_of(s, *mode.point_r), given.event, "point R, less what R says");
    }
    if (mode.bottom && (in_place || !mode.bottom->absolute)) {
      const Real from = mode.bottom->absolute ? Real(0) : hole.point_r;
      holding.zero(hole.bottom - from - value_of(s, *mode.bottom), given.event, "bottom, less what its word says");
    }
    if (b.to_point_r && mode.cycle != kG87)
      holding.zero(hole.level - hole.point_r, given.event, "level of return under G99, less point R");
    if (!b.to_point_r && given.initial_level)
      holding.zero(hole.level - *given.initial_level, given.event, "level of return under G98, less the initial level");
  }
}

void hole_axes(const FanucScene& s, Holding& holding) {
  if (s.program.has_code({kG28, kG29, kG30, kG30_1, kG43_4, kG43_5, kG53})) return;
  const auto& blocks = s.program.blocks();
  const auto edits = [](const FanucBlock& b) { return b.has_code(kG10) || b.has_code(kG37); };
  const auto end = static_cast<std::size_t>(std::ranges::find_if(blocks, edits) - blocks.begin());
  std::optional<Offset> latest;
  for (std::size_t i = 0; i < s.events.size(); ++i) {
    const model::Event& event = s.events[i];
    const bool hole = event.kind == spec::EventKind::hole && event.hole;
    if (!hole && (event.kind != spec::EventKind::move || event.cause == spec::Cause::corner)) continue;
    const std::size_t block = s.program.index(event.line);
    if (block >= end) {
      latest.reset();
      if (block == blocks.size()) continue;
      return;
    }
    const auto offset = offset_of(s.c.setup.axes, event);
    if (!offset) {
      latest.reset();
      continue;
    }
    if (hole) ask_offset(s, i, blocks[block], *offset, holding);
    if (latest && (hole || latest->hole) && latest->block <= block && !may_differ(s, latest->block, block))
      for (std::size_t axis = 0; axis < s.c.setup.axes.size(); ++axis)
        if (offset->has(axis) && latest->value.has(axis))
          holding.zero((*offset)[axis] - latest->value[axis], i,
                       "length offset at or after a hole, less that before it");
    latest = Offset{block, hole, *offset};
  }
}

}  // namespace toolcomp::judge::laws
