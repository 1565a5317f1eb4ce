# SPDX-License-Identifier: Apache-2.0
"""An exact reference of CNC tool compensation.

``run`` runs a program through the exact model, the fast engine or the formal specification. ``diff`` compares engines
on a program, and ``explain`` explains its result. ``certify`` judges a controller, in the simplest case a Python function.
``judge`` judges a recording. ``corpus`` reads the golden corpus. ``Batch`` compensates arrays of lines. docs/python.md
shows each of them.
"""

from __future__ import annotations

from . import _core, corpus
from .batch import Batch, Moves
from .cases import Case
from .certifying import Finding, Verdict, certify
from .comparing import Comparison, Difference, diff
from .controllers import ControllerLike
from .errors import Error, InputError, NotApplicable, UndecidedError
from .events import Alarm, Event, Hole, Move, Note, NotJudged, NotSupported, Sample, Setting, Undecided, Warning
from .explaining import Block, Clause, Decision, ExplainedEvent, clause, explain
from .numbers import Exact, Number
from .recordings import RecordingFinding, RecordingVerdict, judge
from .running import run

__version__: str = _core.version
#: Whether this build has the formal specification (``engine="spec"``).
has_specification: bool = _core.has_specification


def sections() -> list[str]:
    """The manual sections that toolcomp implements."""
    return _core.sections()


__all__ = [
    "Alarm",
    "Batch",
    "Block",
    "Case",
    "Clause",
    "Comparison",
    "ControllerLike",
    "Decision",
    "Difference",
    "Error",
    "Event",
    "Exact",
    "ExplainedEvent",
    "Finding",
    "Hole",
    "InputError",
    "Move",
    "Moves",
    "NotApplicable",
    "NotJudged",
    "NotSupported",
    "Note",
    "Number",
    "RecordingFinding",
    "RecordingVerdict",
    "Sample",
    "Setting",
    "Undecided",
    "UndecidedError",
    "Verdict",
    "Warning",
    "certify",
    "clause",
    "corpus",
    "diff",
    "explain",
    "has_specification",
    "judge",
    "run",
    "sections",
]
