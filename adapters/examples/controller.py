#!/usr/bin/env python3
"""A controller in Python, standard library alone: a control that knows tool length offset and little else. In place of
run() stands what asks your control. docs/protocol.md says what goes to and fro."""
import json
import re
import sys
from decimal import Decimal

HELLO = {"name": "length offsets", "version": "1", "protocol": 1, "sections": ["fanuc/tool-length-offset"],
         "fields": ["kind", "line", "n", "type", "axes", "feed"]}
KNOWN = {"control", "units", "axes", "increment", "cutter_compensation", "block_skip", "offsets", "parameters"}
GROUPS = {0: "motion", 1: "motion", 90: "distance", 91: "distance", 43: "length", 44: "length", 49: "length"}


class NotApplicable(Exception):
    """The control does not have what the case needs."""


def words_of(block):
    """The words of a block by address, its codes by group."""
    words = re.findall(r"([A-Z])([+-]?\d+\.?\d*)", block)
    named = {GROUPS.get(Decimal(number), "") if address == "G" else address: number for address, number in words}
    known = set(named) <= {*GROUPS.values(), *"NXYZFH"} and len(named) == len(words)
    if not known or "".join(a + n for a, n in words) != re.sub(r"\s", "", block):
        raise NotApplicable("the block " + block)
    return named


def run(program, setup):
    """The moves of a program: G00 G01, G90 G91, G43 G44 G49 with H, X Y Z."""
    if {*setup} - KNOWN or {*setup.get("parameters", {})} - {"1411"} or [*setup["axes"], setup["units"]] != [*"XYZ", "mm"]:
        raise NotApplicable("settings of the machine")
    offsets = {int(number): value for number, value in setup["offsets"].get("H", {}).items()}
    at, modal, h, length = dict.fromkeys("XYZ", Decimal(0)), {"motion": 0, "distance": 90, "length": 49}, 0, 0
    feed = setup.get("parameters", {}).get("1411", 0)  # at power-on
    for line, words in enumerate(map(words_of, program.split("\n")), 1):
        modal.update({group: int(words[group]) for group in modal if group in words})
        h, feed = int(words.get("H", h)), words.get("F", feed)
        if isinstance(offsets.get(h, 0), dict) or (h and h not in offsets):
            raise NotApplicable("geometry and wear, or no offset of that number")
        before, length = length, {43: 1, 44: -1, 49: 0}[modal["length"]] * Decimal(offsets.get(h, 0))
        for axis in set("XYZ") & set(words):
            at[axis] = Decimal(words[axis]) + (at[axis] if modal["distance"] == 91 else 0)
        if modal["motion"] and set("XYZ") & set(words) and not Decimal(feed):
            raise NotApplicable("a cutting move without F")
        if set("XYZ") & set(words) or length != before:
            yield {"kind": "move", "line": line, **({"n": int(words["N"])} if "N" in words else {}),
                   "type": ["rapid", "linear"][modal["motion"]],
                   "axes": {axis: str(at[axis] + (length if axis == "Z" else 0)) for axis in "XYZ"},
                   **({"feed": feed} if modal["motion"] else {})}


for request in map(json.loads, sys.stdin):
    try:
        answer = HELLO if "hello" in request else {
            "id": request["id"], "events": list(run(request["program"], request["setup"]))}
    except NotApplicable as why:
        answer = {"id": request["id"], "not_applicable": str(why)}
    print(json.dumps(answer), flush=True)
