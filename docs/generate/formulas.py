# SPDX-License-Identifier: Apache-2.0
"""TeX between $$ … $$ (a line of its own) and \\( … \\) as MathML, made by blahtexml: no script draws it in the browser."""

import functools
import re
import subprocess


@functools.cache
def mathml(tex, display):
    done = subprocess.run(["blahtexml", "--mathml"], input=tex, capture_output=True, text=True, check=True).stdout
    markup = re.search(r"<markup>\n(.*)\n</markup>", done, re.S)
    if not markup:
        raise ValueError(f"{tex}: {done}")
    markup = re.sub(r"(<mo[^>]*>)-(</mo>)", r"\1−\2", markup[1])  # a minus, not a hyphen
    style = ' display="block"' if display else ""
    return f'<math xmlns="http://www.w3.org/1998/Math/MathML"{style}>{markup}</math>'


def formulas(text):
    """A page with its formulas as MathML; code stays as it is."""
    parts = re.split(r"(^```.*?^```$|`[^`\n]+`)", text, flags=re.M | re.S)
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"^\$\$\n(.*?)\n\$\$$", lambda m: f'<div class="formula">{mathml(m[1], True)}</div>', parts[i],
                          flags=re.M | re.S)
        parts[i] = re.sub(r"\\\((.+?)\\\)", lambda m: f'<span class="formula-inline">{mathml(m[1], False)}</span>', parts[i])
    return "".join(parts)
