# SPDX-License-Identifier: Apache-2.0
"""A million blocks as arrays: from Python and from C++, turn about in one run. Each turn is the best of some runs in a
process that has done one before, and ends with the moves at hand. "new" begins with a new batch; "chunks" gives one
batch a tenth of the lines at a time and drops the moves before it goes on (C++: uses their memory again).

    PYTHONPATH=build/release/python python3 tests/python/bench_batch.py build/release/toolcomp_batch_million
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import numpy.typing as npt

import toolcomp

LINES = 1_000_000
TURNS = 15
RUNS = 3
SETUP = 'control = "fanuc"\n[offsets.D]\n1 = "4.95"\n[offsets.H]\n1 = 20\n'
HEADS = {
    "length offset": ("XYZ", "G90 G01 F1000\nG43 H1 Z0\n"),
    "cutter compensation C": ("XY", "G90 G17 G01 F1000 X320. Y-2.\nG42 D1 X326. Y-1.\n"),
}

Columns = dict[str, npt.NDArray[np.float64]]


def ring() -> Columns:
    """A wavy ring, a line half a millimetre long."""
    turn = 2 * np.pi * np.arange(LINES) / 4096
    radius = 0.5 * 4096 / (2 * np.pi) + np.sin(7 * turn)
    places = {"X": radius * np.cos(turn), "Y": radius * np.sin(turn), "Z": 5 * np.sin(3 * turn)}
    return {word: np.round(values, 3) for word, values in places.items()}


def in_python(columns: Columns, head: str, chunks: int) -> float:
    """Seconds of the best run."""
    return min([_in_python(columns, head, chunks) for _ in range(RUNS)][1:])


def _in_python(columns: Columns, head: str, chunks: int) -> float:
    begun = time.perf_counter()
    batch = toolcomp.Batch(SETUP)
    batch.run(head)
    size = LINES // chunks
    count = 0
    for first in range(0, LINES, size):
        batch.lines({word: values[first : first + size] for word, values in columns.items()})
        if first + size == LINES:
            batch.end()
        moves = batch.moves()
        count += len(moves)
        if first + size < LINES:
            del moves
    seconds = time.perf_counter() - begun
    assert count >= LINES and not any(isinstance(event, toolcomp.Alarm) for event in batch.events())
    return seconds


def in_cpp(program: str, words: str, file: Path, head: str, chunks: int) -> float:
    """The same."""
    said = subprocess.run(
        [program, words, str(file), head, SETUP, str(RUNS), str(chunks)], check=True, capture_output=True, text=True
    ).stdout
    return min([float(line) for line in said.split()][1:])


def ratios(program: str) -> dict[str, tuple[float, float]]:
    """By row: nanoseconds a block in Python, and how many times that of C++: the best turn of each."""
    columns = ring()
    result = {}
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "columns"
        for name, (words, head) in HEADS.items():
            given = {word: columns[word] for word in words}
            file.write_bytes(b"".join(column.tobytes() for column in given.values()))
            for how, chunks in (("new", 1), ("chunks", 10)):
                pairs = [
                    (in_python(given, head, chunks), in_cpp(program, words, file, head, chunks)) for _ in range(TURNS)
                ]
                python, cpp = min(pair[0] for pair in pairs), min(pair[1] for pair in pairs)
                result[f"{name}, {how}"] = (python / LINES * 1e9, python / cpp)
    return result


if __name__ == "__main__":
    for name, (nanoseconds, ratio) in ratios(sys.argv[1]).items():
        print(f"{name:<32} {nanoseconds:6.1f} ns a block, {ratio:.2f} times C++")
