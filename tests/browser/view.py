#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Looks at a page of `toolcomp view` as Chromium shows it, and writes what it saw as JSON.

  view.py FILE [--without-webgl] [--pictures FOLDER]   keys, search, sizes, schemes, a burst of keys, print
  view.py URL --edits PROGRAM                          a served page: PROGRAM is changed, broken and mended
"""

import argparse
import base64
import json
import os
import pathlib
import re
import sys
import tempfile
import time

from look import PATIENCE, Browser

FIGURE = "document.querySelector('figure.view')"
SEEN = f"""(() => {{
  const figure = {FIGURE};
  const row = figure.querySelector('.row.selected');
  const canvas = figure.querySelector('.view-space canvas');
  const list = figure.querySelector('.list').getBoundingClientRect();
  const box = row && row.getBoundingClientRect();
  return {{
    block: Number(figure.dataset.block),
    row: row && row.querySelector('.text').textContent,
    in_view: Boolean(row) && box.top >= list.top && box.bottom <= list.bottom,
    text: figure.querySelector('.view-words pre').textContent,
    numbers: [...figure.querySelectorAll('.numbers tr:not(.field)')].map((r) => [...r.children].map((c) => c.textContent).join(' ').trim()),
    clauses: [...figure.querySelectorAll('.clauses code')].map((c) => c.textContent),
    alarms: [...figure.querySelectorAll('.callout')].map((c) => c.textContent),
    notes: [...figure.querySelectorAll('.note')].map((c) => c.textContent),
    rows: figure.querySelectorAll('.row').length,
    picture: canvas ? canvas.toDataURL() : '',
  }};
}})()"""


def wait(browser, expression):
    until = time.monotonic() + PATIENCE
    while time.monotonic() < until:
        try:
            if browser.value(expression):
                return True
        except RuntimeError:
            pass  # between two pages
        time.sleep(0.1)
    return False


def wrong(browser, url):
    """What the console says, and what was asked for besides the page."""
    return {
        "console": [
            *(e["entry"]["text"] for e in browser.seen("Log.entryAdded") if e["entry"]["level"] == "error"),
            *(json.dumps(c["args"]) for c in browser.seen("Runtime.consoleAPICalled") if c["type"] == "error"),
            *(t["exceptionDetails"]["text"] for t in browser.seen("Runtime.exceptionThrown")),
        ],
        "requests": sorted({r["request"]["url"] for r in browser.seen("Network.requestWillBeSent")} - {url}),
    }


class Pictures:
    """Pictures by number: the same number for the same one."""

    def __init__(self):
        self.known = []

    def number(self, seen):
        picture = seen.pop("picture")
        if picture not in self.known:
            self.known.append(picture)
        return {**seen, "picture": self.known.index(picture)}


def type_text(browser, text):
    browser.ask("Input.insertText", text=text)
    browser.settle()


def burst(browser, key, times):
    """A key that repeats, whether or not the page keeps up."""
    for _ in range(times):
        browser.next += 1
        request = {"id": browser.next, "method": "Input.dispatchKeyEvent", "sessionId": browser.session,
                   "params": {"type": "rawKeyDown", "key": key, "code": key, "autoRepeat": True}}
        os.write(browser.out, json.dumps(request).encode() + b"\0")
    last = browser.next
    while True:
        message = browser.message()
        if message.get("id") == last:
            break
        browser.events.append(message)
    browser.settle()


def look(browser, url, pictures):
    browser.size(1280, 800)
    browser.ask("Page.navigate", url=url)
    browser.wait_for("Page.loadEventFired")
    browser.settle()
    numbers = Pictures()
    result = {"keys": [], "blocks": browser.value(f"JSON.parse({FIGURE}.querySelector('script').textContent).program.blocks.length")}

    def see():
        return numbers.number(browser.value(SEEN))

    for key in ("Home", "ArrowDown", "ArrowRight", "ArrowUp", "PageDown", "End", "Home"):
        browser.press(key)
        result["keys"].append({"key": key, **see()})
    before = browser.value(f"Number({FIGURE}.dataset.block)")
    burst(browser, "ArrowDown", 300)
    result["burst"] = browser.value(f"Number({FIGURE}.dataset.block)") - before
    browser.press("Home")
    browser.press("?")
    result["help"] = browser.value("document.querySelector('dialog').open")
    browser.press("Escape")
    result["help_closed"] = not browser.value("document.querySelector('dialog').open")
    result["sizes"] = {}
    for width in (1280, 400):
        browser.size(width, 800)
        for scheme in ("light", "dark"):
            browser.scheme(scheme)
            result["sizes"][f"{width}-{scheme}"] = {
                "overflow": browser.value("document.documentElement.scrollWidth - document.documentElement.clientWidth"),
                "paper": browser.value("getComputedStyle(document.body).backgroundColor"),
                "colours": browser.value(
                    f"""(() => {{
                      const canvas = {FIGURE}.querySelector('.view-space canvas');
                      if (!canvas) return 0;
                      const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
                      return new Set(new Uint32Array(pixels.buffer)).size;
                    }})()"""),
            }
            if pictures:
                browser.screenshot(pathlib.Path(pictures) / f"view-{width}-{scheme}.png")
    browser.size(1280, 800)
    browser.scheme("light")
    result["pictures_shown"] = browser.value("[...document.querySelectorAll('svg')].filter((p) => p.getBoundingClientRect().height > 0).length")
    browser.ask("Emulation.setEmulatedMedia", media="print")
    result["printed"] = browser.value(
        """({
          picture: document.querySelector('figure > .picture svg').getBoundingClientRect().height > 0,
          list: document.querySelector('.list').getBoundingClientRect().height > 0,
        })""")
    pdf = base64.b64decode(browser.ask("Page.printToPDF", preferCSSPageSize=True)["data"])
    result["printed_pages"] = len(re.findall(rb"/Type\s*/Page\b", pdf))
    browser.ask("Emulation.setEmulatedMedia", media="")
    return {**result, **wrong(browser, url)}


def searches(browser, queries):
    """What each query finds: the block selected and how many there are."""
    found = {}
    for query in queries:
        browser.press("Home")
        browser.press("/")
        type_text(browser, query)
        found[query] = [browser.value(f"{FIGURE}.querySelector('.view-words pre').textContent"),
                        browser.value("document.querySelector('.search output').textContent")]
        browser.press("Escape")
    return found


def changed_program(program, change):
    """As an editor saves: beside it, then renamed."""
    beside = program.with_name(program.name + ".new")
    beside.write_bytes(change(program.read_bytes()))
    beside.rename(program)


def edits(browser, url, program):
    browser.size(1280, 800)
    browser.ask("Page.navigate", url=url)
    browser.wait_for("Page.loadEventFired")
    wait(browser, f"Boolean({FIGURE})")
    browser.settle()
    browser.press("Home")
    browser.press("ArrowDown")
    browser.press("ArrowDown")
    words = f"{FIGURE}.querySelector('.view-words pre').textContent"
    result = {"before": browser.value(words)}
    good = program.read_bytes()
    changed_program(program, lambda text: b"(A NEW LINE)\n(AND ANOTHER)\n" + text)
    result["came"] = wait(browser, f"{FIGURE}.dataset.block && document.querySelector('#line-2 .text').textContent === '(AND ANOTHER)'")
    browser.settle()
    result["after"] = browser.value(words)
    changed_program(program, lambda _: b"N10 G01 X\xff\n" + good)
    result["fault"] = wait(browser, "Boolean(document.querySelector('.fault .bad'))")
    result["fault_text"] = browser.value("document.querySelector('.fault').textContent")
    changed_program(program, lambda _: good)
    result["mended"] = wait(browser, f"Boolean({FIGURE} && {FIGURE}.dataset.block)")
    browser.settle()
    result["at_last"] = browser.value(words)
    return {**result, **wrong(browser, url)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", help="FILE or http://…")
    parser.add_argument("--without-webgl", action="store_true", help="as in a browser that cannot draw in space")
    parser.add_argument("--pictures", help="folder for screenshots")
    parser.add_argument("--search", action="append", default=[], help="a query for the search (repeatable)")
    parser.add_argument("--edits", type=pathlib.Path, help="the program that is served")
    arguments = parser.parse_args()
    url = arguments.page if arguments.page.startswith("http") else pathlib.Path(arguments.page).resolve().as_uri()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = Browser(profile, not arguments.without_webgl)
        try:
            if arguments.edits:
                result = edits(browser, url, arguments.edits)
            else:
                result = look(browser, url, arguments.pictures)
                result["found"] = searches(browser, arguments.search)
            json.dump(result, sys.stdout, indent=1)
        finally:
            browser.close()


if __name__ == "__main__":
    main()
