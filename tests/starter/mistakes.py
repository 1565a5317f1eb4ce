# SPDX-License-Identifier: Apache-2.0
"""Controllers with one mistake each: the right one with one rule replaced. MISTAKES: the words by which a vector that finds
the mistake names it, and the controller."""

import math

from right import Right, moved, turned


class WrongSide(Right):
    def side(self, code):
        return -super().side(code)


class InsideForOutside(Right):
    def corner(self, move, following):
        a, b = move.direction(True), following.direction(False)
        ahead = a[0] * b[0] + a[1] * b[1]
        return super().corner(move, following) if ahead <= -1 else [moved(move.end, (move.r / (1 + ahead), turned(a)), (move.r / (1 + ahead), turned(b)))]


class NoStartUp(Right):
    def start_up(self, move, following, type_b):
        return [move.end]


class DiameterForRadius(Right):
    def radius(self, value):
        return value / 2


class G49Kept(Right):
    def length(self, code, h, before, settings):
        return before if code == 49 else super().length(code, h, before, settings)


class DegreesForRadians(Right):
    def tool(self, b, c):
        return super().tool(math.degrees(b), math.degrees(c))


class H0Ignored(Right):
    def length(self, code, h, before, settings):
        return before if h == 0 and code != 49 else super().length(code, h, before, settings)


class CenterOffset(Right):
    """An arc with its radius about a center that is moved: its end moves as its start does."""

    def perpendicular(self, move, at_end, r):
        return moved(move.end, (r, turned(move.direction(False)))) if at_end else super().perpendicular(move, at_end, r)


class CancelWithoutMoveBack(Right):
    def cancel(self, move, r_before):
        return [self.perpendicular(move, True, r_before)]


class InterferenceNotNoticed(Right):
    def interferes(self, move, here, there):
        return False


class SignDropped(Right):
    def radius(self, value):
        return abs(value)


class LengthsAddUp(Right):
    def run(self, program, settings):
        self.last = None
        return super().run(program, settings)

    def length(self, code, h, before, settings):
        if (code, h) == self.last:
            return before
        self.last = code, h
        return super().length(code, h, before, settings) + (before if code != 49 and h else 0)


class TypeAForTypeB(Right):
    def start_up(self, move, following, type_b):
        return super().start_up(move, following, False)

    def before_cancel(self, move, cancel, type_b):
        return super().before_cancel(move, cancel, False)


class TieForInterference(Right):
    """An exact tie decided as an interference."""

    def interferes(self, move, here, there):
        return super().interferes(move, here, there) or math.dist(here, there) < 1e-9


class NotANumber(Right):
    """What a controller answers that divides by 0 everywhere."""

    def put(self, move, point, rest, offset):
        self.points.append([math.nan] * len(self.settings["axes"]))


MISTAKES = {
    "wrong side": WrongSide,
    "inside rule for outside": InsideForOutside,
    "missing start-up": NoStartUp,
    "diameter": DiameterForRadius,
    "g49 kept": G49Kept,
    "degrees taken for radians": DegreesForRadians,
    "h0 ignored": H0Ignored,
    "center is offset instead of its radius": CenterOffset,
    "cancel without move back": CancelWithoutMoveBack,
    "interference not noticed": InterferenceNotNoticed,
    "sign of the offset is dropped": SignDropped,
    "add up": LengthsAddUp,
    "type a where type b is set": TypeAForTypeB,
    "exact tie is taken for an interference": TieForInterference,
}
