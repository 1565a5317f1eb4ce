#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Is anything certified where an intermediate of a judge is no number?

Copies the trace judge (certify/trace) and the oracle (judge/oracle) with each `double NAME = EXPRESSION;` as a place that
can be made NaN or an infinity, links them before the libraries with poison_main.cc, and runs that: no wrong answer and no
wrong recording may be certified, whichever place is poisoned."""
import argparse
import json
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLACE = re.compile(r"^(\s*(?:const )?double \w+ = )([^{]*);$")


def balanced(text):
    return all(text.count(a) == text.count(b) for a, b in ("()", "[]"))


def instrumented(path, places):
    lines = path.read_text().splitlines()
    for i, line in enumerate(lines):
        found = PLACE.match(line)
        if not found or not balanced(found[2]):
            continue
        places.append(f"{path.relative_to(ROOT)}:{i + 1}")
        lines[i] = f"{found[1]}::toolcomp::poison::here({len(places) - 1}, {found[2]});"
    return '#include "tests/mutants/poisoned.h"\n' + "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    args = parser.parse_args()
    build = args.build.resolve()
    work = build / "poison"
    work.mkdir(exist_ok=True)
    flags = None
    for entry in json.loads((build / "compile_commands.json").read_text()):
        if "toolcomp_certify.dir" in entry["command"]:
            flags = [w for w in shlex.split(entry["command"])
                     if w.startswith(("-D", "-I", "-std", "-f", "-isystem", "/usr/include"))]
    places = []
    objects = []
    for folder in ("certify/trace", "judge/oracle"):
        sources = []
        for path in sorted((ROOT / folder).glob("*.cpp")):
            source = work / path.name
            source.write_text(instrumented(path, places))
            sources.append(source)
        for source in sources:
            objects.append(source.with_suffix(".o"))
    main_file = ROOT / "tests/mutants/poison_main.cc"
    jobs = [(work / o.with_suffix(".cpp").name, o) for o in objects] + [(main_file, work / "main.o")]
    running = []
    for source, target in jobs:
        running.append(subprocess.Popen(["ccache", "g++", *flags, "-w", "-O1", f"-I{ROOT}", "-c", str(source), "-o", str(target)]))
        if len(running) >= 2 and running.pop(0).wait() != 0:
            return 2
    if any(process.wait() != 0 for process in running):
        return 2
    link = subprocess.run(["ninja", "-C", build, "-t", "commands", "toolcomp"], check=True, capture_output=True,
                          text=True).stdout.splitlines()[-1]
    words = shlex.split(link)
    words = words[words.index("-o") + 2:]
    libraries = [str(build / w) if w.endswith(".a") and not w.startswith("/") else w
                 for w in words[:words.index("&&") if "&&" in words else len(words)] if w.endswith(".a") or ".so" in w or w.startswith("-l")]
    program = work / "poison"
    subprocess.run(["g++", *map(str, objects), str(work / "main.o"), "-Wl,-z,muldefs", *libraries, "-o", str(program)], check=True, cwd=build)
    out = subprocess.run([program], capture_output=True, text=True)
    for line in out.stdout.splitlines():
        found = re.match(r"place (\d+) (.*)", line)
        print(f"{places[int(found[1])]} {found[2]}" if found else line)
    print(f"{len(places)} places")
    return out.returncode


if __name__ == "__main__":
    sys.exit(main())
