"""Certifies a control of ten lines, written as a function, and finds what is wrong with it.

    PYTHONPATH=build/release/python python3 examples/python/certify_function.py
"""

from __future__ import annotations

import re
import sys
from decimal import Decimal
from typing import Iterator

import toolcomp

PROGRAMS = [
    "G90 G00 X10. Y20.\nG43 Z100. H1\nG01 Z50. F200\nG00 Z100.\nM02\n",
    "G90 G00 X0 Y0\nG44 Z100. H1\nX30. Y5.\nM02\n",
]
SETUP = {"control": "fanuc", "offsets": {"H": {1: 20}}}


def control(case: toolcomp.Case) -> Iterator[toolcomp.Move]:
    """Tool length offset by G43 and G44 of an axis Z, absolute. The mistake: both add the offset."""
    at, length = dict.fromkeys("XYZ", Decimal(0)), Decimal(0)
    for line, block in enumerate(case.program.splitlines(), 1):
        words = dict(re.findall(r"([A-Z])([-+.\d]+)", block.replace("G43", "L1 ").replace("G44", "L-1 ")))
        if "L" in words:
            length = Decimal(case.setup["offsets"]["H"][words["H"]])
        at.update({axis: Decimal(words[axis]) for axis in "XYZ" if axis in words})
        if {*"XYZ"} & {*words}:
            yield toolcomp.Move(line=line, axes=at | {"Z": at["Z"] + length})


def main() -> int:
    """Prints what is found; 0: the mistake was."""
    verdict = toolcomp.certify(control, programs=PROGRAMS, setup=SETUP)
    print(verdict.text)
    for finding in verdict.findings:
        print(f"\n{finding.clause}: {toolcomp.clause(finding.clause or '').text}")
        print(f"{finding.explanation}\n{finding.case.program}with H {finding.case.setup['offsets']['H']}")
    return 0 if not verdict.conforms else 1


if __name__ == "__main__":
    sys.exit(main())
