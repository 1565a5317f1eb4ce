#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What each part of steering (fuzz/campaign/steering.h) gives a search: the same targets, seeds and time with all of it,
without one part of it, and with code coverage alone. Every search begins with nothing. Prints a table in Markdown: what
was reached, each kind of thing counted whether it was looked for or not."""

import argparse
import concurrent.futures
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile

PARTS = ["outcomes", "margins", "pairs", "shapes", "push"]
KINDS = ["outcomes", "margins", "pairs", "shapes"]
TARGETS = ["cutter_compensation_c_directed", "tool_side_compensation_directed", "tool_center_point_control_directed",
           "face_milling_directed"]


def variants():
    """Name, steering, libFuzzer's schedule by entropy."""
    yield "all", "all", 0
    for part in PARTS:
        yield f"without {part}", ",".join(other for other in PARTS if other != part), 0
    yield "code coverage alone", "none", 0
    yield "all, `-entropic=1`", "all", 1


def search(program, steering, entropic, seed, seconds, sightings):
    """Executions, and what was reached by kind. What it saw that differs goes to the folder `sightings`."""
    with tempfile.TemporaryDirectory() as folder:
        work, corpus = pathlib.Path(folder, "work"), pathlib.Path(folder, "corpus")
        (work / "findings").mkdir(parents=True)
        corpus.mkdir()
        run = subprocess.run(
            [program, f"-seed={seed}", f"-max_total_time={seconds}", "-max_len=16384", f"-entropic={entropic}",
             "-verbosity=0", corpus],
            env=dict(os.environ, TOOLCOMP_STEERING=steering, TOOLCOMP_FUZZ_WORK=str(work), TOOLCOMP_FUZZ_SEED=str(seed)),
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if run.returncode != 0:
            raise SystemExit(f"{program.name}, {steering}, seed {seed}: exit status {run.returncode}\n{run.stderr[-2000:]}")
        lines = dict(line.split(" ", 1) for line in (work / "statistics").read_text().splitlines())
        found = sorted((work / "findings").iterdir())
        for file in found:
            sightings.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, sightings / f"{program.name}-{steering.replace(',', '-')}-{seed}-{file.name}")
        return {"executions": int(lines["executions"]), "findings": len(found),
                **dict(zip(KINDS, map(int, lines["reached"].split())))}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--targets", type=pathlib.Path, default="build/fuzz", help="folder of libFuzzer's targets")
    parser.add_argument("--target", action="append", help="one target's name, again for more")
    parser.add_argument("--seconds", type=int, default=30, help="of each search")
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--sightings", type=pathlib.Path, default="build/experiment/sightings",
                        help="folder for what differed")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    targets = options.target or TARGETS
    for target in targets:
        if not (options.targets / target).exists():
            parser.error(f"no target {options.targets / target}: ./dev experiment steering builds them")

    # Seeds outermost: what a busy machine does to one variant it does to all.
    plan = [(seed, target, *variant) for seed in range(1, options.seeds + 1) for target in targets
            for variant in variants()]
    results = {}
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        jobs = {pool.submit(search, options.targets / target, steering, entropic, seed, options.seconds,
                            options.sightings):
                (name, target, seed) for seed, target, name, steering, entropic in plan}
        for job in concurrent.futures.as_completed(jobs):
            results[jobs[job]] = job.result()
            print(f"\r{len(results)} of {len(plan)} searches", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)

    def mean(name, target, key):
        return statistics.mean(results[name, target, seed][key] for seed in range(1, options.seeds + 1))

    print(f"{len(targets)} targets, {options.seeds} seeds, {options.seconds} s each, {options.jobs} side by side.\n")
    print("| steered by | executions/s | outcomes | margins | pairs | shapes |")
    print("|---|---|---|---|---|---|")
    for name, *_ in variants():
        rate = statistics.mean(mean(name, target, "executions") for target in targets) / options.seconds
        cells = []
        for kind in KINDS:
            total = sum(mean(name, target, kind) for target in targets)
            change = 100 * (total / sum(mean("all", target, kind) for target in targets) - 1)
            cells.append(f"{total:.0f}" if name == "all" else f"{total:.0f} ({change:+.1f} %)")
        print(f"| {name} | {rate:.0f} | {' | '.join(cells)} |")
    print("\nThe least and the largest of the seeds, summed over the targets:\n")
    for name, *_ in variants():
        spans = []
        for kind in KINDS:
            sums = [sum(results[name, target, seed][kind] for target in targets)
                    for seed in range(1, options.seeds + 1)]
            spans.append(f"{kind} {min(sums)} to {max(sums)}")
        print(f"* {name}: {', '.join(spans)}")
    findings = sum(result["findings"] for result in results.values())
    if findings:
        print(f"\n{findings} sightings of what differed or could not be decided, in {options.sightings}: "
              "`toolcomp replay FILE` judges one again.")


main()
