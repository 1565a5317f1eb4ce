#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the tables of docs/performance.md: every row of the benchmarks in one run, over its floor row, beside what it was
before (tests/bench/before.json); the exact model's rates; with --peers text to path against LinuxCNC's rs274, with
--growth time and memory against length, look-ahead, digits, offsets and chains, and their plots beside the document.
A table that is not measured again stays as it is."""

import argparse
import json
import pathlib
import re
import statistics
import subprocess
import sys

import guard

HERE = pathlib.Path(__file__).parent
DOCUMENT = HERE.parent.parent / "docs" / "performance.md"
BEFORE = HERE / "before.json"


def measured(program, repetitions):
    """Rows by name, of one run in which the repetitions of all are interleaved: nanoseconds, and what else a row shows."""
    found = {}
    report, _ = guard.runs([program], [f"--benchmark_repetitions={repetitions}", "--benchmark_min_time=0.1",
                                       "--benchmark_enable_random_interleaving=true"])
    for run in report:
        if run.get("run_type") == "iteration":
            found.setdefault(run["run_name"], []).append(run)
    return {name: (statistics.median(map(guard.time_an_item, runs)), runs) for name, runs in sorted(found.items())}


def floors(rows):
    yield "| floor | ns |"
    yield "|---|---:|"
    for name, (time, _) in rows.items():
        if name.startswith("floor/"):
            yield f"| `{name}` | {time:.2f} |"


def engine(rows, before):
    yield "| row | floor | ns a block | times the floor | before |"
    yield "|---|---|---:|---:|---:|"
    for name, (time, _) in rows.items():
        if re.match(r"floor/|model/|print|read|scan|exact", name):
            continue
        floor = guard.floor_of(name)
        was = f"{before[name]:.1f}" if name in before else ""
        yield f"| `{name}` | `{floor}` | {time:.1f} | {time / rows[floor][0]:.1f} | {was} |"


def model(rows):
    yield "| row | blocks/s | p50, us | p99, us | slowest block |"
    yield "|---|---:|---:|---:|---|"
    for name, (time, runs) in rows.items():
        if name.startswith("model/"):
            median = {key: statistics.median(run[key] for run in runs) for key in ("p50_us", "p99_us")}
            slowest = runs[-1]["label"].removeprefix("slowest: ").replace("|", "/")
            yield f"| `{name}` | {1e9 / time:,.0f} | {median['p50_us']:.0f} | {median['p99_us']:.0f} | {slowest} |"


def output_of(command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{command[0]}: exit status {done.returncode}\n{done.stderr}")
    return done.stdout.strip().splitlines()


def replaced(text, name, lines):
    begin, end = f"<!-- {name} -->", f"<!-- /{name} -->"
    if text.count(begin) != 1 or text.count(end) != 1:
        raise SystemExit(f"{DOCUMENT}: one {begin} and one {end} are needed")
    head, rest = text.split(begin)
    return head + begin + "\n" + "\n".join(lines) + "\n" + end + rest.split(end)[1]


def drawn(plots):
    yield ""
    for plot in sorted(plots.glob("*.svg")):
        yield f"![{plot.stem.replace('-', ' ')}]({plots.name}/{plot.name})"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/release/toolcomp_bench")
    parser.add_argument("--toolcomp", default="build/release/toolcomp")
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--peers", action="store_true")
    parser.add_argument("--growth", action="store_true")
    options = parser.parse_args()
    rows = measured(options.program, options.repetitions)
    before = json.loads(BEFORE.read_text())["rows"]
    text = DOCUMENT.read_text()
    text = replaced(text, "floors", floors(rows))
    text = replaced(text, "engine", engine(rows, before))
    text = replaced(text, "model", model(rows))
    python = "/usr/bin/python3"
    if options.peers:
        lines = output_of([python, str(HERE.parent / "peers" / "bench.py"), "--toolcomp", options.toolcomp])
        text = replaced(text, "peers", ["```", *lines, "```"])
    if options.growth:
        plots = DOCUMENT.parent / "growth"
        tables = output_of([python, str(HERE / "growth.py"), "--program", options.toolcomp, "--plots", str(plots)])
        text = replaced(text, "growth", tables + list(drawn(plots)))
    DOCUMENT.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
