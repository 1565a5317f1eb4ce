# SPDX-License-Identifier: Apache-2.0
"""Pictures that toolcomp draws, of programs in examples and of worked examples in the golden corpus."""

import functools
import html
import json
import re
import tempfile

from tree import ROOT, toolcomp, vectors


@functools.cache
def drawn(program):
    return toolcomp("run", program, "--format", "svg")


def drawn_case(case):
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(case, file)
        file.flush()
        return drawn(file.name)


def picture(argument):
    """`PROGRAM | caption`, or `SECTION "beginning of the comment of a vector" | caption`."""
    what, _, caption = argument.partition(" | ")
    match = re.fullmatch(r'(\S+) "(.*)"', what.strip())
    if match:
        found = [v for v in vectors(match[1], "examples*") if v["comment"].startswith(match[2])]
        if len(found) != 1:
            raise ValueError(f"{len(found)} vectors of {match[1]} begin with {match[2]!r}")
        svg = drawn_case(found[0])
        name = found[0]["id"]
    else:
        svg = drawn(what.strip())
        name = what.strip()
    svg = re.sub(r"<style>.*?</style>\n?", "", svg, flags=re.S)
    return (f'<figure class="picture">\n<div class="picture-sheet" tabindex="0" role="region" aria-label="picture">{svg.strip()}</div>\n'
            f"<figcaption>{html.escape(caption)} <code>{name}</code></figcaption>\n</figure>")


def style():
    """The colours of the pictures for the schemes of the site: those of the pictures themselves."""
    css = re.search(r"<style>(.*?)</style>", drawn("examples/fanuc/three-hole-boring/three-holes.nc"), re.S)[1]
    light, dark = css.split("@media(prefers-color-scheme:dark){")
    dark = dark.strip()[:-1]
    dark = re.sub(r"(^|})\s*([^{}]+)\{", lambda m: m[1] + "\n" + ",".join(
        '[data-md-color-scheme="slate"] ' + s for s in m[2].split(",")) + "{", dark)
    return light + dark + "\n"


def worked(section):
    """The worked examples of the corpus: by hand what must come out, and the program."""
    parts = []
    for vector in vectors(section, "examples*"):
        parts.append(f'<details class="theorem"><summary>{html.escape(vector["comment"])} <span class="by">{vector["id"]}</span></summary>'
                     f'<pre><code>{html.escape(vector["program"])}</code></pre></details>')
    count = len(parts)
    return f"{count} worked examples stand in the golden corpus, each with its figures by hand.\n\n<div>\n" + "\n".join(parts) + "\n</div>"
