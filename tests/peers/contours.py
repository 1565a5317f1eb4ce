#!/usr/bin/python3
"""Random contours through toolcomp and through LinuxCNC's rs274: inner corners must agree to 1e-9, and every other
difference must be one that is known.

contours.py --toolcomp build/release/toolcomp [--engine model] [--contours 1000] [--seed 1]

Known differences (LinuxCNC rounds outer corners with an arc, FANUC's compensation C has one or two vectors there;
corners of less than 0.05 rad are straight on for LinuxCNC; the two refuse different things) are not taken on trust:
what each of them must give there is computed here from the geometry alone. Exit status 1 if anything is unexplained.
"""
import argparse
import collections
import json
import math
import random
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

TOLERANCE = 1e-9  # both are doubles through acos, asin, atan2, sin and cos
NEARLY_STRAIGHT = 0.05  # rad, LinuxCNC's
UNIT = 10**6  # coordinates are whole millionths


def rotated(v, turn):
    """v turned by a rational angle (c, s, n) with c^2 + s^2 = n^2, n a power of 5 and 2: decimals stay decimals."""
    c, s, n = turn
    x, y = c * v[0] - s * v[1], s * v[0] + c * v[1]
    assert x % n == 0 and y % n == 0
    return x // n, y // n


TURNS = [(3, 4, 5), (4, 3, 5), (24, 7, 25), (7, 24, 25), (0, 1, 1), (-3, 4, 5), (-4, 3, 5), (-1, 0, 1), (-3, -4, 5)]


class Segment:
    """A line, or an arc about `center`; coordinates in millionths."""

    def __init__(self, start, end, center=None, ccw=None):
        self.start, self.end, self.center, self.ccw = start, end, center, ccw

    def tangent(self, point):
        if self.center is None:
            v = (self.end[0] - self.start[0], self.end[1] - self.start[1])
        else:
            r = (point[0] - self.center[0], point[1] - self.center[1])
            v = (-r[1], r[0]) if self.ccw else (r[1], -r[0])
        length = math.hypot(*v)
        return v[0] / length, v[1] / length

    def radius(self):
        return math.hypot(self.end[0] - self.center[0], self.end[1] - self.center[1]) / UNIT

    def words(self):
        text = f"X{number(self.end[0])} Y{number(self.end[1])}"
        if self.center is None:
            return "G1 " + text
        i, j = self.center[0] - self.start[0], self.center[1] - self.start[1]
        return f"{'G3' if self.ccw else 'G2'} {text} I{number(i)} J{number(j)}"


def number(millionths):
    sign = "-" if millionths < 0 else ""
    return f"{sign}{abs(millionths) // UNIT}.{abs(millionths) % UNIT:06}"


