# SPDX-License-Identifier: Apache-2.0
"""The examples. tests/documentation runs what docs/python.md shows."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import toolcomp

ENVIRONMENT = {**os.environ, "MPLBACKEND": "Agg", "PYTHONPATH": str(Path(toolcomp.__file__).parent.parent)}


def run(source: Path, *command: str) -> str:
    done = subprocess.run(
        [sys.executable, *command], cwd=source, env=ENVIRONMENT, capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_certify_function(source: Path) -> None:
    said = run(source, "examples/python/certify_function.py")
    assert said.startswith("does not conform")
    # The smallest program that shows it: at 0, an offset of 1 is to be subtracted.
    assert "axes.Z is 1 and should be -1" in said
    assert "G44" in said and "G43" not in said


def test_plot_program(source: Path, tmp_path: Path) -> None:
    picture = tmp_path / "program.png"
    said = run(source, "examples/python/plot_program.py", str(picture))
    assert said.startswith("does not conform")
    assert picture.read_bytes().startswith(b"\x89PNG") and picture.stat().st_size > 20_000
