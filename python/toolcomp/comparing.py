# SPDX-License-Identifier: Apache-2.0
"""The model against another engine."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Literal

from . import _core
from .programs import ProgramLike, SetupLike, program_of


@dataclass(frozen=True)
class Difference:
    """The first difference."""

    file: str
    line: int
    #: what differs: "coordinate", "missing event", …
    kind: str
    #: the field that differs, such as "point.X"
    field: str
    expected: str
    actual: str
    #: of a linear coordinate: how far it is outside the permitted range, in micrometres
    deviation_um: float
    #: id of the clause to which the difference is attributed
    clause: str | None


@dataclass(frozen=True)
class Comparison:
    """The result of a comparison."""

    #: "agrees", "differs", "undecided", "nothing judged", "not applicable", …
    outcome: str
    difference: Difference | None
    #: why it is undecided or not applicable
    why: str
    #: number of numbers and alarms that were judged
    values: int
    values_not_judged: int
    #: number of law checks
    questions: int
    #: number of decisions of the model, of those near a tie, and of those that the engine decided the other way
    decisions: int
    near_ties: int
    ties: int
    worst_ulp: float
    worst_um: float

    @property
    def agrees(self) -> bool:
        """Whether everything that was judged agrees."""
        return self.outcome == "agrees"

    @property
    def exit_status(self) -> int:
        """The exit status of the command: 0 agrees, 1 differs, 3 could not be decided."""
        return {"agrees": 0, "differs": 1}.get(self.outcome, 3)


def diff(
    program: ProgramLike,
    *,
    setup: SetupLike | None = None,
    engine: Literal["fast", "spec"] = "fast",
    samples: int | None = None,
) -> Comparison:
    """Compares the fast engine, or the formal specification, with the exact model.

    :raises InputError: if program or setup cannot be read
    """
    if engine not in ("fast", "spec"):
        raise ValueError(f'engine must be "fast" or "spec", not {engine!r}')
    read = program_of(program, setup, samples)
    text = _core.diff_fast(read) if engine == "fast" else _core.diff_specification(read)
    said = json.loads(text)
    difference = said.pop("difference")
    return Comparison(difference=Difference(**difference) if difference else None, **said)
