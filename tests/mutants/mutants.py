#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Random mutants of the sources: does anything notice?

Makes N mutants of the fast engine, or of the oracle and the judges of certify: an operator, a condition or a constant
changed, a statement left out. Each is one object file and one link. In the object file are all sources that the build
compiles as one, with the mutant among them. A mutant of the fast engine is searched as a campaign searches, with fresh
directed cases of all sections in turns, which says after how many executions it is found;
what is not found so answers `toolcomp certify` as ./dev certify runs it, and then runs the engine's unit tests. One of
the oracle runs the tests of the harness. Killed: found. Survived: nobody noticed. Mutants whose object code is that of
the original are counted apart, so are those that do not compile and those that took too long.

The results stand in build/mutants/SOURCES-SEED.json and .txt. A run that was ended goes on where it stopped.
"""
import argparse
import concurrent.futures
import ctypes
import hashlib
import json
import os
import pathlib
import queue
import random
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = {
    "fast": ["fast/**/*.cpp"],
    "model": ["model/**/*.cpp"],
    "oracle": ["judge/oracle/*.cpp", "certify/judge.cpp", "certify/certificate.cpp", "certify/capabilities.cpp",
               "certify/event_fields.cpp", "certify/controller.cpp"],
}
# The sound engine takes some half a minute for 5,000 executions a section: what takes so long hangs.
SEARCH_SECONDS = 240


def tests_of(engine):
    """The engine's unit tests, which know no policy; of the model, which is not certified, the golden corpus first."""
    texts = (path.read_text() for path in ROOT.glob(f"tests/unit/**/{engine}_*.cpp"))
    suites = {suite for text in texts for suite in re.findall(r"^TEST\((\w+),", text, re.MULTILINE)}
    corpus = [("toolcomp", "corpus check", "")] if engine == "model" else []
    return [*corpus, ("unit", ":".join(f"{suite}.*" for suite in sorted(suites)), "")]


# Programs and which of their tests, or of their arguments; the first word of the sources they know. Quick ones first.
ORACLE_TESTS = [("unit", "Answers.*:Capabilities.*:FindingFile.*:FilesOfFindings.*:Report.*:LabelPlaces.*:Markup.*:PathSvg.*:"
                         "ToolShapes.*", "certify"),
                ("harness", "Comparator.*:Conditions.*:ArcFit.*:PoseErrors.*:PoseFit.*:RotaryMachines.*:NearTies.*:Space*:"
                            "HeadsBeforeAlarms.*:RadiusArcs.*:Regression.*:Singular.*:Trials.*:Widths.*", "judge"),
                ("toolcomp", "corpus hard", "judge"),
                ("harness", "*Liars.*", "judge"),
                ("toolcomp", "corpus check", "judge"),
                ("harness_faults", "Streams.*-*WholeCase", "judge")]
SLOW_ORACLE_TESTS = [("harness_faults", "SeededFaults.Each*", "judge"),
                     ("unit", "Trace*:SharedCause.*", ""),
                     ("harness_faults", "SeededFaults.The*", "judge"),
                     ("harness", "WidthsOf*:*/WidthsOf*:Laws.*:Inventory.*", "judge"),
                     ("harness_faults", "Streams.*WholeCase", "judge"),
                     ("harness_misbehaviour", "*", "certify"),
                     ("harness", "Each/Controllers.*", "certify")]

