# SPDX-License-Identifier: Apache-2.0
"""Runs: a program through an engine."""

from __future__ import annotations

import json
from typing import Iterator, Literal

from . import _core
from .events import Event, event_of_json
from .programs import ProgramLike, SetupLike, program_of

#: The exact model, the fast engine in double precision, the formal specification (Coq, extracted).
Engine = Literal["model", "fast", "spec"]

#: The most decimals that are asked for.
MOST_DIGITS = 1000


def expect_digits(digits: int) -> int:
    """Raises ValueError for what is no number of decimals."""
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
    """The events of a run, as they come: ``list(run(…))`` has them all.

    :param program: a file, text with line feeds, or a case
    :param setup: a file, TOML text or a dict; of a file without it, the setup.toml beside it
    :param engine: "model", "fast" or "spec"; the formal specification takes a program as a whole
    :param samples: into how many parts blocks under tool center point control are divided
    :param digits: decimals of values that are no fractions
    :raises InputError: at once for what cannot be read; for bytes inside the program, behind the events before them
    :raises UndecidedError: where digits cannot be certified
    """
    if engine not in ("model", "fast", "spec"):
        raise ValueError(f'engine must be "model", "fast" or "spec", not {engine!r}')
    return _events(_core.run(program_of(program, setup, samples), engine, expect_digits(digits)))


def _events(run: _core.Run) -> Iterator[Event]:
    while lines := run.next():
        for line in lines:
            yield event_of_json(json.loads(line))
