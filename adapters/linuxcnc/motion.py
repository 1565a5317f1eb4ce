#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The whole controller: runs a batch of programs in LinuxCNC and records the joints (docs/adapters.md).

motion.py [--ask] BATCH_FOLDER: in it NNN/program.nc and NNN/setup.json; out come NNN/trace.csv, or NNN/alarm.txt with
LinuxCNC's words, or NNN/not_applicable.txt with what it does not have; and NNN/known.txt, lines where it is known to
differ. One start of LinuxCNC for each kinematics module. With --ask nothing is run.
"""
import argparse
import json
import shutil
import signal
import sys
import time
from pathlib import Path

import configuration
import recording
import session
from interpreter import Interpreter
from known import known_places, known_refusal
from machine import NotApplicable, decimal, unit_of
from translate import translate

HERE = Path(__file__).resolve().parent
PATIENCE = 40.0  # s a program may take …
PATIENCE_A_BLOCK = 0.5  # … and longer by this for each block
TRIES = 3
TOO_LONG = "took too long"  # ui.py's words


class Job:
    """A program of the batch, as LinuxCNC is to run it."""

    def __init__(self, folder, interpreter):
        self.folder = folder
        self.number = int(folder.name)
        self.setup = json.loads((folder / "setup.json").read_text(encoding="utf-8"))
        program = (folder / "program.nc").read_text(encoding="utf-8")
        self.translated = translate(program, self.setup)
        self.module = self.translated.machine.module
        self.known = known_places(program, self.setup, interpreter)
        if self.known:
            self.write_known(self.known)
        self.axes = self.setup.get("axes", ["X", "Y", "Z"])
        self.rests = self.translated.translation.rests
        self.patience = PATIENCE + PATIENCE_A_BLOCK * len(program.splitlines()) + self.rests
        self.unit = float(unit_of(self.setup))
        origins = [self.origin_of(system) for system in sorted(self.translated.translation.systems)]
        if any(origin != origins[0] for origin in origins):
            raise NotApplicable("a change of the workpiece system, behind which a recording is not judged")
        self.origin = origins[0]

    def origin_of(self, system):
        origin = self.setup.get("workpiece", {}).get(f"G{system}", {})
        return {axis: float(decimal(value)) for axis, value in origin.items() if decimal(value)}

    def write(self, folder):
        (folder / f"{self.number}.ngc").write_text(self.translated.text, encoding="ascii")
        tools = sorted(self.translated.tools.items())
        table = (f"T{n} P{n} Z{length:.12f} D{diameter:.12f}\n" for n, (length, diameter) in tools)
        (folder / f"{self.number}.tbl").write_text("".join(table), encoding="ascii")
        return {"number": self.number, "program": str(folder / f"{self.number}.ngc"), "patience": self.patience,
                "tools": str(folder / f"{self.number}.tbl"), "pins": self.translated.pins}

    def write_known(self, places):
        text = "".join(f"{name} {first} {last}\n" for name, first, last in places)
        (self.folder / "known.txt").write_text(text, encoding="ascii")

    def write_alarm(self, words):
        if words.startswith(TOO_LONG):
            (self.folder / "not_applicable.txt").write_text(words + "\n", encoding="utf-8")
            return
        (self.folder / "alarm.txt").write_text(words + "\n", encoding="utf-8")
        if name := known_refusal(words):
            self.write_known([*self.known, (name, 1, 1)])


def read_batch(folder, interpreter):
    jobs = []
    for one in sorted(path for path in folder.iterdir() if path.name.isdigit()):
        try:
            jobs.append(Job(one, interpreter))
        except NotApplicable as why:
            (one / "not_applicable.txt").write_text(f"{why}\n", encoding="utf-8")
    return jobs


def say(text):
    print(text, file=sys.stderr, flush=True)


def answers(folder):
    """What ui.py said: program number → None where it ran, else the alarm."""
    said = {}
    done = folder / "done.txt"
    for line in done.read_text(encoding="utf-8").splitlines() if done.exists() else []:
        if line != "end":
            number, what, *words = line.split(" ", 2)
            said[int(number)] = " ".join(words) if what == "alarm" else None
    return said


def take(job, runs, lost, module, period):
    """Writes the trace of a program that ran; whether there is a whole one."""
    if job.number in lost or job.number not in runs:
        return False
    try:
        samples = recording.program_part(runs[job.number])
    except recording.Lost:
        return False
    recording.write_trace(job.folder / "trace.csv", samples, module, job, period)
    return True


def run_once(module, jobs, period):
    """Runs jobs of one module in one start; those to be run again come back."""
    again = []
    with session.work_folder() as folder:
        configuration.write(folder, module, period)
        (folder / "jobs.json").write_text(json.dumps([job.write(folder) for job in jobs]), encoding="utf-8")
        shutil.copy(HERE / "ui.py", folder / "ui.py")
        (folder / "ui.py").chmod(0o755)
        patience = PATIENCE + sum(job.patience / 4 + job.rests for job in jobs)
        output = session.run(folder, patience, [f"PROGRAM_PIN={len(module.joints) + 1}"])
        said = answers(folder)
        if not said:
            raise session.Failed("LinuxCNC did not run:\n" + output[-4000:])
        runs, lost = recording.split(folder / "trace.txt", len(module.joints))
        for job in jobs:
            if job.number not in said:
                again.append(job)
            elif said[job.number] is not None:
                job.write_alarm(said[job.number])
            elif not take(job, runs, lost, module, period):
                again.append(job)
    return again


def run_module(module, jobs, period):
    for attempt in range(TRIES):
        begin = time.monotonic()
        again = run_once(module, jobs, period)
        say(f"{module.name}: {len(jobs) - len(again)} programs in {time.monotonic() - begin:.1f} s"
            + (f", {len(again)} to be run again" if again else ""))
        if not again:
            return
        jobs = again
        if attempt:
            period *= 2
    for job in jobs:
        (job.folder / "failed.txt").write_text(f"no whole recording in {TRIES} starts\n", encoding="utf-8")


def ask(folder):
    """What LinuxCNC has not and where it is known to differ, refusals of its interpreter with them."""
    interpreter = Interpreter()
    for job in read_batch(folder, interpreter):
        refused = interpreter.run(job.translated.text, job.translated.tools).error
        if refused and (name := known_refusal(refused)):
            job.write_known([*job.known, (name, 1, 1)])


def run_batch(folder, period):
    """Runs what LinuxCNC can run of a batch. Throws session.Failed."""
    jobs = read_batch(folder, Interpreter())
    with session.exclusive(600):
        for module in dict.fromkeys(job.module for job in jobs):
            run_module(module, [job for job in jobs if job.module == module], period)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("batch", type=Path)
    parser.add_argument("--ask", action="store_true", help="write known.txt and not_applicable.txt, and run nothing")
    parser.add_argument("--period", type=int, default=configuration.SERVO_PERIOD, help="servo period in ns")
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    if options.ask:
        ask(options.batch)
        return 0
    try:
        run_batch(options.batch, options.period)
    except session.Failed as failure:
        say(str(failure))
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
