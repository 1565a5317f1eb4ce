#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The built documentation as a reader has it.

whole.py FOLDER [--again FOLDER] [--browser [--pictures FOLDER]]: every link and anchor leads somewhere, nothing is loaded
from outside, and there are no dates; with --again: another build has the same bytes; with --browser: Chromium shows pages
at 1280 and 400 pixels, light and dark, without a word on its console, and finds what is searched for.
Exit status 0 if all of it holds.
"""

import argparse
import base64
import filecmp
import html.parser
import pathlib
import re
import sys
import tempfile
import time
import urllib.parse

LOADS = {("script", "src"), ("link", "href"), ("img", "src"), ("source", "src"), ("iframe", "src"), ("object", "data"),
         ("use", "href"), ("image", "href"), ("input", "src")}
PAGES = ("index.html", "results.html", "first-certificate.html", "sections/fanuc/leading-edge-offset.html", "reliability.html", "variations.html")


class Page(html.parser.HTMLParser):
    """Anchors and links of a page."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.links, self.loads = set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (tag == "a" and name == "name"):
                self.anchors.add(value)
            elif (tag, name) in LOADS:
                self.loads.append((self.getpos()[0], value))
            elif tag == "a" and name == "href":
                self.links.append((self.getpos()[0], value))


def links(site):
    """Faults of links: files and anchors that are not there, and what would be loaded from elsewhere."""
    pages = {file: Page(file.read_text()) for file in sorted(site.rglob("*.html"))}
    if len(pages) < 30:
        yield f"only {len(pages)} pages"
    for file, page in pages.items():
        name = file.relative_to(site)
        for line, link in page.links + page.loads:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or link.startswith("//"):
                if (line, link) in page.loads and parts.scheme != "data":
                    yield f"{name}:{line}: loads {link}"
                continue
            if name.name == "404.html":
                continue  # shown at any place; its links begin at the root of a server
            there = (file.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else file
            if there.is_dir():
                there /= "index.html"
            if not there.is_file():
                yield f"{name}:{line}: no file {link}"
            elif parts.fragment and there in pages and urllib.parse.unquote(parts.fragment) not in pages[there].anchors | {"__skip"}:
                yield f"{name}:{line}: no anchor {link}"
    for file in sorted(site.rglob("*.css")):
        for address in re.findall(r"(?:url\(|@import\s+)[\"']?(?!data:|#)([^\"')\s]+)", file.read_text()):
            if re.match(r"(?:\w+:)?//", address) or not (file.parent / address.split("?")[0].split("#")[0]).is_file():
                yield f"{file.relative_to(site)}: loads {address}"


def contents(site):
    """Faults of what pages say: formulas, directives and marks that were left as they are written."""
    for file in sorted(site.rglob("*.html")):
        text = re.sub(r"<(pre|code)\b.*?</\1>", "", file.read_text(), flags=re.S)
        for left in re.findall(r"generate: \S+|\\\(|\$\$|\x00", text):
            yield f"{file.relative_to(site)}: left as it is written: {left!r}"


def again(site, other):
    """Faults of another build: files that it does not have alike."""
    names = sorted({str(f.relative_to(root)) for root in (site, other) for f in root.rglob("*") if f.is_file()})
    _, differ, missing = filecmp.cmpfiles(site, other, names, shallow=False)
    yield from (f"{name}: not the same bytes in another build" for name in differ + missing)


def in_the_browser(site, pictures):
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "browser"))
    from look import Browser

    def value(browser, expression):
        answer = browser.ask("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        return answer["result"].get("value")

    def until(browser, expression):
        for _ in range(300):
            found = value(browser, expression)
            if found:
                return found
            time.sleep(0.1)
        return None

    with tempfile.TemporaryDirectory() as profile:
        browser = Browser(profile, False)
        try:
            for page in PAGES:
                for width, scheme in ((1280, "light"), (400, "dark"), (400, "light"), (1280, "dark")):
                    where = f"{page} at {width}, {scheme}"
                    browser.events.clear()
                    browser.ask("Emulation.setDeviceMetricsOverride", width=width, height=1400, deviceScaleFactor=1, mobile=False)
                    browser.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
                    browser.ask("Page.navigate", url=(site / page).as_uri())
                    if not until(browser, "document.readyState == 'complete' && typeof __search_index == 'object'"):
                        yield f"{where}: the page, or the index of its search, does not come"
                    wide = value(browser, "document.documentElement.scrollWidth")
                    if wide is None or wide > width:
                        yield f"{where}: {wide} pixels wide"
                    shown = value(browser, "document.body.dataset.mdColorScheme")
                    if shown != {"light": "default", "dark": "slate"}[scheme]:
                        yield f"{where}: shown as {shown}"
                    for event in browser.events:
                        said = event["method"] in ("Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded")
                        if said:
                            yield f"{where}: console: {str(event['params'])[:300]}"
                        if event["method"] == "Network.requestWillBeSent":
                            address = event["params"]["request"]["url"]
                            if not address.startswith((site.as_uri(), "data:", "blob:")):
                                yield f"{where}: asks for {address}"
                    if pictures:
                        pictures.mkdir(parents=True, exist_ok=True)
                        name = f"{page.replace('/', '-').removesuffix('.html')}-{width}-{scheme}.png"
                        shot = browser.ask("Page.captureScreenshot", format="png")["data"]
                        (pictures / name).write_bytes(base64.b64decode(shot))
                    # The theme keeps the scheme that it has shown once.
                    value(browser, "localStorage.clear()")
            # The search, from disk.
            browser.ask("Page.navigate", url=(site / "index.html").as_uri() + "?q=interference")
            found = until(browser, "document.querySelectorAll('.md-search-result__item').length")
            if not found:
                yield "the search finds nothing for interference"
        finally:
            browser.close()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("site", type=pathlib.Path)
    parser.add_argument("--again", type=pathlib.Path)
    parser.add_argument("--browser", action="store_true")
    parser.add_argument("--pictures", type=pathlib.Path)
    arguments = parser.parse_args()
    site = arguments.site.resolve()
    faults = [*links(site), *contents(site)]
    if arguments.again:
        faults += again(site, arguments.again.resolve())
    if arguments.browser:
        faults += in_the_browser(site, arguments.pictures)
    print("\n".join(faults) or f"{site}: {sum(1 for _ in site.rglob('*.html'))} pages, all links lead somewhere, nothing is loaded from outside")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
