#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Text to path: the fast engine and LinuxCNC's rs274 on the same contours, in turn, in one run.

bench.py --toolcomp build/release/toolcomp [--blocks 1000000] [--rounds 3]

Both read a program from a file and write the compensated path to a file. Exit status 1 if the fast engine is not at
least eight times as fast on the contour of lines.
"""
import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

LEAST = 8


def seconds(command, folder, output):
    """Processor time of a command that writes to a file of the folder."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(folder / output, "wb") as out, open(folder / "errors", "wb") as errors:
        status = subprocess.run(command, stdout=out, stderr=errors, env={**os.environ, "HOME": str(folder)}).returncode
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if status != 0:
        sys.exit(f"{command[0]}: exit status {status}\n{(folder / 'errors').read_text()}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--toolcomp", required=True)
    parser.add_argument("--blocks", type=int, default=1_000_000)
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_args()
    toolcomp = str(Path(options.toolcomp).resolve())
    slow = False
    print(f"{'contour':28} {'fast engine':>14} {'rs274':>14} {'ratio':>7}   blocks/s, processor time, median of "
          f"{options.rounds} rounds in turn")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        # The table holds diameters; everything in inches, which rs274 leaves as they are.
        (folder / "tools").write_text("T1 P1 Z0 D6.0\n")
        for title, variant, arcs in (("lines, G41 inside", "pocket", 0), ("lines and arcs, G41 inside", "pocket", 40),
                                     ("lines and arcs, G42 outside", "island", 40)):
            ours, theirs = folder / "contour.nc", folder / "contour.ngc"
            subprocess.run([toolcomp, "corpus", "contour", "--blocks", str(options.blocks), "--variant", variant,
                            "--arcs", str(arcs), "--out", str(ours)], check=True, stdout=subprocess.DEVNULL)
            # An O word is a subroutine there.
            lines = [line for line in ours.read_text().splitlines() if not line.startswith(("O", "%"))]
            theirs.write_text("\n".join(["G20"] + lines) + "\n")
            times = ([], [])
            for _ in range(options.rounds):
                times[0].append(seconds([toolcomp, "run", str(ours), "--setup", str(ours.with_suffix(".toml")),
                                         "--engine", "fast", "--format", "gcode"], folder, "path.nc"))
                times[1].append(seconds(["rs274", "-t", str(folder / "tools"), "-v", str(folder / "parameters"), "-g",
                                         str(theirs), str(folder / "path.canon")], folder, "output"))
            rates = [options.blocks / statistics.median(t) for t in times]
            ratio = rates[0] / rates[1]
            slow = slow or (arcs == 0 and ratio < LEAST)
            print(f"{title:28} {rates[0]:14,.0f} {rates[1]:14,.0f} {ratio:6.1f}x")
    return 1 if slow else 0


sys.exit(main())
