#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How time and memory of a block grow: with the length of the program, with blocks that look-ahead holds, digits, numbers
of offsets, incremental chains. Whole processes, text to events, of the fast engine and of the exact model; processor time
in user mode, so that a busy machine changes little. Prints Markdown tables; --plots FOLDER draws each as an SVG."""

import argparse
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

SETUP = 'control = "fanuc"\naxes = ["X", "Y", "Z"]\n[offsets.D]\n'
START = "G21 G90 G17\nG01 G41 D1 X10 F100\n"


def ring(count, places=3, corners=1000):
    """Round and round, with obtuse corners to the right and the left, a line each."""
    around = [(f"X{radius * math.cos(angle):.{places}f} Y{radius * math.sin(angle):.{places}f}")
              for angle, radius in ((2 * math.pi * i / corners, 5000 + i % 2) for i in range(corners))]
    return [around[i % corners] for i in range(count)]


def program(lines, start=START):
    return start + "".join(line + "\n" for line in lines)


# Each gives a setup, a program and how many blocks it has: of a point of its series, and of about `blocks` blocks where
# the point is not their number.


def length(point, blocks):
    return SETUP + "1 = 2\n", program(ring(point)), point


def plain(point, blocks):
    return SETUP, program(ring(point), "G21 G90 G17 G01 F100\n"), point


def held(point, blocks):
    corners = blocks // (point + 1)
    lines = [line for corner in ring(corners) for line in ["F100"] * point + [corner]]
    return SETUP + "1 = 2\n", program(lines), len(lines)


def digits(point, blocks):
    return SETUP + "1 = 2\n", program(ring(blocks, point)), blocks


def offsets(point, blocks):
    """Another number in every tenth block."""
    memory = "".join(f"{n} = {2 + n % 7 / 1000:.3f}\n" for n in range(1, point + 1))
    lines = [line + (f" D{1 + i * 7 % point}" if i % 10 == 0 else "") for i, line in enumerate(ring(blocks))]
    return SETUP + memory, program(lines), blocks


def chain(point, blocks):
    """All of it under G91, about a square of 10.1 mm: nothing is commanded absolutely behind the start."""
    side = ["X10.1", "Y10.1", "X-10.1", "Y-10.1"]
    return SETUP + "1 = 2\n", program(["G91"] + [side[i % 4] for i in range(point)]), point


LENGTHS = [10**n for n in range(3, 8)]
# Name, what is counted, generator, points.
SERIES = [
    ("length", "blocks, cutter compensation C", length, LENGTHS),
    ("plain", "blocks, no compensation", plain, LENGTHS),
    ("look-ahead", "blocks without movement before each corner", held, [0, 1, 2, 3]),
    ("digits", "decimals of a coordinate", digits, [1, 3, 6, 9]),
    ("offsets", "offset numbers in the memory", offsets, [1, 10, 100, 400]),
    ("incremental", "blocks of one incremental chain", chain, LENGTHS),
]
# Blocks where the point is not their number, and the longest program: the model takes a hundred times as long.
BLOCKS = {"fast": 400_000, "model": 10_000}
SHORTER = {"fast": 1, "model": 10}
LEAST = 0.01  # seconds


def cost(program, engine, setup, text):
    """Seconds of processor time and KiB of a whole run, which must end without an alarm; only the end of what it says is
    looked at. (The memory is asked of time(1): a child of this process begins with this process's own.)"""
    with tempfile.TemporaryDirectory() as folder:
        nc, toml, memory = (pathlib.Path(folder, name) for name in ("program.nc", "setup.toml", "memory"))
        nc.write_text(text)
        toml.write_text(setup)
        run = subprocess.Popen(["/usr/bin/time", "-f", "%M", "-o", memory, program, "run", nc, "--setup", toml, "--engine", engine],
                               stdout=subprocess.PIPE)
        last = subprocess.run(["tail", "-n", "1"], stdin=run.stdout, capture_output=True, text=True, check=True).stdout
        run.stdout.close()
        _, status, usage = os.wait4(run.pid, 0)
        run.returncode = os.waitstatus_to_exitcode(status)
        if run.returncode != 0 or (last and '"kind":"move"' not in last):
            raise SystemExit(f"toolcomp run --engine {engine}: exit status {run.returncode}, at last {last}")
        return usage.ru_utime, int(memory.read_text())


def measured(program, engine, make, points, repetitions):
    """Rows: point, microseconds a block (the start of the process taken off; None where that is too little to tell), MiB."""
    empty = statistics.median(cost(program, engine, SETUP, "G21 G01 X1 F100\n")[0] for _ in range(max(3, repetitions)))
    for point in points:
        setup, text, blocks = make(point, BLOCKS[engine])
        runs = [cost(program, engine, setup, text) for _ in range(repetitions)]
        seconds = statistics.median(run[0] for run in runs)
        taken = seconds - empty
        yield point, 1e6 * taken / blocks if taken > LEAST else None, max(run[1] for run in runs) / 1024


def plot(folder, name, what, rows_of):
    """One SVG: microseconds a block and MiB over the point, an axis each."""
    import matplotlib
    matplotlib.use("svg")
    import matplotlib.pyplot as pyplot
    matplotlib.rcParams.update({"svg.hashsalt": name, "svg.fonttype": "none"})
    figure, axes = pyplot.subplots(1, 2, figsize=(9, 3.2), layout="constrained")
    for engine, rows in rows_of.items():
        for axis, value in zip(axes, (1, 2)):
            told = [(row[0], row[value]) for row in rows if row[value] is not None]
            axis.plot([x for x, _ in told], [y for _, y in told], "o-", label=engine)
    for axis, unit in zip(axes, ["µs a block", "MiB at most"]):
        axis.set_xscale("log" if max(row[0] for rows in rows_of.values() for row in rows) >= 100 else "linear")
        axis.set_yscale("log" if axis is axes[0] else "linear")
        if axis is axes[1]:
            axis.set_ylim(bottom=0)
        axis.set_xlabel(what)
        axis.set_ylabel(unit)
        axis.legend()
    figure.savefig(folder / f"growth-{name}.svg", metadata={"Date": None})
    pyplot.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/release/toolcomp")
    parser.add_argument("--series", action="append", choices=[series[0] for series in SERIES], help="again for more")
    parser.add_argument("--most", type=int, default=10**6, help="blocks of the longest program (default 1,000,000)")
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--plots", type=pathlib.Path, metavar="FOLDER", help="an SVG of each series (python3-matplotlib)")
    options = parser.parse_args()
    if options.plots:
        options.plots.mkdir(parents=True, exist_ok=True)
    for name, what, make, points in SERIES:
        if options.series and name not in options.series:
            continue
        rows_of = {}
        for engine in BLOCKS:
            most = options.most // SHORTER[engine]
            rows_of[engine] = []
            for row in measured(options.program, engine, make, [p for p in points if p <= most], options.repetitions):
                rows_of[engine].append(row)
                print(f"  {name}, {engine}: {row[0]:,}", file=sys.stderr)
        by_point = {engine: {row[0]: row for row in rows} for engine, rows in rows_of.items()}
        print(f"\n| {what} | fast, µs a block | MiB | model, µs a block | MiB |\n|---|---|---|---|---|")
        for point in sorted(set().union(*by_point.values())):
            cells = []
            for engine in BLOCKS:
                row = by_point[engine].get(point)
                cells += [f"{row[1]:.2f}" if row[1] else "", f"{row[2]:.0f}"] if row else ["", ""]
            print(f"| {point:,} | " + " | ".join(cells) + " |", flush=True)
        if options.plots:
            plot(options.plots, name, what, rows_of)
    return 0


if __name__ == "__main__":
    sys.exit(main())
