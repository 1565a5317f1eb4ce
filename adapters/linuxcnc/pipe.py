#!/usr/bin/python3
"""The interpreter alone behind the controller protocol (certify/README.md): one JSON line asks, one answers."""
import json
import sys

from interpreter import LETTERS, Interpreter
from known import known_places
from machine import THREE_AXES, NotApplicable, machine_of
from translate import PREAMBLE, translate

HELLO = {
    "name": "LinuxCNC rs274", "version": "2.9", "protocol": 1,
    "sections": ["fanuc/tool-length-offset", "fanuc/cutter-compensation-c"],
    "fields": ["kind", "line", "type", "point", "axes", "center", "plane", "direction"],
    "resolution": "0.000001",
}


def event(move, axes):
    point = {letter: move.end[letter] for letter in axes}
    out = {"kind": "move", "line": move.line - PREAMBLE, "type": move.kind, "point": point,
           "axes": {letter: value + (move.length if letter == "Z" else 0) for letter, value in point.items()}}
    if move.kind == "arc":
        out["center"] = dict(zip(move.plane, move.center))
        out["plane"] = move.plane
        out["direction"] = "ccw" if move.turn > 0 else "cw"
    return out


def answer(case, interpreter):
    setup, program = case["setup"], case["program"]
    machine = machine_of(setup)
    if machine.module is not THREE_AXES:
        raise NotApplicable("setup: rotary axes, which the interpreter alone does not turn")
    translated = translate(program, setup, machine)
    if places := known_places(program, setup, machine, interpreter):
        raise NotApplicable(f"known difference {places[0][0]} in line {places[0][1]}")
    run = interpreter.run(translated.text, translated.tools)
    if run.error:
        raise NotApplicable(f"LinuxCNC's own alarm in line {run.line - PREAMBLE}: {run.error}")
    axes = [letter for letter in LETTERS if letter in setup.get("axes", ["X", "Y", "Z"])]
    return [event(move, axes) for move in run.moves if move.line > PREAMBLE]


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
