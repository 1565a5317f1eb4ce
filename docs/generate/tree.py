# SPDX-License-Identifier: Apache-2.0
"""What the generators read: the source tree, and the toolcomp command that was built from it."""

import json
import os
import pathlib
import subprocess
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TOOLCOMP = os.environ.get("TOOLCOMP", str(ROOT / "build/release/toolcomp"))

# The sections in the order of the manuals: path, title, formal file of its definitions and theorems.
SECTIONS = [
    ("fanuc/tool-length-offset", "Tool length offset", "ToolLengthOffset"),
    ("fanuc/tool-length-measurement", "Tool length measurement", "ToolLengthMeasurement"),
    ("fanuc/tool-offset", "Tool offset", "ToolOffset"),
    ("fanuc/canned-cycle", "Canned cycles", "CannedCycle"),
    ("fanuc/cutter-compensation-b", "Cutter compensation B", "CutterCompensationB"),
    ("fanuc/cutter-compensation-c", "Cutter compensation C", "CutterCompensationC"),
    ("fanuc/tool-side-compensation", "Tool side compensation", "ToolSideCompensation"),
    ("fanuc/leading-edge-offset", "Leading edge offset", "LeadingEdgeOffset"),
    ("fanuc/tool-center-point-control", "Tool center point control", "ToolCenterPointControl"),
    ("fanuc/tool-posture-control", "Tool posture control", "ToolPostureControl"),
    ("heidenhain/face-milling", "Face milling", "FaceMilling"),
    ("heidenhain/peripheral-milling", "Peripheral milling", "PeripheralMilling"),
    ("heidenhain/programmed-contour", "Programmed contour", "ProgrammedContour"),
]

# Clauses that several sections share.
SHARED = [
    ("fanuc/program", "FANUC programs"),
    ("fanuc/tool-direction", "Tool direction"),
    ("heidenhain/program", "Klartext programs"),
    ("heidenhain/tool", "Heidenhain tools"),
]


def clauses(section):
    """The clauses of a section, in the order of its file."""
    return tomllib.loads((ROOT / f"spec/clauses/{section}.toml").read_text())["clause"]


def all_clauses():
    """Every clause with its section."""
    return [(section, clause) for section, *_ in SECTIONS + SHARED for clause in clauses(section)]


def vectors(section, files="*"):
    """Golden vectors of a section: all, or those of files such as examples*."""
    for file in sorted((ROOT / "corpus/golden" / section).glob(files + ".jsonl")):
        for line in file.read_text().splitlines():
            yield json.loads(line)


def toolcomp(*arguments):
    """Standard output of the command; it has to end with status 0."""
    return subprocess.run([TOOLCOMP, *arguments], capture_output=True, text=True, check=True, cwd=ROOT).stdout
