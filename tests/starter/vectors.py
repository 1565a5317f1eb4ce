#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The starter vectors are current, right by geometry and by hand, find planted mistakes, and every runner runs.

vectors.py --source FOLDER --toolcomp FILE [Vectors|Mistakes|Runners]"""

import csv
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest
from decimal import Decimal

import jsonschema

SOURCE, TOOLCOMP = (pathlib.Path(sys.argv[sys.argv.index(name) + 1]).resolve() for name in ("--source", "--toolcomp"))
HERE, STARTER = SOURCE / "tests/starter", SOURCE / "corpus/starter"
PYTHON = "/usr/bin/python3"
sys.path[:0] = [str(HERE), str(STARTER / "runners/python")]
sys.dont_write_bytecode = True
import geometry  # noqa: E402
import mistakes  # noqa: E402
import right  # noqa: E402
import run  # noqa: E402

WHOLE = json.loads((STARTER / "starter.json").read_text())
EXACT = json.loads((STARTER / "starter.json").read_text(), parse_float=Decimal, parse_int=Decimal)["vectors"]
SOURCES = {vector["name"]: (vector, vector.get("hand_axes", family.get("hand_axes", "XY")))
           for family in (tomllib.loads(file.read_text()) for file in sorted((STARTER / "sources").glob("*.toml"))) for vector in family.get("vector", [])}

# Prints the vectors of the header.
PRINT = r"""
#include <stdio.h>
#include <string.h>
#include "starter.h"
int main(void) {
  int i, k, axis;
  for (i = 0; i < TOOLCOMP_STARTER_COUNT; ++i) {
    const struct toolcomp_starter_vector* v = &toolcomp_starter_vectors[i];
    printf("%s\n%s\n%s\n", v->name, v->needs, v->program);
    for (k = 0; k < v->setting_count; ++k) printf("%s %.17g\n", v->settings[k].name, v->settings[k].value);
    for (k = 0; k < v->point_count; ++k) {
      printf("%d", v->points[k].line);
      for (axis = 0; v->axes[axis]; ++axis) printf(" %.17g", v->points[k].axes[axis]);
      printf("\n");
    }
    printf("%d %s %.17g\n", v->alarm_line, v->alarm_number, v->tolerance);
  }
  return 0;
}
"""


def commanded(*command, **environment):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False, env={**os.environ, **environment})
    return done.returncode, done.stdout + done.stderr


def failed(controller):
    """The vectors that a controller of right.py answers otherwise, of those that it knows."""
    known = [v for v in WHOLE["vectors"] if v["section"] in controller.SECTIONS and set(v["needs"]) <= set(controller.NEEDS)]
    return known, [v for v in known if run.difference(v, controller().run(v["program"], v["settings"]))]


class Vectors(unittest.TestCase):
    def test_current(self):
        self.assertEqual(commanded(PYTHON, "-B", STARTER / "generate.py", "--toolcomp", TOOLCOMP, "--check"), (0, ""))

    def test_schema_has_no_free_properties(self):
        judge = jsonschema.Draft202012Validator(json.loads((STARTER / "starter.schema.json").read_text()))
        whole = {**WHOLE, "vectors": [v for v in WHOLE["vectors"] if v["name"] in ("torus", "head-head-lean", "notch")]}
        self.assertTrue(judge.is_valid(whole))
        places = [whole]
        while places:
            place = places.pop()
            if isinstance(place, dict):
                place["No such name"] = {}
                self.assertFalse(judge.is_valid(whole), list(place))
                del place["No such name"]
            places += place.values() if isinstance(place, dict) else place if isinstance(place, list) else []

    def test_lines_and_lengths_by_geometry(self):
        counted = {"lines": 0, "lengths": 0}
        for vector in EXACT:
            points = geometry.computed(vector)
            if points is None:
                # No corner between lines, and no length, is left out.
                self.assertFalse(vector["family"] == "length" or vector["family"] == "corners" and "arcs" not in vector["needs"], vector["name"])
                continue
            counted["lengths" if vector["family"] == "length" else "lines"] += 1
            wanted = vector["expect"]["points"]
            self.assertEqual(len(points), len(wanted), vector["name"])
            for point, want in zip(points, wanted):
                for axis in "XYZ":
                    # The vector has 15 decimals, rounded correctly.
                    self.assertLessEqual(abs(point[axis] - want[axis]), Decimal("5.1e-16"), f"{vector['name']} {axis}")
        self.assertGreaterEqual(counted["lines"], 35)
        self.assertGreaterEqual(counted["lengths"], 15)

    def test_by_hand(self):
        """Each point of `hand` in the sources, on the axes of hand_axes. Every vector has them."""
        for vector in WHOLE["vectors"]:
            source, axes = SOURCES[vector["name"]]
            points = [geometry.by_hand(expression) for expression in source["hand"]]
            self.assertEqual(len(points), len(vector["expect"]["points"]), vector["name"])
            for point, want in zip(points, vector["expect"]["points"]):
                self.assertEqual(len(point), len(axes), vector["name"])
                for axis, value in zip(axes, point):
                    self.assertLessEqual(abs(value - want[axis]), 1e-12, f"{vector['name']} {axis}")

    def test_alarms_are_as_their_sentence_says(self):
        for vector in WHOLE["vectors"]:
            alarm = vector["expect"]["alarm"]
            if alarm and alarm["number"].startswith("PS"):
                self.assertIn(alarm["number"], vector["shows"] + vector["by_hand"], vector["name"])

    def test_csv_says_the_same(self):
        with open(STARTER / "starter.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["name"] for row in rows], [v["name"] for v in WHOLE["vectors"]])
        for row, vector in zip(rows, WHOLE["vectors"]):
            axes, expect, fields = vector["settings"]["axes"], vector["expect"], vector["settings"]
            points = [dict((word[0], float(word[1:])) for word in point.split()[2:]) for point in row["points"].split("; ")]
            self.assertEqual(points, [{axis: point[axis] for axis in axes} for point in expect["points"]])
            self.assertEqual((row["alarm_line"], row["alarm_number"]), (str(expect["alarm"]["line"]), expect["alarm"]["number"]) if expect["alarm"] else ("", ""))
            self.assertEqual(row["program"].split("\n"), vector["program"])
            for name, values in (("offsets", fields["offsets"]), ("parameters", fields["parameters"]), ("tool", fields["tool"] or {})):
                self.assertEqual({key: float(value) for key, value in (pair.split("=") for pair in row[name].split())}, values)

    def test_header_says_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "print.c").write_text(PRINT)
            self.assertEqual(commanded("cc", "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-I", STARTER, f"{folder}/print.c", "-o", f"{folder}/print"), (0, ""))
            said = commanded(f"{folder}/print")[1]
        wanted = ""
        for vector in WHOLE["vectors"]:
            fields, expect = vector["settings"], vector["expect"]
            own = {**fields["offsets"], **fields["parameters"], **(fields["tool"] or {})}
            alarm = expect["alarm"] or {"line": 0, "number": ""}
            wanted += "\n".join([vector["name"], " ".join(vector["needs"]), *vector["program"], *(f"{name} {value:.17g}" for name, value in own.items()),
                                 *(" ".join([str(point["line"]), *(f"{point[axis]:.17g}" for axis in fields["axes"])]) for point in expect["points"]),
                                 f"{alarm['line']} {alarm['number']} {expect['tolerance']:.17g}"]) + "\n"
        self.assertEqual(said, wanted)


class Mistakes(unittest.TestCase):
    def test_right(self):
        known, wrong = failed(right.Right)
        self.assertEqual([v["name"] for v in wrong], [])
        self.assertGreaterEqual(len(known), 60)

    def test_each_mistake_is_found_by_a_vector_that_names_it(self):
        self.assertGreaterEqual(len(mistakes.MISTAKES), 10)
        for words, controller in mistakes.MISTAKES.items():
            _, wrong = failed(controller)
            self.assertTrue(any(words in v["catches"].lower() for v in wrong), f"{words}: found by {[v['name'] for v in wrong]}")

    def test_not_a_number_never_agrees(self):
        known, wrong = failed(mistakes.NotANumber)
        # Where an alarm comes before any move there is nothing else to compare; every vector has a move.
        self.assertEqual(len(known), len(wrong))

    def test_other_answers(self):
        """Too few and too many points, no alarm, another line, another alarm."""
        vector = next(v for v in WHOLE["vectors"] if v["name"] == "groove-too-narrow")
        points = [[20, 10, 0], [50, 10, 0]]
        self.assertIsNone(run.difference(vector, (points, (4, "PS0041"))))
        self.assertIsNone(run.difference(vector, (points, (4, "interference"))))
        for answer in [(points[:1], (4, "PS0041")), ([*points, points[0]], (4, "PS0041")), (points, None), (points, (3, "PS0041")), (points, (4, "PS0033")),
                       ([[20, 10], [50, 10]], (4, "PS0041")), ([[20, 10, 0], [50, math.inf, 0]], (4, "PS0041"))]:
            self.assertIsNotNone(run.difference(vector, answer), answer)


class Runners(unittest.TestCase):
    """Each runner agrees with its example controller, and says what is wrong with one that has a mistake."""

    AGREES = "12 vectors agree, 0 do not, "

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def wrong(self, language, name):
        """The example with G49 kept, in the folder of the test."""
        text = (STARTER / "runners" / language / name).read_text()
        self.assertIn("49", text)
        (self.folder / name).write_text(text.replace("49", "149"))
        return self.folder / name

    def judge(self, good, bad):
        self.assertEqual(good[0], 0, good[1])
        self.assertIn(self.AGREES, good[1])
        self.assertEqual(bad[0], 1, bad[1])
        self.assertIn("FAILED g49-removes: G49 takes the length offset away", bad[1])
        self.assertIn("mistake: G49 kept", bad[1])
        self.assertIn("point 2, line 2: expected X0 Y0 Z50, got X0 Y0 Z70", bad[1])

    def test_python(self):
        runner = STARTER / "runners/python/run.py"
        self.judge(commanded(PYTHON, "-B", runner), commanded(PYTHON, "-B", runner, self.wrong("python", "example.py")))

    def test_python_answers_of_any_kind(self):
        for body in ("raise ValueError('no')", "return None", "return [['x', 0, 0]], None", "return [[]], None"):
            (self.folder / "odd.py").write_text(f"SECTIONS, NEEDS = ['fanuc/tool-length-offset'], []\ndef your_function(program, settings):\n    {body}\n")
            status, text = commanded(PYTHON, "-B", STARTER / "runners/python/run.py", self.folder / "odd.py")
            self.assertEqual(status, 1, text)
            self.assertNotIn("Traceback", text)
        (self.folder / "none.py").write_text("SECTIONS, NEEDS = [], []\n")
        status, text = commanded(PYTHON, "-B", STARTER / "runners/python/run.py", self.folder / "none.py")
        self.assertEqual((status, text.split(",")[0]), (1, "0 vectors agree"))

    def test_c(self):
        def built(controller):
            program = self.folder / "run"
            status, text = commanded("cc", "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", f'-DCONTROLLER="{controller}"',
                                     STARTER / "runners/c/run.c", "-lm", "-o", program)
            self.assertEqual((status, text), (0, ""))
            return commanded(program)

        self.judge(built("example.c"), built(self.wrong("c", "example.c")))

    @unittest.skipUnless(shutil.which("node"), "no node")
    def test_javascript(self):
        runner = STARTER / "runners/javascript/run.mjs"
        self.judge(commanded("node", runner), commanded("node", runner, self.wrong("javascript", "example.mjs")))

    @unittest.skipUnless(shutil.which("rustc"), "no rustc")
    def test_rust(self):
        def built(folder):
            status, text = commanded("rustc", "--edition", "2021", "-D", "warnings", folder / "run.rs", "-o", self.folder / "run")
            self.assertEqual((status, text), (0, ""))
            return commanded(self.folder / "run")

        good = built(STARTER / "runners/rust")
        self.wrong("rust", "example.rs")
        runner = (STARTER / "runners/rust/run.rs").read_text().replace('"../../starter.csv"', json.dumps(str(STARTER / "starter.csv")))
        (self.folder / "run.rs").write_text(runner)
        self.judge(good, built(self.folder))

    def test_short(self):
        for language, name in (("python", "run.py"), ("c", "run.c"), ("javascript", "run.mjs"), ("rust", "run.rs")):
            self.assertLess(len((STARTER / "runners" / language / name).read_text().splitlines()), 120, name)

    def test_fast_engine(self):
        status, text = commanded(PYTHON, "-B", STARTER / "runners/python/run.py", STARTER / "runners/python/command.py", TOOLCOMP=str(TOOLCOMP))
        self.assertEqual((status, text), (0, f"{len(WHOLE['vectors'])} vectors agree, 0 do not, 0 skipped: their section or a need is not named\n"))

    @unittest.skipUnless(shutil.which("npm"), "no npm")
    def test_npm(self):
        done = subprocess.run(["npm", "pack", "--dry-run", "--json", "--offline", str(STARTER)], capture_output=True, text=True, check=False, cwd=self.folder,
                              env={**os.environ, "npm_config_cache": str(self.folder / "cache"), "npm_config_update_notifier": "false"})
        self.assertEqual(done.returncode, 0, done.stderr)
        package = json.loads(done.stdout)[0]
        listed = {file["path"] for file in package["files"]}
        self.assertEqual(package["version"], WHOLE["version"])
        self.assertLessEqual({"starter.json", "starter.schema.json", "starter.csv", "starter.h", "runners/c/run.c", "pictures/outside-acute.svg"}, listed)
        self.assertFalse({path for path in listed if path.startswith("sources") or path.endswith((".pyc", "generate.py"))})


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *(word for word in sys.argv[1:] if word in ("Vectors", "Mistakes", "Runners"))])
