# SPDX-License-Identifier: Apache-2.0
"""Expected points of vectors from geometry alone, to 40 digits: every corner is the point where two straight lines meet, each
given by an equation, and every length is a sum. Nothing here comes from toolcomp."""

import decimal
import math
import re
from decimal import Decimal

decimal.getcontext().prec = 40
PLANES = {17: "XYZ", 18: "ZXY", 19: "YZX"}
# What the vectors need that are computed here: lines and corners between lines.
LINES = {"tie", "incremental", "planes", "inch", "negative-offset", "type-b", "no-check"}


def meet(first, second):
    """The point with a x + b y = c of both equations."""
    (a, b, c), (d, e, f) = first, second
    whole = a * e - b * d
    return (c * e - b * f) / whole, (a * f - c * d) / whole


class Line:
    """A programmed line, and the equations of what lies beside it and across it."""

    def __init__(self, start, end):
        x, y = end[0] - start[0], end[1] - start[1]
        length = (x * x + y * y).sqrt()
        self.way, self.start, self.end = (x / length, y / length), start, end

    def beside(self, r):
        """Points at the distance r to the left."""
        a, b = -self.way[1], self.way[0]
        return a, b, a * self.end[0] + b * self.end[1] + r

    def across(self, at, by=0):
        """Points as far along the line as `at`, and `by` further."""
        a, b = self.way
        return a, b, a * at[0] + b * at[1] + by


def turn(one, two, r):
    """inside, straight, obtuse or acute, of the tool at r to the left."""
    (a, b), (c, d) = one.way, two.way
    left, ahead = a * d - b * c, a * c + b * d
    # Programs have few digits, so that nothing but 0 is as small.
    left, ahead = (Decimal(0) if abs(v) < Decimal("1e-30") else v for v in (left, ahead))
    if left == 0:
        return "straight" if ahead > 0 else "acute"
    return "inside" if left * r > 0 else "acute" if ahead < 0 else "obtuse"


def corner(one, two, r):
    kind, corner_point = turn(one, two, r), one.end
    if kind == "straight":
        return [meet(one.beside(r), one.across(corner_point))]
    if kind == "acute":
        return [meet(one.beside(r), one.across(corner_point, abs(r))), meet(two.beside(r), two.across(corner_point, -abs(r)))]
    return [meet(one.beside(r), two.beside(r))]


def heads(one, two, r, off, type_b):
    """The points at the end of a line: what follows it, and whether the offset comes (`off` is the first) or goes."""
    here = [meet(one.beside(r), one.across(one.end))]
    if two is None:
        return here
    there = [meet(two.beside(r), two.across(two.start))]
    round_it = type_b and turn(one, two, r) in ("acute", "obtuse")
    if off == "start":
        return here + corner(one, two, r) if round_it else there
    if off == "cancel":
        return corner(one, two, r) + there if round_it else here
    return corner(one, two, r)


def read(line):
    return [(word[0], Decimal(word[1:])) for word in re.findall("[A-Z][-+.0-9]+", line)]


def lines(vector):
    """Points of lines under G41, G42 and G40, the length offset of Z included; only the block of G43 does not move in the plane, and it comes first."""
    fields = vector["settings"]
    at, absolute, side, plane, unit, z_offset = dict.fromkeys("XYZ", Decimal(0)), True, 0, 17, 1, Decimal(0)
    points, moves = [], []
    for text in vector["program"]:
        words = read(text)
        codes = {int(value) for letter, value in words if letter == "G"}
        named = dict(word for word in words if word[0] != "G")
        absolute = 91 not in codes and (absolute or 90 in codes)
        plane = max(codes & set(PLANES), default=plane)
        side = 1 if 41 in codes else -1 if 42 in codes else 0 if 40 in codes else side
        unit = Decimal("25.4") if 20 in codes and fields["units"] == "mm" else unit
        z_offset += fields["offsets"].get("H1", 0) if 43 in codes else 0
        before = dict(at)
        for axis in set(at) & set(named):
            at[axis] = named[axis] * unit + (0 if absolute else at[axis])
        if set(PLANES[plane][:2]) & set(named):
            moves.append((before, dict(at), side, z_offset))
        elif set(at) & set(named):
            points.append({**at, "Z": at["Z"] + z_offset})
    first, second, third = PLANES[plane]
    places = [[(place[first], place[second]) for place in move[:2]] for move in moves]
    ways = [Line(start, end) for start, end in places]
    radius, type_b = fields["offsets"].get("D1", Decimal(0)), fields["parameters"].get("5003#0")
    # Corner points behind the first come at the height of the block that ends there.
    for index, (_, after, side, z) in enumerate(moves):
        two = index + 1 if index + 1 < len(moves) else None
        if side:
            off = "start" if not index or not moves[index - 1][2] else "cancel" if two and not moves[two][2] else None
            ends = heads(ways[index], two and ways[two], side * radius, off, type_b)
        else:
            ends = [places[index][1]]
        points += [{first: end[0], second: end[1], third: after[third] + z} for end in ends]
    return points


def lengths(vector):
    """Points of programs with G43, G44, G49 and H: a sum on one axis."""
    fields = vector["settings"]
    kind = fields["parameters"]
    at, shift, axis = dict.fromkeys("XYZ", Decimal(0)), dict.fromkeys("XYZ", Decimal(0)), "Z"
    sign, h, absolute, plane, points = 0, None, True, 17, []
    for text in vector["program"]:
        words = read(text)
        codes = {int(value) for letter, value in words if letter == "G"}
        named = dict(word for word in words if word[0] != "G")
        absolute, plane = 91 not in codes and (absolute or 90 in codes), max(codes & set(PLANES), default=plane)
        if codes & {43, 44}:
            sign = 1 if 43 in codes else -1
            if kind.get("5001#1"):
                axis = PLANES[plane][2]
            if kind.get("5001#0"):
                named_axis = next(letter for letter in "XYZ" if letter in named)
                if shift[axis] and named_axis != axis:
                    return points  # an alarm
                axis = named_axis
        if 49 in codes:
            sign = 0
        h = int(named["H"]) if "H" in named else h
        value = sum((v for name, v in fields["offsets"].items() if re.fullmatch(rf"H{h}(\..*)?", name)), Decimal(0))
        before, shift = shift, {**dict.fromkeys("XYZ", Decimal(0)), axis: sign * value}
        for letter in set(at) & set(named):
            at[letter] = named[letter] + (0 if absolute else at[letter])
        if set(at) & set(named) or shift != before:
            points.append({letter: at[letter] + shift[letter] for letter in "XYZ"})
    return points


def computed(vector):
    """Points from geometry, or None for a vector that is not made of lines or lengths alone."""
    if vector["section"] == "fanuc/tool-length-offset":
        return lines(vector) if "radius" in vector["needs"] else lengths(vector)
    if vector["section"] == "fanuc/cutter-compensation-c" and set(vector["needs"]) <= LINES:
        return lines(vector)
    return None


def by_hand(expression):
    """A point of `hand` in a source."""
    names = {"sqrt": math.sqrt, "acos": lambda x: math.degrees(math.acos(x)),
             **{name: lambda degrees, f=getattr(math, name): f(math.radians(degrees)) for name in ("sin", "cos", "tan")}}
    return eval(f"({expression},)", {"__builtins__": {}}, names)
