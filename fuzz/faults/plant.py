#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Plants the seeded faults: writes a copy of the fast engine in which each of them can be switched on.

    plant.py FOLDER     # FOLDER/fast/…

The changes stand in DIALECT/FOLDER.diff beside this file, for the files of fast/DIALECT/FOLDER. Each begins with
"@@ FILE". Its lines are those of a diff: " " stays, "-" goes, "+" comes. The lines that stay or go must be in the file
exactly once. A file that is the same as before is not written, so that nothing is compiled again."""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
HEADER = '#include "fuzz/faults/fault.h"\n'


def changes():
    """(place of the change, file, lines before, lines after) of each change."""
    for diff in sorted(HERE.rglob("*.diff")):
        parts = re.split(r"^@@ (.*)\n", diff.read_text(), flags=re.M)
        line = 1 + parts[0].count("\n")
        for file, lines in zip(parts[1::2], parts[2::2]):
            before = "".join(re.findall(r"^[ -](.*\n)", lines, re.M))
            after = "".join(re.findall(r"^[ +](.*\n)", lines, re.M))
            yield f"{diff.relative_to(ROOT)}:{line}", file, before, after
            line += 1 + lines.count("\n")


def main():
    to = pathlib.Path(sys.argv[1])
    texts = {str(f.relative_to(ROOT)): f.read_text() for f in (ROOT / "fast").rglob("*") if f.suffix in (".h", ".cpp")}
    changed = set()
    for place, file, before, after in changes():
        times = texts.get(file, "").count(before)
        if times != 1:
            sys.exit(f"{place}: these lines are {times} times in {file}, not once: a fault changes with the code it is in")
        texts[file] = texts[file].replace(before, after)
        changed.add(file)
    for file, text in texts.items():
        if file in changed:
            text = text.replace('#include "', HEADER + '#include "', 1) if '#include "' in text else HEADER + text
        copy = to / file
        if not copy.exists() or copy.read_text() != text:
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_text(text)
    for copy in (to / "fast").rglob("*"):
        if copy.is_file() and str(copy.relative_to(to)) not in texts:
            copy.unlink()


main()
