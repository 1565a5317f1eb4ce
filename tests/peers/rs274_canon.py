#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""LinuxCNC's interpreter as a process: one program a line in, its moves a line out, in full double precision.

Standard input:  {"id": 1, "program": "G20 ...\\n..."}
Standard output: {"id": 1, "moves": [[line, kind, x, y, center_x, center_y, turn], ...], "error": null, "line": 0}
kind is "rapid", "feed" or "arc" (turn > 0: counter-clockwise). `line` counts from 1. Needs Debian's linuxcnc-uspace and
its own Python.
"""
import ctypes
import json
import os
import sys
import tempfile


class Canon:
    """Takes the canonical calls of one program; what is not named here does not matter."""

    def __init__(self, folder):
        self.parameter_file = os.path.join(folder, "parameters")
        open(self.parameter_file, "a", encoding="ascii").close()
        self.line = 0
        self.moves = []

    def next_line(self, state):
        self.line = state.sequence_number

    def get_external_length_units(self):
        return 1.0

    def get_external_angular_units(self):
        return 1.0

    def get_axis_mask(self):
        return 7

    def get_block_delete(self):
        return False

    def get_tool(self, _):
        return (-1,) + 13 * (0,)

    def check_abort(self):
        return False

    def straight_traverse(self, *to):
        self.moves.append([self.line, "rapid", to[0], to[1], 0, 0, 0])

    def straight_feed(self, *to):
        self.moves.append([self.line, "feed", to[0], to[1], 0, 0, 0])

    def arc_feed(self, x, y, center_x, center_y, turn, *_):
        self.moves.append([self.line, "arc", x, y, center_x, center_y, turn])

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return lambda *_: None


def main():
    with tempfile.TemporaryDirectory() as folder:
        # The tool table lives in a file of the home folder that every start truncates: never share it.
        os.environ["HOME"] = folder
        tools = ctypes.CDLL("libtooldata.so.0", mode=ctypes.RTLD_GLOBAL)
        tools._Z17tool_mmap_creatorPK13EMC_TOOL_STATi(None, 0)
        import gcode

        program = os.path.join(folder, "program.ngc")
        for text in sys.stdin:
            case = json.loads(text)
            with open(program, "w", encoding="ascii") as file:
                file.write(case["program"])
            canon = Canon(folder)
            result, line = gcode.parse(program, canon, "", "")
            error = gcode.strerror(result) if result > gcode.MIN_ERROR else None
            print(json.dumps({"id": case["id"], "moves": canon.moves, "error": error, "line": line}), flush=True)


main()
