#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Random contours through toolcomp and through LinuxCNC's rs274: inner corners must agree to 1e-9, and every other
difference must be one that is known.

contours.py --toolcomp build/release/toolcomp [--engine model] [--contours 1000] [--seed 1]

Known differences: LinuxCNC rounds outer corners with an arc where FANUC's compensation C has one or two vectors;
corners below 0.05 rad are straight on for LinuxCNC; the two refuse different things. None is taken on trust: what each
must give is computed from the geometry alone (rules.py), and toolcomp and rs274 are each held to their own rules.
Exit status 1 if anything is unexplained.
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

import rules
from geometry import UNIT, Corner, Segment

TOLERANCE = 1e-9  # both are doubles through acos, asin, atan2, sin and cos; relative beyond 1
# Cosine, sine and denominator of turns after which decimals are decimals still.
TURNS = [(3, 4, 5), (4, 3, 5), (24, 7, 25), (7, 24, 25), (0, 1, 1), (-3, 4, 5), (-4, 3, 5), (-1, 0, 1), (-3, -4, 5)]
FIRST = 4  # line of the first segment


def number(millionths):
    sign = "-" if millionths < 0 else ""
    return f"{sign}{abs(millionths) // UNIT}.{abs(millionths) % UNIT:06}"


def words(segment):
    text = f"X{number(segment.end[0])} Y{number(segment.end[1])}"
    if segment.center is None:
        return "G1 " + text
    i, j = segment.center[0] - segment.start[0], segment.center[1] - segment.start[1]
    return f"{'G3' if segment.ccw else 'G2'} {text} I{number(i)} J{number(j)}"


def straight_on(direction, length):
    """A whole multiple of the shortest vector of this direction, about `length` long."""
    g = math.gcd(direction[0], direction[1])
    step = direction[0] // g, direction[1] // g
    k = max(1, round(length * UNIT / math.hypot(*step)))
    return k * step[0], k * step[1]


