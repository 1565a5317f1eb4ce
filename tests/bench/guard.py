#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Benchmarks held against those of another version, as ratios: each row over the floor row of its own run, so that two
machines, or one that is busy, compare. Rows of a release are kept by --save FILE; --against FILE runs them again and
ends with exit status 1 where one is worse by more than --worse percent, or is gone.

--instructions counts instructions a block instead (valgrind --tool=cachegrind): the same on a noisy machine, slower by
fifty times, so mostly with --filter."""

import argparse
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

# What a row's time is divided by: the floor of the geometry it has. The first that matches; in the plane otherwise.
FLOORS = [
    (r"sine|sin_and_cos", "floor/sine_and_cosine"),
    (r"^batch.*(cutter_c|length_offset)", "floor/arrays_in_the_plane"),
    (r"^batch", "floor/arrays_in_space"),
    (r"line_and_arc", "floor/corner_of_line_and_arc"),
    (r"(cutter_.|tool_side)_arcs", "floor/corner_of_arcs"),
    (r"(inverse|posture).*_inclined", "floor/inverse_inclined"),
    (r"^inverse|(tip|posture)_ijk", "floor/inverse"),
    (r"(tip|posture)_rotary", "floor/forward"),
    (r"tool_side|leading_edge|tip_|posture_|milling|contour", "floor/corner_in_space"),
    (r"", "floor/corner_in_the_plane"),
]
INSTRUCTIONS = "instructions"
UNITS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}


def floor_of(row):
    return next(floor for pattern, floor in FLOORS if re.search(pattern, row))


def runs(program, arguments, environment=None):
    """The benchmark's own report, as JSON, and what it says on the way."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder, "rows.json")
        done = subprocess.run([*program, *arguments, f"--benchmark_out={out}", "--benchmark_out_format=json"],
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              env={**os.environ, **(environment or {})})
        if done.returncode != 0:
            raise SystemExit(f"{program[-1]}: exit status {done.returncode}\n{done.stderr[-2000:]}")
        return json.loads(out.read_text())["benchmarks"], done.stderr


def names(program, pattern):
    listed = subprocess.run([program, "--benchmark_list_tests"], capture_output=True, text=True, check=True).stdout.split()
    floors = {floor for _, floor in FLOORS}
    return [name for name in listed if re.search(pattern, name) or name in floors]


def time_an_item(run):
    """Nanoseconds a block, or an iteration of rows that have none."""
    if "items_per_second" in run:
        return 1e9 / run["items_per_second"]
    return run["cpu_time"] * UNITS[run["time_unit"]]


def times(program, rows, repetitions):
    """Nanoseconds by row: medians of repetitions that are interleaved."""
    only = "^(" + "|".join(map(re.escape, rows)) + ")$"
    found = {}
    for run in runs([program], [f"--benchmark_filter={only}", f"--benchmark_repetitions={repetitions}",
                                "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.1"])[0]:
        if run.get("run_type") == "iteration":
            found.setdefault(run["run_name"], []).append(time_an_item(run))
    return {row: statistics.median(values) for row, values in found.items()}


def counted(program, row, seconds):
    """Instructions of a process that runs a row for this long, and how many items it ran, those of its trials with them."""
    with tempfile.TemporaryDirectory() as folder:
        log = pathlib.Path(folder, "log")
        report, said = runs(["valgrind", "--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null",
                             f"--log-file={log}", program],
                            [f"--benchmark_filter=^{re.escape(row)}$", f"--benchmark_min_time={seconds}", "--v=2"],
                            {"TOOLCOMP_BENCH_LATENCY": "off"})
        total = int(re.search(r"I\s+refs:\s+([\d,]+)", log.read_text())[1].replace(",", ""))
        iterations = sum(map(int, re.findall(r"Running \S+ for (\d+)", said)))
        run = report[0]
        items = round(run["cpu_time"] * UNITS[run["time_unit"]] / time_an_item(run))  # an iteration
        return total, items * iterations


def instructions(program, rows):
    """Instructions an item by row: what a longer run has more than a shorter one, so that the start does not count."""
    result = {}
    for row in rows:
        short, few = counted(program, row, 0.01)
        long, many = counted(program, row, 0.2)
        if many <= few:
            raise SystemExit(f"{row}: the longer run is no longer")
        result[row] = (long - short) / (many - few)
        print(f"  {row}: {result[row]:.0f}", file=sys.stderr)
    return result


def ratios(values):
    return {row: value / values[floor_of(row)] for row, value in values.items() if not row.startswith("floor/")}


def compare(before, now, worse):
    """Lines of a report, and whether a row is worse."""
    lines, bad = [], False
    for row in sorted(before.keys() | now.keys()):
        if row not in now:
            lines.append(f"{row:44} {before[row]:9.2f}         gone")
            bad = True
        elif row not in before:
            lines.append(f"{row:44}           {now[row]:9.2f}  new")
        else:
            change = 100 * (now[row] / before[row] - 1)
            slower = change > worse
            bad = bad or slower
            lines.append(f"{row:44} {before[row]:9.2f} {now[row]:9.2f}  {change:+6.1f} %{'  WORSE' if slower else ''}")
    return lines, bad


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/release/toolcomp_bench")
    parser.add_argument("--save", type=pathlib.Path, metavar="FILE", help="keep the rows of this version")
    parser.add_argument("--against", type=pathlib.Path, metavar="FILE", help="rows kept before")
    parser.add_argument("--worse", type=float, default=10, help="percent that a row may be worse (default 10)")
    parser.add_argument("--filter", default="", help="rows whose names have this regular expression")
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--instructions", action="store_true", help="count instructions instead of time")
    options = parser.parse_args()
    if not options.save and not options.against:
        parser.error("one of --save and --against is needed")
    kept = None
    if options.against:
        try:
            kept = json.loads(options.against.read_text())
            before, kind = kept["rows"], kept["of"]
        except (OSError, ValueError, KeyError, TypeError) as error:
            parser.error(f"{options.against}: no rows kept by --save: {error}")
        if kind != (INSTRUCTIONS if options.instructions else "ratios"):
            parser.error(f"{options.against}: it keeps {kind}")
        before = {row: value for row, value in before.items() if re.search(options.filter, row)}

    rows = names(options.program, options.filter)
    if options.instructions:
        now = instructions(options.program, [row for row in rows if not row.startswith("floor/")])
    else:
        now = ratios(times(options.program, rows, options.repetitions))
    if options.save:
        options.save.write_text(json.dumps({"of": INSTRUCTIONS if options.instructions else "ratios", "rows": now},
                                           indent=1) + "\n")
    if kept is None:
        return 0
    lines, bad = compare(before, now, options.worse)
    print(f"{'row':44}    before       now  {'instructions a block' if options.instructions else 'times the floor'}")
    print("\n".join(lines))
    print(f"a row is worse by more than {options.worse:g} %, or gone" if bad else "no row is worse")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
