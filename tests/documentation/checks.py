#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The checks of the documentation find what they are there to find: planted faults, by hand, each with what is sound beside it."""

import pathlib
import shutil
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent.parent / "docs/generate")]
import formulas  # noqa: E402
import pages  # noqa: E402
from blocks import blocks  # noqa: E402
from shown import Page, Shown, matches  # noqa: E402
import whole  # noqa: E402


class Outputs(unittest.TestCase):
    def test_lines_as_shown(self):
        self.assertTrue(matches(["a", "b"], "a\nb\n"))
        self.assertTrue(matches(["a … c"], "a b c\n"))
        self.assertTrue(matches(["…", "c"], "a\nb\nc\n"))
        self.assertTrue(matches(["…"], ""))

    def test_lines_otherwise(self):
        self.assertFalse(matches(["a", "b"], "a\nc\n"))
        self.assertFalse(matches(["a"], "a\nb\n"))
        self.assertFalse(matches(["a … d"], "a b c\n"))
        self.assertFalse(matches(["a"], ""))


class Blocks(unittest.TestCase):
    def test_commands_and_notes(self):
        page = ("Text.\n\n<!-- with: 8h => 1s -->\n\n    toolcomp run a.nc     # comment\n    other words\n\nMore.\n\n"
                "<!-- exit status: 1 -->\n```console\n$ toolcomp diff a.nc\nline\n$ true\n```\n")
        indented, console = blocks(page)
        self.assertEqual(indented.commands(), [("toolcomp run a.nc", None)])
        self.assertEqual(indented.note("with"), "8h => 1s")
        self.assertEqual(console.commands(), [("toolcomp diff a.nc", ["line"]), ("true", None)])
        self.assertEqual(console.note("exit status"), "1")

    def test_a_paragraph_ends_notes(self):
        self.assertEqual(blocks("<!-- not run: no -->\n\nText.\n\n    toolcomp run a\n")[0].notes, [])


class Commands(unittest.TestCase):
    """A page with one block; toolcomp is a script that knows the verb run with --format."""

    def faults(self, text):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in ("examples", "adapters", "corpus", "spec", "fuzz", "docs", "bin", "work"):
                (root / name).mkdir()
            (root / "dev").write_text("#!/bin/sh\necho './dev test  all'\n")
            (root / "bin/toolcomp").write_text('#!/bin/sh\n[ "$1" = run ] || exit 2\n[ "$2" = --help ] && echo --format\nexit 0\n')
            for file in ("dev", "bin/toolcomp"):
                (root / file).chmod(0o755)
            (root / "page.md").write_text(text)
            return Page(Shown(root, root / "bin/toolcomp"), "page.md", root / "work").run().faults

    def test_sound(self):
        self.assertEqual(self.faults("```console\n$ toolcomp run a --format b\n$ echo x\nx\n```\n`./dev test`\n"), [])

    def test_exit_status(self):
        self.assertIn("exit status 1, not 0", self.faults("```console\n$ false\n```\n")[0])
        self.assertIn("exit status 0, not 1", self.faults("<!-- exit status: 1 -->\n```console\n$ true\n```\n")[0])

    def test_output(self):
        self.assertIn("something else than shown", self.faults("```console\n$ echo y\nx\n```\n")[0])

    def test_replacements(self):
        self.assertEqual(self.faults("<!-- with: no => yes -->\n```console\n$ echo no\nyes\n```\n"), [])
        self.assertIn("no command has 8h", self.faults("<!-- with: 8h => 1s -->\n```console\n$ true\n```\n")[0])

    def test_options_and_verbs(self):
        self.assertIn("has no option --shape", self.faults("<!-- not run: why -->\n```console\n$ toolcomp run --shape c\n```\n")[0])
        self.assertIn("has no verb fly", self.faults("Say `toolcomp fly`.\n")[0])
        self.assertIn("./dev has no verb fly", self.faults("    ./dev fly\n")[0])

    def test_programs(self):
        self.assertIn("that nothing runs", self.faults("```gcode\nG00\n```\n")[0])
        self.assertIn("no command uses a.nc", self.faults("<!-- file: a.nc -->\n```gcode\nG00\n```\n")[0])
        self.assertIn("page.md:4", self.faults("```python\na = 1\n```\n```python\nraise ValueError(a)\n```\n")[0].replace('page.py", line 5', "page.md:4"))
        self.assertIn("says something else", self.faults("<!-- source: dev -->\n```python\nx = 2\n```\n")[0])


class Site(unittest.TestCase):
    PAGE = '<html><head><link href="a.css"></head><body id="top"><a href="b.html#two">b</a><img src="a.svg"></body></html>'

    def faults(self, page, css=""):
        folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        (folder / "a.html").write_text(page)
        (folder / "b.html").write_text('<p id="two"></p>')
        (folder / "a.svg").write_text("<svg/>")
        (folder / "a.css").write_text(css)
        return [f for f in [*whole.links(folder), *whole.contents(folder)] if not f.startswith("only")]

    def test_sound(self):
        self.assertEqual(self.faults(self.PAGE, "a { background: url(a.svg) }"), [])

    def test_links(self):
        self.assertIn("no file c.html", self.faults(self.PAGE.replace("b.html", "c.html"))[0])
        self.assertIn("no anchor", self.faults(self.PAGE.replace("#two", "#three"))[0])

    def test_from_outside(self):
        self.assertIn("loads https://", self.faults(self.PAGE.replace("a.svg", "https://a.b/c.svg"))[0])
        self.assertIn("loads //", self.faults(self.PAGE, "@import '//a.b/c.css';")[0])

    def test_left_as_written(self):
        self.assertIn("left as it is written", self.faults(self.PAGE.replace("<a ", r"<!-- generate: clauses x --><a "))[0])

    def test_other_bytes(self):
        one, two = (pathlib.Path(tempfile.mkdtemp()) for _ in range(2))
        for folder in (one, two):
            self.addCleanup(shutil.rmtree, folder)
            (folder / "a").write_text("a")
        self.assertEqual(list(whole.again(one, two)), [])
        (two / "a").write_text("b")
        (two / "c").write_text("")
        self.assertEqual(len(list(whole.again(one, two))), 2)


class Pages(unittest.TestCase):
    def test_links_of_the_source_tree(self):
        links = pages.Links()
        text = links.rewrite("docs/kits.md", "[`a`](adapters.md) [r](../README.md#x) [f](../dev) [o](https://a.b) [n](none.md) `[c](d)`")
        self.assertEqual(text, "[`a`](adapters.md) [r](index.md#x) f (`../dev`) [o](https://a.b) n (`none.md`) `[c](d)`")
        self.assertEqual(links.faults, ["docs/kits.md: no file none.md"])

    def test_lists_behind_paragraphs(self):
        self.assertEqual(pages.commonmark("text\n* a\n  * b\n\n```\nx\n* y\n```"), "text\n\n* a\n    * b\n\n```\nx\n* y\n```")

    @unittest.skipUnless(shutil.which("blahtexml"), "no blahtexml")
    def test_formulas(self):
        text = formulas.formulas("a \\(x^2\\) `\\(y\\)`\n")
        self.assertIn("<msup><mi>x</mi><mn>2</mn></msup>", text)
        self.assertIn("`\\(y\\)`", text)
        with self.assertRaises(ValueError):
            formulas.formulas("\\( \\frac{1 \\)")


if __name__ == "__main__":
    unittest.main()
