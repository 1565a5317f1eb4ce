# SPDX-License-Identifier: Apache-2.0
"""A controller that asks a command: here toolcomp's own fast engine, which takes a program and a setup and prints JSON lines.

TOOLCOMP names the command where it is not on the path. A control of yours that is a command is asked in the same way."""
import json
import os
import subprocess
import tempfile

VECTORS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../starter.json")
with open(VECTORS, encoding="utf-8") as file:
    WHOLE = json.load(file)
SECTIONS = sorted({vector["section"] for vector in WHOLE["vectors"]})
NEEDS = sorted(WHOLE["needs"])


def setup(settings):
    """The settings as toolcomp reads them."""
    offsets = {}
    for name, value in settings["offsets"].items():
        number, _, part = name[1:].partition(".")
        entry = offsets.setdefault(name[0], {})
        entry[number] = {**entry.get(number, {}), part: value} if part else value
    if settings["control"] == "heidenhain":
        return {"control": "heidenhain", "units": settings["units"], "tool": [settings["tool"]]}
    return {"control": "fanuc", "units": settings["units"], "axes": settings["axes"], "offsets": offsets, "parameters": settings["parameters"]}


def your_function(program, settings):
    case = {"case": 1, "id": "starter", "section": SECTIONS[0], "setup": setup(settings), "program": "\n".join(program) + "\n",
            "dialect": "klartext" if settings["control"] == "heidenhain" else "fanuc"}
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(case, file)
        file.flush()
        command = [os.environ.get("TOOLCOMP", "toolcomp"), "run", file.name, "--engine", os.environ.get("ENGINE", "fast"), "--quiet", "--notes", "off"]
        events = [json.loads(line) for line in subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()]
    alarm = next(((event["line"], event["number"]) for event in events if event["kind"] == "alarm"), None)
    return [[event["axes"][axis] for axis in settings["axes"]] for event in events if event["kind"] == "move"], alarm
