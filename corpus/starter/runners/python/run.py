#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the starter vectors against your function.

run.py [CONTROLLER.py] (example.py): a file with SECTIONS and NEEDS, which name what it knows, and
your_function(program, settings) -> (points, alarm)
    program    the lines of the program, a list of strings
    settings   `settings` of the vector, as in starter.json
    points     where the axes go at the end of each move: lists of numbers, in the order of settings["axes"]
    alarm      None, or (line, name): the number of the alarm, or its cause as in starter.json
Exit status: 0 all agree, 1 one does not, or nothing was compared.
"""

import importlib.util
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True


def load(file):
    spec = importlib.util.spec_from_file_location("controller", file)
    module = importlib.util.module_from_spec(spec)
    sys.path.insert(0, str(pathlib.Path(file).resolve().parent))
    spec.loader.exec_module(module)
    return module


def shown(axes, point):
    return " ".join(f"{axis}{float(value):.10g}" for axis, value in zip(axes, point)) if point is not None else "nothing"


def at(points, index):
    return points[index] if index < len(points) else None


def difference(vector, answer):
    """The first thing that is not as expected, as text; nothing where all agrees."""
    axes, expect = vector["settings"]["axes"], vector["expect"]
    points, alarm = answer
    wanted = [[point[axis] for axis in axes] for point in expect["points"]]
    for index in range(max(len(wanted), len(points))):
        want, got = at(wanted, index), at(points, index)
        # Written so that a NaN, which compares with nothing, does not agree.
        if want is None or got is None or len(got) != len(axes) or not all(abs(float(g) - w) <= expect["tolerance"] for g, w in zip(got, want)):
            line = f", line {expect['points'][index]['line']}" if want else ""
            return f"point {index + 1}{line}: expected {shown(axes, want)}, got {shown(axes, got)}"
    wanted = expect["alarm"]
    if (wanted is None) != (alarm is None) or wanted and (alarm[0] != wanted["line"] or alarm[1] not in (wanted["number"], wanted["cause"])):
        name = f"line {wanted['line']}: {wanted['number']} ({wanted['cause']})" if wanted else "none"
        return f"alarm: expected {name}, got {f'line {alarm[0]}: {alarm[1]}' if alarm else 'none'}"
    return None


def main():
    controller = load(sys.argv[1] if len(sys.argv) > 1 else HERE / "example.py")
    vectors = json.loads((HERE / "../../starter.json").read_text())["vectors"]
    agreed = failed = 0
    for vector in vectors:
        if vector["section"] not in controller.SECTIONS or not set(vector["needs"]) <= set(controller.NEEDS):
            continue
        try:
            wrong = difference(vector, controller.your_function(vector["program"], vector["settings"]))
        except Exception as why:  # whatever the function does is an answer of it
            wrong = f"your function raised {type(why).__name__}: {why}"
        agreed, failed = agreed + (wrong is None), failed + (wrong is not None)
        if wrong:
            print(f"FAILED {vector['name']}: {vector['shows']}\n  mistake: {vector['catches']}\n  {wrong}\n  see {vector['picture']}")
    print(f"{agreed} vectors agree, {failed} do not, {len(vectors) - agreed - failed} skipped: their section or a need is not named")
    return 0 if agreed and not failed else 1


if __name__ == "__main__":
    sys.exit(main())
