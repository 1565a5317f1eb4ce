# SPDX-License-Identifier: Apache-2.0
"""LinuxCNC's interpreter alone (rs274): a program in, its canonical moves out, in full double precision."""
import ctypes
import os
import tempfile
from dataclasses import dataclass, field

LETTERS = "XYZABCUVW"
INCH = 25.4  # mm; canonical lengths are inches
PLANES = {1: "XY", 2: "YZ", 3: "ZX"}  # CANON_PLANE_XY, YZ, XZ


@dataclass
class Move:
    line: int
    kind: str  # rapid, linear, arc
    end: dict  # by letter, workpiece coordinates without the tool length
    length: float  # tool length offset along Z in force
    plane: str  # in force
    center: tuple = None  # of an arc, in its plane: first and second axis
    turn: int = 0  # of an arc: above 0 counter-clockwise


@dataclass
class Run:
    moves: list = field(default_factory=list)
    error: str = None  # LinuxCNC's words
    line: int = 0  # of the error


class Canon:
    """Takes the canonical calls of one program; what is not named here does not matter."""

    def __init__(self, parameter_file, tools):
        self.parameter_file = parameter_file
        self.tools = tools  # index in LinuxCNC's table → (number, length, diameter)
        self.moves = []
        self.line = 0
        self.length = 0.0
        self.plane = 1

    def next_line(self, state):
        self.line = state.sequence_number

    def get_external_length_units(self):
        return 1 / 25.4  # of an inch: millimetres

    def get_external_angular_units(self):
        return 1.0

    def get_axis_mask(self):
        return 0o777

    def get_block_delete(self):
        return False

    def get_tool(self, index):
        number, length, diameter = self.tools.get(index, (-1, 0.0, 0.0))
        return (number, 0.0, 0.0, length / INCH) + 6 * (0.0,) + (diameter / INCH, 0.0, 0.0, 0)

    def check_abort(self):
        return False

    def tool_offset(self, _x, _y, z, *_):
        self.length = INCH * z

    def set_plane(self, plane):
        self.plane = plane

    def add(self, kind, end, **others):
        at = {letter: value if letter in "ABC" else INCH * value for letter, value in zip(LETTERS, end)}
        self.moves.append(Move(self.line, kind, at, self.length, PLANES[self.plane], **others))

    def straight_traverse(self, *to):
        self.add("rapid", to)

    def straight_feed(self, *to):
        self.add("linear", to)

    def arc_feed(self, first, second, center_first, center_second, turn, across, *rotary):
        plane = PLANES[self.plane]
        at = {plane[0]: first, plane[1]: second, next(letter for letter in "XYZ" if letter not in plane): across}
        center = (INCH * center_first, INCH * center_second)
        self.add("arc", (at["X"], at["Y"], at["Z"], *rotary), center=center, turn=turn)

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return lambda *_: None


class Interpreter:
    """One a process. Its tool table lives in a file of the home folder that every start truncates: never share it."""

    def __init__(self):
        self.folder = tempfile.TemporaryDirectory()
        os.environ["HOME"] = self.folder.name
        self.tools = ctypes.CDLL("libtooldata.so.0", mode=ctypes.RTLD_GLOBAL)
        self.tools._Z17tool_mmap_creatorPK13EMC_TOOL_STATi(None, 0)
        import gcode  # pylint: disable=import-outside-toplevel

        self.gcode = gcode

    def file(self, name, text):
        path = os.path.join(self.folder.name, name)
        with open(path, "w", encoding="ascii") as file:
            file.write(text)
        return path

    def run(self, program, tools):
        """`tools`: number → (length, diameter)."""
        table = "".join(f"T{number} P{number}\n" for number in sorted(tools))
        self.tools._Z13tooldata_loadPKcPPc(self.file("tools", table).encode(), None)
        index = self.tools._Z28tooldata_find_index_for_tooli
        path = self.file("program.ngc", program)
        canon = Canon(self.file("parameters", ""), {index(n): (n, *tool) for n, tool in tools.items()})
        result, line = self.gcode.parse(path, canon, "", "")
        run = Run(canon.moves)
        if result > self.gcode.MIN_ERROR:
            run.error, run.line = " ".join(self.gcode.strerror(result).split()), line
        return run
