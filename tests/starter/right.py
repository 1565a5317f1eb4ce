# SPDX-License-Identifier: Apache-2.0
"""A small controller that is right in what it knows: lines and smooth arcs under G41, G42 and G40, the length offset of Z,
and G43.4 on a head-head machine. mistakes.py has one that is wrong for each of its rules."""

import math
import re

PLANES = {17: "XYZ", 18: "ZXY", 19: "YZX"}
CENTER = {"X": "I", "Y": "J", "Z": "K"}


def turned(v):
    """To the left by 90 degrees."""
    return -v[1], v[0]


def moved(p, *steps):
    """p plus each length times its direction."""
    return p[0] + sum(length * v[0] for length, v in steps), p[1] + sum(length * v[1] for length, v in steps)


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


class Move:
    """A move in the plane: where it begins and ends, an arc's center and sense (1 counter-clockwise), and what is in force at its end."""

    def __init__(self, **fields):
        self.__dict__.update(fields)

    def direction(self, at_end):
        if self.center is None:
            way = moved(self.end, (-1, self.start))
        else:
            way = turned(moved(self.end if at_end else self.start, (-1, self.center)))
            way = (way[0] * self.sense, way[1] * self.sense)
        length = math.hypot(*way)
        return way[0] / length, way[1] / length


