#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The parts of LinuxCNC's adapter that need no LinuxCNC: translation, machines, recordings. Values by hand."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "adapters" / "linuxcnc"))
sys.dont_write_bytecode = True
import recording  # noqa: E402
from machine import NotApplicable, machine_of, unit_of  # noqa: E402
from translate import PREAMBLE, by_tip, translate  # noqa: E402

THREE = {"axes": ["X", "Y", "Z"],
         "offsets": {"H": {"1": "12.5", "2": "-3"}, "D": {"1": {"geometry": 5, "wear": "-0.25"}}}}
TRUNNION = {"axes": ["X", "Y", "Z", "A", "C"], "offsets": {"H": {"1": 50}},
            "parameters": {"19680": 12, "19681": 4, "19682": 1, "19684": 0, "19686": 5, "19687": 3, "19689": 0,
                           "19700": 1, "19701": 2, "19702": 3, "19704": -4, "19705": -5}}


def lines(program, setup=None):
    return translate(program, setup or THREE).text.splitlines()[PREAMBLE:]


class Translation(unittest.TestCase):
    def test_line_for_line(self):
        self.assertEqual(lines("%\nO1\nN10 G01 X1. F100 (comment)\n\nM30\n"), ["", "", "G1 X1. F30000", "", "M2"])

    # What FANUC runs and LinuxCNC refuses: the last code counts, the last word counts, an arc of 0 degrees.
    def test_what_linuxcnc_refuses_does_not_apply(self):
        for program in ("G90 G91 X1\n", "G00 G01 X1 F100\n", "G17 G17\n", "G00 X1 X2\n", "G00 X0 Y0\nG02 X0 Y0 R10. F100\n",
                        "G00 X5.\nG91 G02 X0 R10. F100\n"):
            with self.subTest(program), self.assertRaises(NotApplicable):
                lines(program)
        self.assertEqual(lines("G00 X5.\nG02 X-5. R10. F100\n")[1], "G2 X-5. R10. F30000")
        self.assertEqual(lines("G90 G00 X5.\n")[0], "G90 G0 X5.")

    def test_a_cutting_move_needs_a_feed(self):
        for program in ("G01 X1.\n", "G00 X1.\nG02 X2. R5.\n", "G01 X1. F5\nX2. F0\n"):
            with self.assertRaises(NotApplicable, msg=program):
                lines(program)
        for program in ("G00 X1.\n", "G01\nG00 X1.\n", "F5\nG01 X1.\n"):
            self.assertEqual(len(lines(program)), program.count("\n") + 1)
        self.assertEqual(lines("G01 X1.\n", {**THREE, "parameters": {"1411": 100}})[0], "G1 X1.")
        with self.assertRaises(NotApplicable):
            lines("G01 X1.\n", {**THREE, "parameters": {"1411": "0"}})

    def test_offsets_stand_beside_their_codes(self):
        self.assertEqual(lines("G43 H1 Z5\nG41 D1 X1\nG40 X2\n")[:3], ["G43 Z5 H1", "G41 X1 D1", "G40 X2"])
        self.assertEqual(lines("D1\nG41 X1\n")[:2], ["", "G41 X1 D1"])
        self.assertEqual(lines("G43 H1 Z5\nH2 Z6\n")[:2], ["G43 Z5 H1", "Z6 G43 H2"])

    def test_tools_are_a_length_and_a_diameter(self):
        self.assertEqual(translate("G43 H1 Z0\nG41 D1 X1\n", THREE).tools, {1: [12.5, 9.5]})

    def test_rests_are_milliseconds(self):
        translated = translate("G04 P1500\nG4 P20\n", THREE)
        self.assertEqual(translated.text.splitlines()[PREAMBLE:-1], ["G4 P1.5", "G4 P0.02"])
        self.assertAlmostEqual(translated.translation.rests, 1.52)
        for program in ("G04 X1.", "G04 P1.5", "G04 P1 X1"):
            with self.assertRaises(NotApplicable, msg=program):
                lines(program)

    def test_block_skip(self):
        self.assertEqual(lines("/X1\n/G69\nX2\n", {**THREE, "block_skip": True})[:3], ["", "", "X2"])
        self.assertEqual(lines("/X1\n")[0], "X1")

    def test_inches(self):
        inch = {**THREE, "units": "inch"}
        self.assertEqual(float(unit_of(inch)), 25.4)
        self.assertEqual(translate("G43 H2 Z0\n", inch).tools, {2: [-76.2, 0.0]})

    def test_what_it_does_not_have(self):
        for program in ("G44 H1 Z0", "G28 Z0", "G10 L10 P1 R1", "G19 G41 D1 Y1", "G43 H401 Z1", "G43 H0 Z1", "X#1",
                        "M98 P1", "O43.4", "A5"):
            with self.assertRaises(NotApplicable, msg=program):
                lines(program)

    def test_what_no_machine_has(self):
        for parameter, program in (("5001#0", "G43 H1 Z0"), ("5003#0", "G41 D1 X1"), ("3401#0", "X1")):
            value = 0 if parameter == "3401#0" else 1
            with self.assertRaises(NotApplicable, msg=parameter):
                lines(program, {**THREE, "parameters": {parameter: value}})
        lines("X1", {**THREE, "parameters": {"5001#0": 1, "5003#0": 1}})  # without effect there

    def test_the_kinematics_is_always_in_force(self):
        lines("G43.4 H1 X0 Z0\nA30 C40\nA0 C0\nG49 Z0\n", TRUNNION)
        for program in ("A30\nG43.4 H1 Z0\n", "G43.4 H1 Z0 A5\n", "G43.4 H1 Z0\nA5\nG49 Z0\n",
                        "G43.4 H1 Z0\nA5\nG49 Z0 A0\n"):
            with self.assertRaises(NotApplicable, msg=program):
                lines(program, TRUNNION)
        lines("A30\n", TRUNNION)  # without G43.4 each axis moves by itself

    def test_by_tip(self):
        self.assertTrue(by_tip("N1 g43.4 H1"))
        self.assertFalse(by_tip("G43 H1 (G43.4)"))


