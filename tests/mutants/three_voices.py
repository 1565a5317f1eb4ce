#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Faults planted in the model and in the formal specification: does fuzzing with three voices find each, and say who
stands alone?

Of each fault the text is changed, compiled anew and linked with everything else as it is (voices_main.cc); then so many
fresh directed cases of its section are put to model, fast engine and formal specification. Found: two of them disagree,
and the one with the fault is said to stand alone. Exit status 1 where one was not found, or another was accused, or
the three differ as they stand.
"""
import argparse
import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

import specification
from specification import CUTTER_B, CUTTER_C, FACE, FLANK, LENGTH, OFFSET, ROOT

EDGE, SIDE = "fanuc/leading-edge-offset", "fanuc/tool-side-compensation"
TIP, POSTURE = "fanuc/tool-center-point-control", "fanuc/tool-posture-control"

# Section, cases it may take, file below model/, the text there and what stands in its place.
MODEL = [
    (LENGTH, 500, "fanuc/tool_length_offset/rules.cpp", "plus ? value : Rational(-value)", "value"),
    (OFFSET, 500, "fanuc/tool_offset/rules.cpp", "? once * 2 : once", "? once : once"),
    (CUTTER_B, 500, "fanuc/cutter_compensation_b/rules.cpp", ": Rational(-block.offset)", ": block.offset"),
    (CUTTER_C, 2000, "fanuc/corner/rules.cpp", "former.is_arc(), latter.is_arc());\n    // fanuc.cutter-c.outer-acute",
     "false, latter.is_arc());\n    // fanuc.cutter-c.outer-acute"),
    (EDGE, 2000, "fanuc/leading_edge_offset/rules.cpp", "vector(before.sense,", "vector(Sense::backward,"),
    (SIDE, 2000, "fanuc/tool_side_compensation/rules.cpp", "given.treatment == 1", "given.treatment == 7"),
    (TIP, 2000, "fanuc/tool_center_point_control/rules.cpp", "tool.unit + exact::sin", "tool.unit - exact::sin"),
    (POSTURE, 2000, "fanuc/tool_posture_control/rules.cpp", "order(to, from), 1) != Sign::zero",
     "order(to, from), 1) == Sign::positive"),
    (FACE, 500, "heidenhain/face_milling/rules.cpp", "contact.dr2 * lean + ring.change * ring.u;", "contact.dr2 * lean;"),
    (FLANK, 2000, "heidenhain/peripheral_milling/rules.cpp", "next->is_peripheral() ? next->side : motion.side",
     "next->is_peripheral() ? motion.side : motion.side"),
]

# The same below spec/formal/program.
SPECIFICATION = [
    (LENGTH, 500, "LengthOffset.v", "Subtract => (- x)%num", "Subtract => x"),
    (OFFSET, 500, "ToolShift.v", "Some (negb minus_written)", "Some true"),
    (CUTTER_B, 500, "CutterB.v", "or_else letters (travel", "or_else None (travel"),
    (CUTTER_C, 2000, "CutterC.v", "(leg_before s b (- rho_of x)%num)", "(leg_before s b (rho_of x))"),
    (EDGE, 2000, "EdgeVector.v", "leading_by (backward v) r", "leading_by by_sign r"),
    (SIDE, 2000, "SideGroups.v", "if q1 && negb starts &&", "if q1 &&"),
    (TIP, 2000, "Lean.v", "let tangent := if clockwise", "let tangent := if negb clockwise"),
    (POSTURE, 2000, "PosturePath.v", "if above then h else (- h)%num", "h"),
    (FACE, 500, "KlartextFace.v", "n_less_t := sub3 n t", "n_less_t := n"),
    (FLANK, 2000, "KlartextPeripheral.v", "(or_else (next_left n) (left_side l))", "(left_side l)"),
]


def changed(file, text, instead):
    was = file.read_text()
    if was.count(text) < 1:
        sys.exit(f"{file}: there is no {text}")
    return was.replace(text, instead, 1)


class Bench:
    """Compiles as the build does, and links a searcher with one library of its own."""

    def __init__(self, build):
        self.build = build
        commands = json.loads((build / "compile_commands.json").read_text())
        self.commands = {entry["file"]: entry for entry in commands}
        self.searcher = build / "mutants_voices_main.o"
        command = next(e for f, e in self.commands.items() if f"{build}/certify/" in f and "unity_" in f)
        self.compile(command, ROOT / "tests/mutants/voices_main.cc", self.searcher)

    def compile(self, entry, source, target):
        words = shlex.split(entry["command"])
        at = words.index("-o")
        words[at + 1] = str(target)
        words[words.index("-c") + 1] = str(source)
        # Whatever is not used any more is no error; dependencies are not written.
        dropped = {words.index(w) + i for w in ("-MF", "-MT") if w in words for i in (0, 1)}
        words = [w for i, w in enumerate(words) if i not in dropped and w not in ("-MD", "-Werror")]
        subprocess.run([*words, "-w"], check=True, cwd=entry["directory"])

    def link(self, folder, library, instead):
        """The searcher with `instead` in place of a library of the build."""
        line = specification.link_command(self.build)
        words = [w for w in shlex.split(line) if w not in (":", "&&") and not w.endswith(".o")]
        program = folder / "voices"
        words[words.index("-o") + 1] = str(program)
        words = [str(instead) if w == library else w for w in words]
        words.insert(words.index("-o"), str(self.searcher))
        subprocess.run(words, check=True, cwd=self.build)
        return program

    def with_model(self, folder, name, text, instead):
        source = ROOT / "model" / name
        scratch = folder / "changed.cpp"
        scratch.write_text(changed(source, text, instead))
        unity = next(pathlib.Path(f) for f in self.commands
                     if "toolcomp_model" in f and f'"{source}"' in pathlib.Path(f).read_text())
        together = folder / unity.name
        together.write_text(unity.read_text().replace(f'"{source}"', f'"{scratch}"'))
        member = folder / (unity.name + ".o")
        self.compile(self.commands[str(unity)], together, member)
        library = folder / "libtoolcomp_model.a"
        shutil.copy(self.build / "model/libtoolcomp_model.a", library)
        subprocess.run(["ar", "r", library, member], check=True, stderr=subprocess.DEVNULL)
        return self.link(folder, "model/libtoolcomp_model.a", library)

    def with_specification(self, folder, name, text, instead):
        program, extracted = folder / "program", folder / "extracted"
        shutil.copytree(specification.PROGRAM, program)
        (program / name).write_text(changed(program / name, text, instead))
        # What does not rest on the changed file is not made again.
        shutil.copytree(self.build / "spec_engine/extracted", extracted)
        subprocess.run([ROOT / "spec_engine/compile", extracted, program], check=True, stdout=subprocess.DEVNULL)
        library = folder / "libtoolcomp_spec_engine.a"
        shutil.copy(self.build / "spec_engine/libtoolcomp_spec_engine.a", library)
        subprocess.run(["ar", "r", library, folder / "extracted/specification.o"], check=True, stderr=subprocess.DEVNULL)
        return self.link(folder, "spec_engine/libtoolcomp_spec_engine.a", library)


def search(program, section, cases):
    run = subprocess.run([program, section, str(cases)], capture_output=True, text=True, timeout=900)
    return run.stdout.strip() or f"exit status {run.returncode}"


def judge(bench, alone, fault):
    section, cases, name, text, instead = fault
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        make = bench.with_model if alone == "the model" else bench.with_specification
        said = search(make(folder, name, text, instead), section, cases)
    found = said.startswith("found ") and f": {alone} stands alone" in said
    what = " ".join(f"{name}: {text} as {instead}".split())
    print(f"{'ok    ' if found else 'MISSED'} {section:32} {cases:5} {what}\n       {said}", flush=True)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--in", dest="where", choices=("model", "specification"), help="these faults alone")
    parser.add_argument("--section", help="those of this section alone")
    options = parser.parse_args()
    bench = Bench(options.build.resolve())
    tables = {"model": ("the model", MODEL), "specification": ("the formal specification", SPECIFICATION)}
    missed = 0
    with tempfile.TemporaryDirectory() as temporary:
        sound = bench.link(pathlib.Path(temporary), "", "")
        for section in sorted({fault[0] for _, table in tables.values() for fault in table}):
            if options.section not in (None, section):
                continue
            said = search(sound, section, 500)
            missed += not said.startswith("not found")
            print(f"{'ok    ' if said.startswith('not found') else 'MISSED'} {section:32}   500 as it stands: {said}", flush=True)
    for where, (alone, table) in tables.items():
        if options.where in (None, where):
            missed += sum(not judge(bench, alone, fault) for fault in table if options.section in (None, fault[0]))
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
