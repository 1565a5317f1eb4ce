#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Looks at a page as Chromium shows it: opens FILE without a screen, presses keys, prints, and writes what it saw as JSON.

It speaks the DevTools protocol over a pipe; nothing but Python and Chromium is needed.
"""

import argparse
import base64
import fcntl
import json
import os
import pathlib
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time

PATIENCE = 120  # seconds that an answer may take: tests share their machine


class Browser:
    """One Chromium with one page."""

    def __init__(self, profile, webgl):
        command = [
            shutil.which("chromium"), "--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run",
            "--disable-background-networking", "--disable-component-update", "--disable-dev-shm-usage",
            "--hide-scrollbars", f"--user-data-dir={profile}", "--remote-debugging-pipe",
        ]  # fmt: skip
        command += ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"] if webgl else ["--disable-3d-apis"]
        # The browser reads file 3 and writes file 4: ours stand above both.
        ours = [fcntl.fcntl(fd, fcntl.F_DUPFD_CLOEXEC, 10) for pair in (os.pipe(), os.pipe()) for fd in pair]
        reads, self.out, self.into, writes = ours
        self.process = subprocess.Popen(
            command, close_fds=False, preexec_fn=lambda: (os.dup2(reads, 3), os.dup2(writes, 4)),
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(reads)
        os.close(writes)
        self.buffer = b""
        self.next = 0
        self.session = None
        self.events = []
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(f"{domain}.enable")

    def close(self):
        self.process.kill()
        self.process.wait()

    def message(self):
        """The next one, answer or event."""
        until = time.monotonic() + PATIENCE
        while b"\0" not in self.buffer:
            if not select.select([self.into], [], [], max(0, until - time.monotonic()))[0]:
                raise TimeoutError("Chromium does not answer")
            read = os.read(self.into, 1 << 20)
            if not read:
                raise EOFError("Chromium has ended")
            self.buffer += read
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def ask(self, method, **parameters):
        self.next += 1
        request = {"id": self.next, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        os.write(self.out, json.dumps(request).encode() + b"\0")
        while True:
            message = self.message()
            if message.get("id") == self.next:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']['message']}")
                return message["result"]
            self.events.append(message)

    def seen(self, name):
        return [event["params"] for event in self.events if event.get("method") == name]

    def wait_for(self, name):
        while not self.seen(name):
            self.events.append(self.message())

    def value(self, expression):
        answer = self.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"].get("exception", {}).get("description", expression))
        return answer["result"].get("value")

    def size(self, width, height):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                 mobile=width < 600)
        self.settle()

    def scheme(self, name):
        self.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": name}])
        self.settle()

    def settle(self):
        """Two frames later everything is drawn."""
        self.value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))")

    def press(self, key, shift=False):
        for kind in ("keyDown", "keyUp"):
            self.ask("Input.dispatchKeyEvent", type=kind, key=key, code=key, modifiers=8 if shift else 0)
        self.settle()

    def screenshot(self, file):
        size = self.ask("Page.getLayoutMetrics")["cssContentSize"]
        clip = {"x": 0, "y": 0, "width": size["width"], "height": min(size["height"], 15000), "scale": 1}
        image = self.ask("Page.captureScreenshot", captureBeyondViewport=True, clip=clip)["data"]
        pathlib.Path(file).write_bytes(base64.b64decode(image))


def colours(browser):
    """How many colours the view is drawn in."""
    return browser.value(
        """(() => {
             const canvas = document.querySelector('.looked-at canvas');
             const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
             return new Set(new Uint32Array(pixels.buffer)).size;
           })()""")


# Of the views of a page one in which something deviates, and of those that with the most blocks.
CHOOSE = """{
  const blocks = (figure) => JSON.parse(figure.querySelector('script').textContent).steps.length;
  const worth = (figure) => 1e6 * (figure.querySelector('[type=range]') !== null) + blocks(figure);
  const views = [...document.querySelectorAll('figure.live')].sort((a, b) => worth(b) - worth(a));
  views[0].classList.add('looked-at');
  blocks(views[0]);
}"""
IMAGE = "document.querySelector('.looked-at canvas').toDataURL()"
STEP = "Number(document.querySelector('.looked-at').dataset.step)"
WORDS = "document.querySelector('.looked-at .view-words').textContent"


def steps(browser):
    """The block selected, and whether the image and the words change, key by key."""
    browser.value("document.querySelector('.looked-at canvas').focus()")
    list_of = []
    for key, shift in (("Home", False), ("ArrowRight", False), ("ArrowLeft", False), ("End", False),
                       ("ArrowRight", True), ("]", False)):
        image, words = browser.value(IMAGE), browser.value(WORDS)
        browser.press(key, shift)
        list_of.append({"key": ("Shift+" if shift else "") + key, "step": browser.value(STEP),
                        "drawn_anew": browser.value(IMAGE) != image, "told_anew": browser.value(WORDS) != words})
    return list_of


def look(browser, url, pictures):
    browser.size(1280, 900)
    browser.ask("Page.navigate", url=url)
    browser.wait_for("Page.loadEventFired")
    # Every view is started when it is seen.
    browser.value("""(async () => {
      for (const figure of document.querySelectorAll('figure.view')) {
        figure.scrollIntoView();
        await new Promise((done) => setTimeout(done, 200));
      }
    })()""")
    browser.settle()
    result = {
        "views": browser.value("document.querySelectorAll('figure.view').length"),
        "live": browser.value("document.querySelectorAll('figure.live').length"),
        "pictures_shown": browser.value(
            "[...document.querySelectorAll('.picture')].filter((p) => p.offsetHeight > 0).length"),
    }
    if result["live"]:
        result["blocks"] = browser.value(CHOOSE)
        result["colours"] = colours(browser)
        result["keys"] = steps(browser)
    result["overflow"] = {}
    for width in (1280, 400):
        browser.size(width, 900)
        result["overflow"][str(width)] = browser.value(
            "document.documentElement.scrollWidth - document.documentElement.clientWidth")
        for scheme in ("light", "dark"):
            browser.scheme(scheme)
            result[f"{scheme}_paper"] = browser.value("getComputedStyle(document.body).backgroundColor")
            if pictures:
                browser.value("document.querySelectorAll('figure.view').forEach((f) => f.scrollIntoView())")
                browser.value("new Promise((done) => setTimeout(done, 500))")
                browser.screenshot(pathlib.Path(pictures) / f"{width}-{scheme}.png")
    browser.size(1280, 900)
    browser.scheme("light")
    pdf = base64.b64decode(browser.ask("Page.printToPDF", preferCSSPageSize=True, paperWidth=8.27, paperHeight=11.69)["data"])
    if pictures:
        (pathlib.Path(pictures) / "print.pdf").write_bytes(pdf)
    result["printed_pages"] = len(re.findall(rb"/Type\s*/Page\b", pdf))
    result["console"] = [
        *(entry["entry"]["text"] for entry in browser.seen("Log.entryAdded") if entry["entry"]["level"] == "error"),
        *(json.dumps(call["args"]) for call in browser.seen("Runtime.consoleAPICalled") if call["type"] == "error"),
        *(thrown["exceptionDetails"]["text"] for thrown in browser.seen("Runtime.exceptionThrown")),
    ]
    result["requests"] = [
        request["request"]["url"] for request in browser.seen("Network.requestWillBeSent")
        if request["request"]["url"] != url
    ]
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("--without-webgl", action="store_true", help="as in a browser that cannot draw in space")
    parser.add_argument("--pictures", help="folder for screenshots and the printed page")
    arguments = parser.parse_args()
    if shutil.which("chromium") is None:
        sys.exit("chromium is not installed")
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = Browser(profile, not arguments.without_webgl)
        try:
            print(json.dumps(look(browser, arguments.file.resolve().as_uri(), arguments.pictures), indent=1))
        finally:
            browser.close()


if __name__ == "__main__":
    main()
