# SPDX-License-Identifier: Apache-2.0
"""Figures of the reliability statement that are counted in the build, and tables that stand elsewhere."""

import json
import re
import subprocess

from formal import sentences
from tree import ROOT, SECTIONS, all_clauses, clauses, toolcomp

FORMAL = sorted(str(file.relative_to(ROOT / "spec/formal")) for file in (ROOT / "spec/formal").rglob("*.v"))


def thousands(number):
    return f"{number:,}"


def manifest():
    return json.loads((ROOT / "corpus/golden/manifest.json").read_text())


def counted(_=None):
    """What there is, and the command that counts it again."""
    listed = [clause for _, clause in all_clauses()]
    kinds = {kind: sum(c["kind"] == kind for c in listed) for kind in ("normative", "parameter", "alarm", "open", "note")}
    coverage = toolcomp("spec", "coverage", "--dir", str(ROOT / "corpus/golden")).splitlines()[0]
    runs, reached, outcomes = re.match(r"(\d+) runs; (\d+) of (\d+) outcomes", coverage).groups()
    golden = manifest()
    vectors = sum(file["vectors"] for file in golden["files"])
    unproven = sum(len(ids) for ids in json.loads((ROOT / "corpus/proofs/unproven.json").read_text()).values())
    theorems = sum(keyword == "Theorem" for file in FORMAL for _, keyword, _, _ in sentences(file))
    axioms = len((ROOT / "spec/formal/allowed_axioms.txt").read_text().split())
    hard = sum(len(file.read_text().splitlines()) for file in (ROOT / "corpus/hard").rglob("*.jsonl"))
    faults = len(re.findall(r"^TOOLCOMP_FAULT\(", (ROOT / "fuzz/faults/faults.inc").read_text(), re.M))
    laws = law_rows()
    rows = [
        ("clauses", f"{len(listed)}: " + ", ".join(f"{n} {kind}" for kind, n in kinds.items()), "toolcomp spec sections"),
        ("outcomes of clauses that golden vectors reach", f"{reached} of {outcomes}, in {thousands(int(runs))} runs",
         "toolcomp spec coverage"),
        ("golden vectors, version " + golden["version"], thousands(vectors), "toolcomp corpus check"),
        ("of these proved by Coq, every event and number", thousands(vectors - unproven), "./dev proofs"),
        ("hard cases: nearest to a boundary, largest deviations", thousands(hard), "toolcomp corpus hard"),
        ("theorems of the formal specification", thousands(theorems), "bash spec/formal/check build/formal-check"),
        ("axioms they may rest on, all of Coq's real numbers", str(axioms), "bash spec/formal/check build/formal-check"),
        ("laws that know no clause", str(len(laws)), "build/release/harness --gtest_filter='Laws.*'"),
        ("seeded faults of the fast engine, each found within its budget", str(faults), "./dev mutants"),
    ]
    lines = ["| what | figure | counted again by |", "|---|---:|---|"]
    lines += [f"| {what} | {figure} | `{command}` |" for what, figure, command in rows]
    return "\n".join(lines)


def law_rows():
    text = (ROOT / "judge/laws/README.md").read_text().split("| file | laws |")[1].split("\n\n")[0]
    return re.findall(r"`([a-z-]+)`", re.sub(r"^\| `[^`]*` \|", "|", text, flags=re.M))


def sections(_=None):
    """The sections with their clauses, vectors and theorems, each a link."""
    files = manifest()["files"]
    lines = ["| section | clauses | open | golden vectors | theorems |", "|---|---:|---:|---:|---:|"]
    for section, name, formal in SECTIONS:
        listed = clauses(section)
        count = sum(file["vectors"] for file in files if file["section"] == section)
        theorems = sum(keyword == "Theorem" for _, keyword, _, _ in sentences(f"{section.split('/')[0]}/{formal}.v"))
        lines.append(f"| [{name}]({section}.md) | {len(listed)} | {sum(c['kind'] == 'open' for c in listed)} | {count} | {theorems} |")
    return "\n".join(lines)


def table(argument):
    """`FILE MARK`: what stands between the marks of that name in a file of the source tree."""
    file, mark = argument.split()
    return re.search(rf"<!-- {mark} -->\n(.*?)<!-- /{mark} -->", (ROOT / file).read_text(), re.S)[1]


def versions(_=None):
    """Version of the corpus, number of vectors, and SHA-256 of its manifest."""
    golden = manifest()
    digest = subprocess.run(["sha256sum", ROOT / "corpus/golden/manifest.json"], capture_output=True, text=True, check=True)
    count = sum(file["vectors"] for file in golden["files"])
    lines = [f"Version {golden['version']}, seed {golden['seed']}, {count} vectors; its manifest has the SHA-256",
             f"`{digest.stdout.split()[0]}`.", "", "| flag | what it means | for whoever compares |", "|---|---|---|"]
    lines += [f"| `{name}` | {flag['description']} | {flag['effect']} |" for name, flag in golden["flags"].items()]
    return "\n".join(lines)


def wrong_clauses(_=None):
    """The table of wrong clauses that both engines follow, as it stands beside the laws."""
    text = (ROOT / "judge/laws/README.md").read_text()
    return re.search(r"^\| wrong clause .*?(?=\n\n|\Z)", text, re.M | re.S)[0]
