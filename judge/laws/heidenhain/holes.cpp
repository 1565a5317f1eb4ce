// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/heidenhain/holes.h"

#include <algorithm>

#include "judge/laws/heidenhain/holes_by_words.h"

namespace toolcomp::judge::laws {
namespace {

void ask_rotary(const KlartextScene& s, const KlartextHole& hole, Holding& holding) {
  const spec::Axes& axes = s.c.setup.axes;
  const model::Event& event = s.events[hole.event];
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (spec::is_rotary_axis(axes.letter(i)) && event.axes.has(i) && hole.block->rotary)
      holding.zero(event.axes[i] - Real(hole.block->rotary->at(static_cast<std::size_t>(axes.letter(i) - 'A'))),
                   hole.event, "rotary axis at a hole, less its words");
}

}  // namespace

void hole_where_programmed(const KlartextScene& s, Holding& holding) {
  const KlartextHoles words = holes_by_words(s);
  const spec::Axes& axes = s.c.setup.axes;
  hold_counts(words.blocks, holding);
  for (const KlartextHole& hole : words.holes) {
    const model::Event& event = s.events[hole.event];
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (i == hole.axis || !spec::is_linear_axis(axes.letter(i))) continue;
      holding.holds(event.point.has(i), hole.event, "a hole has a position in every linear axis except the tool axis");
      if (event.point.has(i) && hole.position.has(i))
        holding.zero(event.point[i] - hole.position[i], hole.event, "position of the hole, less the programmed one");
    }
  }
  for (const MoveBehindHole& move : words.moves) {
    const model::Event& event = s.events[move.event];
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (!move.position.has(i)) continue;
      holding.holds(i != move.axis || event.programmed.has(i), move.event,
                    "after a hole the position of the tool axis is known");
      if (event.programmed.has(i))
        holding.zero(event.programmed[i] - move.position[i], move.event,
                     "programmed point after a hole, less that of the words from the hole on");
    }
  }
}

void hole_by_its_parameters(const KlartextScene& s, Holding& holding) {
  for (const KlartextHole& given : holes_by_words(s).holes) {
    const spec::Hole<Real>& hole = *s.events[given.event].hole;
    const CycleByWords& cycle = given.cycle;
    holding.holds(hole.axis == given.axis, given.event, "the drilling axis is the tool axis");
    holding.not_negative(hole.level - hole.point_r, given.event, "level of return, less the set-up clearance");
    if (!cycle.clearance) continue;
    if (cycle.surface && cycle.datum)
      holding.zero(hole.point_r - Real(Rational(*cycle.datum + *cycle.surface + *cycle.clearance)), given.event,
                   "beginning of the hole, less surface and set-up clearance from the shifted datum");
    if (cycle.depth)
      holding.zero(hole.point_r - hole.bottom - Real(Rational(*cycle.clearance - *cycle.depth)), given.event,
                   "beginning less bottom of the hole, less set-up clearance and depth");
    if (cycle.second_clearance)
      holding.zero(
          hole.level - hole.point_r - Real(std::max(Rational(0), Rational(*cycle.second_clearance - *cycle.clearance))),
          given.event, "level of return above the beginning, less the excess of the second clearance");
  }
}

void hole_with_length(const KlartextScene& s, Holding& holding) {
  const spec::Axes& axes = s.c.setup.axes;
  for (const KlartextHole& hole : holes_by_words(s).holes) {
    const model::Event& event = s.events[hole.event];
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (!spec::is_linear_axis(axes.letter(i))) continue;
      holding.holds(event.axes.has(i), hole.event, "after a hole all linear axes are known");
      if (i != hole.axis && event.axes.has(i) && event.point.has(i))
        holding.zero(event.axes[i] - event.point[i], hole.event, "axis across the tool after a hole, less its point");
    }
    ask_rotary(s, hole, holding);
    if (!event.axes.has(hole.axis)) continue;
    const Real length = event.axes[hole.axis] - event.hole->level;
    if (hole.block->cutter)
      holding.zero(length - hole.block->cutter->dl, hole.event,
                   "tool axis after a hole, less level of return and delta of the length");
    if (hole.length)
      holding.zero(length - *hole.length, hole.event,
                   "tool axis less level of return, less tool axis less point of the move before");
  }
}

}  // namespace toolcomp::judge::laws
