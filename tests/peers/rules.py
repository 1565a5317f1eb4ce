# SPDX-License-Identifier: Apache-2.0
"""What FANUC's compensation C and LinuxCNC's compensation make of a contour, each by its own published rules, in doubles.

The contour starts with a line that the lead-in meets straight on; start-up and cancel are of type A.
"""
import math
from collections import namedtuple

from geometry import UNIT, Corner, dot, minus, plus, sweep

NEARLY_STRAIGHT = 0.05  # rad, LinuxCNC's
TIE = 1e-9  # decisions nearer than this to their boundary are left open here
GROWTH = 0.001  # rad an arc may grow by, LinuxCNC's

# heads: for each block that is run, the points at its end in order. stop: the block that is refused, or None; why: the
# alarm. open: a decision that doubles cannot make, or None.
Result = namedtuple("Result", "heads stop why open")


def group(corner):
    """FANUC's heads at a corner, or the alarm."""
    c, r = corner, abs(corner.rho)
    if c.straight:
        return [c.p1], None
    if c.inner:
        arcs = [s for s in (c.a, c.b) if s.center is not None]
        if any(s.offset_radius(c.rho) < 0 for s in arcs):
            return [c.p1], None
        point = c.intersection()
        return ([point], None) if point else (None, "PS0033")
    k = dot(c.t1, c.t2)
    if k >= 0:
        middle = [plus(c.point, 1 / (1 + k), minus(minus(c.p1, c.point), minus(c.point, c.p2)))]
    else:
        middle = [plus(c.p1, r, c.t1), plus(c.p2, -r, c.t2)]
    return ([c.p1] if c.a.center else []) + middle + ([c.p2] if c.b.center else []), None


def interferes(segment, rho, v, w, first):
    """Whether the block from head v to head w goes wrong, and how near that is to its boundary."""
    if segment.center is not None and first:
        radius = segment.offset_radius(rho)
        if radius < 0:
            return True, -radius
        start, end = (tuple(x / UNIT for x in p) for p in (segment.start, segment.end))
        if radius == 0:
            return False, 1
        more = abs(sweep(segment, v, w, segment.middle()) - sweep(segment, start, end, segment.middle())) - math.pi
        return more > 0, min(abs(more), radius)
    d = tuple((segment.end[i] - segment.start[i]) / UNIT for i in (0, 1))
    product = dot(d, minus(w, v))
    scale = math.hypot(*d) * (1 + math.hypot(*minus(w, v)))
    return product < 0, abs(product) / scale


def fanuc(segments, rho):
    first = segments[0].tangent(segments[0].start)
    before = [plus(tuple(x / UNIT for x in segments[0].start), rho, (-first[1], first[0]))]
    heads = []
    for i, segment in enumerate(segments):
        if i + 1 < len(segments):
            after, alarm = group(Corner(segment, segments[i + 1], rho))
            if alarm:
                return Result(heads, i, alarm, None)
        else:
            t = segment.tangent(segment.end)
            after = [plus(tuple(x / UNIT for x in segment.end), rho, (-t[1], t[0]))]
        v, w = before, after
        pairs = max(len(v), len(w))
        for q in range(pairs):
            last_v, last_w = v[max(len(v) - 1 - q, 0)], w[min(q, len(w) - 1)]
            bad, margin = interferes(segment, rho, last_v, last_w, q == 0)
            if margin < TIE:
                return Result(heads, None, None, i)
            if not bad:
                # What lay nearer is gone, but a corner keeps its outermost vector.
                before, after = v[: max(len(v) - q, 1)], w[min(q, len(w) - 1):]
                break
        else:
            return Result(heads, i, "PS0041", None)
        if heads:
            heads[-1] = before
        heads.append(after)
        before = after
    return Result(heads, None, None, None)


class LeadIn:
    """What lies before the first segment: the lead-in, in its direction."""

    center = None

    def __init__(self, segment):
        self.end = segment.start
        self._t = segment.tangent(segment.start)

    def tangent(self, _):
        return self._t


def linuxcnc(segments, rho):
    """One head a block, where its own move ends; after an outer corner an arc about the corner follows."""
    r = abs(rho)
    heads = []
    first = Corner(LeadIn(segments[0]), segments[0], rho).p2
    start = first
    for i, segment in enumerate(segments):
        after = segments[i + 1] if i + 1 < len(segments) else None
        corner = Corner(segment, after, rho) if after else None
        next_start = None
        if after is None:
            t = segment.tangent(segment.end)
            end = plus(tuple(x / UNIT for x in segment.end), rho, (-t[1], t[0]))
        else:
            if after.center is not None and after.ccw == (rho > 0):
                if abs(after.radius() - r) < TIE:
                    return Result(heads, None, None, i)
                if after.radius() <= r:
                    return Result(heads, i, "Tool radius not less than arc radius", None)
            if abs(abs(corner.turn) - NEARLY_STRAIGHT) < TIE:
                return Result(heads, None, None, i)
            if abs(corner.turn) < NEARLY_STRAIGHT:
                end = next_start = corner.p1
            elif not corner.inner:
                end, next_start = corner.p1, corner.p2
            else:
                end = next_start = corner.intersection()
                if end is None:
                    fits = segment.center is None and after.center is not None
                    return Result(heads, i, "Arc move in concave corner" if fits
                                  else "makes a corner the compensated tool can't fit in", None)
        nearly_straight = corner is not None and abs(corner.turn) < NEARLY_STRAIGHT
        rounded = corner is not None and not nearly_straight and not corner.inner
        # It looks at a move before every line, and before an arc at inner corners.
        looks = not nearly_straight and not (rounded and after.center is not None)
        if looks and segment.center is not None:
            ends = (tuple(x / UNIT for x in p) for p in (segment.start, segment.end))
            growth = sweep(segment, start, end, segment.middle()) - sweep(segment, *ends, segment.middle()) - GROWTH
            if abs(growth) < TIE:
                return Result(heads, None, None, i)
            if growth > 0:
                return Result(heads, i, "Arc move in concave corner", None)
        elif looks:
            product = dot(segment.tangent(segment.end), minus(end, start))
            if abs(product) < TIE:
                return Result(heads, None, None, i)
            if product < 0:
                return Result(heads, i, "Straight feed in concave corner", None)
        heads.append([end])
        start = next_start
    return Result(heads, None, None, None)
