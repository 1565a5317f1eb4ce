# SPDX-License-Identifier: Apache-2.0
"""Recorded runs against the exact path (docs/trace.md)."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from typing import Any, Literal, Mapping, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from .programs import ProgramLike, SetupLike, program_of

#: A CSV file, or samples by axis, and by "time" in seconds.
RecordingLike = Union[str, "os.PathLike[str]", Mapping[str, Union[npt.ArrayLike, Sequence[float]]]]


@dataclass(frozen=True)
class RecordingFinding:
    """Where a recording leaves the path."""

    #: "off the path", "corner not reached", …
    kind: str
    #: index of the first sample concerned; of a CSV its line
    sample: int
    #: how many; 0 where what is missing lies between two samples
    samples: int
    #: of the program: the first and the last move concerned
    line: int
    last_line: int
    #: linear axes, setup units: the true distance lies between both
    distance: Tuple[float, float]
    #: degrees, with the axis; None where no rotary axis is concerned
    rotary: Tuple[float, float] | None
    rotary_axis: str | None
    #: where it was worst
    at: Mapping[str, float]
    #: seconds without a sample
    duration: float


@dataclass(frozen=True)
class RecordingVerdict:
    """What came of a recording."""

    #: 0 conforms, 1 does not, 3 could not be decided or nothing was judged
    exit_status: int
    findings: Tuple[RecordingFinding, ...]
    #: all of them; the first hundred are kept
    findings_total: int
    #: one mistake that explains everything found, in words: a hint
    cause: str
    samples: int
    samples_off: int
    corners: int
    corners_missed: int
    #: of an accepted sample, setup units
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
        """Whether the recording is within the tolerance, from begin to end."""
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
    """Judges one recorded run of a program: positions as `axes` of the events, in the units of the program.

    :param recording: a CSV file; or arrays or sequences by axis letter, with "time" in seconds where it is recorded.
        Contiguous arrays of float64 are looked at where they are
    :param tolerance: of the linear axes, as one length
    :param rotary_tolerance: of each rotary axis, degrees; without it the number of `tolerance`
    :param frame: the coordinates of the recording
    :param rapids: whether rapid moves run on a line, or each axis by itself
    :param time_resolution: of arrays: seconds by which a time may be off
    :raises InputError: a program or CSV that cannot be read
    :raises ValueError: arrays of different lengths, samples that are no numbers, axes the setup does not have
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
