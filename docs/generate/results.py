# SPDX-License-Identifier: Apache-2.0
"""What controllers were certified to do: the certificates kept in docs/results, as `toolcomp results` reads them."""

import functools
import json
import re

from tree import ROOT, SECTIONS, all_clauses, toolcomp

# The order of the table.
KEPT = ["fast", "spec", "linuxcnc", "controller-py"]


@functools.cache
def kept():
    folders = [f"docs/results/{name}" for name in KEPT if (ROOT / f"docs/results/{name}").is_dir()]
    return json.loads(toolcomp("results", "--json", *folders))["controllers"]


@functools.cache
def section_of():
    return {clause["id"]: section for section, clause in all_clauses()}


def title(controller):
    return f"{controller['name']} {controller['version']}".strip()


def cell(text):
    return text.replace("|", "\\|")


def linked(text):
    """Ids of clauses in a text as links to them."""
    def link(match):
        section = section_of().get(match[0])
        return f"[`{match[0]}`](sections/{section}.md#{match[0]})" if section else match[0]

    return re.sub(r"\b(?:fanuc|heidenhain)(?:\.[a-z0-9-]+)+", link, text)


def several(number, what):
    return f"{number:,} {what}{'' if number == 1 else 's'}"


def names(_=None):
    """Who is in the table: name, version and date."""
    return "; ".join(f"**{title(c)}**, certified {c['date'][:10]}" for c in kept()) + "."


def words(controller, section):
    found = controller["cells"].get(section, {"standing": "not asked"})
    if found["standing"] == "finding":
        first = next((f["clause"] for f in controller["findings"] if f["section"] == section and f["clause"] in section_of()), "")
        page = f"sections/{section_of()[first]}.md#{first}" if first else f"sections/{section}.md"
        return f"[{several(found['findings'], 'finding')}]({page})"
    if found["standing"] == "differs by design" or found.get("why"):
        return f"[{found['standing']}](#{anchor(controller)})"
    if found["standing"] in ("not asked", "not applicable"):
        return found["standing"]
    return f"[{found['standing']}](sections/{section}.md#clauses)"


def anchor(controller):
    return "of-" + re.sub(r"[^a-z0-9]+", "-", title(controller).lower()).strip("-")


def table(_=None):
    """Sections and controllers."""
    lines = ["| section | " + " | ".join(f"[{cell(c['name'])}](#{anchor(c)})" for c in kept()) + " |", "|---" * (len(kept()) + 1) + "|"]
    for section, name, _ in SECTIONS:
        lines.append(f"| [{name}](sections/{section}.md) | " + " | ".join(words(c, section) for c in kept()) + " |")
    return "\n".join(lines)


def details(_=None):
    """Of each controller: its verdict, what it was asked, and what it does otherwise."""
    parts = []
    for c in kept():
        parts += [f'<h3 id="{anchor(c)}">{title(c)}</h3>', "", f"Verdict: {c['verdict']}.", ""]
        asked = [found for found in c["cells"].values() if found["standing"] not in ("not asked", "not applicable")]
        judged, values, others = (sum(f[key] for f in asked) for key in ("cases", "values", "not_applicable"))
        parts.append(f"* {several(judged, 'case')} applied, {others:,} of these sections did not; {several(values, 'value')} were "
                     f"compared, by {c['tool']}, corpus {c['corpus'] or 'none'}, on {c['date']}.")
        parts += [f"* {name}: {found['standing']}, {found['why']}." for section, name, _ in SECTIONS
                  if (found := c["cells"][section]).get("why")]
        if c["fields_not_judged"]:
            parts.append("* Not judged: the fields " + ", ".join(f"`{field}`" for field in c["fields_not_judged"]) + ".")
        reasons = c["known_differences"]
        known = {}
        for found in asked:
            for name, cases in found["known_differences"].items():
                known[name] = known.get(name, 0) + cases
        parts += [f"* {several(cases, 'case')} by design, `{name}`: {linked(reasons.get(name, 'no reason is given'))}"
                  for name, cases in known.items()]
        parts += [f"* Finding, {several(f['cases'], 'case')}: {f['what']}" + (f"; {linked(f['clause'])}" if f["clause"] else "")
                  for f in c["findings"]]
        parts.append("")
    return "\n".join(parts)
