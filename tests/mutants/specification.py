#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Faults planted in the formal specification, one at a time: does judging it by the exact model find each?

Of each fault the text is changed, extracted and compiled anew, linked into the command, and certified with the golden
vectors and so many generated cases of its section. Says which were found, and by which clause. Exit status 1 where one
was not found, or where the text as it stands does not conform.
"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "spec/formal/program"
LENGTH, MEASUREMENT, OFFSET = "fanuc/tool-length-offset", "fanuc/tool-length-measurement", "fanuc/tool-offset"
CUTTER_B, CUTTER_C = "fanuc/cutter-compensation-b", "fanuc/cutter-compensation-c"
FACE, FLANK, CONTOUR = "heidenhain/face-milling", "heidenhain/peripheral-milling", "heidenhain/programmed-contour"

# Section, generated cases it may take, file, the text there and what stands in its place.
FAULTS = [
    (LENGTH, 100, "LengthOffset.v", "Subtract => (- x)%num", "Subtract => x"),
    (LENGTH, 500, "LengthOffset.v", "without (taken_away l) set", "taken_away l"),
    (LENGTH, 2000, "LengthOffset.v", "alarm_if (3 <=? size offset)", "alarm_if (4 <=? size offset)"),
    (LENGTH, 500, "LengthOffset.v", "ofh s && negb (sets_mode c) then None", "false then None"),
    (LENGTH, 500, "Coordinates.v", "(sum (shifted c) (local c))", "(shifted c)"),
    (LENGTH, 500, "Codes.v", "(x * integer 254 / integer 10)", "(x * integer 25)"),
    (LENGTH, 2000, "Memory.v", "if incremental m then (old + r)%num else r", "r"),
    (MEASUREMENT, 500, "Measurement.v", "(d + ahead (zone s))", "d"),
    (MEASUREMENT, 500, "Measurement.v", "if later : bool then p else b", "p"),
    (MEASUREMENT, 500, "OwnMove.v", "(t - on_axis (vector l) - on_axis (shift st))", "(t - on_axis (shift st))"),
    (OFFSET, 100, "ToolShift.v", "Some ShortenTwice => Some (- (integer 2 * l))", "Some ShortenTwice => Some (- l)"),
    (OFFSET, 500, "ToolShift.v", "Some (negb minus_written)", "Some true"),
    (OFFSET, 2000, "ToolShift.v", "alarm_if negative \"PS0038\"", "alarm_if false \"PS0038\""),
    (LENGTH, 2000, "Arcs.v", "xorb clockwise larger", "clockwise"),
    (CUTTER_B, 100, "CutterRules.v", "RightHand => (- value)%num", "RightHand => value"),
    (CUTTER_B, 500, "CutterB.v", "or_else letters (travel", "or_else None (travel"),
    (CUTTER_B, 500, "CutterB.v", "if names_plane s c then (zero2, Off) else kept", "kept"),
    (CUTTER_B, 500, "CutterB.v", "if incremental (in_modes c) then 0%num else", "if false then 0%num else"),
    (CUTTER_B, 500, "CutterB.v", "alarm_if (negb nothing) \"PS0034\"", "alarm_if false \"PS0034\""),
    (CUTTER_C, 100, "Corners.v", "add (perpendicular a) (scale r (unit_way a))", "perpendicular a"),
    (CUTTER_C, 100, "Corners.v", "if behind : bool then (foot + root square)", "if behind : bool then (foot - root square)"),
    (CUTTER_C, 500, "Corners.v", "Got (of_arc a ++ [tangents_meet a b] ++ of_arc b)", "Got (of_arc a ++ [tangents_meet a b])"),
    (CUTTER_C, 500, "Corners.v", "Apart => Alarm \"PS0033\"", "Apart => Got [perpendicular a]"),
    (CUTTER_C, 2000, "Corners.v", "then kept_behind limit last rest", "then kept_behind limit v rest"),
    (CUTTER_C, 500, "Interference.v", "(add2 travel (sub2 w v))", "(add2 travel (sub2 v w))"),
    (CUTTER_C, 2000, "Interference.v", "is_positive \"fanuc.cutter-c.interference-sweep\" x", "Got false"),
    (CUTTER_C, 500, "CutterModes.v", "names_plane s c then 2 else 1", "names_plane s c then 1 else 1"),
    (CUTTER_C, 500, "CutterC.v", "NoVector => Got [zero2]", "NoVector => Got [perpendicular (leg_behind s a)]"),
    (CUTTER_C, 2000, "Interference.v", "if silent && negb (given (about p))", "if false && negb (given (about p))"),
    (CUTTER_C, 2000, "CutterModes.v", "series_30i s && bit s \"5008#3\"", "bit s \"5008#3\""),
    (CUTTER_C, 500, "CutterC.v", "repeated || repeats b", "repeated"),
    (CUTTER_C, 500, "CutterC.v", "(leg_before s b (- rho_of x)%num)", "(leg_before s b (rho_of x))"),
    (CUTTER_C, 500, "CutterC.v", "(last vs zero2) (hd zero2 ws)", "(hd zero2 vs) (hd zero2 ws)"),
    (CUTTER_C, 2000, "CutterC.v", "if all_stay : bool then Got group else", "if false : bool then Got group else"),
    (FACE, 100, "KlartextFace.v", "n_less_t := sub3 n t", "n_less_t := n"),
    (FACE, 100, "KlartextTool.v", "alarm_if larger \"E_OVERSIZE_DR\"", "alarm_if false \"E_OVERSIZE_DR\""),
    (FACE, 500, "KlartextTool.v", "(v0 + (v1 - v0) * (theta - b0) / (b1 - b0))", "v0"),
    (FACE, 500, "KlartextTool.v", "if with_flat : bool then R' - R2' else 0", "R' - R2'"),
    (FACE, 500, "KlartextFace.v", "is_negative \"heidenhain.face.contact-jump\" (dot3 w b)", "Got false"),
    (FACE, 2000, "KlartextFace.v", "(excess + permitted)", "(excess + permitted + permitted)"),
    (FACE, 500, "KlartextState.v", "if with_i w then (shift + v)%num else v", "v"),
    (FACE, 500, "KlartextState.v", "if minus_written then (- x)%num else x", "x"),
    (FLANK, 100, "KlartextPeripheral.v", "(if left then 1 else - (1))", "1"),
    (FLANK, 500, "KlartextPeripheral.v", "(or_else (next_left n) (left_side l))", "(left_side l)"),
    (FLANK, 2000, "KlartextPeripheral.v", "c' <- of_next n (Some c)", "c' <- of_next n made"),
    (FLANK, 100, "KlartextProgram.v", "if given before then Cancelling else Programmed", "Programmed"),
    (FLANK, 500, "KlartextState.v", "(if without_tool then radius_mode st else R0)", "(radius_mode st)"),
    (CONTOUR, 100, "KlartextMoves.v", "if contour (tcpm_of st) then full_radius e else dR", "dR"),
    (CONTOUR, 500, "KlartextMoves.v", "if contour (tcpm_of st) then p else nominal_tip st t p", "nominal_tip st t p"),
    (CONTOUR, 500, "KlartextState.v", "(direction_held (tcpm_of st)) (contour (tcpm_of st))", "(direction_held (tcpm_of st)) false"),
]


