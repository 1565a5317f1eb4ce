# SPDX-License-Identifier: Apache-2.0
"""Lines, arcs and corners of a contour in doubles. Coordinates of segments are whole millionths."""
import math

UNIT = 10**6


class Segment:
    """A line, or an arc about `center`."""

    def __init__(self, start, end, center=None, ccw=None):
        self.start, self.end, self.center, self.ccw = start, end, center, ccw

    def tangent(self, point):
        """Unit tangent at an end."""
        if self.center is None:
            v = (self.end[0] - self.start[0], self.end[1] - self.start[1])
        else:
            r = (point[0] - self.center[0], point[1] - self.center[1])
            v = (-r[1], r[0]) if self.ccw else (r[1], -r[0])
        length = math.hypot(*v)
        return v[0] / length, v[1] / length

    def middle(self):
        return self.center[0] / UNIT, self.center[1] / UNIT

    def radius(self):
        return math.hypot(self.end[0] - self.center[0], self.end[1] - self.center[1]) / UNIT

    def offset_radius(self, rho):
        """R' = R - sigma rho; negative where the tool does not fit."""
        return self.radius() - (rho if self.ccw else -rho)


def plus(p, k, v):
    return p[0] + k * v[0], p[1] + k * v[1]


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def left(t):
    return -t[1], t[0]


def sweep(segment, start, end, center):
    """Angle from start to end about center in the segment's sense, in (0, 2 pi]."""
    a, b = minus(start, center), minus(end, center)
    if not segment.ccw:
        a, b = b, a
    angle = math.atan2(cross(a, b), dot(a, b))
    return angle if angle > 1e-12 else angle + 2 * math.pi


class Corner:
    """Between segments a and b, the tool at rho to the left."""

    def __init__(self, a, b, rho):
        self.a, self.b, self.rho = a, b, rho
        self.point = a.end[0] / UNIT, a.end[1] / UNIT
        self.t1, self.t2 = a.tangent(a.end), b.tangent(b.start)
        self.turn = math.atan2(cross(self.t1, self.t2), dot(self.t1, self.t2))  # to the left
        self.straight = abs(self.turn) < 1e-12
        self.inner = not self.straight and rho * self.turn > 0
        self.p1 = plus(self.point, rho, left(self.t1))
        self.p2 = plus(self.point, rho, left(self.t2))

    def intersection(self):
        """Of the two offset paths, the point that tends to the corner with rho; None if they do not meet."""
        a_arc, b_arc = self.a.center is not None, self.b.center is not None
        if a_arc and b_arc:
            return self._circles()
        if a_arc:
            return self._line_and_circle(self.t2, self.p2, self.a)
        if b_arc:
            return self._line_and_circle(self.t1, self.p1, self.b)
        n = minus(plus((0, 0), 1, left(self.t1)), plus((0, 0), -1, left(self.t2)))
        return plus(self.point, self.rho / (1 + dot(self.t1, self.t2)), n)

    def _line_and_circle(self, t, on_line, arc):
        to_center = minus(arc.middle(), self.point)
        h = dot(to_center, left(t)) - self.rho
        s0 = dot(to_center, t)
        square = arc.offset_radius(self.rho) ** 2 - h * h
        if square < 0:
            return None
        return plus(on_line, s0 - math.copysign(math.sqrt(square), s0), t)

    def _circles(self):
        o1, o2 = self.a.middle(), self.b.middle()
        r1, r2 = self.a.offset_radius(self.rho), self.b.offset_radius(self.rho)
        e = minus(o2, o1)
        distance = math.hypot(*e)
        if distance == 0:
            return None
        along = (r1 * r1 - r2 * r2 + distance * distance) / (2 * distance)
        square = r1 * r1 - along * along
        if square < 0:
            return None
        u = e[0] / distance, e[1] / distance
        side = math.copysign(1, cross(u, minus(self.point, o1)))
        return plus(plus(o1, along, u), side * math.sqrt(square), left(u))
