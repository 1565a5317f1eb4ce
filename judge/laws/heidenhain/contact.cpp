// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/heidenhain/contact.h"

#include <algorithm>

#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {
namespace {

using spec::klartext::Statement;

using Move = SpaceMove;

template <class Ask>
void for_each_move(const KlartextScene& s, const Ask& ask) {
  for (const Move& move : s.moves) ask(move);
}

Vector axis_of(char letter) {
  Vector v;
  v.at(static_cast<std::size_t>(letter - 'X')) = 1;
  return v;
}

// From the contact point to the centre, less R2 n: it is ρ u, across the tool and toward the normal.
void is_across(const Vector& across, const Move& move, const std::optional<Real>& length, Holding& holding) {
  const spec::Contact<Real>& contact = *move.event->space->contact;
  const Vector& n = contact.normal;
  if (contact.flat) {
    holding.zero(across, move.index, "centre over the contact point, across the tool");
    return;
  }
  holding.zero(dot(across, move.tool), move.index, "centre over the contact point, along the tool");
  holding.zero(dot(across, move.side), move.index,
               "centre over the contact point, out of the plane of normal and tool");
  holding.not_negative(dot(across, n), move.index, "centre over the contact point, toward the normal");
  if (length && std::ranges::any_of(move.side, certainly_not_zero))
    holding.zero(dot(across, across) - square(*length), move.index,
                 "square of the distance of tool axis and ring, less that of the tool");
}

// The tip of the nominal tool.
std::optional<Vector> nominal_tip(const Move& move) {
  if (!move.block->center || move.block->contour || !move.block->tcpm) return move.programmed;
  if (!move.block->cutter) return std::nullopt;
  return move.programmed - move.block->cutter->r2 * move.tool;
}

}  // namespace

void touches_the_contact_plane(const KlartextScene& s, Holding& holding) {
  for_each_move(s, [&](const Move& move) {
    const auto& contact = move.event->space->contact;
    if (!contact) return;
    const Vector from_tip = move.event->space->tool_center - move.tip;
    const Real r2 = dot(from_tip, move.tool);
    holding.zero(dot(contact->normal, contact->normal) - Real(1), move.index, "square of the normal, less 1");
    holding.zero(dot(move.tool, move.tool) - Real(1), move.index, "square of the tool axis, less 1");
    holding.zero(from_tip - r2 * move.tool, move.index, "distance of the centre of the tool from its axis");
    std::optional<Real> ring;
    if (const auto& cutter = move.block->cutter; cutter && !cutter->by_angle) {
      holding.zero(r2 - cutter->effective_r2, move.index, "height of the centre over the tip, less the corner radius");
      ring = cutter->effective_ring;
    }
    is_across(move.event->space->tool_center - contact->point - r2 * contact->normal, move, ring, holding);
  });
}

void nominal_tool_touches(const KlartextScene& s, Holding& holding) {
  for_each_move(s, [&](const Move& move) {
    const auto& contact = move.event->space->contact;
    if (!contact) return;
    if (move.block->contour) {
      holding.zero(contact->point - move.programmed, move.index, "contact point, less the programmed point");
      return;
    }
    const auto tip = nominal_tip(move);
    if (!tip || !move.block->cutter) return;
    const Cutter& cutter = *move.block->cutter;
    const Vector center = *tip + cutter.r2 * move.tool;
    is_across(center - contact->point - cutter.r2 * contact->normal, move, cutter.ring, holding);
  });
}

void direction_of_the_tool(const KlartextScene& s, Holding& holding) {
  for_each_move(s, [&](const Move& move) {
    const KlartextBlock& b = *move.block;
    if (b.statement != Statement::line_with_vectors) return;
    const auto& contact = move.event->space->contact;
    if (b.normal && contact) {
      holding.zero(cross(contact->normal, *b.normal), move.index, "normal across N");
      holding.not_negative(dot(contact->normal, *b.normal), move.index, "normal along N");
    }
    const Vector expected = !b.tcpm ? axis_of(b.axis) : b.tool ? *b.tool : b.normal ? *b.normal : move.tool;
    holding.zero(cross(move.tool, expected), move.index, "tool axis across its direction");
    holding.not_negative(dot(move.tool, expected), move.index, "tool axis along its direction");
  });
}

