# SPDX-License-Identifier: Apache-2.0
"""FANUC programs as LinuxCNC reads them, line for line: line k of a program is line k + PREAMBLE of its translation."""
import re
from dataclasses import dataclass

from machine import MAX, OF_CUTTER, OF_LENGTH, Machine, NotApplicable, check_parameter, decimal, machine_of, unit_of

PREAMBLE = 13  # lines in front of a program
FEED = "30000"  # of every F: time is real there, and no position depends on it
WORD = re.compile(r"([A-Z])\s*([+-]?(?:\d+\.?\d*|\.\d+))\s*")
# G codes that mean the same. G43.4 has no code there: the kinematics is always in force, G43 gives it the tool length.
SAME = {"0", "1", "2", "3", "17", "18", "19", "20", "21", "40", "41", "42", "43", "49", "80", "90", "91", "94"}
SYSTEMS = {"54", "55", "56", "57", "58", "59"}
TIP = "43.4"
IGNORED_M = {"3", "4", "5", "8", "9"}
AXES = "XYZABCUVW"
# Codes of which LinuxCNC refuses two in a block; on FANUC the last one counts.
GROUPS = [{"0", "1", "2", "3", "80"}, {"17", "18", "19"}, {"20", "21"}, {"40", "41", "42"}, {"43", "49", TIP}, {"90", "91"}, SYSTEMS]
PLANES = {"17": "XY", "18": "ZX", "19": "YZ"}


def plain(text):
    """A number of a program without zeros that say nothing."""
    value = decimal(text)
    return str(value.numerator) if value.denominator == 1 else f"{float(value):.12g}"


def fixed(value):
    return f"{float(decimal(value)):.12f}".rstrip("0").rstrip(".")


def words_of(line, number, skip):
    """(letter, number as text) of a block; NotApplicable for what is no word. `skip`: of blocks with / nothing."""
    text = re.sub(r"\([^)]*\)", " ", line.split(";")[0]).strip().upper()
    if text.startswith("/"):
        if skip:
            return []
        text = text[1:]
    if not text or text == "%" or re.fullmatch(r"[O:]\d+", text):
        return []
    words, at = [], 0
    while at < len(text):
        match = WORD.match(text, at)
        if not match:
            raise NotApplicable(f"line {number}: {text[at:at + 20]}")
        if match[1] == "N" and not match[2].isdigit():
            raise NotApplicable(f"line {number}: N{match[2]}")
        words.append((match[1], match[2]))
        at = match.end()
    return [word for word in words if word[0] != "N"]


