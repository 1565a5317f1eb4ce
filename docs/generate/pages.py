# SPDX-License-Identifier: Apache-2.0
"""Pages of the source tree as pages of the site: where each stands, and where its links lead."""

import os
import pathlib
import re
import tomllib

from tree import ROOT

CODE = re.compile(r"(^```.*?^```$|^(?:    [^\n]*\n?)+|`[^`\n]+`)", re.M | re.S)
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^()\s]+)\)")


def place(file):
    """Where a file of the source tree stands in the site."""
    if file.startswith("docs/"):
        return file.removeprefix("docs/")
    if "/" not in file:
        return file.lower()
    return "source/" + re.sub(r"/README\.md$", ".md", file)


def navigation():
    """Parts with their pages that are there; pages of docs/ that nobody lists come last."""
    parts = tomllib.loads((ROOT / "docs/navigation.toml").read_text())["part"]
    listed = {file for part in parts for file, _ in part["pages"]}
    more = sorted(str(file.relative_to(ROOT)) for file in (ROOT / "docs").rglob("*.md"))
    more = [file for file in more if file not in listed]
    if more:
        parts.append({"title": "More", "pages": [[file, title(file)] for file in more]})
    return [(part["title"], [(file, name) for file, name in part["pages"] if (ROOT / file).is_file()]) for part in parts]


def title(file):
    return re.search(r"^# (.+)$", (ROOT / file).read_text(), re.M)[1].replace("`", "")


class Links:
    """Rewrites the links of pages, and remembers which other files they lead to."""

    def __init__(self):
        self.pages = []    # Markdown files in the order in which they are met
        self.figures = set()
        self.faults = []

    def page(self, file):
        if file not in self.pages:
            self.pages.append(file)

    def target(self, file, link):
        """The place of what a page links to, from that page; none where the site does not have it."""
        path, _, anchor = link.partition("#")
        full = os.path.normpath(os.path.join(os.path.dirname(file), path))
        if (ROOT / full).is_dir() and (ROOT / full / "README.md").is_file():
            full = os.path.join(full, "README.md")
        if full == "README.md":
            full = "docs/index.md"
        if not (ROOT / full).exists():
            self.faults.append(f"{file}: no file {path}")
            return None
        if full.endswith(".md"):
            self.page(full)
        elif full.endswith((".svg", ".png")):
            self.figures.add(full)
        else:
            return None
        there = os.path.relpath(place(full), os.path.dirname(place(file)) or ".")
        return there + ("#" + anchor if anchor else "")

    def rewrite(self, file, text):
        def link(match):
            picture, name, there = match.groups()
            if re.match(r"[a-z]+:|#", there):
                return match[0]
            new = self.target(file, there)
            if new is None:
                return name if name.startswith("`") else f"{name} (`{there}`)"
            return f"{picture}[{name}]({new})"

        # A link around code is a link; code by itself is left alone.
        hidden = []

        def hide(match):
            hidden.append(match[0])
            return f"\x00{len(hidden) - 1}\x00"

        def shown(text):
            return re.sub(r"\x00(\d+)\x00", lambda m: hidden[int(m[1])], text)

        return shown(LINK.sub(lambda m: link(re.match(LINK, shown(m[0])) or m), CODE.sub(hide, text)))


def commonmark(text):
    """Markdown as GitHub reads it, for Python-Markdown: a list or table after a paragraph, and shallow nesting."""
    lines, fenced = [], False
    for line in text.split("\n"):
        before = lines[-1] if lines else ""
        if line.startswith("```"):
            fenced = not fenced
        elif not fenced:
            begins = r"(\* |- |\d+\. |\|)"
            if re.match(begins, line) and before and not re.match(begins + r"|\s|<!--", before):
                lines.append("")
            if re.fullmatch(r"<!--.*-->", before) and line and not line.startswith("<!--"):
                lines.append("")
            nested = re.match(r" {2,3}((?:\*|-|\d+\.) .*)", line)
            if nested:
                line = "    " + nested[1]
        lines.append(line)
    return "\n".join(lines)


def write(folder, file, text):
    there = pathlib.Path(folder) / place(file)
    there.parent.mkdir(parents=True, exist_ok=True)
    there.write_text(text)
