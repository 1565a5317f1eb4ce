# SPDX-License-Identifier: Apache-2.0
"""Where LinuxCNC is known to do otherwise (known_differences.toml): told from the program as written alone.

Never from what LinuxCNC makes of it, so that a new difference cannot pass for a known one.
"""
import math

from translate import PREAMBLE, translate

NEARLY_STRAIGHT = 0.05  # rad: LinuxCNC takes such a corner as straight on
STRAIGHT = 1e-7  # rad
# LinuxCNC's words where it refuses and FANUC's rules go on.
REFUSED = {
    "R i j k words all missing for arc": "arc-without-plane-words",
    "cutter compensation entry move": "short-entry",
    "Tool radius not less than arc radius": "arc-of-the-cutters-radius",
    "Cannot turn cutter radius comp on when on": "side-change",
    "Radius to end of arc differs": "spiral",
    "word with no G2, G3": "vector-words",
}


class Leg:
    """A move in its plane as programmed: the tangents at both ends."""

    def __init__(self, move, before):
        self.line = move.line - PREAMBLE
        self.plane = move.plane
        start, end = ([at[letter] for letter in self.plane] for at in (before, move.end))
        if move.kind == "arc":
            c, turn = move.center, 1 if move.turn > 0 else -1
            self.first, self.last = ((-turn * (p[1] - c[1]), turn * (p[0] - c[0])) for p in (start, end))
        else:
            self.first = self.last = (end[0] - start[0], end[1] - start[1])
        self.moves = math.hypot(*self.first) > 1e-9
        self.straight = move.kind != "arc"


def turn(a, b):
    return math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])


def legs_of(moves):
    before, legs = None, []
    for move in moves:
        if before is not None and move.line > PREAMBLE:
            legs.append(Leg(move, before))
        before = move.end
    return legs


def entries(legs, translation):
    """Lines of the moves that take compensation on: the first behind each G41 and G42."""
    return {next((leg.line for leg in legs if leg.line >= start), start) for start in translation.starts}


def still(legs, translation, last):
    """The legs that move, and where a block in compensation does not, or two in a row have no move at all."""
    moving = [leg for leg in legs if leg.moves]
    lines = {leg.line for leg in moving}
    blocks = sorted(translation.sides)
    first = next((line for line, following in zip(blocks, blocks[1:] + [0])
                  if line not in lines and line not in translation.starts and
                  (line in translation.moving or following and following not in lines)), None)
    if first is None:
        return moving, []
    before = max((line for line in lines if line < first), default=1)
    return moving, [("no-movement", before, last)]


def corners(legs, translation, last):
    legs, places = still(legs, translation, last)
    entry = entries(legs, translation)
    places += [("start-in-arc", leg.line, last) for leg in legs if leg.line in entry and not leg.straight]
    for a, b in zip(legs, legs[1:]):
        side = translation.sides.get(a.line)
        if side is None or b.line not in translation.sides:
            continue
        angle = turn(a.last, b.first)
        if abs(angle) < STRAIGHT:
            continue
        if a.line in entry:
            places.append(("entry-not-straight-on", a.line, b.line))
        elif angle * side < 0 or abs(abs(angle) - math.pi) < STRAIGHT:
            places.append(("outer-corner", a.line, b.line))
        elif abs(angle) < NEARLY_STRAIGHT:
            places.append(("nearly-straight-corner", a.line, b.line))
    return places


def lengths(translation, last):
    """From the move before a block that changes the length without an absolute Z to the next one with it."""
    return [("length-without-move", max((m for m in translation.moving if m < line), default=1),
             next((z for z in translation.absolute_z if z > line), last))
            for line, moved in translation.lengths if not moved]


def cancels(translation, last):
    """From the move before G40 by itself to the next one in the plane, if others lie between."""
    places = []
    for line in translation.cancels:
        end = min((m for m in translation.in_plane if m > line), default=last)
        if any(line <= m < end for m in translation.moving):
            places.append(("cancel-without-move", max((m for m in translation.moving if m < line), default=1), end))
    return places


def known_places(program, setup, interpreter):
    """(id, first line, last line) of the program."""
    nominal = translate(program, setup, compensate=False)
    run = interpreter.run(nominal.text, nominal.tools)
    last = len(program.splitlines())
    made = nominal.translation
    return corners(legs_of(run.moves), made, last) + cancels(made, last) + lengths(made, last)


def known_refusal(words):
    """The id of a known difference behind an alarm of LinuxCNC, or None."""
    return next((name for text, name in REFUSED.items() if text in words), None)
