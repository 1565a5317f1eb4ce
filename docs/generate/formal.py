# SPDX-License-Identifier: Apache-2.0
"""Definitions and theorems out of the Coq files, with their docstrings."""

import html
import re

from tree import ROOT

SENTENCE = re.compile(
    r"(?P<doc>\(\*\* (?:[^*]|\*(?!\)))*\*\)\n)?(?P<text>^(?:Definition|Fixpoint|Inductive|Record|Theorem) .*?\.(?=\s*$)(?:\n|\Z))",
    re.M | re.S)


def sentences(file):
    """Docstring, keyword, name and text of each definition and theorem of a file."""
    for match in SENTENCE.finditer((ROOT / "spec/formal" / file).read_text()):
        doc = re.sub(r"\s+", " ", (match["doc"] or "")[4:].rsplit("*)", 1)[0]).strip()
        keyword, name = match["text"].split()[:2]
        yield doc, keyword, name.rstrip(":"), match["text"].rstrip()


def coq(text):
    return f'\n```coq\n{text}\n```\n'


def definitions(file):
    """The definitions of a file in their order, each docstring above its text."""
    parts = []
    for doc, keyword, _, text in sentences(file):
        if keyword == "Theorem":
            continue
        comment = f"(* {doc} *)\n" if doc else ""
        parts.append(comment + text)
    return f"`spec/formal/{file}`\n" + coq("\n\n".join(parts))


def definition(argument):
    """One definition, "FILE NAME"."""
    file, wanted = argument.split()
    return next(coq(f"(** {doc} *)\n{text}") for doc, _, name, text in sentences(file) if name == wanted)


def function(argument):
    """One function of C++ with the comment above it, "FILE NAME"."""
    file, wanted = argument.split()
    lines = (ROOT / file).read_text().splitlines()
    begin = next(i for i, line in enumerate(lines) if re.match(rf" *[^/ ].*\b{wanted}\(.*\{{$", line))
    indent = re.match(" *", lines[begin])[0]
    end = lines.index(indent + "}", begin)
    while lines[begin - 1].startswith(indent + "//"):
        begin -= 1
    return "\n```cpp\n" + "\n".join(line.removeprefix(indent) for line in lines[begin:end + 1]) + "\n```\n"


def theorems(file):
    """The theorems: what each says, and its statement to unfold."""
    parts = []
    for doc, keyword, name, text in sentences(file):
        if keyword != "Theorem":
            continue
        clause, _, said = doc.partition(": ")
        said = said[:1].upper() + said[1:]
        parts.append(f'<details class="theorem"><summary><code>{name}</code> {html.escape(said.replace("[", "").replace("]", ""))}'
                     f' <span class="by">{clause}</span></summary><pre><code>{html.escape(text)}</code></pre></details>')
    return "\n".join(["<div>", *parts, "</div>"])
