#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes starter.json, starter.csv, starter.h, package.json, LICENSE and pictures/ from sources/, by the exact model.

generate.py --toolcomp FILE [--check]: --check writes nothing, names the files that are not current, and ends with 1.
"""

import argparse
import concurrent.futures
import csv
import io
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

import jsonschema

HERE = pathlib.Path(__file__).resolve().parent
# One least increment of a usual control: a wrong rule is off by far more.
TOLERANCE = {"mm": "0.001", "inch": "0.0001"}
MOVES = {"rapid": "rapid", "linear": "line"}


def merged(*tables):
    """Tables of tables put together; a later value counts."""
    out = {}
    for table in tables:
        for key, value in table.items():
            out[key] = merged(out[key], value) if isinstance(value, dict) and isinstance(out.get(key), dict) else value
    return out


def number(value):
    """A number that keeps its decimals: json writes a string, which `plain` makes bare."""
    return f"@{value}@"


def plain(text):
    return re.sub(r'"@(.*?)@"', r"\1", text)


def bare(value):
    return str(value).strip("@")


def sources():
    """Version, needs and all vectors of the sources, each with what its family says."""
    known = tomllib.loads((HERE / "sources/starter.toml").read_text())
    vectors = []
    for file in sorted((HERE / "sources").glob("*.toml")):
        if file.name == "starter.toml":
            continue
        family = tomllib.loads(file.read_text(), parse_float=str)
        for vector in family["vector"]:
            machine = family.get("machines", {}).get(vector.get("machine"), {})
            tool = {"tool": [vector["tool"]]} if "tool" in vector else {}
            vectors.append({"needs": [], "section": family["section"], "hand_axes": family.get("hand_axes", "XY"), **vector,
                            "family": file.stem, "kinematics": machine,
                            "setup": merged({"control": "fanuc"}, family.get("setup", {}), machine.get("setup", {}), vector.get("setup", {}), tool)})
    names = [vector["name"] for vector in vectors]
    if len(set(names)) != len(names):
        sys.exit(f"{HERE}/sources: a name stands twice: {sorted(name for name in set(names) if names.count(name) > 1)}")
    return known["version"], known["needs"], vectors


def run(toolcomp, vector, *options):
    """What the command says of a vector."""
    case = {"case": 1, "id": vector["name"], "section": vector["section"], "setup": vector["setup"],
            "dialect": "klartext" if vector["setup"]["control"] == "heidenhain" else "fanuc",
            "program": "\n".join(vector["program"]) + "\n"}
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(case, file)
        file.flush()
        done = subprocess.run([toolcomp, "run", file.name, "--quiet", "--notes", "off", *options], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{vector['family']}.toml, {vector['name']}: {toolcomp} run ends with {done.returncode}: {done.stderr.strip()}")
    return done.stdout


def expected(vector, axes, text):
    """Points and alarm of the events of a run."""
    points, alarm = [], None
    for line in text.splitlines():
        event = json.loads(line, parse_float=str, parse_int=str)
        if event["kind"] == "move":
            move = {"cw": "cw", "ccw": "ccw"}.get(event.get("direction")) or MOVES[event["type"]]
            points.append({"line": int(event["line"]), "move": move, **{axis: number(event["axes"][axis]) for axis in axes}})
        elif event["kind"] == "alarm":
            alarm = {"line": int(event["line"]), "number": event["number"], "cause": event["cause"]}
        elif event["kind"] != "warning":
            sys.exit(f"{vector['family']}.toml, {vector['name']}: a starter vector has no event {event['kind']}")
    if not points:
        sys.exit(f"{vector['family']}.toml, {vector['name']}: no move, so there is nothing to compare")
    return {"points": points, "alarm": alarm, "tolerance": number(TOLERANCE[vector["setup"].get("units", "mm")])}


def settings(vector, meanings):
    """The setup in words and as plain fields."""
    setup, machine = vector["setup"], vector["kinematics"]
    units, axes = setup.get("units", "mm"), setup.get("axes", ["X", "Y", "Z"])
    offsets = {}
    for letter, values in setup.get("offsets", {}).items():
        for index, value in values.items():
            parts = value.items() if isinstance(value, dict) else [(None, value)]
            offsets.update({f"{letter}{index}" + (f".{part}" if part else ""): number(v) for part, v in parts})
    parameters = {key: number(value) for key, value in setup.get("parameters", {}).items()}
    tool = {key: number(vector["tool"].get(key, 0)) for key in ("number", "R", "R2", "DL", "DR", "DR2")} if "tool" in vector else None
    words = [("Heidenhain control" if setup["control"] == "heidenhain" else "FANUC control, series 16i") +
             f", set to {'inches' if units == 'inch' else 'millimetres'}. Axes {' '.join(axes)}, all at 0 at the beginning."]
    words += [machine["words"]] if machine else []
    words += [f"{name} = {bare(value)}, {'a radius' if name[0] == 'D' else 'a length'}." for name, value in offsets.items()]
    words += ["Start-up and cancel are of type A."] if "cutter" in vector["section"] and "5003#0" not in parameters else []
    words += [f"Parameter {name} = {bare(value)}: {meanings[name]}" for name, value in parameters.items() if not machine or name[:3] != "196"]
    words += ["The tool table has " + ", ".join(f"{key} {bare(value)}" for key, value in tool.items() if key != "number") +
              f" for tool {bare(tool['number'])}."] if tool else []
    return {"words": " ".join(words), "control": setup["control"], "units": units, "axes": axes, "offsets": offsets,
            "parameters": parameters, "meanings": {name: meanings[name] for name in parameters},
            "machine": {"type": vector["machine"], "rotary": machine["rotary"]} if machine else None, "tool": tool}


def needs(vector, said, alarm):
    """What a vector needs: what its source names, and what program and setup show."""
    program, parameters = " ".join(vector["program"]), vector["setup"].get("parameters", {})
    found = {"arcs": re.search(r"\bG0?[23]\b", program), "incremental": "G91" in program, "planes": re.search(r"\bG1[89]\b", program),
             "inch": vector["setup"].get("units") == "inch" or "G20" in program, "type-b": "5003#0" in parameters,
             "length-type": {"5001#0", "5001#1"} & set(parameters), "no-check": "5008#0" in parameters,
             "ranges": "19741" in parameters,
             "alarm": alarm and alarm["cause"] != "interference", "interference": alarm and alarm["cause"] == "interference", vector.get("machine"): True}
    unknown = set(vector["needs"]) - set(said["named"])
    if unknown or set(found) - set(said["found"]) - {None}:
        sys.exit(f"{vector['family']}.toml, {vector['name']}: starter.toml does not know the needs {sorted(unknown) or sorted(map(str, found))}")
    return [*vector["needs"], *(name for name in said["found"] if found.get(name))]


def described(vector, said, meanings, text):
    fields = settings(vector, meanings)
    expect = expected(vector, fields["axes"], text)
    return {"name": vector["name"], "family": vector["family"], "section": vector["section"],
            "needs": needs(vector, said, expect["alarm"]), "shows": vector["shows"], "catches": vector["catches"],
            "program": vector["program"], "settings": fields, "expect": expect, "by_hand": vector["by_hand"],
            "picture": f"pictures/{vector['name']}.svg"}


def as_csv(vectors):
    """One row a vector. Points: `LINE MOVE X… Y…`, one after another with a semicolon between; the rest is plain."""
    def pairs(fields):
        return " ".join(f"{key}={bare(value)}" for key, value in (fields or {}).items())

    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n", quoting=csv.QUOTE_ALL)
    writer.writerow(["name", "family", "section", "needs", "shows", "catches", "program", "settings", "control", "units", "axes", "offsets",
                     "parameters", "machine", "tool", "points", "alarm_line", "alarm_number", "alarm_cause", "tolerance", "by_hand", "picture"])
    for vector in vectors:
        fields, expect = vector["settings"], vector["expect"]
        points = "; ".join(f"{point['line']} {point['move']} " + " ".join(axis + bare(point[axis]) for axis in fields["axes"]) for point in expect["points"])
        alarm = expect["alarm"] or {"line": "", "number": "", "cause": ""}
        writer.writerow([vector["name"], vector["family"], vector["section"], " ".join(vector["needs"]), vector["shows"], vector["catches"],
                         "\n".join(vector["program"]), fields["words"], fields["control"], fields["units"], "".join(fields["axes"]), pairs(fields["offsets"]),
                         pairs(fields["parameters"]), (fields["machine"] or {}).get("type", ""), pairs(fields["tool"]), points,
                         alarm["line"], alarm["number"], alarm["cause"], bare(expect["tolerance"]), vector["by_hand"], vector["picture"]])
    return out.getvalue()


HEADER = """/* SPDX-License-Identifier: Apache-2.0 */
/* Test vectors of tool compensation, VERSION. Made by generate.py: do not change it here. C99. */
#ifndef TOOLCOMP_STARTER_H
#define TOOLCOMP_STARTER_H

