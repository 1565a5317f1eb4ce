#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The interpreter alone behind the controller protocol (docs/protocol.md): one JSON line asks, one answers."""
import json
import subprocess
import sys

from interpreter import Interpreter
from known import known_places, known_refusal
from machine import NotApplicable, unit_of
from translate import PREAMBLE, translate


def version():
    """That of Debian's package; of LinuxCNC from elsewhere nobody knows more than 2.9."""
    try:
        asked = subprocess.run(["dpkg-query", "-W", "-f=${Version}", "linuxcnc-uspace"],
                               capture_output=True, text=True, check=False)
    except OSError:
        return "2.9"
    return asked.stdout if asked.returncode == 0 and asked.stdout else "2.9"


HELLO = {
    "name": "LinuxCNC rs274", "version": version(), "protocol": 1,
    "sections": ["fanuc/tool-length-offset", "fanuc/cutter-compensation-c"],
    "fields": ["kind", "line", "type", "point", "axes", "center", "plane", "direction"],
    "resolution": {"mm": "0.000001", "inch": "0.000001", "degrees": "0.000001"},
}


def event(move, axes, unit):
    at = {letter: move.end[letter] / (1 if letter in "ABC" else unit) for letter in axes}
    out = {"kind": "move", "line": move.line - PREAMBLE, "type": move.kind,
           "point": {letter: value for letter, value in at.items() if letter not in "ABC"},
           "axes": {letter: value + (move.length / unit if letter == "Z" else 0) for letter, value in at.items()}}
    if move.kind == "arc":
        out["center"] = {letter: value / unit for letter, value in zip(move.plane, move.center)}
        out["plane"] = move.plane
        out["direction"] = "ccw" if move.turn > 0 else "cw"
    return out


class Otherwise(NotApplicable):
    """By design: a known difference."""

    def __init__(self, name, why):
        super().__init__(why)
        self.name = name


def answer(case, interpreter):
    setup, program = case["setup"], case["program"]
    translated = translate(program, setup)
    if translated.pins or translated.translation.kinematics:
        raise NotApplicable("tool center point control, which is not the interpreter's")
    if places := known_places(program, setup, interpreter):
        raise Otherwise(places[0][0], f"known difference {places[0][0]} in line {places[0][1]}")
    run = interpreter.run(translated.text, translated.tools)
    if run.error:
        why = f"LinuxCNC's own alarm in line {run.line - PREAMBLE}: {run.error}"
        name = known_refusal(run.error)
        raise Otherwise(name, why) if name else NotApplicable(why)
    axes = setup.get("axes", ["X", "Y", "Z"])
    moving = translated.translation.moving
    events, before = [], None
    for move in run.moves:
        # G01 alone makes a move there, of no length.
        nothing = move.kind != "arc" and move.end == before and move.line - PREAMBLE not in moving
        before = move.end
        if move.line > PREAMBLE and not nothing:
            events.append(event(move, axes, float(unit_of(setup))))
    return events


def main():
    interpreter = Interpreter()
    for line in sys.stdin:
        request = json.loads(line)
        if "hello" in request:
            reply = HELLO
        else:
            reply = {"id": request["id"]}
            try:
                reply["events"] = answer(request, interpreter)
            except NotApplicable as why:
                reply["not_applicable"] = str(why)
                if isinstance(why, Otherwise):
                    reply["known_difference"] = why.name
        print(json.dumps(reply), flush=True)


sys.exit(main())
