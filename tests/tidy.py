#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""clang-tidy on everything: python3 tests/tidy.py BUILD, a folder configured with groups of sources.

Sources that the build compiles as one are looked at as one: a header is read once a group instead of once a file, which
is half the time. The group is one text, not a file that includes others, because clang-tidy looks into the functions of
its main file alone."""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
INCLUDE = re.compile(r'^#include "(/.*\.cpp)"$', re.M)


def sources():
    """Of ours; examples are programs of users, and tests are looked at by their builds."""
    listed = subprocess.run(["git", "ls-files", "*.cpp"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    return {str(ROOT / name) for name in listed.split() if not name.startswith(("tests/", "examples/"))}


def groups(build, wanted):
    """Each compile command with the sources that it compiles; those that are compiled twice, once."""
    seen = set()
    for entry in json.loads((build / "compile_commands.json").read_text()):
        file = pathlib.Path(entry["file"])
        parts = INCLUDE.findall(file.read_text()) if "Unity" in file.parts else [str(file)]
        parts = [part for part in parts if part in wanted and part not in seen]
        seen.update(parts)
        if parts:
            yield entry, parts
    for left in sorted(wanted - seen):
        print(f"not compiled in this build: {os.path.relpath(left, ROOT)}")


def write_group(folder, entry, parts):
    """The group as one text, with what says where its lines stand; a source alone stays where it is."""
    if len(parts) == 1:
        return entry | {"file": parts[0], "command": entry["command"].replace(entry["file"], parts[0])}, parts[0], []
    target = folder / (re.sub(r"\W+", "_", os.path.relpath(parts[0], ROOT)) + ".cpp")
    text, places = "", []
    for part in parts:
        lines = pathlib.Path(part).read_text().splitlines(keepends=True)
        text += "".join(lines)
        places += [(os.path.relpath(part, ROOT), number + 1) for number in range(len(lines))]
    target.write_text(text)
    command = {"directory": entry["directory"], "file": str(target),
               "command": entry["command"].replace(entry["file"], str(target))}
    return command, target, places


def looked_at(folder, target, places):
    done = subprocess.run(
        ["clang-tidy-19", "-p", folder, "--quiet", f"--config-file={ROOT}/.clang-tidy", "--warnings-as-errors=*",
         "--checks=-readability-duplicate-include", target], capture_output=True, text=True, check=False)

    def placed(found):
        return "{}:{}:".format(*places[int(found[1]) - 1])

    # One that crashes or is killed says so on the other stream, or not at all.
    words = done.stdout or (f"{target}: clang-tidy ended with {done.returncode}\n{done.stderr}" if done.returncode else "")
    return done.returncode, re.sub(re.escape(str(target)) + r":(\d+):", placed, words) if places else words


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    folder = build / "groups"
    folder.mkdir(exist_ok=True)
    written = [write_group(folder, *group) for group in groups(build, sources())]
    (folder / "compile_commands.json").write_text(json.dumps([command for command, _, _ in written]))
    faults = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for status, words in pool.map(lambda group: looked_at(folder, *group[1:]), written):
            print(words, end="", flush=True)
            faults += status != 0
    print(f"{len(written)} groups, {faults} with faults")
    return 1 if faults else 0


sys.exit(main())