class Translation:
    """One program. `compensate`: with cutter compensation, or along the path as programmed."""

    def __init__(self, setup, module, compensate=True):
        self.module = module
        self.axes = setup.get("axes", ["X", "Y", "Z"])
        self.kinematics = not module.name.startswith("trivkins")
        self.in_tip = False
        self.compensate = compensate
        self.skip = setup.get("block_skip", False)
        self.sides = {}  # line → 1 left, -1 right: blocks in cutter compensation
        self.starts = []  # lines of G41 and G42
        self.cancels = []  # lines of G40 without a word of the plane
        self.in_plane = set()  # lines with a word of the plane
        self.lengths = []  # lines where the length offset may change, and whether LinuxCNC makes the move of it
        self.absolute_z = []  # lines
        self.moving = set()  # lines with an axis word
        self.systems = {54}  # workpiece systems in use
        self.incremental = False
        self.most = int(setup.get("offsets", {}).get("count", 400))
        self.offsets = {kind: setup.get("offsets", {}).get(kind, {}) for kind in "HD"}
        self.numbers = {"H": None, "D": None}  # in force
        self.used = {"H": set(), "D": set()}
        self.compensating = 0  # side
        self.length_on = False
        self.plane = "17"
        self.rests = 0.0  # s
        self.ended = False
        self.cuts = False  # G01, G02 or G03 is in force
        self.arc = False  # G02 or G03 is
        self.at = {axis: decimal(value) for axis, value in setup.get("position", {}).items()}  # as programmed
        self.feed = bool(decimal(setup.get("parameters", {}).get("1411", 0)))  # at power-on

    def line(self, text, number):
        if self.ended:
            return ""
        words = words_of(text, number, self.skip)
        if any(letter in AXES for letter, _ in words):
            self.moving.add(number)
        letters = {letter for letter, _ in words}
        codes = [plain(value) for letter, value in words if letter == "G"]
        if "4" in codes:
            return self.rest(dict(words), number)
        self.follow_feed(words, codes, letters, number)
        turned = self.is_turned()
        moves = self.follow_positions(words, codes)
        self.check_block(words, codes, letters, moves, number)
        if self.kinematics:
            self.follow_rotary(codes, turned, number)
        for kind in "HD":
            for letter, value in words:
                if letter == kind:
                    self.take_number(kind, value, codes, number)
        self.systems |= {int(code) for code in codes if code in SYSTEMS}
        if "90" in codes or "91" in codes:
            self.incremental = "91" in codes
        if "Z" in letters and not self.incremental:
            self.absolute_z.append(number)
        out = [self.word(letter, value, number) for letter, value in words if letter not in "HD"]
        if {"41", "42"} & set(codes):
            self.plane = next((c for c in codes if c in ("17", "18", "19")), self.plane)
            if self.plane == "19":
                raise NotApplicable(f"line {number}: cutter compensation in G19")
            value = self.number_in_force("D", number)
            out.append("D" + value if self.compensate else "")
            self.compensating = 1 if "41" in codes else -1
            self.starts.append(number)
        elif plane := next((c for c in codes if c in ("17", "18", "19")), None):
            self.plane = plane
        if letters & set(PLANES[self.plane]):
            self.in_plane.add(number)
        if "40" in codes:
            if self.compensating and number not in self.in_plane:
                self.cancels.append(number)
            self.compensating = 0
        if self.compensating:
            self.sides[number] = self.compensating
        changes = self.length_on and any(letter == "H" for letter, _ in words) and "49" not in codes
        if {"43", TIP} & set(codes) or changes:
            if changes and not {"43", TIP} & set(codes):
                out.append("G43")
            out.append("H" + self.number_in_force("H", number))
            self.length_on = True
            self.lengths.append((number, "Z" in letters and not self.incremental))
        if "49" in codes:
            if self.length_on:
                self.lengths.append((number, "Z" in letters and not self.incremental))
            self.length_on = False
        return " ".join(word for word in out if word)

    def follow_feed(self, words, codes, letters, number):
        """FANUC refuses a cutting move without a feed (PS0011); the interpreter alone does not look at it."""
        self.cuts = next((code != "0" for code in codes if code in ("0", "1", "2", "3")), self.cuts)
        self.feed = next((bool(decimal(value)) for letter, value in words if letter == "F"), self.feed)
        if self.cuts and not self.feed and letters & set(AXES):
            raise NotApplicable(f"line {number}: a cutting move without F")

    def is_turned(self):
        return any(self.at.get(axis) for axis in "ABC")

    def follow_positions(self, words, codes):
        """Whether the block ends elsewhere than it starts."""
        incremental = "91" in codes or self.incremental and "90" not in codes
        before = dict(self.at)
        for letter, value in words:
            if letter in AXES:
                self.at[letter] = decimal(value) + (self.at.get(letter, 0) if incremental else 0)
        return any(end != before.get(axis, 0) for axis, end in self.at.items())

    def check_block(self, words, codes, letters, moves, number):
        """What LinuxCNC refuses and FANUC runs: two codes of one group, a letter twice, an arc by R that ends in its start."""
        if any(sum(code in group for code in codes) > 1 for group in GROUPS):
            raise NotApplicable(f"line {number}: two G codes of one group")
        if sum(letter not in "GM" for letter, _ in words) > len(letters - set("GM")):
            raise NotApplicable(f"line {number}: a letter twice")
        self.arc = next((code in ("2", "3") for code in codes if code in GROUPS[0]), self.arc)
        if self.arc and "R" in letters and letters & set("XYZ") and not moves:
            raise NotApplicable(f"line {number}: an arc by R that ends where it starts")

    def rest(self, words, number):
        """FANUC's P is milliseconds, LinuxCNC's seconds."""
        if set(words) != {"G", "P"} or not words["P"].isdigit():
            raise NotApplicable(f"line {number}: G4 with other words than P")
        seconds = int(words["P"]) / 1000
        self.rests += seconds
        return f"G4 P{seconds:g}"

    def follow_rotary(self, codes, turned, number):
        """The kinematics is always in force: outside G43.4 the rotary axes must stand at 0. `turned`: before the block."""
        inside = self.in_tip and "49" not in codes
        if TIP in codes or "49" in codes:
            self.in_tip = TIP in codes
        if not inside and (turned or self.is_turned()):
            raise NotApplicable(f"line {number}: a rotary axis is not at 0 outside G43.4")

    def check_parameters(self, setup):
        for used, names in ((self.used["H"], OF_LENGTH), (self.starts, OF_CUTTER)):
            for name in setup.get("parameters", {}):
                if used and name in names:
                    check_parameter(setup, name)

    def take_number(self, kind, value, codes, number):
        if kind == "D" and self.compensating and not {"40", "41", "42"} & set(codes):
            raise NotApplicable(f"line {number}: D without G41 or G42")
        if not value.isdigit() or int(value) > self.most:
            raise NotApplicable(f"line {number}: {kind}{value}")
        self.numbers[kind] = plain(value)

    def number_in_force(self, kind, number):
        value = self.numbers[kind]
        if value in (None, "0"):
            raise NotApplicable(f"line {number}: {kind}0")
        self.used[kind].add(value)
        return value

    def word(self, letter, value, number):
        value_plain = plain(value)
        if letter == "G":
            if value_plain == TIP:
                return "G43"
            if value_plain not in SAME | SYSTEMS:
                raise NotApplicable(f"line {number}: G{value_plain}")
            return "" if value_plain in ("41", "42") and not self.compensate else "G" + value_plain
        if letter == "M":
            if value_plain in ("2", "30"):
                self.ended = True
                return "M2"
            if value_plain in IGNORED_M:
                return ""
            raise NotApplicable(f"line {number}: M{value_plain}")
        if letter == "S":
            return ""
        if letter == "F":
            return "F" + FEED
        if letter in "IJKR" or letter in self.axes:
            return letter + value
        raise NotApplicable(f"line {number}: {letter}{value}")

    def offset(self, kind, number):
        entry = self.offsets[kind].get(number, 0)
        if isinstance(entry, dict):
            return decimal(entry.get("geometry", 0)) + decimal(entry.get("wear", 0))
        return decimal(entry)


