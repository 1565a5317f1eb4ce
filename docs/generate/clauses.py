# SPDX-License-Identifier: Apache-2.0
"""Clauses as HTML: text, formula, source, alternatives, decisions, and where each is found."""

import collections
import functools
import html
import json
import re

from tree import ROOT, all_clauses, clauses, toolcomp

KINDS = {
    "normative": "what the manual rules",
    "parameter": "what a parameter of the control chooses",
    "alarm": "what the control refuses",
    "open": "what the manual leaves open, or we could not confirm: our definition",
    "note": "what explains and is not tested",
}

KNOWN = {
    "manual": "the manual",
    "sister": "a sister manual",
    "recollection": "recollection, no page confirms it",
    "ours": "our definition",
}

# On what an open clause rests, in a table.
REASONS = {
    "manual": "the manual's words, which leave room",
    "sister": "a sister manual, or another vendor's",
    "recollection": "recollection",
    "ours": "no source: ours",
}


@functools.cache
def places():
    """What `toolcomp spec trace` says of each clause."""
    return {entry["id"]: entry for entry in json.loads(toolcomp("spec", "trace", "--json", "--dir", str(ROOT)))}


@functools.cache
def notations():
    """What `toolcomp spec list` says of the symbols of each clause."""
    return {entry["id"]: entry.get("notation", []) for entry in json.loads(toolcomp("spec", "list", "--json"))}


def plain(formula):
    """A formula of a clause file with the signs of print."""
    for written, sign in ((" x ", " × "), (" . ", " · "), ("<=", "≤"), (">=", "≥"), (" +- ", " ± "), ("->", "→")):
        formula = formula.replace(written, sign)
    return re.sub(r"(?<=[A-Za-z])\.(?=[A-Za-z])", "·", formula)


def marked(text):
    return re.sub(r"`([^`]*)`", r"<code>\1</code>", html.escape(text, quote=False))


def source(clause):
    where = clause["source"]
    said = KNOWN[where["known"]]
    if "document" in where:
        document = where["document"] + (f", edition {where['edition']}" if "edition" in where else "")
        page = where.get("page", "")
        said += f": {document}" + (f", {'page ' if page[0].isdigit() else ''}{page}" if page else "")
    return said + (f" ({where['words']})" if "words" in where else "")


def rows(clause):
    """The lines below the text of a clause: name and HTML."""
    if "parameters" in clause:
        yield "Parameters", ", ".join(f"<code>{html.escape(p)}</code>" for p in clause["parameters"])
    yield "Source", html.escape(source(clause))
    if "alternatives" in clause:
        listed = "".join(f"<li>{marked(a)}</li>" for a in clause["alternatives"])
        yield ("Alternatives" if clause["kind"] == "open" else "Other readings"), f"<ul>{listed}</ul>"
    if clause.get("outcome_text"):
        listed = "".join(f"<li><i>{name}</i>: {marked(text)}</li>" for name, text in clause["outcome_text"].items())
        yield "Decided by", f"<ul>{listed}</ul>"
    if not clause.get("testable", True):
        yield "Not tested by itself", marked(clause["reason"])
    if "replaced_by" in clause:
        target = clause["replaced_by"]
        yield "Replaced by", f"<code>{target}</code>"
    place = places().get(clause["id"], {})
    found = []
    if place.get("vectors"):
        count = len(place["vectors"])
        found.append(f"{count} golden vector{'' if count == 1 else 's'}")
    found += [f"<code>{theorem}</code>" for theorem in place.get("theorems", [])]
    if found:
        yield "Held by", ", ".join(found)


def card(clause):
    name = clause["id"]
    body = [f'<p class="clause-name"><a href="#{name}"><code>{name}</code></a> '
            f'<span class="kind kind-{clause["kind"]}">{clause["kind"]}</span></p>',
            f"<p>{marked(clause['text'])}</p>"]
    if "formula" in clause:
        body.append(f'<pre class="clause-formula">{html.escape(plain(clause["formula"]))}</pre>')
    symbols = [entry.split(": ", 1) for entry in notations()[name]]
    if symbols:
        listed = "; ".join(f"<code>{html.escape(symbol)}</code> {html.escape(plain(meaning))}" for symbol, meaning in symbols)
        body.append(f'<p class="notation">Here {listed}.</p>')
    body.append("<dl>" + "".join(f"<dt>{key}</dt><dd>{value}</dd>" for key, value in rows(clause)) + "</dl>")
    return f'<div class="clause" id="{name}">{"".join(body)}</div>'


def listing(section):
    """All clauses of a section, and how many of which kind."""
    listed = clauses(section)
    kinds = collections.Counter(clause["kind"] for clause in listed)
    known = collections.Counter(clause["source"]["known"] for clause in listed)
    counted = " · ".join(f'<span class="kind kind-{kind}">{kind}</span> {kinds[kind]}' for kind in KINDS if kinds[kind])
    counted += "; known by " + ", ".join(f"{words} {known[name]}" for name, words in KNOWN.items() if known[name])
    return f'<p class="kinds">{counted}</p>\n\n' + "\n\n".join(card(clause) for clause in listed)


def open_points(section):
    """The open clauses of a section in short: what we do, on what that rests, and what else it could be."""
    lines = ["| open point | our definition | it rests on | alternatives |", "|---|---|---|---|"]
    for clause in clauses(section):
        if clause["kind"] != "open":
            continue
        first = re.split(r"(?<=[.:]) (?=[A-Z])", clause["text"])[0]
        others = [a for a in clause.get("alternatives", []) if a != "None known."]
        cells = [f"[`{clause['id'].split('.', 1)[1]}`](#{clause['id']})", first, REASONS[clause["source"]["known"]],
                 " / ".join(others) or "–"]
        lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(lines)


def alarms(section):
    """Which alarms and warnings the clauses of a section name."""
    named = collections.defaultdict(list)
    for clause in clauses(section):
        for number in re.findall(r"\b(?:PS\d{4}|[EW]_[A-Z0-9_]+|[A-Z]+(?:_[A-Z0-9]+)+)\b", clause["text"]):
            if clause["id"] not in named[number]:
                named[number].append(clause["id"])
    if not named:
        return "No clause of this section names an alarm of its own; those of the program rules apply."
    lines = ["| alarm | clauses |", "|---|---|"]
    for number in sorted(named):
        lines.append(f"| `{number}` | " + ", ".join(f"[`{name.split('.', 1)[1]}`](#{name})" for name in named[number]) + " |")
    return "\n".join(lines)


def variations(_=None):
    """Every open clause with alternatives: what a control may do otherwise without breaking a word of the manual."""
    parts, last = [], None
    for section, clause in all_clauses():
        others = [a for a in clause.get("alternatives", []) if a != "None known."]
        if clause["kind"] != "open" or not others:
            continue
        if section != last:
            parts.append(f"\n### {section}\n")
            last = section
        page = f"sections/{section}.md"
        parts.append(f"* [`{clause['id']}`]({page}#{clause['id']}): " + " ".join(others))
    return "\n".join(parts)
