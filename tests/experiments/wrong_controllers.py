#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How long `toolcomp certify` takes with a controller that is wrong, beside the same one being right, and into how many
groups it puts what it found; each group's finding is asked again by `toolcomp replay`. Prints a table in Markdown.

The controllers are this file again: `wrong_controllers.py --be FAULT TOOLCOMP` passes each request on to the fast engine
and changes what comes back."""

import argparse
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import time


def each(change, kind="move"):
    def fault(events, _):
        for event in events:
            if event["kind"] == kind:
                change(event)
        return events

    return fault


def position(change):
    def moved(event):
        for field in ("programmed", "point", "axes", "machine"):
            for letter in event.get(field, {}):
                event[field][letter] = change(letter, event[field][letter])

    return each(moved)


def alarms(events, _):
    return [event for event in events if event["kind"] != "alarm"]


def one_less(events, _):
    return events[:1] + events[2:]


def line(event):
    event["line"] += 1


def feed(event):
    if "feed" in event:
        event["feed"] *= 1.01


def number(event):
    event["number"] = "PS9999"


FAULTS = {
    "right": lambda events, _: events,
    "constant off by 1e-6": position(lambda _, x: x + 1e-6),
    "scaled by 1.0001": position(lambda _, x: x * 1.0001),
    "one axis off by 0.01": position(lambda letter, x: x + 0.01 if letter == "Z" else x),
    "alarms missing": alarms,
    "wrong alarm number": each(number, "alarm"),
    "one event missing": one_less,
    "rubbish every seventh answer": lambda events, n: None if n % 7 == 0 else events,
    "a crash every fiftieth": lambda events, n: sys.exit(3) if n % 50 == 0 else events,
    "wrong line": each(line),
    "wrong feed": each(feed),
}


def be(fault, toolcomp):
    engine = subprocess.Popen([toolcomp, "serve", "--engine", "fast"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              text=True)
    for n, request in enumerate(sys.stdin):
        engine.stdin.write(request)
        engine.stdin.flush()
        answer = json.loads(engine.stdout.readline())
        if "events" in answer:
            answer["events"] = FAULTS[fault](answer["events"], n)
        print("%%%" if answer.get("events", 0) is None else json.dumps(answer), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--be", nargs=2, metavar=("FAULT", "TOOLCOMP"), help=argparse.SUPPRESS)
    parser.add_argument("--only", choices=FAULTS, action="append", help="this one alone (repeatable)")
    parser.add_argument("--toolcomp", default="build/release/toolcomp")
    parser.add_argument("arguments", nargs="*", help="for certify, behind --; without any, 80 cases of each section")
    args = parser.parse_args()
    if args.be:
        return be(*args.be)
    toolcomp = str(pathlib.Path(args.toolcomp).resolve())
    print("| controller | status | cases | seconds | groups | findings | settled | replayed |")
    print("|---|---|---|---|---|---|---|---|")
    for fault in args.only or FAULTS:
        with tempfile.TemporaryDirectory() as folder:
            command = shlex.join([sys.executable, os.path.abspath(__file__), "--be", fault, toolcomp])
            begun = time.monotonic()
            run = subprocess.run([toolcomp, "certify", "--controller", command, "--report", folder, "--quiet",
                                  *(args.arguments or ["--cases", "80"])], stdout=subprocess.DEVNULL)
            seconds = time.monotonic() - begun
            said = json.loads(pathlib.Path(folder, "certificate.json").read_text())
            files = [os.path.join(folder, said["findings"][group["findings"][0]]["file"]) for group in said["causes"]]
            again = [subprocess.run([toolcomp, "replay", "--yes", "--quiet", file], stdout=subprocess.DEVNULL,
                                    stderr=subprocess.DEVNULL).returncode for file in files]
            cases = sum(sum(section["cases"].values()) for section in said["sections"])
            settled = said.get("settling", {}).get("settled", "")
            print(f"| {fault} | {run.returncode} | {cases} | {seconds:.1f} | {len(files)} | {len(said['findings'])} "
                  f"| {settled} | {again.count(1)} of {len(again)} |", flush=True)
            for group in said["causes"]:
                print(f"  {group.get('cases', '')} {group['cause']}", file=sys.stderr)


if __name__ == "__main__":
    sys.exit(main())
