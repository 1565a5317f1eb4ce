#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""try.py PAGE: the page to try toolcomp as Chromium shows it, from disk and without a network.

What is expected is the manual's (three holes) or worked out here by hand.
"""

import json
import os
import pathlib
import sys
import tempfile
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "browser"))
from look import PATIENCE, Browser  # noqa: E402

ROOT = HERE.parent.parent
URL = pathlib.Path(sys.argv[1]).resolve().as_uri()
FRAME = "document.getElementById('frame')"
FIGURE = f"{FRAME}.contentDocument.querySelector('figure.view.live')"
NUMBERS = f"[...{FIGURE}.querySelectorAll('.numbers tr:not(.field)')].map((r) => [...r.children].map((c) => c.textContent).join(' ').trim())"

# To the left of +Y is -X: with the radius r the start-up block ends at X = 20 - r.
CORNER = "N10 G90 G17 G41 D1 G01 X20. Y20. F100\nN20 Y60.\nN30 X50.\nN40 G40 X60. Y60.\n"
SETUP = 'control = "fanuc"\naxes = ["X", "Y", "Z"]\n[offsets.D]\n1 = "{}"\n'
# R 10 over a chord of 40.
ALARM = "N10 G90 G17 G01 X10. F100\nN20 G03 X50. R10.\nN30 X0\n"


class Try(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        cls.addClassCleanup(cls.profile.cleanup)
        cls.browser = Browser(cls.profile.name, True)
        cls.addClassCleanup(cls.browser.close)
        cls.browser.ask("Network.emulateNetworkConditions", offline=True, latency=0, downloadThroughput=0, uploadThroughput=0)
        cls.browser.size(1280, 900)
        cls.open(URL)

    @classmethod
    def open(cls, url):
        cls.browser.ask("Page.navigate", url="about:blank")
        cls.browser.events = [e for e in cls.browser.events if e.get("method") != "Page.loadEventFired"]
        cls.browser.ask("Page.navigate", url=url)
        cls.browser.wait_for("Page.loadEventFired")
        cls.wait_for(f"Boolean({FIGURE})")

    @classmethod
    def wait_for(cls, expression):
        until = time.monotonic() + PATIENCE
        while time.monotonic() < until:
            try:
                if cls.browser.value(expression):
                    return
            except RuntimeError:
                pass  # between two pages
            time.sleep(0.05)
        raise TimeoutError(f"{expression}; the page says {cls.browser.value('document.body.innerText')[:2000]}")

    def type(self, place, text):
        """As a user does: all of it replaced by what is typed."""
        self.browser.value(f"document.getElementById('{place}').focus(); document.getElementById('{place}').select()")
        self.browser.ask("Input.insertText", text=text)
        self.browser.settle()

    def run_of(self, program, setup, until):
        self.type("setup", setup)
        self.type("program", program)
        self.wait_for(until)

    def select(self, block):
        self.wait_for(f"{FIGURE} && {FIGURE}.dataset.block !== undefined")
        self.browser.value(f"{FRAME}.contentWindow.focus()")
        self.browser.press("Home")
        for _ in range(block):
            self.browser.press("ArrowDown")

    def says(self, kind):
        return self.browser.value(f"[...document.querySelectorAll('#says > .{kind}')].map((li) => li.textContent)")

    def test_1_examples(self):
        """Each program of examples/ with each setup beside it; the manual: N2 G43 Z-32.0 H1 with H1 = -4 goes to -36."""
        programs = [p for p in (ROOT / "examples").glob("*/*/*") if p.suffix in (".nc", ".h")]
        wanted = sum(len(list(program.parent.glob("setup*.toml"))) for program in programs)
        self.assertEqual(self.browser.value("document.querySelectorAll('#examples option').length") - 1, wanted)
        self.open(URL + "#fanuc/three-hole-boring/three-holes.nc")
        self.wait_for(f"{FRAME}.contentDocument.title.startsWith('three-holes.nc')")
        self.select(2)
        self.assertIn("Z -36 -36 0", self.browser.value(NUMBERS))
        self.assertEqual(self.browser.value("document.getElementById('examples').selectedOptions[0].textContent"), "three hole boring")
        # Each of them runs, and says nothing of a fault.
        for i in range(wanted):
            self.browser.value("document.getElementById('status').textContent = ''")
            self.browser.value(f"(() => {{ const s = document.getElementById('examples'); s.value = {i}; s.dispatchEvent(new Event('change')); }})()")
            self.wait_for("/events in/.test(document.getElementById('status').textContent)")
            self.assertEqual(self.says("fault"), [], i)

    def test_2_the_path_follows_the_text(self):
        self.run_of(CORNER, SETUP.format("5.0"), f"{FRAME}.contentDocument.body.textContent.includes('N40 G40')")
        self.select(0)
        self.assertIn("X 15 15 0", self.browser.value(NUMBERS))
        before = self.browser.value(f"{FIGURE}.querySelector('canvas').toDataURL()")
        self.type("setup", SETUP.format("8.0"))
        self.wait_for(f"{NUMBERS}.includes('X 12 12 0')")
        self.browser.settle()
        self.assertNotEqual(self.browser.value(f"{FIGURE}.querySelector('canvas').toDataURL()"), before)
        # The block selected stays, though lines come before it.
        self.select(2)
        text = f"{FIGURE}.querySelector('.view-words pre').textContent"
        self.assertEqual(self.browser.value(text), "N30 X50.")
        self.type("program", "(ONE)\n(TWO)\n" + CORNER)
        self.wait_for(f"{FRAME}.contentDocument.querySelector('#line-2')?.textContent.includes('(TWO)')")
        self.browser.settle()
        self.assertEqual(self.browser.value(text), "N30 X50.")
        lines = self.browser.value("document.getElementById('events').textContent").splitlines()
        self.assertEqual([json.loads(line)["n"] for line in lines if json.loads(line)["kind"] == "move"][0], 10)
        self.assertEqual(json.loads(lines[0])["point"]["X"], 12)

    def test_3_an_alarm_with_its_clause(self):
        self.run_of(ALARM, SETUP.format("5.0"), "document.querySelector('#says .alarm') !== null")
        [alarm] = self.says("alarm")
        self.assertIn("line 2", alarm)
        self.assertIn("PS0020", alarm)
        name = self.browser.value("document.querySelector('#says .alarm code').textContent")
        clauses = "".join(file.read_text() for file in (ROOT / "spec/clauses").rglob("*.toml"))
        self.assertIn(f'id = "{name}"', clauses)
        self.assertIn(f"{name}\n", self.browser.value("document.querySelector('#says .alarm pre').textContent"))
        # Its button leads to the line in the text.
        self.browser.value("document.querySelector('#says .alarm button').click()")
        self.assertEqual(self.browser.value("(({ id, value, selectionEnd }) => [id, value.slice(0, selectionEnd).split('\\n').length])(document.activeElement)"), ["program", 2])

    def test_4_what_is_not_judged_and_what_cannot_be_read(self):
        self.run_of("N10 G51 X1. P2.\n", SETUP.format("5.0"), "document.querySelector('#says .not_supported') !== null")
        self.assertIn("G51", self.says("not_supported")[0])
        self.type("setup", 'control = "fanuc"\naxes =\n')
        self.wait_for("document.querySelector('#says .fault') !== null")
        self.assertIn("setup line 2", self.says("fault")[0])
        self.assertTrue(self.browser.value(f"{FRAME}.classList.contains('old')"))
        self.run_of(CORNER, SETUP.format("5.0"), f"!{FRAME}.classList.contains('old')")
        self.assertEqual(self.says("fault"), [])

    def test_5_a_link_holds_both_texts(self):
        program = CORNER + "(Größe, \U0001f527 < & \")\n"
        self.run_of(program, SETUP.format("6.5"), f"{FRAME}.contentDocument.body.textContent.includes('Größe')")
        self.browser.value("document.getElementById('share').click()")
        self.wait_for("document.getElementById('link').value !== ''")
        address = self.browser.value("document.getElementById('link').value")
        self.assertTrue(address.startswith(URL + "#z="), address)
        self.open(address)
        self.wait_for("document.getElementById('program').value !== ''")
        self.assertEqual(self.browser.value("document.getElementById('program').value"), program)
        self.assertEqual(self.browser.value("document.getElementById('setup').value"), SETUP.format("6.5"))
        # One that holds nothing says so, and what stood there stays.
        self.browser.value("window.location.hash = '#z=bm90aGluZw'")
        self.wait_for("document.getElementById('status').textContent.includes('link')")
        self.assertEqual(self.browser.value("document.getElementById('program').value"), program)

    def test_6_keys_reach_everything(self):
        """Tab goes through the page and into that of the program, whose keys then are its own."""
        self.browser.value("document.activeElement.blur(); window.focus()")
        reached = []
        for _ in range(60):
            self.browser.ask("Input.dispatchKeyEvent", type="keyDown", key="Tab", code="Tab", windowsVirtualKeyCode=9)
            self.browser.ask("Input.dispatchKeyEvent", type="keyUp", key="Tab", code="Tab", windowsVirtualKeyCode=9)
            reached.append(self.browser.value(
                f"(({{ id, tagName, className }}) => id === 'frame' ? 'in ' + {FRAME}.contentDocument.activeElement.className : id || tagName)(document.activeElement)"))
            if reached[-1] == "in list":
                break
        for wanted in ("examples", "samples", "share", "program", "setup", "in list"):
            self.assertIn(wanted, reached)
        block = self.browser.value(f"{FIGURE}.dataset.block")
        self.browser.press("End")
        self.assertNotEqual(self.browser.value(f"{FIGURE}.dataset.block"), block)

    def test_7_two_widths_and_two_schemes(self):
        papers = {}
        for width in (1280, 400):
            self.browser.size(width, 800)
            for scheme in ("light", "dark"):
                self.browser.scheme(scheme)
                for document in ("document", f"{FRAME}.contentDocument"):
                    self.assertEqual(self.browser.value(f"{document}.documentElement.scrollWidth - {document}.documentElement.clientWidth"), 0, (width, document))
                papers[scheme] = self.browser.value("getComputedStyle(document.body).backgroundColor")
                if "TOOLCOMP_PICTURES" in os.environ:
                    self.browser.value("new Promise((done) => setTimeout(done, 500))")
                    self.browser.screenshot(pathlib.Path(os.environ["TOOLCOMP_PICTURES"]) / f"try-{width}-{scheme}.png")
        self.assertNotEqual(papers["light"], papers["dark"])
        self.browser.size(1280, 900)

    def test_8_nothing_is_asked_for_and_nothing_goes_wrong(self):
        asked = {r["request"]["url"].split("#")[0] for r in self.browser.seen("Network.requestWillBeSent")}
        self.assertEqual({url for url in asked if not url.startswith(("blob:", "about:"))}, {URL})
        self.assertEqual([e["entry"]["text"] for e in self.browser.seen("Log.entryAdded") if e["entry"]["level"] == "error"], [])
        self.assertEqual([json.dumps(c["args"]) for c in self.browser.seen("Runtime.consoleAPICalled") if c["type"] == "error"], [])
        self.assertEqual([t["exceptionDetails"]["text"] for t in self.browser.seen("Runtime.exceptionThrown")], [])


if __name__ == "__main__":
    if not pathlib.Path(sys.argv[1]).exists():
        print("the page is not there: `./dev playground` builds it")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=2)