def by_tip(program):
    """Whether the program has G43.4."""
    return re.search(r"[Gg]\s*0*43\.4", re.sub(r"\([^)]*\)", " ", program)) is not None


def preamble(setup, module):
    """PREAMBLE lines: everything modal, the workpiece origins, and two moves to where the program starts."""
    # G40 by itself and first: an alarm before may have left compensation on, which no change of the plane bears.
    lines = ["G40", f"{'G21' if unit_of(setup) == 1 else 'G20'} G17 G90 G94 G49 G80 G61 G54 F{FEED}", "G92.1"]
    if any(decimal(v) for v in setup.get("workpiece", {}).get("external", {}).values()):
        raise NotApplicable("setup: an origin that is added to all workpiece systems")
    for k in range(6):
        origin = setup.get("workpiece", {}).get(f"G{54 + k}", {})
        if not module.name.startswith("trivkins") and any(decimal(v) for axis, v in origin.items() if axis in "ABC"):
            raise NotApplicable(f"setup: a workpiece origin of a rotary axis in G{54 + k}")
        lines.append(f"G10 L2 P{k + 1} " + " ".join(f"{axis}{fixed(origin.get(axis, 0))}" for axis in module.joints))
    start = {axis: fixed(setup.get("position", {}).get(axis, 0)) for axis in module.joints}
    lines.append("G0 " + " ".join(axis + value for axis, value in start.items()))
    # A move for certain, and a rest, so that the recording can be cut where the tool stands.
    lines += ["G91 G0 Z1", "G90 G0 Z" + start["Z"], "G4 P0.005"]
    assert len(lines) == PREAMBLE
    return lines


@dataclass
class Translated:
    machine: Machine
    text: str  # for LinuxCNC
    tools: dict  # number → (length, diameter), mm
    pins: dict  # of this machine, and of the program
    translation: Translation


def translate(program, setup, compensate=True):
    """Throws NotApplicable."""
    machine = machine_of(setup, by_tip(program))
    translation = Translation(setup, machine.module, compensate)
    lines = preamble(setup, machine.module)
    lines += [translation.line(text, i + 1) for i, text in enumerate(program.splitlines())]
    translation.check_parameters(setup)
    if not translation.ended:
        lines.append("M2")
    tools = {int(n): [0.0, 0.0] for kind in "HD" for n in translation.used[kind]}
    for number in translation.used["H"]:
        tools[int(number)][0] = float(translation.offset("H", number) * unit_of(setup))
    for number in translation.used["D"]:
        tools[int(number)][1] = float(2 * translation.offset("D", number) * unit_of(setup))
    pins = dict(machine.pins)
    if machine.module is MAX:
        if len(translation.used["H"]) > 1:
            raise NotApplicable("setup: two tool lengths, where the pivot is a pin that can only be set")
        pins[MAX.pivot_pin] = float(sum(translation.offset("H", n) for n in translation.used["H"]) * unit_of(setup))
    return Translated(machine, "\n".join(lines) + "\n", tools, pins, translation)
