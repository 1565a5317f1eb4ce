#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs what the documentation shows: every command and program of every page, in a folder of its own for each page.

shown.py --source FOLDER --toolcomp FILE [--jobs N] [PAGE…]: exit status 0 if all of it runs as shown. blocks.py says
what may stand above a block. What only installs, builds or measures (LOOKED_UP) is not run: that it is there is looked up,
and so are verbs and options of commands within sentences and tables.
"""

import argparse
import concurrent.futures
import functools
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from blocks import blocks  # noqa: E402

PATIENCE = 240  # seconds a command may take: tests share their machine
LOOKED_UP = ("./dev", "sbatch", "tests/", "engines/", "cmake", "ctest", "bash spec/")
PROGRAMS = ("gcode", "klartext", "toml", "sh", "c", "cpp")


class Shown:
    def __init__(self, source, toolcomp):
        self.source, self.toolcomp = pathlib.Path(source).resolve(), pathlib.Path(toolcomp).resolve()
        self.dev_help = subprocess.run([self.source / "dev", "help"], capture_output=True, text=True, check=True).stdout

    @functools.cache
    def help(self, *verbs):
        done = subprocess.run([self.toolcomp, *verbs, "--help"], capture_output=True, text=True, check=False)
        return done.stdout if done.returncode == 0 else None

    def help_of(self, words):
        """What the verb says that begins these words: `run`, or `corpus check`, a verb of a verb."""
        text = self.help(words[0])
        inner = text and len(words) > 1 and words[1].isalpha() and re.search(rf"^  {re.escape(words[1])} ", text, re.M)
        return self.help(*words[:2]) if inner else text

    def environment(self, folder):
        python = self.toolcomp.parent / "python"
        return {**os.environ, "PATH": f"{self.toolcomp.parent}:/usr/bin:{os.environ['PATH']}", "HOME": str(folder), "NO_COLOR": "1",
                "TOOLCOMP": str(self.toolcomp), "PYTHONPATH": str(python), "PYTHONDONTWRITEBYTECODE": "1", "MPLBACKEND": "Agg"}

    def look_up(self, command):
        """Why a command cannot be as it is written; none if its verb and options are there."""
        command = re.sub(r"[…|>].*", "", command)
        try:
            words = shlex.split(command)
        except ValueError:
            words = command.split()
        while words and re.fullmatch(r"[A-Z_]+=.*", words[0]):
            words.pop(0)
        if not words:
            return None
        filters = [word for word in words if re.match("--gtest_filter=.", word)]
        program = self.source / words[0]
        if filters and program.is_file():
            listed = subprocess.run([program, "--gtest_list_tests", *filters], capture_output=True, text=True, check=False)
            return None if re.search(r"^  ", listed.stdout, re.M) else f"no test of {words[0]} is {filters[0]}"
        name = words[0].rsplit("/", 1)[-1] if not words[0].startswith(("tests/", "engines/")) else words[0]
        if name in ("toolcomp", "dev") and len(words) > 1:
            verb = words[1]
            text, options = self.dev_help, set()
            if name == "toolcomp":
                text = self.help_of(words[1:]) if re.fullmatch(r"[a-z]+", verb) else ""
                if text is None:
                    return f"toolcomp has no verb {verb}"
            elif not re.search(rf"^\./dev {re.escape(verb)}\b", text, re.M) and verb.isalpha():
                return f"./dev has no verb {verb}"
            elif verb in ("certify", "fuzz", "corpus", "proofs"):
                said = self.help_of(["corpus", "proofs"] if verb == "proofs" else words[1:])
                if said is None:
                    return f"toolcomp has no verb {' '.join(words[1:3])}"
                text += said
            else:
                return None  # options of the others are those of scripts
            options = {w.split("=")[0].strip("[]") for w in words[2:] if re.match(r"\[?--[a-z]", w)}
            missing = [o for o in options if o != "--help" and text and o not in text]
            return f"{name} {verb} has no option {', '.join(missing)}" if missing else None
        for word in words[:2]:
            if word.startswith(("tests/", "engines/", "spec/")) and not (self.source / word).exists():
                return f"there is no {word}"
        return None


def matches(shown, said):
    """Whether lines are as shown: … stands for any text in a line, alone for any lines."""
    parts = []
    for line in shown:
        parts.append("(?:.*\n)*?" if line.strip() == "…" else ".*?".join(map(re.escape, line.split("…"))) + "\n")
    return re.fullmatch("".join(parts), "".join(line.rstrip() + "\n" for line in said.rstrip("\n").split("\n")) if said else "")


class Page:
    """One page in its folder."""

    def __init__(self, shown, file, folder):
        self.shown, self.file, self.folder = shown, file, pathlib.Path(folder)
        self.text = (shown.source / file).read_text()
        self.faults, self.ran, self.looked_up, self.seconds = [], 0, [], []

    def fault(self, line, text):
        self.faults.append(f"{self.file}:{line}: {text}")

    def prepare(self):
        for name in ("examples", "adapters"):
            shutil.copytree(self.shown.source / name, self.folder / name, ignore=shutil.ignore_patterns("__pycache__"))
        for name in ("corpus", "spec", "fuzz", "docs"):
            (self.folder / name).symlink_to(self.shown.source.resolve() / name)
        (self.folder / "build").mkdir()
        (self.folder / "build/release").symlink_to(self.shown.toolcomp.parent)
        # README files speak of what stands beside them.
        beside = self.shown.source / pathlib.Path(self.file).parent
        if self.file.startswith("adapters/"):
            for file in beside.iterdir():
                shutil.copy(file, self.folder / file.name)

    def run(self):
        self.prepare()
        snippets = []
        for block in blocks(self.text):
            if block.note("file"):
                file = self.folder / block.note("file")
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(block.text + "\n")
                file.chmod(0o755)
                if not re.search(rf"\b{re.escape(file.name)}\b", self.text.replace(f"file: {file.name}", "")):
                    self.fault(block.line, f"no command uses {file.name}")
            elif block.note("source"):
                if block.text not in (self.shown.source / block.note("source")).read_text():
                    self.fault(block.line, f"{block.note('source')} says something else")
            elif block.note("excerpt"):
                pass
            elif block.language == "python":
                if block.note("not run"):
                    compile(block.text, self.file, "exec")
                else:
                    snippets.append(block)
            elif block.language in PROGRAMS:
                self.fault(block.line, f"a {block.language} block that nothing runs: it needs file, source or excerpt")
            else:
                self.commands(block)
        if snippets:
            # Line numbers of the page, for what Python says of it.
            program, at = "", 1
            for block in snippets:
                program += "\n" * (block.line + 1 - at) + block.text + "\n"
                at = block.line + 1 + block.text.count("\n") + 1
            (self.folder / "page.py").write_text(program)
            self.command(snippets[0].line, "/usr/bin/python3 page.py", None, 0)
        self.sentences()
        return self

    def commands(self, block):
        commands = block.commands()
        for value in (value for key, value in block.notes if key == "with"):
            if not any(value.split(" => ")[0] in command for command, _ in commands):
                self.fault(block.line, f"no command has {value.split(' => ')[0]}")
        for index, (command, output) in enumerate(commands):
            if block.note("not run") or command.startswith(LOOKED_UP):
                self.look_up(block.line, command)
                self.looked_up.append(f"{self.file}:{block.line}: {command}  ({block.note('not run') or 'builds, installs or measures'})")
                continue
            if "[" in command and re.search(r"\[--", command):
                self.fault(block.line, f"a form, no command: {command}")
                continue
            status = int(block.note("exit status") or 0) if index == len(commands) - 1 else 0
            changed = command
            for key, value in block.notes:
                if key == "with":
                    changed = changed.replace(*value.split(" => "))
            self.look_up(block.line, command)
            self.command(block.line, changed, output, status)

    def command(self, line, command, output, status):
        self.ran += 1
        begun = time.monotonic()
        try:
            done = subprocess.run(["/bin/bash", "-c", command], cwd=self.folder, env=self.shown.environment(self.folder),
                                  stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=PATIENCE, check=False)
        except subprocess.TimeoutExpired:
            self.fault(line, f"{command}: longer than {PATIENCE} s")
            return
        self.seconds.append((time.monotonic() - begun, f"{self.file}:{line}: {command}"))
        if done.returncode != status:
            self.fault(line, f"{command}: exit status {done.returncode}, not {status}\n{done.stdout[-1500:]}{done.stderr[-1500:]}")
        elif output is not None and not matches(output, done.stdout):
            self.fault(line, f"{command}: says something else than shown:\n{done.stdout[:4000]}")

    def look_up(self, line, command):
        why = self.shown.look_up(command)
        if why:
            self.fault(line, f"{command}: {why}")

    def sentences(self):
        """Commands within sentences and tables: verbs and options."""
        prose = re.sub(r"^```.*?^```", lambda m: "\n" * m[0].count("\n"), self.text, flags=re.M | re.S)
        for match in re.finditer(r"`((?:[A-Z_]+=\S+ )?(?:toolcomp|\./dev|build/release/\w+) [^`\n]+)`", prose):
            self.look_up(prose[:match.start()].count("\n") + 1, match[1])


def pages(source):
    """The pages of the site and the README: what docs/navigation.toml lists, what is in docs, rooms with commands."""
    import tomllib

    listed = [file for part in tomllib.loads((source / "docs/navigation.toml").read_text())["part"] for file, _ in part["pages"]]
    listed += ["README.md", *(str(file.relative_to(source)) for file in (source / "docs").rglob("*.md"))]
    listed += ["corpus/README.md", "adapters/examples/README.md", "examples/heidenhain/README.md", "fuzz/README.md", "tests/README.md"]
    return sorted({file for file in listed if (source / file).is_file()})


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--source", required=True, type=pathlib.Path)
    parser.add_argument("--toolcomp", required=True)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("pages", nargs="*")
    arguments = parser.parse_args()
    shown = Shown(arguments.source, arguments.toolcomp)

    def run(file):
        with tempfile.TemporaryDirectory(prefix="toolcomp-shown-") as folder:
            return Page(shown, file, folder).run()

    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        done = list(pool.map(run, arguments.pages or pages(arguments.source)))
    for page in done:
        print("\n".join(page.faults)) if page.faults else None
    ran, looked_up = sum(page.ran for page in done), [entry for page in done for entry in page.looked_up]
    print(f"{len(done)} pages, {ran} commands run, {len(looked_up)} looked up:")
    print("\n".join(looked_up))
    print("slowest:")
    print("\n".join(f"{seconds:5.1f} s {command}" for seconds, command in sorted(s for page in done for s in page.seconds)[:-8:-1]))
    if ran == 0:
        print("nothing was run")
    return 1 if ran == 0 or any(page.faults for page in done) else 0


if __name__ == "__main__":
    sys.exit(main())
