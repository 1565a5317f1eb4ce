# SPDX-License-Identifier: Apache-2.0
"""A controller to be replaced by yours: it knows the length offset of Z."""
import re

SECTIONS = ["fanuc/tool-length-offset"]
NEEDS = ["incremental"]


def your_function(program, settings):
    at, offset, h, sign, incremental, points = {"X": 0, "Y": 0, "Z": 0}, 0, 0, 0, False, []
    for line in program:
        words = [(word[0], float(word[1:])) for word in re.findall("[A-Z][-+.0-9]+", line)]
        codes = [value for letter, value in words if letter == "G"]
        incremental = 91 in codes or incremental and 90 not in codes
        sign = 1 if 43 in codes else -1 if 44 in codes else 0 if 49 in codes else sign
        h = next((int(value) for letter, value in words if letter == "H"), h)
        before, offset = offset, sign * settings["offsets"].get(f"H{h}", 0)
        moved = [(letter, value) for letter, value in words if letter in at]
        at.update((letter, value + incremental * at[letter]) for letter, value in moved)
        if moved or offset != before:
            points.append([at["X"], at["Y"], at["Z"] + offset])
    return points, None