SWAPS = [(" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" == ", " != "), (" != ", " == "),
         (" && ", " || "), (" || ", " && "), (" + ", " - "), (" - ", " + "), (" * ", " / "), (" / ", " * "),
         (" += ", " -= "), (" -= ", " += "), ("std::min", "std::max"), ("std::max", "std::min"),
         ("return true;", "return false;"), ("return false;", "return true;"), ("++", "--"), (" < ", " > "),
         (" > ", " < ")]
INCLUDE = re.compile(r'^#include "(/.*\.cpp)"$', re.M)
CONSTANT = re.compile(r"(?<![\w.#])(\d+(?:\.\d+)?)(?![\w.'])")
DELETABLE = re.compile(r"^\s+(?!return\b|case\b|default\b|using\b|const\b|constexpr\b|static\b|auto\b|struct\b|enum\b|"
                       r"break;|template\b|friend\b|throw\b|explicit\b|typedef\b|delete\b|virtual\b)"
                       r"[\w:.>\-\[\]*+]+(\(|\s*[-+*/|&]?=\s|\+\+;|--;).*;$")


def code_of(line):
    """The line with comments and texts blanked, so that places stay."""
    line = re.sub(r'"(\\.|[^"\\])*"', lambda m: " " * len(m.group()), line)
    line = re.sub(r"'(\\.|[^'\\])'", lambda m: " " * len(m.group()), line)
    at = line.find("//")
    return line if at < 0 else line[:at]


def closing(text, opening):
    depth = 0
    for i in range(opening, len(text)):
        depth += (text[i] == "(") - (text[i] == ")")
        if depth == 0:
            return i
    return -1


def mutations_of(line):
    """(operator, line changed) for everything that can be changed in a line."""
    code = code_of(line)
    stripped = code.strip()
    if not stripped or stripped.startswith(("#", "static_assert", "namespace", "using ", "template")):
        return
    for old, new in SWAPS:
        for found in re.finditer(re.escape(old), code):
            yield old.strip() + " as " + new.strip(), line[:found.start()] + new + line[found.end():]
    for found in re.finditer(r"\bif (?:constexpr )?\(", code):
        end = closing(code, found.end() - 1)
        if end < 0 or "constexpr" in found.group():
            continue
        for value in ("true", "false"):
            yield "condition " + value, line[:found.end()] + value + line[end:]
    for found in re.finditer(r"(?<![\w)\]])!(?=[\w(])", code):
        yield "negation left out", line[:found.start()] + line[found.end():]
    for found in CONSTANT.finditer(code):
        number = found.group(1)
        changed = [number + "1" if "." in number else str(int(number) + 1), "0" if number != "0" else "1"]
        for new in changed:
            if float(new) != float(number):
                yield f"{number} as {new}", line[:found.start()] + new + line[found.end():]
    if DELETABLE.match(code.rstrip()) and closing(code, code.find("(")) != -2 and code.count("(") == code.count(")"):
        yield "statement left out", re.match(r"\s*", line).group() + ";"


def all_mutations(patterns):
    for path in sorted({p for pattern in patterns for p in ROOT.glob(pattern)}):
        lines = path.read_text().splitlines()
        for i, line in enumerate(lines):
            for operator, changed in mutations_of(line):
                yield path.relative_to(ROOT), i, operator, line, changed


def end_with_parent():
    """A mutant that hangs must not outlive a run that was killed."""
    pr_set_pdeathsig = 1
    ctypes.CDLL(None).prctl(pr_set_pdeathsig, signal.SIGKILL)


def run(command, timeout, **how):
    """Exit status, or None after the time-out; what it started ends with it."""
    process = subprocess.Popen(command, start_new_session=True, preexec_fn=end_with_parent, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, **how)
    try:
        out, _ = process.communicate(timeout=timeout)
        return process.returncode, out.decode(errors="replace")
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        return None, ""


def commands_of(build):
    """For each source, the command that compiles it, and what that compiles as one: None where it is the source alone.

    A file of the fast engine is compiled twice; the first is the engine as it is shipped."""
    commands = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        file = pathlib.Path(entry["file"])
        group = file.read_text() if "Unity" in file.parts else None
        for source in INCLUDE.findall(group) if group else [str(file)]:
            commands.setdefault(source, (entry, group))
    return commands


class Bench:
    """Where one mutant at a time is made and judged."""

    def __init__(self, build, work, options):
        self.build, self.work, self.sources, self.timeout = build, work, options.sources, options.timeout
        self.cases, self.runs = options.cases, options.runs
        oracle = ORACLE_TESTS if options.quick else ORACLE_TESTS + SLOW_ORACLE_TESTS
        self.tests = oracle if self.sources == "oracle" else tests_of(self.sources)
        self.commands = commands_of(build)
        self.originals = {}
        self.baseline = {}
        work.mkdir(parents=True, exist_ok=True)
        self.libraries = self.link_line("toolcomp")
        if self.sources != "oracle":
            flags = ["-std=c++20", "-O1", f"-I{ROOT}", f"-I{build}/generated", "-isystem", "/usr/include/eigen3"]
            for name in ("serve_main", "search_main"):
                main = ROOT / f"tests/mutants/{name}.cc"
                subprocess.run(["g++", *flags, "-c", main, "-o", work / f"{name}.o"], check=True)

    def link_line(self, target):
        """The libraries of a target, in the order of its link."""
        out = subprocess.run(["ninja", "-C", self.build, "-t", "commands", target], check=True, capture_output=True,
                             text=True).stdout.splitlines()[-1]
        words = shlex.split(out)
        words = words[words.index("-o") + 2:]
        libraries = []
        for word in words:
            if word == "&&":
                break
            if word.endswith(".a") or ".so" in word or word.startswith("-l"):
                libraries.append(str(self.build / word) if word.endswith(".a") and not word.startswith("/") else word)
        return libraries

    def compile(self, path, text):
        """The object file of a text in place of a source, with what is compiled with it, or None."""
        entry, group = self.commands[str(ROOT / path)]
        words = shlex.split(entry["command"])
        if words[0].endswith("ccache"):
            words = words[1:]
        source, target = self.work / ("unit_" + path.name), self.work / "unit.o"
        source.write_text(text)
        if group:
            alone, source = source, self.work / ("group_" + path.name)
            source.write_text(group.replace(f'"{ROOT / path}"', f'"{alone}"'))
        keep = []
        skip = 0
        for word in words:
            if skip:
                skip -= 1
            elif word in ("-o", "-c", "-MF", "-MT", "-MQ"):
                skip = 1
            elif word not in ("-Werror", "-MD", "-O2", "-O3"):
                keep.append(word)
        ccache = ["ccache"] if shutil.which("ccache") else []
        status, _ = run([*ccache, *keep, "-w", "-O1", "-c", str(source), "-o", str(target)], 300,
                        cwd=entry["directory"])
        return target if status == 0 else None

    def original_hash(self, path):
        if path not in self.originals:
            target = self.compile(path, (ROOT / path).read_text())
            self.originals[path] = hashlib.sha256(target.read_bytes()).hexdigest()
        return self.originals[path]

    def link(self, objects, program, libraries):
        status, out = run(["g++", *map(str, objects), *libraries, "-o", str(program)], 300, cwd=self.build)
        return "" if status == 0 else out

    def link_test(self, test, objects, program):
        """As the build links a test, its own objects too, with these before its libraries."""
        command = subprocess.run(["ninja", "-C", self.build, "-t", "commands", test], check=True, capture_output=True,
                                 text=True).stdout.splitlines()[-1]
        words = [w for w in shlex.split(command) if w not in (":", "&&")]
        at = words.index("-o")
        status, out = run([*words[:at], *map(str, objects), "-o", str(program), *words[at + 2:]], 300, cwd=self.build)
        return "" if status == 0 else out

    def certify(self, program, arguments):
        report = self.work / "report"
        command = [str(self.build / "toolcomp"), "certify", "--controller", str(program), "--report",
                   str(report), "--timeout", "5", "--corpus", str(ROOT / "corpus/golden"), *arguments]
        return run(command, self.timeout, cwd=ROOT)[0]

    def search(self, objects):
        """Outcome, by what, executions; None where it does not link, no outcome where nothing was found."""
        program = self.work / "search"
        if self.link([self.work / "search_main.o", *objects], program, self.libraries):
            return None
        status, out = run([str(program), str(self.runs)], min(self.timeout, SEARCH_SECONDS), cwd=ROOT)
        lines = out.splitlines() or [""]
        if status is None:
            return "timeout", "search", None
        if lines[-1].startswith("found "):
            _, executions, what = lines[-1].split(" ", 2)
            return "killed", f"search, {executions} executions: {what}", int(executions)
        if lines[-1].startswith("not found"):
            return "", "", None
        last = [int(line.split()[1]) for line in lines if line.startswith("at ")] or [0]
        return "killed", f"search, exit status {status} after about {last[-1]} executions", last[-1]

    def judge_engine(self, target):
        found = self.search([target])
        if found is None:
            return "does not compile", "link", None
        if found[0]:
            return found
        if self.sources == "model":
            return self.judge_by_tests("", [target])
        program = self.work / "serve"
        if self.link([self.work / "serve_main.o", target], program, self.libraries):
            return "does not compile", "link", None
        # The golden corpus first: most end there, and it is quick.
        for what, arguments in self.stages():
            status = self.certify(program, arguments)
            if status is None:
                return "timeout", what, None
            if status != self.baseline[what]:
                return "killed", f"{what}, status {status}", None
        return self.judge_by_tests("", [target])

    def stages(self):
        programs = sorted(str(p) for e in ("nc", "h") for p in (ROOT / "examples").glob(f"*/*/*.{e}"))
        return (("golden", ["--cases", "0", *programs[:1]]), ("certify", ["--cases", str(self.cases), *programs]))

    def measure_baseline(self, path):
        """What comes of it without a change: what fails then tells nothing of a mutant."""
        # By the same way as with a mutant of the source at `path`.
        unchanged = [self.compile(path, (ROOT / path).read_text())]
        outcome, what, _ = self.judge_by_tests("", unchanged)
        if outcome != "survived":
            sys.exit(f"without a mutant {what} fails: ./dev build")
        if self.sources == "oracle":
            return
        found = self.search(unchanged)
        if found is None or found[0]:
            sys.exit(f"the sound engine is found: {found}")
        self.baseline = {} if self.sources == "model" else {what: self.certify(f"{self.build}/toolcomp serve --engine fast", arguments)
                         for what, arguments in self.stages()}
        if self.baseline:
            print(f"exit statuses of the sound engine: {self.baseline}", flush=True)
        if not set(self.baseline.values()) <= {0, 3}:
            sys.exit("the sound engine does not conform")

    def passes(self, program, which):
        """None where it takes too long."""
        gtest = ["--gtest_fail_fast", "--gtest_brief=1", f"--gtest_filter={which}"]
        status, _ = run([str(program), *(which.split() if " " in which else gtest)], self.timeout, cwd=ROOT)
        return None if status is None else status == 0

    def judge_by_tests(self, sources, objects):
        linked = set()
        for test, which, known in self.tests:
            if sources and not sources.startswith(known):
                continue
            program = self.work / test
            if test not in linked and self.link_test(test, objects, program):
                return "does not compile", "link", None
            linked.add(test)
            passed = self.passes(program, which)
            if passed is None:
                return "timeout", f"{test} {which}", None
            if not passed:
                return "killed", f"{test} {which}", None
        return "survived", "", None

    def judge(self, mutation):
        """Outcome, by what, executions to find it."""
        path, i, _, _, changed = mutation
        lines = (ROOT / path).read_text().splitlines()
        original = self.original_hash(path)
        lines[i] = changed
        target = self.compile(path, "\n".join(lines) + "\n")
        if target is None:
            return "does not compile", "", None
        if hashlib.sha256(target.read_bytes()).hexdigest() == original:
            return "same object code", "", None
        return self.judge_by_tests(str(path), [target]) if self.sources == "oracle" else self.judge_engine(target)


def table(results):
    counts = {}
    for r in results:
        counts[r["outcome"]] = counts.get(r["outcome"], 0) + 1
    out = [f"{len(results)} mutants: " + ", ".join(f"{n} {o}" for o, n in sorted(counts.items()))]
    judged = counts.get("killed", 0) + counts.get("survived", 0) + counts.get("timeout", 0)
    if judged:
        out.append(f"found, or ended by their time: {100 * (judged - counts.get('survived', 0)) / judged:.1f} %")
    searched = sorted(r["executions"] for r in results if r.get("executions") is not None)
    if searched:
        within = ", ".join(f"{sum(n <= most for n in searched)} within {most}" for most in (100, 1000, 10000))
        out.append(f"found by searching: {len(searched)}, {within}, the last after {searched[-1]} executions")
    for r in sorted(results, key=lambda r: (r["outcome"] != "survived", r["outcome"], r["file"], r["line"])):
        out.append(f"{r['outcome']:17} {r['file']}:{r['line']}: {r['operator']}   {r['by']}")
        out.append(f"    - {r['original'].strip()}\n    + {r['changed'].strip()}")
    return "\n".join(out) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sources", choices=sorted(SOURCES), default="fast")
    parser.add_argument("--count", type=int, default=150)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--file", help="mutants of this source alone, e.g. fast/geometry/path.cpp")
    parser.add_argument("--line", type=int, help="of --file, this line alone")
    parser.add_argument("--again", action="store_true", help="those of an earlier run that survived, once more")
    parser.add_argument("--quick", action="store_true", help="of the oracle, the quick tests alone")
    parser.add_argument("--cases", type=int, default=1000, help="generated cases a section")
    parser.add_argument("--runs", type=int, default=5000, help="executions a section of the search")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--timeout", type=float, default=900, help="seconds a mutant may take")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release",
                        help="a build with the tests")
    options = parser.parse_args()
    every = [m for m in all_mutations([options.file] if options.file else SOURCES[options.sources])
             if options.line in (None, m[1] + 1)]
    chosen = random.Random(options.seed).sample(every, min(options.count, len(every)))
    folder = ROOT / "build/mutants"
    name = f"{options.sources}-{options.seed}" + (f"-{pathlib.Path(options.file).stem}" if options.file else "")
    name += f"-{options.line}" if options.line else ""
    benches = [Bench(options.build.resolve(), folder / f"{name}.work" / str(job), options) for job in range(options.jobs)]
    record = folder / f"{name}.json"
    results = json.loads(record.read_text())["mutants"] if record.exists() else []
    if options.again:
        survivors = [r for r in results if r["outcome"] == "survived"]
        results = [r for r in results if r["outcome"] != "survived"]
        chosen = [(pathlib.Path(r["file"]), r["line"] - 1, r["operator"], r["original"], r["changed"])
                  for r in survivors if (ROOT / r["file"]).read_text().splitlines()[r["line"] - 1] == r["original"]]
    done = {(r["file"], r["line"], r["original"], r["changed"]) for r in results}
    if chosen and (options.sources != "oracle" or not record.exists()):
        benches[0].measure_baseline(chosen[0][0])
    for bench in benches:
        bench.baseline = benches[0].baseline
    print(f"{len(every)} places, {len(chosen)} mutants, {len(done)} of an earlier run", flush=True)
    free = queue.SimpleQueue()
    for bench in benches:
        free.put(bench)

    def judged(mutation):
        bench = free.get()
        start = time.monotonic()
        try:
            return mutation, bench.judge(mutation), round(time.monotonic() - start, 1)
        finally:
            free.put(bench)

    waiting = [m for m in chosen if (str(m[0]), m[1] + 1, m[3], m[4]) not in done]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for n, job in enumerate(concurrent.futures.as_completed([pool.submit(judged, m) for m in waiting]), 1):
            (path, i, operator, line, changed), (outcome, by, executions), seconds = job.result()
            results.append({"file": str(path), "line": i + 1, "operator": operator, "original": line,
                            "changed": changed, "outcome": outcome, "by": by, "executions": executions,
                            "seconds": seconds})
            print(f"{n}/{len(waiting)} {outcome:17} {path}:{i + 1}: {operator} {by}", flush=True)
            partial = record.with_suffix(".part")
            partial.write_text(json.dumps({"sources": options.sources, "seed": options.seed, "mutants": results},
                                          indent=1))
            partial.rename(record)
    text = table(results)
    (folder / f"{name}.txt").write_text(text)
    print(text + str(record))


if __name__ == "__main__":
    main()