void tool_as_the_axes_stand(const KlartextScene& s, Holding& holding) {
  for_each_move(s, [&](const Move& move) {
    const KlartextBlock& b = *move.block;
    if (b.statement != Statement::line || !b.tcpm || !b.rotary) return;
    Vector expected = axis_of(b.axis);
    std::size_t turned = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const Rational& degrees = b.rotary->at(i);
      if (degrees == 0) continue;
      if (++turned > 1) return;
      const Real sine = exact::sin_degrees(degrees);
      const Real cosine = exact::cos_degrees(degrees);
      Real& y = expected.at((i + 1) % 3);
      Real& z = expected.at((i + 2) % 3);
      const Real before = y;
      y = cosine * before - sine * z;
      z = sine * before + cosine * z;
    }
    holding.zero(move.tool - expected, move.index, "tool axis, less that of the rotary positions");
  });
}

void length_along_the_tool(const KlartextScene& s, Holding& holding) {
  for_each_move(s, [&](const Move& move) {
    const auto axes = xyz(s.c.setup.axes, move.event->axes);
    if (!axes) return;
    const Vector given = *axes - move.tip;
    holding.zero(move.event->space->tool_shift - move.event->space->shift - given, move.index,
                 "tool shift, less shift and length");
    const auto& cutter = move.block->cutter;
    if (!cutter) {
      holding.zero(cross(given, move.tool), move.index, "length across the tool");
      return;
    }
    holding.zero(given - cutter->dl * move.tool, move.index, "axes, less tip and delta of the length");
    if (cutter->length && move.event->space->carrier)
      holding.zero(*move.event->space->carrier - *axes - *cutter->length * move.tool, move.index,
                   "carrier, less axes and length");
  });
}

void shift_of_the_tip(const KlartextScene& s, Holding& holding) {
  for_each_move(s, [&](const Move& move) {
    if (move.block->contour) return;
    if (const auto tip = nominal_tip(move))
      holding.zero(move.tip - *tip - move.event->space->shift, move.index, "tip, less the nominal one and the shift");
  });
}

void cylinder_beside_the_line(const KlartextScene& s, Holding& holding) {
  for (std::size_t k = 1; k < s.moves.size(); ++k) {
    const Move* before = &s.moves[k - 1];
    const Move* move = &s.moves[k];
    const std::size_t i = move->index;
    if (before->index + 1 != i || move->block->side == 0 || !move->block->tcpm || !move->block->cutter) continue;
    if (move->event->space->contact) continue;
    const Cutter& cutter = *move->block->cutter;
    const Real offset = move->block->contour ? cutter.r + cutter.dr : cutter.dr;
    const auto tip = nominal_tip(*move);
    if (!tip) continue;
    const Vector v = move->tip - *tip;
    const auto beside = [&](const Vector& line, int side, std::string_view what) {
      const Vector across = Real(side) * cross(move->tool, line);
      if (!std::ranges::any_of(across, certainly_not_zero)) return;
      holding.zero(dot(v, across) - offset * length(across), i, what);
    };
    const Vector line = move->programmed - before->programmed;
    const bool first = before->block->side == 0 || s.klartext.calls_tool(before->block->line, move->block->line);
    if (std::ranges::any_of(cross(move->tool, line), certainly_not_zero))
      holding.zero(dot(v, move->tool), i, "shift of the tip along the tool");
    if (!first)
      beside(line, move->block->side, "distance of the cylinder from the line before, times the length of the line");
    if (k + 1 == s.moves.size()) continue;
    const Move* next = &s.moves[k + 1];
    if (next->index != i + 1 || next->block->side == 0 || next->event->space->contact) continue;
    if (s.klartext.calls_tool(move->block->line, next->block->line)) continue;
    if (!first && !std::ranges::any_of(cross(move->tool, line), certainly_not_zero)) continue;
    beside(next->programmed - move->programmed, next->block->side,
           "distance of the cylinder from the line after, times the length of the line");
  }
}

}  // namespace toolcomp::judge::laws
