# SPDX-License-Identifier: Apache-2.0
"""Why a block does what it does."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Tuple

from . import _core
from .events import Event, Outcome, event_of_json
from .numbers import Number, number_of_json
from .programs import ProgramLike, SetupLike, program_of
from .running import expect_digits


@dataclass(frozen=True)
class Clause:
    """A clause of a section."""

    id: str
    section: str
    text: str
    #: how well it is known: "manual", "sister", "recollection" or "ours"
    known: str
    #: how well it is known, with document and page
    source: str
    formula: str
    #: other readings that the manual permits, for an open clause
    alternatives: str
    #: whether the manual does not decide the clause, so that the definition is ours
    open: bool


@dataclass(frozen=True)
class Decision:
    """A decision that the sign of an exact value answers."""

    clause: Clause
    quantity: Number
    #: the size that the quantity is compared with, None if it is 0; margin is quantity / scale
    scale: Number | None
    margin: Number | None
    outcome: Outcome
    #: what the outcome means, in words
    meaning: str


@dataclass(frozen=True)
class ExplainedEvent:
    """An event of the model, with explanations in words."""

    event: Event
    #: for G37: by how much the measured position may be off
    measured: str
    #: the heads and vectors of the corner after the event
    corner: str


@dataclass(frozen=True)
class Block:
    """A block with the events of both engines."""

    line: int
    n: int | None
    text: str
    decisions: Tuple[Decision, ...]
    exact: Tuple[ExplainedEvent, ...]
    fast: Tuple[Event, ...]


def clause(id: str) -> Clause:
    """The clause with this id.

    :raises KeyError: if there is none
    """
    return Clause(**json.loads(_core.clause(id)))


def _number(json: Any) -> Number | None:
    return None if json is None else number_of_json(json)


def _decision(said: dict[str, Any]) -> Decision:
    return Decision(
        clause=clause(said["clause"]),
        quantity=number_of_json(said["quantity"]),
        scale=_number(said["scale"]),
        margin=_number(said["margin"]),
        outcome=said["outcome"],
        meaning=said["meaning"],
    )


def explain(
    program: ProgramLike,
    *,
    setup: SetupLike | None = None,
    block: int | None = None,
    samples: int | None = None,
    digits: int = 15,
) -> list[Block]:
    """Explains a program block by block: decisions with their exact values, clauses, and the events of both engines.

    :param block: a sequence number, or a line if no block has this sequence number; by default all blocks
    :raises InputError: if program or setup cannot be read, or if there is no such `block`
    """
    read = program_of(program, setup, samples)
    return [
        Block(
            line=said["line"],
            n=said["n"],
            text=said["text"],
            decisions=tuple(map(_decision, said["decisions"])),
            exact=tuple(
                ExplainedEvent(event_of_json(each["event"]), each["measured"], each["corner"])
                for each in said["exact"]
            ),
            fast=tuple(map(event_of_json, said["fast"])),
        )
        for said in json.loads(_core.explain(read, block, expect_digits(digits)))
    ]
