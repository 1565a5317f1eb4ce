# SPDX-License-Identifier: Apache-2.0
"""Second readings side by side: one worked example of the corpus, run with each value of the key that chooses."""

import functools
import html
import json
import tempfile

from tree import toolcomp, vectors

# Key of the setup, or parameter of the control; section; how the comment of a worked example begins that tells them apart.
KEYS = [
    ("g49_sets_h0", "fanuc/tool-length-offset", "g49_sets_h0, G49 without H"),
    ("type_b_without_perpendicular", "fanuc/tool-side-compensation", "type_b_without_perpendicular, obtuse"),
    ("rotary_angles", "fanuc/tool-center-point-control", "The same with programmed angles"),
    ("tip_control_cancel", "fanuc/tool-center-point-control", "tip_control_cancel = moves: G49"),
    ("m128_reference", "heidenhain/face-milling", "m128_reference = center"),
    ("series", "fanuc/cutter-compensation-c", "The 30i reads five blocks"),
]
PARAMETERS = [
    ("5006#6", [0, 1], "fanuc/tool-length-offset", "5006#6 = 1"),
    ("3403#5", [0, 1], "fanuc/tool-length-offset", "With CIR = 0"),
    ("3410", [0, "1.999"], "fanuc/tool-length-offset", "The same, with 3410 = 1.999"),
    ("3411", [0, 8], "fanuc/cutter-compensation-c", "M08 stops the look-ahead if No. 3411"),
    ("5008#1", [0, 1], "fanuc/cutter-compensation-c", "CNC = 1, a groove"),
    ("5008#3", [0, 1], "fanuc/cutter-compensation-c", "CNV = 1 on series 30i: no vector"),
    ("19625", [3, 5], "fanuc/cutter-compensation-c", "The 30i reads five blocks"),
    ("19746#4", [0, 1], "fanuc/tool-side-compensation", "30i with 19746#4 = 1: VT"),
]


@functools.cache
def registry(what):
    return {entry["id"]: entry for entry in json.loads(toolcomp("spec", what, "--json"))}


def example(section, comment):
    found = [v for v in vectors(section) if v.get("comment", "").startswith(comment)]
    if len(found) != 1:
        raise ValueError(f"{len(found)} vectors of {section} begin with {comment!r}")
    return found[0]


def said(event):
    """Where an event leads, in one cell."""
    if event["kind"] != "move":
        return html.escape(event.get("number") or event.get("code") or event["name"])
    places = [f"{axis}{value:.4f}".rstrip("0").rstrip(".") for axis, value in event["axes"].items()]
    return " ".join(places).replace("-0 ", "0 ")


def by_line(case):
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(case, file)
        file.flush()
        events = [json.loads(line) for line in toolcomp("run", file.name, "--digits", "9", "--notes", "off").splitlines()]
    lines = {}
    for event in events:
        lines.setdefault(event["line"], []).append(said(event))
    return lines


def compared(name, values, place, section, comment, text, clauses):
    """One reading: what it is about, the program, and a column for each value."""
    vector = example(section, comment)
    columns = []
    for value in values:
        case = {k: vector[k] for k in ("case", "id", "section", "dialect", "setup", "program")}
        case["setup"] = json.loads(json.dumps(case["setup"]))
        (case["setup"] if place == "key" else case["setup"].setdefault("parameters", {}))[name] = value
        columns.append(by_line(case))
    if all(column == columns[0] for column in columns):
        raise ValueError(f"{vector['id']} does not tell the values of {name} apart")
    shown = [json.dumps(value).strip('"') for value in values]
    rows = [f"### `{name}`", "", text, "",
            "Clauses: " + ", ".join(f"`{clause}`" for clause in clauses) + f". Vector: `{vector['id']}`.", "",
            "| block | " + " | ".join(f"`{name}` = {value}" for value in shown) + " |", "|---|" + "---|" * len(values)]
    for number, block in enumerate(vector["program"].splitlines(), 1):
        cells = ["<br>".join(column.get(number, [])) for column in columns]
        if len(set(cells)) > 1:
            cells = [f"**{cell}**" if cell else "nothing" for cell in cells]
        rows.append(f"| `{block}` | " + " | ".join(cells) + " |")
    return "\n".join(rows)


def keys(_=None):
    known = registry("keys")
    return "\n\n".join(compared(name, known[name]["values"], "key", section, comment, known[name]["text"], known[name]["clauses"])
                       for name, section, comment in KEYS)


def parameters(_=None):
    known = registry("parameters")
    return "\n\n".join(compared(name, values, "parameter", section, comment, known[name]["text"], known[name]["clauses"])
                       for name, values, section, comment in PARAMETERS)