class Machines(unittest.TestCase):
    def test_the_trunnion(self):
        machine = machine_of(TRUNNION, True)
        self.assertEqual(machine.module.joints, "XYZAC")
        prefix = "xyzac-trt-kins."
        self.assertEqual(machine.pins, {prefix + "y-offset": 4.0, prefix + "z-offset": 5.0, prefix + "x-rot-point": 1.0,
                                        prefix + "y-rot-point": -2.0, prefix + "z-rot-point": -2.0})

    def test_a_sense_that_no_module_has(self):
        parameters = {**TRUNNION["parameters"], "19684": 1}
        with self.assertRaises(NotApplicable):
            machine_of({**TRUNNION, "parameters": parameters}, True)

    def test_an_offset_that_the_module_has_not(self):
        parameters = {**TRUNNION["parameters"], "19703": 1}
        with self.assertRaises(NotApplicable):
            machine_of({**TRUNNION, "parameters": parameters}, True)


class Recordings(unittest.TestCase):
    def split(self, text):
        with tempfile.NamedTemporaryFile("w") as file:
            file.write(text)
            file.flush()
            return recording.split(file.name, 1)

    def test_programs_come_apart(self):
        runs, lost = self.split("1 5.0 9 1\n2 6.0 14 1\n3 0.0 9 2\n")
        self.assertEqual(runs, {1: [(9, ["5.0"]), (14, ["6.0"])], 2: [(9, ["0.0"])]})
        self.assertEqual(lost, set())

    def test_lost_samples(self):
        self.assertEqual(self.split("1 5.0 9 1\n3 6.0 14 1\n4 0.0 9 2\n")[1], {1})
        self.assertEqual(self.split("1 5.0 9 1\noverrun\n8 6.0 14 2\n")[1], {2})

    def test_the_preamble_is_cut_off(self):
        samples = [(PREAMBLE + 3, ["stale"]), (PREAMBLE - 1, ["a"]), (0, ["b"]), (PREAMBLE + 1, ["c"])]
        self.assertEqual(recording.program_part(samples[1:]), [(0, ["b"]), (PREAMBLE + 1, ["c"])])
        self.assertEqual(recording.program_part(samples), [(0, ["b"]), (PREAMBLE + 1, ["c"])])
        with self.assertRaises(recording.Lost):
            recording.program_part([(0, ["b"])])


if __name__ == "__main__":
    unittest.main()
