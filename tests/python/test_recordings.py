# SPDX-License-Identifier: Apache-2.0
"""Recordings from arrays and files. Expected values by hand."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import toolcomp

SETUP = {"control": "fanuc", "axes": ["X", "Y", "Z", "C"]}
# An L of two straight lines, ten long each, from the origin.
PROGRAM = "G90 G01 F100 X10.\nY10.\nM02\n"

T = np.linspace(0, 1, 11)
X = np.concatenate([10 * T, np.full(10, 10.0)])
Y = np.concatenate([np.zeros(11), 10 * T[1:]])


def test_conforms() -> None:
    verdict = toolcomp.judge(PROGRAM, {"X": X, "Y": Y}, tolerance=0.01, setup=SETUP)
    assert verdict.conforms and verdict.exit_status == 0
    assert (verdict.samples, verdict.samples_off, verdict.corners, verdict.corners_missed) == (21, 0, 2, 0)
    assert (verdict.recorded, verdict.not_recorded) == ("XY", "ZC")
    assert verdict.worst < 1e-12


def test_sequences_of_any_kind_are_the_same() -> None:
    lists = toolcomp.judge(PROGRAM, {"X": X.tolist(), "Y": list(Y)}, tolerance=0.01, setup=SETUP)
    halves = toolcomp.judge(PROGRAM, {"X": np.repeat(X, 2)[::2], "Y": Y.astype(np.float32)}, tolerance=0.01, setup=SETUP)
    assert lists.conforms and halves.conforms


def test_a_sample_off_the_path() -> None:
    bad = Y.copy()
    bad[5] = 0.25
    verdict = toolcomp.judge(PROGRAM, {"X": X, "Y": bad}, tolerance=0.1, setup=SETUP)
    assert verdict.exit_status == 1 and verdict.samples_off == 1
    (finding,) = verdict.findings
    assert (finding.kind, finding.sample, finding.samples, finding.line) == ("off the path", 5, 1, 1)
    assert finding.distance == pytest.approx((0.25, 0.25))
    assert finding.at["X"] == 5.0
    assert verdict.html().startswith("<!DOCTYPE html>")


def test_a_constant_shift_is_named() -> None:
    verdict = toolcomp.judge(PROGRAM, {"X": X + 0.5, "Y": Y}, tolerance=0.01, setup=SETUP)
    assert not verdict.conforms
    assert "X" in verdict.cause and "0.5" in verdict.cause


def test_time() -> None:
    time = 0.001 * np.arange(21)
    assert toolcomp.judge(PROGRAM, {"X": X, "Y": Y, "time": time}, tolerance=0.01, setup=SETUP).conforms
    time[12:] += 0.005
    verdict = toolcomp.judge(PROGRAM, {"X": X, "Y": Y, "time": time}, tolerance=0.01, setup=SETUP)
    (finding,) = verdict.findings
    assert finding.kind == "gap"
    assert finding.duration == pytest.approx(0.006)
    coarse = {"X": X, "Y": Y, "time": time}
    assert toolcomp.judge(PROGRAM, coarse, tolerance=0.01, setup=SETUP, time_resolution=0.01).conforms


def test_rotary_axes_have_their_own_tolerance() -> None:
    program = "G90 G01 F100 X10. C90.\nM02\n"
    turned = {"X": 10 * T, "C": 90 * T + 0.3 * (T == T[5])}
    assert toolcomp.judge(program, turned, tolerance=0.01, rotary_tolerance=0.5, setup=SETUP).conforms
    verdict = toolcomp.judge(program, turned, tolerance=0.01, rotary_tolerance=0.1, setup=SETUP)
    assert verdict.findings[0].rotary_axis == "C"
    assert verdict.findings[0].rotary is not None


def test_a_file(tmp_path: Path) -> None:
    csv = tmp_path / "run.csv"
    csv.write_text("X,Y\n" + "".join(f"{x},{y}\n" for x, y in zip(X, Y)))
    assert toolcomp.judge(PROGRAM, csv, tolerance=0.01, setup=SETUP).conforms
    csv.write_text("X,Y\n1,2\n3,four\n")
    with pytest.raises(toolcomp.InputError) as raised:
        toolcomp.judge(PROGRAM, csv, tolerance=0.01, setup=SETUP)
    assert (raised.value.file, raised.value.line, raised.value.column) == (str(csv), 3, 3)


@pytest.mark.parametrize(
    ("recording", "message"),
    [
        ({"X": X, "Y": Y[1:]}, "Y: 20 samples, and other arrays have 21"),
        ({"X": X, "Q": Y}, "Q: not an axis of the setup, which has XYZC"),
        ({"X": X, "Y": np.where(Y == 5, np.nan, Y)}, "Y: sample 15 is not a number"),
        ({"X": X, "time": -0.001 * np.arange(21)}, "time: runs backwards at sample 1"),
        ({"X": X.reshape(3, 7)}, "X: not one-dimensional"),
        ({}, "at least one axis"),
    ],
)
def test_what_is_no_recording(recording: dict[str, np.ndarray], message: str) -> None:  # type: ignore[type-arg]
    with pytest.raises(ValueError, match=message):
        toolcomp.judge(PROGRAM, recording, tolerance=0.01, setup=SETUP)


@pytest.mark.parametrize("tolerance", [0, -1, float("nan"), float("inf")])
def test_what_is_no_tolerance(tolerance: float) -> None:
    with pytest.raises(ValueError, match="tolerance must be positive"):
        toolcomp.judge(PROGRAM, {"X": X}, tolerance=tolerance, setup=SETUP)
