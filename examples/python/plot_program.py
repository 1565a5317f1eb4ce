"""Draws a program, its compensation vectors and a recording of it, in 3D.

    PYTHONPATH=build/release/python python3 examples/python/plot_program.py [PICTURE [PROGRAM]]

Without a picture to write to, a window opens. The program is one of straight lines. The recording is made here: the exact
path, sampled, with one corner a tenth of a millimetre off; `judge` says where it leaves the path.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Sequence

import matplotlib.pyplot as plt
import numpy as np
import numpy.typing as npt

import toolcomp

PROGRAM = Path(__file__).parent.parent / "fanuc/tapered-boss-tool-side/boss.nc"
TOLERANCE = 0.05

Points = npt.NDArray[np.float64]


def points(moves: Sequence[toolcomp.Move], field: str, axes: Sequence[str] = "XYZ") -> Points:
    """Axes of a field of every move, a row a move."""
    return np.array([[float(getattr(move, field)[axis]) for axis in axes] for move in moves])


def recorded(path: Points) -> Points:
    """Samples of straight lines along the path, one corner of it moved in X."""
    path = path.copy()
    path[len(path) // 2, 0] += 0.1
    steps = np.linspace(0, 1, 20, endpoint=False)[:, None]
    return np.vstack([a + steps * (b - a) for a, b in zip(path, path[1:])] + [path[-1:]])


def main(arguments: Sequence[str]) -> int:
    """Draws, and prints what the judge says of the recording."""
    program = Path(arguments[1]) if len(arguments) > 1 else PROGRAM
    moves = [event for event in toolcomp.run(program) if isinstance(event, toolcomp.Move)]
    programmed, compensated = points(moves, "programmed"), points(moves, "point")
    recording = recorded(points(moves, "axes", list(moves[0].axes)))
    columns = dict(zip(moves[0].axes, np.ascontiguousarray(recording.T)))
    verdict = toolcomp.judge(program, columns, tolerance=TOLERANCE)
    print("conforms" if verdict.conforms else "does not conform")
    for finding in verdict.findings:
        print(f"{finding.kind}, line {finding.line}: {finding.distance[1]:.3f} at sample {finding.sample}")

    axes = plt.figure(figsize=(9, 7)).add_subplot(projection="3d")
    axes.plot(*programmed.T, color="0.6", label="programmed")
    axes.plot(*compensated.T, color="C0", label="compensated")
    axes.plot(*(columns[axis] for axis in "XYZ"), ".", color="C1", markersize=2, label="recording")
    axes.quiver(*programmed.T, *(compensated - programmed).T, color="C2", linewidth=0.8, label="vectors")
    if verdict.findings:
        worst = [[finding.at[axis] for axis in "XYZ"] for finding in verdict.findings]
        axes.plot(*np.array(worst).T, "o", color="C3", fillstyle="none", label="findings")
    axes.set(xlabel="X", ylabel="Y", zlabel="Z", title=program.name)
    axes.legend()
    if arguments:
        plt.savefig(arguments[0], dpi=120)
    else:
        plt.show()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