#define TOOLCOMP_STARTER_VERSION "VERSION"
#define TOOLCOMP_STARTER_AXES 5 /* the most that a vector has */

/* A value by its name: offsets D1, H1, H1.wear; parameters 5003#0; of a Heidenhain tool: number, R, R2, DL, DR, DR2. */
struct toolcomp_starter_setting {
  const char* name;
  double value;
};

/* Where the axes go at the end of a move, in the order of `axes` of the vector, and the line of the program, from 1. */
struct toolcomp_starter_point {
  int line;
  double axes[TOOLCOMP_STARTER_AXES];
};

struct toolcomp_starter_vector {
  const char *name, *family, *section;
  const char* needs; /* names with a space between */
  const char *shows, *catches;
  const char* program; /* lines with a line feed between */
  const char* words;   /* the settings in words */
  const char *control, *units;
  const char* axes;    /* letters, such as XYZBC */
  const char* machine; /* head-head, table-table, head-table or nothing */
  const struct toolcomp_starter_setting* settings;
  int setting_count;
  const struct toolcomp_starter_point* points;
  int point_count;
  int alarm_line; /* 0: no alarm */
  const char *alarm_number, *alarm_cause;
  double tolerance;
};

/* clang-format off */
"""


def as_header(version, vectors):
    values, points, rows = [], [], []
    for vector in vectors:
        fields, expect = vector["settings"], vector["expect"]
        own = {**fields["offsets"], **fields["parameters"], **(fields["tool"] or {})}
        own_points = ["{%d, {%s}}" % (point["line"], ", ".join(bare(point[axis]) for axis in fields["axes"])) for point in expect["points"]]
        alarm = expect["alarm"] or {"line": 0, "number": "", "cause": ""}
        texts = [vector["name"], vector["family"], vector["section"], " ".join(vector["needs"]), vector["shows"], vector["catches"],
                 "\n".join(vector["program"]), fields["words"], fields["control"], fields["units"], "".join(fields["axes"]),
                 (fields["machine"] or {}).get("type", "")]
        rows.append("  {%s,\n   toolcomp_starter_settings + %d, %d, toolcomp_starter_points + %d, %d, %d, %s, %s, %s}" % (
            ",\n   ".join(map(json.dumps, texts)), len(values), len(own), len(points), len(own_points), alarm["line"],
            json.dumps(alarm["number"]), json.dumps(alarm["cause"]), bare(expect["tolerance"])))
        values += [f'{{"{name}", {bare(value)}}}' for name, value in own.items()]
        points += own_points

    def array(kind, name, lines):
        return f"\nstatic const struct toolcomp_starter_{kind} toolcomp_starter_{name}[] = {{\n" + ",\n".join(lines) + "\n};\n"

    return (HEADER.replace("VERSION\"", version + "\"").replace("VERSION.", version + ".") + array("setting", "settings", ["  " + v for v in values]) +
            array("point", "points", ["  " + p for p in points]) + array("vector", "vectors", rows) +
            f"/* clang-format on */\n\n#define TOOLCOMP_STARTER_COUNT {len(rows)}\n\n#endif\n")


def files(toolcomp):
    """Every generated file with its content."""
    version, said, written = sources()
    listed = json.loads(subprocess.run([toolcomp, "spec", "parameters", "--json"], capture_output=True, text=True, check=True).stdout)
    meanings = {entry["id"]: entry["text"] for entry in listed}
    with concurrent.futures.ThreadPoolExecutor() as pool:
        events = list(pool.map(lambda vector: run(toolcomp, vector, "--engine", "model", "--digits", "15"), written))
        pictures = list(pool.map(lambda vector: run(toolcomp, vector, "--format", "svg"), written))
    vectors = [described(vector, said, meanings, text) for vector, text in zip(written, events)]
    whole = {"$schema": "starter.schema.json", "version": version, "needs": {**said["named"], **said["found"]}, "vectors": vectors}
    text = plain(json.dumps(whole, indent=1)) + "\n"
    jsonschema.Draft202012Validator(json.loads((HERE / "starter.schema.json").read_text())).validate(json.loads(text))
    package = {"name": "toolcomp-starter", "version": version, "license": "Apache-2.0",
               "description": "Test vectors of CNC tool compensation: G41, G43, G43.4, LN, each with its exact result",
               "keywords": ["cnc", "g-code", "g41", "cutter compensation", "test vectors"], "main": "starter.json",
               "files": ["starter.json", "starter.schema.json", "starter.csv", "starter.h", "README.md", "pictures", "runners"]}
    return {"starter.json": text, "starter.csv": as_csv(vectors), "starter.h": as_header(version, vectors),
            "package.json": json.dumps(package, indent=2) + "\n", "LICENSE": (HERE / "../../LICENSE").read_text(),
            **{vector["picture"]: picture for vector, picture in zip(vectors, pictures)}}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--toolcomp", required=True)
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    made = files(arguments.toolcomp)
    there = {str(file.relative_to(HERE)) for file in (HERE / "pictures").glob("*.svg")}
    stale = [name for name, text in made.items() if not (HERE / name).is_file() or (HERE / name).read_text() != text]
    gone = sorted(there - set(made))
    if arguments.check:
        for name in [*stale, *gone]:
            print(f"{HERE / name}: not current: run generate.py")
        return 1 if stale or gone else 0
    (HERE / "pictures").mkdir(exist_ok=True)
    for name in stale:
        (HERE / name).write_text(made[name])
    for name in gone:
        (HERE / name).unlink()
    print(f"{sum(name.startswith('pictures/') for name in made)} vectors, {len(stale)} files written, {len(gone)} removed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
