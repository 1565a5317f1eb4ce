#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Schemas of setups and cases against what the command itself accepts and refuses.

usage: schemas.py TOOLCOMP SOURCE_TREE
"""
import glob
import json
import os
import subprocess
import sys
import tempfile
import tomllib
import warnings

warnings.filterwarnings("ignore", category=DeprecationWarning)
import jsonschema  # noqa: E402

FANUC = 'control = "fanuc"\n'
HEIDENHAIN = 'control = "heidenhain"\n'
TABLE = HEIDENHAIN + '[[dr2table]]\nname = "a"\n'
TOOL = HEIDENHAIN + "[[tool]]\nnumber = 1\n"

# A class of fault a line.
REFUSED_BY_BOTH = [
    # Names and values of keys.
    'control = "siemens"\n', FANUC + 'unitz = "mm"\n', FANUC + 'units = "cm"\n', FANUC + "units = 3\n",
    FANUC + 'increment = "IS-D"\n', FANUC + 'cutter_compensation = "A"\n', FANUC + 'g49_sets_h0 = "yes"\n',
    FANUC + "block_skip = 1\n", FANUC + 'rotary_angles = "workpiece"\n',
    # Axes.
    FANUC + "axes = []\n", FANUC + 'axes = ["X", "X"]\n', FANUC + 'axes = ["Q"]\n', FANUC + 'axes = "XYZ"\n',
    HEIDENHAIN + 'axes = ["X", "Y"]\n',
    # Parameters: number, bit, type, range.
    FANUC + "[parameters]\n19860 = 2\n", FANUC + "[parameters]\nabc = 1\n", FANUC + '[parameters]\n"19631#3" = 1\n',
    FANUC + '[parameters]\n"5001#2" = 2\n', FANUC + '[parameters]\n"5001#2" = "01"\n',
    FANUC + "[parameters]\n19680 = 3\n", FANUC + "[parameters]\n19631 = 91\n", FANUC + '[parameters]\n19631 = "abc"\n',
    FANUC + "[parameters]\n19631 = true\n", FANUC + "[parameters]\n5001 = 300\n", FANUC + "[parameters]\n5001 = 4.5\n",
    FANUC + '[parameters]\n5001 = "00000100"\n', FANUC + "[parameters]\n19681 = 10\n",
    FANUC + "[parameters]\n19681 = 1.5\n",
    # Offsets.
    FANUC + '[offsets]\nmemory = "D"\n', FANUC + "[offsets]\ncount = 0\n", FANUC + "[offsets]\ncount = 1000\n",
    FANUC + '[offsets]\ncount = "4"\n', FANUC + "[offsets.K]\n1 = 1\n", FANUC + "[offsets.H]\n0 = 1\n",
    FANUC + "[offsets.H]\n1000 = 1\n", FANUC + "[offsets.H]\n01 = 1\n", FANUC + '[offsets.H]\n1 = "x"\n',
    FANUC + '[offsets.H]\n1 = "1e3"\n', FANUC + '[offsets.H]\n1 = " 1"\n', FANUC + "[offsets.H]\n1 = true\n",
    FANUC + "[offsets.H]\n1 = [1]\n", FANUC + "[offsets.H]\n1 = { ware = 1 }\n",
    # Tables by axis.
    FANUC + "[workpiece.G53]\nX = 1\n", FANUC + "[workpiece.P0]\nX = 1\n", FANUC + "[workpiece.P49]\nX = 1\n",
    FANUC + "[workpiece.G54]\nQ = 1\n", FANUC + "[workpiece.G54]\nXY = 1\n", FANUC + "[reference.5]\nX = 1\n",
    FANUC + '[reference.1]\nX = "a"\n', FANUC + "[measurement]\nZ = true\n", FANUC + "[position]\nx = 1\n",
    FANUC + "position = 3\n",
    # Of the other control.
    FANUC + "[[tool]]\nnumber = 1\n", HEIDENHAIN + "[parameters]\n", HEIDENHAIN + "[offsets.H]\n1 = 1\n",
    HEIDENHAIN + 'increment = "IS-B"\n',
    # Tools.
    HEIDENHAIN + "[tool]\nnumber = 1\n", HEIDENHAIN + "[[tool]]\nR = 1\n", HEIDENHAIN + "[[tool]]\nnumber = 0\n",
    HEIDENHAIN + "[[tool]]\nnumber = 32768\n", HEIDENHAIN + '[[tool]]\nnumber = "99999"\n',
    HEIDENHAIN + '[[tool]]\nnumber = "1.10"\n', TOOL + "r = 1\n", TOOL + 'R = "x"\n', TOOL + 'name = ""\n',
    TOOL + 'name = "' + 33 * "a" + '"\n', TOOL + "name = 'a\"b'\n",
    # Tables of compensation.
    HEIDENHAIN + "[[correction.wpl]]\nnumber = 1\n", HEIDENHAIN + "[[correction.tcs]]\nDL = 1\n",
    HEIDENHAIN + "[[correction.tcs]]\nnumber = -1\n", HEIDENHAIN + "[[correction.tcs]]\nnumber = 1.5\n",
    HEIDENHAIN + "[[correction.tcs]]\nnumber = 1\nR = 1\n", HEIDENHAIN + '[[dr2table]]\nname = "a"\n',
    HEIDENHAIN + "[[dr2table]]\npoints = [[0, 0]]\n", TABLE + "points = []\n", TABLE + "points = [[0]]\n",
    TABLE + "points = [[0, 0, 0]]\n", TABLE + 'points = [["x", 0]]\n', TABLE + "points = [[-1, 0]]\n",
    TABLE + "points = [[181, 0]]\n",
]

GOOD_CASE = {"case": 1, "setup": {"control": "fanuc"}, "program": "G00 X1.\n"}
CASES_REFUSED_BY_BOTH = [
    {"case": 2}, {"program": 3}, {"setup": {"unitz": "mm"}}, {"dialect": "iso"}, {"samples": -1},
    {"samples": 1000001}, {"clauses": "all"}, {"flags": [1]}, {"source": {"seeds": "1"}}, {"extra": 1},
    {"expect": [{"kind": "motion", "line": 1}]}, {"expect": {}},
]


class Schemas:
    def __init__(self, tree):
        self.store = {}
        for path in glob.glob(f"{tree}/corpus/schema/*.json"):
            with open(path, encoding="utf-8") as file:
                self.store[os.path.basename(path)] = json.load(file)

    def validator(self, name):
        schema = self.store[f"{name}.schema.json"]
        jsonschema.Draft202012Validator.check_schema(schema)
        resolver = jsonschema.RefResolver(f"{name}.schema.json", schema, store=dict(self.store))
        return jsonschema.Draft202012Validator(schema, resolver=resolver)


def why(validator, document):
    return "; ".join(error.message[:200] for error in validator.iter_errors(document))


# What a finding may not be; "left out" stands for a member that is missing.
FINDINGS_REFUSED_BY_BOTH = [
    {"finding": 2}, {"finding": "1"}, {"more": 1}, {"kind": 1}, {"line": -1}, {"line": 1.5}, {"line": "1"},
    {"occurrences": 10**13}, {"deviation_um": "2"}, {"before": {}}, {"before": [1]}, {"case": 1}, {"case": "left out"},
    {"capabilities": []}, {"capabilities": {}}, {"errors": []}, {"controller": {"run": "it"}},
    {"known": "rumour"}, {"known": 1}, {"source": 1}, {"judged": []}, {"judged": ["rumour"]}, {"judged": "manual"},
]


def main():
    toolcomp, tree = sys.argv[1:]
    schemas = Schemas(tree)
    setup, case = schemas.validator("setup"), schemas.validator("case")
    for name in schemas.store:
        schemas.validator(name.removesuffix(".schema.json"))
    faults = []

    with tempfile.TemporaryDirectory() as folder:
        def checked(name, text):
            path = os.path.join(folder, name)
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            return subprocess.run([toolcomp, "config", "check", path], capture_output=True, check=False).returncode

        for text in REFUSED_BY_BOTH:
            if checked("s.toml", text) != 2:
                faults.append(f"the command takes {text!r}")
            if setup.is_valid(tomllib.loads(text)):
                faults.append(f"the schema takes {text!r}")
        if checked("c.json", json.dumps(GOOD_CASE)) != 0 or not case.is_valid(GOOD_CASE):
            faults.append("a good case is refused: " + why(case, GOOD_CASE))
        for change in CASES_REFUSED_BY_BOTH:
            document = GOOD_CASE | change
            if checked("c.json", json.dumps(document)) != 2:
                faults.append(f"the command takes {document}")
            if case.is_valid(document):
                faults.append(f"the schema takes {document}")

    finding_schema = schemas.validator("finding")
    good = {"finding": 1, "kind": "coordinate", "clause": None, "known": "sister",
            "source": "sister: page 1", "judged": ["manual", "sister"], "line": 1, "deviation_um": 2.5, "seen": 1, "tried": 1,
            "capabilities": {"protocol": 1}, "before": [GOOD_CASE], "case": GOOD_CASE}
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "finding.json")
        for change in [{}] + FINDINGS_REFUSED_BY_BOTH:
            document = {key: value for key, value in (good | change).items() if value != "left out"}
            with open(path, "w", encoding="utf-8") as file:
                json.dump(document, file)
            refused = subprocess.run([toolcomp, "replay", path, "--controller", f"{toolcomp} serve --engine fast"],
                                     capture_output=True, check=False).returncode == 2
            if refused != bool(change):
                faults.append(f"the command {'refuses' if refused else 'takes'} the finding {document}")
            if finding_schema.is_valid(document) == bool(change):
                faults.append(f"the schema {'takes' if change else 'refuses'} the finding {document}")

    examples = glob.glob(f"{tree}/examples/*/*/*.toml") + glob.glob(f"{tree}/adapters/*/setups/*.toml")
    for path in examples:
        with open(path, "rb") as file:
            if wrong := why(setup, tomllib.load(file)):
                faults.append(f"{path}: {wrong}")
    for control in ("fanuc", "heidenhain"):
        text = subprocess.run([toolcomp, "config", "example", "--control", control], capture_output=True, check=True)
        if wrong := why(setup, tomllib.loads(text.stdout.decode())):
            faults.append(f"config example --control {control}: {wrong}")

    # Whole cases with their events are slow to judge: all setups, and the first case of each file.
    setups, vectors = set(), 0
    for path in sorted(glob.glob(f"{tree}/corpus/golden/**/*.jsonl", recursive=True)):
        with open(path, encoding="utf-8") as file:
            for number, line in enumerate(file):
                document = json.loads(line)
                vectors += 1
                if number == 0 and (wrong := why(case, document)):
                    faults.append(f"{path}: {wrong}")
                key = json.dumps(document["setup"], sort_keys=True)
                if key not in setups and (wrong := why(setup, document["setup"])):
                    faults.append(f"{path}: {document['id']}: {wrong}")
                setups.add(key)

    print("\n".join(faults))
    print(f"{len(examples)} examples, {vectors} vectors, {len(setups)} setups")
    return 0 if not faults and len(examples) > 20 and vectors > 3000 else 1


sys.exit(main())
