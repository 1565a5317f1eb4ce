# SPDX-License-Identifier: Apache-2.0
"""What LinuxCNC has to be to run a setup: the kinematics module, its axes and its pins."""
from dataclasses import dataclass, field
from fractions import Fraction


class NotApplicable(Exception):
    """LinuxCNC has no such thing: why."""


@dataclass(frozen=True)
class Module:
    """A kinematics module as a start of LinuxCNC loads it."""

    name: str  # as in [KINS]KINEMATICS
    joints: str  # axis letter of each joint
    length_pin: str = ""  # gets motion.tooloffset.z
    pivot_pin: str = ""  # of a module whose tool length can only be set
    switch: int = 0  # motion.switchkins-type
    zero: tuple = ()  # pins that stay as they are


@dataclass
class Machine:
    module: Module
    pins: dict = field(default_factory=dict)  # geometry of this setup


XYZAC = Module("xyzac-trt-kins", "XYZAC", length_pin="xyzac-trt-kins.tool-offset")
XYZBC = Module("xyzbc-trt-kins", "XYZBC", length_pin="xyzbc-trt-kins.tool-offset")
XYZAB = Module("xyzab_tdr_kins", "XYZAB", length_pin="xyzab_tdr_kins.tool-offset-z", switch=1)
BRIDGE = Module("5axiskins coordinates=xyzbcw", "XYZBCW", length_pin="5axiskins.pivot-length")
MAX = Module("maxkins", "XYZABCUVW", pivot_pin="maxkins.pivot-length")

# (19680, first axis and direction, second axis and direction, senses) and the module.
MECHANISMS = {
    (12, "A", 1, 0, "C", 3, 0): XYZAC,
    (12, "B", 2, 0, "C", 3, 0): XYZBC,
    (12, "B", 2, 1, "A", 1, 1): XYZAB,
    (2, "C", 3, 0, "B", 2, 1): BRIDGE,
    (21, "B", 2, 1, "C", 3, 1): MAX,
}
# Parameters that say nothing about where the tool goes on these machines (of 1411 the translation asks whether there is
# a feed), and those that name the machine.
WITHOUT_EFFECT = {"1260", "1411", "1403#5", "3401#0", "6241", "6251", "6254", "19696#6", "19696#7", "19745", "19738",
                  "19739", "19741", "19742", "19743", "19744", "19608#5", "6261", "19605#5", "19630", "19631",
                  "5001#5"}
# These count only for a program with length offsets, or with cutter compensation.
OF_LENGTH = {"5001", "5001#0", "5001#1", "5001#2", "5001#3", "5001#6"}
OF_CUTTER = {"5001", "5001#2", "5001#4", "5003", "5003#0", "5003#1", "5003#2", "5008", "5008#0", "5010"}
GEOMETRY = {str(n) for n in range(19700, 19706)}
NAMED = {"19680", "19681", "19682", "19684", "19686", "19687", "19689", *GEOMETRY}
DEFAULTS = {"19697": Fraction(3), "3401#0": Fraction(1)}


def decimal(value):
    """Of a number or its text, also "5." as programs have it."""
    text = str(value)
    return Fraction(text + "0" if text.endswith(".") else text)


def parameter(setup, name):
    values = setup.get("parameters", {})
    return decimal(values[name]) if name in values else DEFAULTS.get(name, Fraction(0))


def check_parameter(setup, name):
    if parameter(setup, name) != DEFAULTS.get(name, 0):
        raise NotApplicable(f"setup: parameter {name}")


def unit_of(setup):
    """Millimetres in one unit of the setup."""
    return Fraction("25.4") if setup.get("units", "mm") == "inch" else Fraction(1)


def check_chosen(setup, by_tip):
    """Everything of a setup that LinuxCNC cannot be made to do."""
    for key, usual in {"control": "fanuc", "cutter_compensation": "C", "g49_sets_h0": False}.items():
        if setup.get(key, usual) != usual:
            raise NotApplicable(f"setup: {key} is {setup[key]}")
    for name in setup.get("parameters", {}):
        of_kinematics = name.startswith(("196", "197"))
        if by_tip if of_kinematics else name not in WITHOUT_EFFECT | OF_LENGTH | OF_CUTTER:
            if name not in NAMED | WITHOUT_EFFECT:
                check_parameter(setup, name)
    check_parameter(setup, "3401#0")


def geometry(setup, module):
    """Pins of the module by 19700 to 19705; NotApplicable where it has no such offset."""
    table = [parameter(setup, str(19700 + i)) for i in range(3)]
    between = [parameter(setup, str(19703 + i)) for i in range(3)]
    if module in (BRIDGE, MAX):
        if any(table) or any(between):
            raise NotApplicable("setup: 19700 to 19705 with a head")
        return {}
    prefix = module.name
    # The module's offsets lead from the second axis to the first; its rot-point is a point of the second.
    if module is XYZAC:
        absent, offsets, back = between[0], {"y-offset": -between[1], "z-offset": -between[2]}, between
    elif module is XYZBC:
        absent, offsets, back = between[1], {"x-offset": -between[0], "z-offset": -between[2]}, between
    else:
        absent, offsets, back = between[0] or between[1], {"x-offset": Fraction(0), "z-offset": between[2]}, [0, 0, 0]
    if absent:
        raise NotApplicable("setup: 19703 to 19705 in a direction the module has not")
    pins = {f"{prefix}.{name}": value for name, value in offsets.items()}
    for letter, a, b in zip("xyz", table, back):
        pins[f"{prefix}.{letter}-rot-point"] = a + b
    return {name: float(value * unit_of(setup)) for name, value in pins.items()}


def plain(letters):
    """A machine on which each axis moves by itself."""
    joints = "".join(letter for letter in "XYZABCUVW" if letter in letters or letter in "XYZ")
    return Module(f"trivkins coordinates={joints.lower()}", joints)


def machine_of(setup, by_tip):
    """The machine for a setup; `by_tip`: for a program with tool center point control. Throws NotApplicable."""
    check_chosen(setup, by_tip)
    letters = "".join(setup.get("axes", ["X", "Y", "Z"]))
    if not by_tip:
        return Machine(plain(letters))

    def axis(name):
        number = int(parameter(setup, name))
        return letters[number - 1] if 0 < number <= len(letters) else ""

    mechanism = (int(parameter(setup, "19680")), axis("19681"), int(parameter(setup, "19682")),
                 int(parameter(setup, "19684")), axis("19686"), int(parameter(setup, "19687")),
                 int(parameter(setup, "19689")))
    module = MECHANISMS.get(mechanism)
    if module is None or not set("XYZ") <= set(letters) <= set(module.joints):
        raise NotApplicable("setup: no kinematics module is like this machine")
    return Machine(module, geometry(setup, module))
