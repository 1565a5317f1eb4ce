# SPDX-License-Identifier: Apache-2.0
"""Runs of a program through an engine."""

from __future__ import annotations

import json
from typing import Iterator, Literal

from . import _core
from .events import Event, event_of_json
from .programs import ProgramLike, SetupLike, program_of

#: The exact model, the fast engine in double precision, or the formal specification (extracted from Coq).
Engine = Literal["model", "fast", "spec"]

#: The largest number of decimals.
MOST_DIGITS = 1000


def expect_digits(digits: int) -> int:
    """Raises ValueError if `digits` is not a possible number of decimals."""
    if not 1 <= digits <= MOST_DIGITS:
        raise ValueError(f"digits must be 1 to {MOST_DIGITS}, not {digits}")
    return digits


def run(
    program: ProgramLike,
    *,
    setup: SetupLike | None = None,
    engine: Engine = "model",
    samples: int | None = None,
    digits: int = 15,
) -> Iterator[Event]:
    """Yields the events of a run as they come. ``list(run(…))`` gives all of them.

    :param program: a file, text with line feeds, or a case
    :param setup: a file, TOML text or a dict; by default the setup.toml in the folder of the program file
    :param engine: "model", "fast" or "spec"; the formal specification reads the whole program before its first event
    :param samples: number of parts into which each block under tool center point control is divided
    :param digits: number of decimals of values that are not fractions
    :raises InputError: at once if a file cannot be read; for bad bytes inside the program, after the events before them
    :raises UndecidedError: if digits cannot be certified
    """
    if engine not in ("model", "fast", "spec"):
        raise ValueError(f'engine must be "model", "fast" or "spec", not {engine!r}')
    return _events(_core.run(program_of(program, setup, samples), engine, expect_digits(digits)))


def _events(run: _core.Run) -> Iterator[Event]:
    while lines := run.next():
        for line in lines:
            yield event_of_json(json.loads(line))
