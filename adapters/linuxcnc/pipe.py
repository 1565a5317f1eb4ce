#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The interpreter alone behind the controller protocol (docs/protocol.md): one JSON line asks, one answers."""
import json
import sys

from interpreter import Interpreter
from known import known_places
from machine import NotApplicable, unit_of
from translate import PREAMBLE, translate

HELLO = {
    "name": "LinuxCNC rs274", "version": "2.9", "protocol": 1,
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


def answer(case, interpreter):
    setup, program = case["setup"], case["program"]
    translated = translate(program, setup)
    if translated.pins or translated.translation.kinematics:
        raise NotApplicable("tool center point control, which is not the interpreter's")
    if places := known_places(program, setup, interpreter):
        raise NotApplicable(f"known difference {places[0][0]} in line {places[0][1]}")
    run = interpreter.run(translated.text, translated.tools)
    if run.error:
        raise NotApplicable(f"LinuxCNC's own alarm in line {run.line - PREAMBLE}: {run.error}")
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
        print(json.dumps(reply), flush=True)


sys.exit(main())
