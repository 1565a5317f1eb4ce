# SPDX-License-Identifier: Apache-2.0
"""The code blocks of a Markdown page, with what a comment above a block says of it.

<!-- file: NAME -->        the block is this file, for the commands of the page
<!-- source: FILE -->      the block stands in this file of the source tree, word for word
<!-- exit status: N -->    the last command of the block ends with N; all others end with 0
<!-- with: A => B -->      in the test B stands for A (repeatable), such as a second for an hour
<!-- not run: WHY -->      the commands cannot run in a test; verb and options are looked up
<!-- excerpt: WHY -->      no whole file: an excerpt or a form, which nothing can run
"""

import dataclasses
import re

NOTE = re.compile(r"<!-- (file|source|exit status|with|not run|excerpt): (.*?) -->")
COMMAND = re.compile(r"(toolcomp|build/release/toolcomp|\./dev|sbatch|tests/|engines/|bash |python3? |c\+\+ |cmake |ctest |PYTHONPATH=|[A-Z_]+=\S+ toolcomp)")


@dataclasses.dataclass
class Block:
    line: int                 # of the page, where it begins
    language: str             # "" of an indented block
    text: str
    notes: list               # pairs of name and value

    def note(self, name):
        return next((value for key, value in self.notes if key == name), None)

    def commands(self):
        """Pairs of a command and the output shown below it; None where none is shown."""
        lines = self.text.split("\n")
        if self.language == "console":
            found = []
            for line in lines:
                if line.startswith("$ "):
                    found.append([line[2:], []])
                elif found:
                    found[-1][1].append(line)
            return [(command, output or None) for command, output in found]
        if self.language:
            return []
        joined = re.sub(r"\\\n\s*", "", self.text).split("\n")
        return [(re.sub(r"\s{2,}#.*$|\s+# .*$", "", line), None) for line in joined if COMMAND.match(line)]


def blocks(text):
    """All code blocks of a page, fenced and indented, in order."""
    lines, found, notes, i = text.split("\n"), [], [], 0
    while i < len(lines):
        line = lines[i]
        note = NOTE.fullmatch(line.strip())
        fence = re.match(r"```(\w*)", line)
        if note:
            notes.append(note.groups())
        elif fence:
            end = next(j for j in range(i + 1, len(lines)) if lines[j].startswith("```"))
            found.append(Block(i + 1, fence[1] or "none", "\n".join(lines[i + 1:end]), notes))
            notes, i = [], end
        elif line.startswith("    ") and (i == 0 or not lines[i - 1].strip() or lines[i - 1].startswith(("<!--", "#"))):
            end = i
            while end < len(lines) and (lines[end].startswith("    ") or not lines[end].strip()):
                end += 1
            found.append(Block(i + 1, "", "\n".join(part[4:] for part in lines[i:end]).rstrip(), notes))
            notes, i = [], end - 1
        elif line.strip() and not line.startswith("<!--"):
            notes = []
        i += 1
    return found