def near(direction, angle, length, exact):
    """A vector at `angle` from `direction`, about `length` long, in thousandths; `exact` keeps the direction."""
    if exact:
        # A whole multiple of the shortest vector of this direction on the grid.
        g = math.gcd(direction[0], direction[1])
        step = (direction[0] // g, direction[1] // g)
        k = max(1, round(length * UNIT / math.hypot(*step)))
        return k * step[0], k * step[1]
    a = math.atan2(direction[1], direction[0]) + angle
    return tuple(round(length * 1000 * f) * (UNIT // 1000) for f in (math.cos(a), math.sin(a)))


def contour(rng):
    """The lead-in and the segments after it; the first goes straight on from the lead-in."""
    small = rng.random() < 0.15  # contours about as small as the tool, for alarms
    size = 6 if small else 40
    at, direction = (0, 0), (UNIT, 0)
    segments = []
    for i in range(rng.randint(3, 8)):
        kind = rng.random()
        angle, exact = 0.0, i == 0
        if i > 0:
            exact = kind < 0.15
            angle = rng.uniform(-0.06, 0.06) if kind < 0.3 else rng.uniform(-2.6, 2.6)
        if rng.random() < 0.55 or i == 0:
            v = near(direction, angle, rng.uniform(0.2, 1) * size, exact)
            if v == (0, 0):
                continue
            segments.append(Segment(at, (at[0] + v[0], at[1] + v[1])))
            at, direction = segments[-1].end, v
            continue
        ccw = rng.random() < 0.5
        tangent = near(direction, angle, rng.uniform(0.15, 0.6) * size, exact)
        # Twenty-fifths of the radius must be whole.
        tangent = tuple(25 * x for x in near(direction, 0, math.hypot(*tangent) / UNIT / 25, True)) if exact else tangent
        if tangent == (0, 0):
            continue
        to_center = (-tangent[1], tangent[0]) if ccw else (tangent[1], -tangent[0])
        center = (at[0] + to_center[0], at[1] + to_center[1])
        radial = (-to_center[0], -to_center[1])
        c, s, n = rng.choice(TURNS)
        end = rotated(radial, (c, s if ccw else -s, n))
        segments.append(Segment(at, (center[0] + end[0], center[1] + end[1]), center, ccw))
        at = segments[-1].end
        direction = (-end[1], end[0]) if ccw else (end[1], -end[0])
    return segments


class Case:
    def __init__(self, name, rng):
        self.name = name
        self.segments = contour(rng)
        self.left = rng.random() < 0.5
        self.radius = Fraction(rng.randint(10, 60), 10)
        first = self.segments[0]
        lead = near((first.end[0] - first.start[0], first.end[1] - first.start[1]), 0, 25, True)
        self.lead = lead
        self.text = {}

    def rho(self):
        return float(self.radius) * (1 if self.left else -1)

    def program(self, linuxcnc):
        """Block k of the contour stands on line 4 + k in both programs; millionths of the unit are exact in both."""
        start = (self.segments[0].start[0] - self.lead[0], self.segments[0].start[1] - self.lead[1])
        d = f"D{float(2 * self.radius)}" if linuxcnc else "D1"
        side = ("G41" if self.left else "G42") + (".1" if linuxcnc else "")
        lines = [
            ("G20 " if linuxcnc else "") + "G17 G90 G40",
            f"G0 X{number(start[0])} Y{number(start[1])}",
            f"G1 {side} {d} X{number(self.segments[0].start[0])} Y{number(self.segments[0].start[1])} F1000",
        ]
        lines += [s.words() for s in self.segments]
        tangent = self.segments[-1].tangent(self.segments[-1].end)
        end = [self.segments[-1].end[i] + round(tangent[i] * 25) * UNIT for i in (0, 1)]
        return "\n".join(lines + [f"G1 G40 X{number(end[0])} Y{number(end[1])}", "M2", ""])


FIRST = 4  # line of the first segment


def close(a, b, scale=1.0):
    return math.hypot(a[0] - b[0], a[1] - b[1]) <= TOLERANCE * scale


class Corner:
    """The corner between two segments, in doubles."""

    def __init__(self, a, b, rho):
        self.point = tuple(x / UNIT for x in a.end)
        self.t1, self.t2 = a.tangent(a.end), b.tangent(b.start)
        self.cross = self.t1[0] * self.t2[1] - self.t1[1] * self.t2[0]
        self.dot = self.t1[0] * self.t2[0] + self.t1[1] * self.t2[1]
        self.turn = abs(math.atan2(self.cross, self.dot))
        self.rho = rho
        self.inner = rho * self.cross > 0
        self.a, self.b = a, b

    def perpendicular(self, t):
        return self.point[0] - self.rho * t[1], self.point[1] + self.rho * t[0]

    def outer_heads(self):
        """FANUC's vectors of an outer corner."""
        p1, p2 = self.perpendicular(self.t1), self.perpendicular(self.t2)
        r = abs(self.rho)
        if self.dot >= 0:
            middle = [self.point[i] + (p1[i] + p2[i] - 2 * self.point[i]) / (1 + self.dot) for i in (0, 1)]
            heads = [middle]
        else:
            heads = [
                [p1[i] + r * self.t1[i] for i in (0, 1)],
                [p2[i] - r * self.t2[i] for i in (0, 1)],
            ]
        return ([p1] if self.a.center else []) + heads + ([p2] if self.b.center else [])


class Unexplained(Exception):
    pass


def expect(fact, what):
    if not fact:
        raise Unexplained(what)


def own_and_inserted(moves, line):
    """Moves of LinuxCNC on a line: the arc put in before the block's own move, if any, and that move."""
    here = [m for m in moves if m[0] == line]
    expect(1 <= len(here) <= 2, f"{len(here)} moves of rs274 on line {line}")
    return (here[0] if len(here) == 2 else None), here[-1]


def heads_of(events, line):
    """The heads of the corner at the end of the block on `line`."""
    own = [e for e in events if e["kind"] == "move" and e["line"] == line and e["cause"] in ("programmed", "start-up")]
    expect(len(own) == 1, f"{len(own)} own moves on line {line}")
    inserted = [e for e in events if e["kind"] == "move" and e["line"] == line + 1 and e["cause"] == "corner"]
    return [(e["point"]["X"], e["point"]["Y"]) for e in own + inserted]


def small(segment, corner):
    """Whether a circle inside the arc with the tool's offset is none, or just none."""
    if segment.center is None:
        return False
    inward = segment.ccw == (corner.rho > 0)
    return inward and segment.radius() <= abs(corner.rho) * (1 + 1e-12)


def compare(case, theirs, events, count):
    """Block by block up to the first refusal; counts agreements and explained differences."""
    alarm = next((e for e in events if e["kind"] != "move"), None)
    segments = case.segments
    corners = [Corner(a, b, case.rho()) for a, b in zip(segments, segments[1:])]
    scale = 1 + max(abs(x) / UNIT for s in segments for x in s.end)
    # rs274 stops on reading the block after the one it cannot run.
    their_end = theirs["line"] - FIRST - 1 if theirs["error"] else len(segments)
    our_end = alarm["line"] - FIRST if alarm else len(segments)
    for i in range(min(their_end, our_end, len(segments))):
        arc, own = own_and_inserted(theirs["moves"], FIRST + i)
        heads = heads_of(events, FIRST + i)
        if i == len(segments) - 1:
            expect(close(heads[0], own[2:4], scale), f"last vector: {heads[0]} and {own[2:4]}")
            count["agree: vector before the cancel"] += 1
            break
        corner = corners[i]
        p1, p2 = corner.perpendicular(corner.t1), corner.perpendicular(corner.t2)
        next_arc = [m for m in theirs["moves"] if m[0] == FIRST + i + 1 and m[1] == "arc"]
        if corner.turn < NEARLY_STRAIGHT:
            expect(close(own[2:4], p1, scale), f"nearly straight corner {i}: rs274 does not end perpendicular")
            exact = corner.turn == 0 or close(heads[0], own[2:4], scale)
            count["agree: straight on" if exact else "known: corner below 0.05 rad is straight on for LinuxCNC"] += 1
        elif corner.inner:
            if len(heads) == 1 and close(heads[0], own[2:4], scale):
                count["agree: inner corner"] += 1
            elif alarm and our_end == i + 1:
                count["agree: inner corner before an alarm"] += 1
            else:
                expect(False, f"inner corner {i}: {heads} and {own[2:4]}")
        else:
            expect(close(own[2:4], p1, scale), f"outer corner {i}: rs274's arc does not start perpendicular")
            if their_end > i + 1:
                expect(len(next_arc) >= 1, f"outer corner {i}: no arc of rs274")
                expect(close(next_arc[0][4:6], corner.point, scale), f"outer corner {i}: centre of rs274's arc")
                expect(close(next_arc[0][2:4], p2, scale), f"outer corner {i}: end of rs274's arc")
            expected = corner.outer_heads()
            if len(heads) == len(expected) and all(close(h, e, scale) for h, e in zip(heads, expected)):
                count["known: outer corner, arc there, vectors here"] += 1
            else:
                count["?outer"] += 1
    return alarm, their_end, our_end, corners


def classify_end(case, theirs, alarm, their_end, our_end, corners, count):
    error = theirs["error"]
    if not error and not alarm:
        count["agree: both run to the end"] += 1
        return
    count[f"end: {alarm['number'] if alarm else 'runs'} / {error or 'runs'} / {their_end - our_end if error and alarm else ''}"] += 1


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--toolcomp", required=True)
    parser.add_argument("--engine", default="model", choices=["model", "fast"])
    parser.add_argument("--contours", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    start = lambda command: subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    ours = start([options.toolcomp, "serve", "--engine", options.engine])
    peer = start(["/usr/bin/python3", str(Path(__file__).with_name("rs274_canon.py"))])

    def ask(process, question):
        process.stdin.write(json.dumps(question) + "\n")
        process.stdin.flush()
        return json.loads(process.stdout.readline())

    count = collections.Counter()
    findings = 0
    for k in range(options.contours):
        case = Case(k, random.Random(f"{options.seed} {k}"))
        if len(case.segments) < 2:
            continue
        theirs = ask(peer, {"id": k, "program": case.program(True)})
        setup = {"control": "fanuc", "axes": ["X", "Y", "Z"], "offsets": {"D": {"1": str(float(case.radius))}}}
        events = ask(ours, {"case": 1, "id": str(k), "dialect": "fanuc", "section": "fanuc/cutter-compensation-c",
                            "setup": setup, "program": case.program(False)})["events"]
        try:
            classify_end(case, theirs, *compare(case, theirs, events, count), count)
        except Unexplained as what:
            findings += 1
            print(f"contour {k}: {what}\n{case.program(False)}{case.program(True)}rs274: {theirs['error']}\n", file=sys.stderr)
    for what, n in sorted(count.items()):
        print(f"{n:8} {what}")
    print(f"seed {options.seed}; {options.contours} contours; {findings} unexplained")
    return 1 if findings else 0


sys.exit(main())