def link_command(build):
    commands = subprocess.run(["ninja", "-C", build, "-t", "commands", "toolcomp"], check=True, capture_output=True,
                              text=True).stdout.splitlines()
    return commands[-1]


def make(build, folder, change=None):
    """The command with the specification, changed, in `folder`."""
    program = folder / "program"
    shutil.copytree(PROGRAM, program)
    if change is not None:
        name, text, instead = change
        file = program / name
        was = file.read_text()
        if was.count(text) < 1:
            sys.exit(f"{name}: there is no {text}")
        file.write_text(was.replace(text, instead, 1))
    subprocess.run([ROOT / "spec_engine/compile", folder / "extracted", program], check=True, stdout=subprocess.DEVNULL)
    library = folder / "libtoolcomp_spec_engine.a"
    shutil.copy(build / "spec_engine/libtoolcomp_spec_engine.a", library)
    subprocess.run(["ar", "r", library, folder / "extracted/specification.o"], check=True, stderr=subprocess.DEVNULL)
    command = folder / "toolcomp"
    line = link_command(build).replace("spec_engine/libtoolcomp_spec_engine.a", str(library)).replace("-o toolcomp ", f"-o {command} ")
    subprocess.run(line, shell=True, check=True, cwd=build, stdout=subprocess.DEVNULL)
    return command


def certify(build, command, section, cases, folder):
    """The exit status, and the first clause of a finding."""
    report = folder / "report"
    status = subprocess.run([build / "toolcomp", "certify", "--controller", f"{command} serve --engine spec", "--section",
                             section, "--cases", str(cases), "--seed", "11", "--report", report], capture_output=True).returncode
    certificate = json.loads((report / "certificate.json").read_text())
    findings = certificate["findings"]
    return status, findings[0].get("clause", "") if findings else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    options = parser.parse_args()
    build = options.build.resolve()
    missed = 0
    for number, (section, cases, name, text, instead) in enumerate([(LENGTH, 500, None, "", "")] + FAULTS):
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            command = make(build, folder, None if name is None else (name, text, instead))
            status, clause = certify(build, command, section, cases, folder)
        if name is None:
            found, what = status in (0, 3) and not clause, "as it stands"
        else:
            found, what = status == 1, f"{name}: {text} as {instead}"
        missed += not found
        print(f"{'ok    ' if found else 'MISSED'} {section:30} {cases:5} {what}  {clause}", flush=True)
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