def turned(direction, angle, length):
    """In whole thousandths."""
    a = math.atan2(direction[1], direction[0]) + angle
    return tuple(round(length * 1000 * f) * (UNIT // 1000) for f in (math.cos(a), math.sin(a)))


def rotated(v, turn):
    c, s, n = turn
    x, y = c * v[0] - s * v[1], s * v[0] + c * v[1]
    assert x % n == 0 and y % n == 0
    return x // n, y // n


def contour(rng):
    """Lines and arcs with corners of every kind, exactly straight on among them; a line first."""
    size = 6 if rng.random() < 0.15 else 40  # small ones for alarms
    at, direction = (0, 0), (UNIT, 0)
    segments = []
    for i in range(rng.randint(3, 8)):
        corner, kind, short = rng.random(), rng.random(), rng.uniform(0.15, 0.6) * size
        long = rng.uniform(0.2, 1) * size
        angle = rng.uniform(-0.06, 0.06) if corner < 0.3 else rng.uniform(-2.6, 2.6)
        tangent = i == 0 or corner < 0.15
        if kind < 0.55 or i == 0:
            v = straight_on(direction, long) if tangent else turned(direction, angle, long)
            if v != (0, 0):
                segments.append(Segment(at, (at[0] + v[0], at[1] + v[1])))
                at, direction = segments[-1].end, v
            continue
        # The radius is a multiple of 25, so that fifths and twenty-fifths of it are whole.
        v = tuple(25 * x for x in straight_on(direction, short / 25)) if tangent else turned(direction, angle, short)
        if v == (0, 0):
            continue
        ccw = rng.random() < 0.5
        radial = (v[1], -v[0]) if ccw else (-v[1], v[0])
        center = (at[0] - radial[0], at[1] - radial[1])
        c, s, n = rng.choice(TURNS)
        end = rotated(radial, (c, s if ccw else -s, n))
        segments.append(Segment(at, (center[0] + end[0], center[1] + end[1]), center, ccw))
        at = segments[-1].end
        direction = (-end[1], end[0]) if ccw else (end[1], -end[0])
    return segments


class Case:
    def __init__(self, rng):
        self.segments = contour(rng)
        self.left = rng.random() < 0.5
        self.radius = Fraction(rng.randint(10, 60), 10)
        self.rho = float(self.radius) * (1 if self.left else -1)
        self.size = 1 + max(abs(x) / UNIT for s in self.segments for x in s.end)

    def program(self, linuxcnc):
        """Segment k stands on line FIRST + k for both."""
        first, last = self.segments[0], self.segments[-1]
        lead = straight_on((first.end[0] - first.start[0], first.end[1] - first.start[1]), 25)
        side = ("G41" if self.left else "G42") + (f".1 D{float(2 * self.radius)}" if linuxcnc else " D1")
        tangent = last.tangent(last.end)
        end = [last.end[i] + round(tangent[i] * 25) * UNIT for i in (0, 1)]
        lines = [
            ("G20 " if linuxcnc else "") + "G17 G90 G40",
            f"G0 X{number(first.start[0] - lead[0])} Y{number(first.start[1] - lead[1])}",
            f"G1 {side} X{number(first.start[0])} Y{number(first.start[1])} F1000",
            *(words(s) for s in self.segments),
            f"G1 G40 X{number(end[0])} Y{number(end[1])}",
            "M2",
        ]
        return "\n".join(lines) + "\n"

    def question(self, name):
        setup = {"control": "fanuc", "axes": ["X", "Y", "Z"], "offsets": {"D": {"1": str(float(self.radius))}}}
        return {"case": 1, "id": str(name), "dialect": "fanuc", "section": "fanuc/cutter-compensation-c",
                "setup": setup, "program": self.program(False)}


class Unexplained(Exception):
    pass


def expect(fact, what):
    if not fact:
        raise Unexplained(what)


def close(case, a, b):
    return math.hypot(a[0] - b[0], a[1] - b[1]) <= TOLERANCE * case.size


def our_heads(events, block):
    """The points at the end of a block, and whether the block has run."""
    moves = [e for e in events if e["kind"] == "move"]
    own = [e for e in moves if e["line"] == FIRST + block and e["cause"] == "programmed"]
    after = [e for e in moves if e["line"] == FIRST + block + 1 and e["cause"] == "corner"]
    return [(e["point"]["X"], e["point"]["Y"]) for e in own + after], len(own) == 1


def hold_us(case, events):
    """toolcomp against FANUC's rules; how many blocks were compared, and the expected result."""
    expected = rules.fanuc(case.segments, case.rho)
    alarm = next((e for e in events if e["kind"] == "alarm"), None)
    expect(all(e["kind"] in ("move", "alarm") for e in events), "an event that is neither move nor alarm")
    for i, heads in enumerate(expected.heads):
        if expected.open is not None and i + 1 >= expected.open:
            return i, expected
        given, runs = our_heads(events, i)
        if expected.stop is not None and i + 1 == expected.stop:
            heads = heads[:1]  # the corner's other moves belong to the block at fault
        expect(runs and len(given) == len(heads) and all(close(case, a, b) for a, b in zip(given, heads)),
               f"toolcomp, block {i}: {given}, by the rules {heads}")
    if expected.open is not None:
        return max(expected.open - 1, 0), expected
    if expected.stop is None:
        expect(alarm is None, f"toolcomp stops: {alarm}")
    else:
        expect(alarm is not None and alarm["number"] == expected.why and alarm["line"] == FIRST + expected.stop,
               f"toolcomp: {alarm}, by the rules {expected.why} on line {FIRST + expected.stop}")
    return len(expected.heads), expected


def hold_them(case, answer):
    """rs274 against LinuxCNC's rules."""
    expected = rules.linuxcnc(case.segments, case.rho)
    for i, heads in enumerate(expected.heads):
        if expected.open is not None and i >= expected.open:
            return i, expected
        moves = [m for m in answer["moves"] if m[0] == FIRST + i]
        expect(moves and close(case, moves[-1][2:4], heads[0]), f"rs274, block {i}: {moves}, by the rules {heads}")
        if i > 0:
            corner = Corner(case.segments[i - 1], case.segments[i], case.rho)
            if abs(corner.turn) >= rules.NEARLY_STRAIGHT and not corner.inner:
                expect(len(moves) == 2 and moves[0][1] == "arc" and close(case, moves[0][4:6], corner.point) and
                       close(case, moves[0][2:4], corner.p2), f"rs274, block {i}: {moves}, no arc about the corner")
            else:
                expect(len(moves) == 1, f"rs274, block {i}: {moves}")
    if expected.open is not None:
        return expected.open, expected
    if expected.stop is None:
        expect(answer["error"] is None, f"rs274 stops: {answer['error']}")
    else:
        # It refuses a block on reading the one after it.
        expect(answer["error"] is not None and expected.why in answer["error"] and
               answer["line"] == FIRST + expected.stop + 1,
               f"rs274: {answer['error']} on line {answer['line']}, by the rules {expected.why} in block {expected.stop}")
    return len(expected.heads), expected


def compare(case, answer, events, count):
    """Corner by corner as far as both run."""
    ours, our_rules = hold_us(case, events)
    theirs, their_rules = hold_them(case, answer)
    for i in range(min(ours, theirs)):
        heads, _ = our_heads(events, i)
        point = [m for m in answer["moves"] if m[0] == FIRST + i][-1][2:4]
        same = len(heads) == 1 and close(case, heads[0], point)
        if i + 1 == len(case.segments):
            expect(same, f"before the cancel: {heads} and {point}")
            count["agree: the vector before the cancel"] += 1
            continue
        corner = Corner(case.segments[i], case.segments[i + 1], case.rho)
        dropped = i + 1 != our_rules.stop and len(heads) < len(rules.group(corner)[0])
        if corner.straight:
            expect(same or dropped, f"straight corner {i}: {heads} and {point}")
            count["agree: straight on"] += 1
        elif abs(corner.turn) < rules.NEARLY_STRAIGHT:
            count["known: below 0.05 rad LinuxCNC goes straight on"] += 1
        elif not corner.inner:
            count["known: outer corner, an arc there, vectors here"] += 1
        elif any(s.center is not None and s.offset_radius(case.rho) < 0 for s in (corner.a, corner.b)):
            count["known: beside an arc too small for the tool"] += 1
        else:
            expect(same, f"inner corner {i}: {heads} and {point}")
            count["agree: inner corner"] += 1
    if our_rules.open is not None or their_rules.open is not None:
        count["open: a decision on its boundary"] += 1
    elif our_rules.stop is None and their_rules.stop is None:
        count["agree: both run to the end"] += 1
    elif our_rules.stop == their_rules.stop:
        count["agree: both refuse the same block"] += 1
    else:
        count[f"known: refused, here {our_rules.why or 'nothing'}, there {their_rules.why or 'nothing'}"] += 1


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--toolcomp", required=True)
    parser.add_argument("--engine", default="model", choices=["model", "fast"])
    parser.add_argument("--contours", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()

    def start(command):
        return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(process, question):
        process.stdin.write(json.dumps(question) + "\n")
        process.stdin.flush()
        return json.loads(process.stdout.readline())

    ours = start([options.toolcomp, "serve", "--engine", options.engine])
    peer = start(["/usr/bin/python3", str(Path(__file__).with_name("rs274_canon.py"))])
    count = collections.Counter()
    findings = 0
    for k in range(options.contours):
        case = Case(random.Random(f"{options.seed} {k}"))
        answer = ask(peer, {"id": k, "program": case.program(True)})
        events = ask(ours, case.question(k))["events"]
        try:
            compare(case, answer, events, count)
        except Unexplained as what:
            findings += 1
            print(f"contour {k}: {what}\n{case.program(False)}", file=sys.stderr)
    for what, n in sorted(count.items()):
        print(f"{n:8} {what}")
    print(f"{options.engine}: seed {options.seed}, {options.contours} contours, {findings} unexplained")
    return 1 if findings else 0


sys.exit(main())
