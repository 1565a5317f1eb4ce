# SPDX-License-Identifier: Apache-2.0
"""Recorded runs, compared with the exact path (docs/trace.md)."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from typing import Any, Literal, Mapping, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from .programs import ProgramLike, SetupLike, program_of

#: A CSV file, or a mapping of samples by axis, and by "time" in seconds.
RecordingLike = Union[str, "os.PathLike[str]", Mapping[str, Union[npt.ArrayLike, Sequence[float]]]]


@dataclass(frozen=True)
class RecordingFinding:
    """A place at which a recording leaves the path."""

    #: "off the path", "corner not reached", …
    kind: str
    #: index of the first sample concerned; for a CSV file, its line
    sample: int
    #: number of samples concerned; 0 if something is missing between two samples
    samples: int
    #: program lines of the first and of the last move concerned
    line: int
    last_line: int
    #: distance of the linear axes, in the units of the setup; the true distance is between the two
    distance: Tuple[float, float]
    #: deviation in degrees and its axis; None if no rotary axis is concerned
    rotary: Tuple[float, float] | None
    rotary_axis: str | None
    #: the position with the largest distance
    at: Mapping[str, float]
    #: seconds without a sample
    duration: float


@dataclass(frozen=True)
class RecordingVerdict:
    """The verdict on a recording."""

    #: 0 conforms, 1 does not, 3 could not be decided or nothing was judged
    exit_status: int
    findings: Tuple[RecordingFinding, ...]
    #: number of all findings; the first hundred are kept
    findings_total: int
    #: a hint: one mistake that would explain everything found, in words
    cause: str
    samples: int
    samples_off: int
    corners: int
    corners_missed: int
    #: largest distance of an accepted sample, in the units of the setup
    worst: float
    worst_rotary: float
    #: axis letters
    recorded: str
    not_recorded: str
    #: why the model could not decide
    undecided: str
    #: certificate.json as a whole
    report: Mapping[str, Any] = field(repr=False)
    _trace: _core.TraceReport = field(repr=False, compare=False)

    @property
    def conforms(self) -> bool:
        """Whether the recording is within the tolerance from beginning to end."""
        return self.exit_status == 0

    def html(self) -> str:
        """The report as one page."""
        return self._trace.html()

    def write(self, folder: str | os.PathLike[str]) -> None:
        """Writes the report: index.html, certificate.json, junit.xml, certificate.sarif."""
        self._trace.write(os.fspath(folder))


def judge(
    program: ProgramLike,
    recording: RecordingLike,
    *,
    tolerance: float,
    rotary_tolerance: float | None = None,
    setup: SetupLike | None = None,
    frame: Literal["workpiece", "machine"] = "workpiece",
    rapids: Literal["line", "by axis"] = "line",
    time_resolution: float = 0.0,
) -> RecordingVerdict:
    """Judges one recorded run of a program. Its positions are those of the field `axes` of events, in the units of the
    program.

    :param recording: a CSV file; or arrays or sequences by axis letter, and "time" in seconds if it was recorded.
        Contiguous arrays of float64 are used without a copy
    :param tolerance: largest distance from the exact path, over all linear axes together
    :param rotary_tolerance: largest deviation of each rotary axis in degrees; by default the number of `tolerance`
    :param frame: the coordinates of the recording
    :param rapids: whether a rapid move runs on a line, or moves each axis by itself
    :param time_resolution: seconds by which a time of an array may be off
    :raises InputError: if the program or the CSV file cannot be read
    :raises ValueError: if arrays have different lengths, a sample is not a number, or the setup does not have an axis
    """
    if frame not in ("workpiece", "machine"):
        raise ValueError(f'frame must be "workpiece" or "machine", not {frame!r}')
    if rapids not in ("line", "by axis"):
        raise ValueError(f'rapids must be "line" or "by axis", not {rapids!r}')
    read = program_of(program, setup)
    how = (tolerance, rotary_tolerance, frame == "machine", rapids == "line")
    if isinstance(recording, Mapping):
        columns = [(name, np.asarray(values, dtype=np.float64)) for name, values in recording.items() if name != "time"]
        time = np.asarray(recording["time"], dtype=np.float64) if "time" in recording else None
        return _verdict(_core.judge_arrays(read, columns, time, time_resolution, *how), 1)
    return _verdict(_core.judge_file(read, os.fspath(recording), *how), 0)


def _bounds(said: Mapping[str, float]) -> Tuple[float, float]:
    return said["lower"], said["upper"]


def _verdict(trace: _core.TraceReport, first: int) -> RecordingVerdict:
    report = json.loads(trace.json())
    findings = tuple(
        RecordingFinding(
            kind=said["kind"],
            sample=said["sample"] - first,
            samples=said["samples"],
            line=said["line"],
            last_line=said["last_line"],
            distance=_bounds(said["distance"]),
            rotary=_bounds(said["rotary"]) if "rotary" in said else None,
            rotary_axis=said.get("rotary_axis"),
            at=said.get("at", {}),
            duration=said.get("duration", 0.0),
        )
        for said in report["findings"]
    )
    taken = {name: report[name] for name in ("exit_status", "findings_total", "cause", "samples", "samples_off")}
    taken |= {name: report[name] for name in ("corners", "corners_missed", "recorded", "not_recorded", "undecided")}
    return RecordingVerdict(
        findings=findings,
        worst=report["worst"]["upper"],
        worst_rotary=report["worst_rotary"]["upper"],
        report=report,
        _trace=trace,
        **taken,
    )