class Right:
    SECTIONS = ["fanuc/cutter-compensation-c", "fanuc/tool-length-offset", "fanuc/tool-center-point-control"]
    NEEDS = ["tie", "arcs", "incremental", "planes", "inch", "negative-offset", "type-b", "interference", "no-check", "radius", "head-head"]

    # Each rule is a method, so that a controller with a mistake replaces one.
    def side(self, code):
        return {41: 1, 42: -1, 40: 0}[code]

    def radius(self, value):
        return value

    def length(self, code, h, before, settings):
        """The offset of Z: sign times the value of H."""
        return {43: 1, 44: -1, 49: 0}[code] * settings["offsets"].get(f"H{h}", 0)

    def tool(self, b, c):
        """The direction of the tool in a head whose C carries B."""
        b, c = math.radians(b), math.radians(c)
        return math.sin(b) * math.cos(c), math.sin(b) * math.sin(c), math.cos(b)

    def perpendicular(self, move, at_end, r):
        return moved(move.end if at_end else move.start, (r, turned(move.direction(at_end))))

    def corner(self, move, following):
        """The points at the end of a move in offset mode; r is positive to the left."""
        a, b, r = move.direction(True), following.direction(False), move.r
        turn, ahead = cross(a, b), dot(a, b)
        if abs(turn) < 1e-12 and ahead > 0:
            return [self.perpendicular(move, True, r)]
        if turn * r < 0 and ahead < 0 or ahead <= -1:
            return [moved(move.end, (r, turned(a)), (abs(r), a)), moved(move.end, (r, turned(b)), (-abs(r), b))]
        return [moved(move.end, (r / (1 + ahead), turned(a)), (r / (1 + ahead), turned(b)))]

    def start_up(self, move, following, type_b):
        head = self.perpendicular(following, False, following.r)
        if not type_b or cross(move.direction(True), following.direction(False)) * following.r >= 0:
            return [head]
        return [self.perpendicular(move, True, move.r), *self.corner(move, following)]

    def before_cancel(self, move, cancel, type_b):
        if not type_b or cross(move.direction(True), cancel.direction(False)) * move.r >= 0:
            return [self.perpendicular(move, True, move.r)]
        return [*self.corner(move, cancel), self.perpendicular(cancel, False, move.r)]

    def cancel(self, move, r_before):
        return [move.end]

    def interferes(self, move, here, there):
        """Whether the tool goes against its programmed way."""
        if move.center is not None:
            return math.dist(move.start, move.center) - move.sense * move.r < 0
        return dot(moved(there, (-1, here)), moved(move.end, (-1, move.start))) < -1e-9

    # What follows is reading and order, not rules.
    def words(self, line):
        return [(word[0], float(word[1:])) for word in re.findall("[A-Z][-+.0-9]+", line)]

    def run(self, program, settings):
        self.settings, self.points = settings, []
        at, g, side, d, h, unit = dict.fromkeys(settings["axes"], 0.0), {"motion": 0, "plane": 17, "count": 90, "length": 49}, 0, 0, 0, 1
        offset, tip, moves = 0.0, False, []
        for number, line in enumerate(program, 1):
            words = self.words(line)
            codes, values = [v for letter, v in words if letter == "G"], dict(w for w in words if w[0] != "G")
            for code in codes:
                group = "motion" if code in (0, 1, 2, 3) else "plane" if code in PLANES else "count" if code in (90, 91) else "length"
                if code in (40, 41, 42):
                    side = self.side(int(code))
                elif code == 20 and settings["units"] == "mm":
                    unit = 25.4
                elif code in (0, 1, 2, 3, 17, 18, 19, 90, 91, 43, 44, 49):
                    g[group] = int(code)
            d, h = int(values.get("D", d)), int(values.get("H", h))
            before, offset = offset, self.length(43 if 43.4 in codes else g["length"], h, offset, settings)
            if 43.4 in codes:
                tip, g["length"] = True, 43
            start = dict(at)
            for axis in at:
                if axis in values:
                    at[axis] = values[axis] * unit + (at[axis] if g["count"] == 91 else 0)
            arc = g["motion"] in (2, 3) and {"I", "J", "K", "R"} & set(values)
            if set(at) & set(values) or arc or offset != before or 43.4 in codes:
                first, second, third = PLANES[g["plane"]]
                begin, end, sense = (start[first], start[second]), (at[first], at[second]), 1 if g["motion"] == 3 else -1
                center = self.center(begin, end, sense, values, first, second, unit) if arc else None
                moves.append(Move(line=number, start=begin, end=end, center=center, sense=sense, names=(first, second), rest=dict(at), before=start,
                                  r=side * self.radius(settings["offsets"].get(f"D{d}", 0)), on=side != 0, offset=offset, offset_before=before, tip=tip))
        return self.points, self.follow(moves)

    def center(self, begin, end, sense, values, first, second, unit):
        if "R" not in values:
            return moved(begin, (unit, (values.get(CENTER[first], 0), values.get(CENTER[second], 0))))
        chord = moved(end, (-1, begin))
        half, r = math.hypot(*chord) / 2, values["R"] * unit
        height = math.sqrt(r * r - half * half) * sense * math.copysign(1, r)
        return moved(begin, (0.5, chord), (height / (2 * half), turned(chord)))

    def follow(self, moves):
        """Gives the points of all moves, and the alarm if one comes."""
        type_b, check = self.settings["parameters"].get("5003#0", 0), not self.settings["parameters"].get("5008#0", 0)
        groups = []
        for index, move in enumerate(moves):
            last, following = moves[index - 1] if index else None, moves[index + 1] if index + 1 < len(moves) else None
            was_on = last is not None and last.on
            if not move.on:
                groups.append(self.cancel(move, last.r) if was_on else [move.end])
            elif following is None:
                groups.append([self.perpendicular(move, True, move.r)])
            elif not following.on:
                groups.append(self.before_cancel(move, following, type_b))
            else:
                groups.append(self.corner(move, following) if was_on else self.start_up(move, following, type_b))
        fault = next((index for index in range(1, len(moves)) if check and moves[index - 1].on and moves[index].on and
                      not self.fits(moves[index], groups[index - 1], groups[index])), None)
        for index, move in enumerate(moves[:fault]):
            for point in groups[index - 1][1:] if index else []:
                self.put(move, point, move.before, move.offset_before)
            self.put(move, groups[index][0], move.rest, move.offset)
        return None if fault is None else (moves[fault].line, "interference")

    def fits(self, move, here, there):
        """Whether a way is left between two corners, if need be without points of them, which are dropped."""
        while self.interferes(move, here[-1], there[0]):
            if len(here) + len(there) == 2:
                return False
            (here if len(here) > 1 else there).pop(-1 if len(here) > 1 else 0)
        return True

    def put(self, move, point, rest, offset):
        axes = {**rest, move.names[0]: point[0], move.names[1]: point[1]}
        tool = self.tool(axes["B"], axes["C"]) if move.tip else (0, 0, 1)
        axes.update({axis: axes[axis] + offset * part for axis, part in zip("XYZ", tool)})
        self.points.append([axes[axis] for axis in self.settings["axes"]])


SECTIONS, NEEDS = Right.SECTIONS, Right.NEEDS


def your_function(program, settings):
    return Right().run(program, settings)
