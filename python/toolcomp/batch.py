# SPDX-License-Identifier: Apache-2.0
"""Lines by the million: arrays of words in, arrays of axis positions out. No value passes through Python."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Mapping, Union

import numpy as np
import numpy.typing as npt

from . import _core
from .events import Event, event_of_json
from .programs import SetupLike, setup_of

FloatArray = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Moves:
    """The moves of many blocks: arrays of one length, views of the memory the engine wrote to, which they keep."""

    #: by axis letter: what the axis is sent to, workpiece coordinates, setup units or degrees; nan where a move does not
    #: name it
    axes: Mapping[str, FloatArray]
    #: the block that each move belongs to, from 1
    block: npt.NDArray[np.uint64]

    def __len__(self) -> int:
        return len(self.block)


class Batch:
    """A program in parts: blocks as text, and lines as arrays, through the fast engine.

    Moves are those of ``run(…, engine="fast")`` on the same blocks, bit for bit. The GIL is not held meanwhile; one
    thread at a time uses a batch, others wait.
    """

    def __init__(self, setup: SetupLike) -> None:
        """:raises InputError: for a setup that cannot be read, or that no control could have"""
        self._batch = _core.Batch(setup_of(setup))

    def run(self, text: str) -> None:
        """Blocks as a program has them: modes, offsets, start-up and cancel.

        :raises InputError: for what is no text of a program
        """
        self._batch.run(text)

    def lines(
        self,
        columns: Mapping[str, npt.ArrayLike] | None = None,
        *,
        decimals: Union[int, Mapping[str, int]] = 3,
        **words: npt.ArrayLike,
    ) -> None:
        """As many blocks as the arrays have values, each of all their words, under the modes in force.

        Contiguous arrays of float64 are looked at where they are; others are converted, which is a copy. Each word is
        the decimal of so many places nearest to the value, as a post processor prints it.

        :param columns: arrays by word: a letter; Klartext vectors: NX NY NZ TX TY TZ. Or by name, ``lines(X=x, Y=y)``
        :param decimals: of all words, or by word (3 where it has none); 9 at most
        :raises ValueError: and nothing is done: arrays of different lengths, words no line has, values that are no
            numbers
        """
        given = {**(columns or {}), **words}
        places = decimals if isinstance(decimals, Mapping) else dict.fromkeys(given, decimals)
        if unknown := [word for word in places if word not in given]:
            raise ValueError(f"decimals of {', '.join(unknown)}, which has no values")
        self._batch.lines([(word, values, places.get(word, 3)) for word, values in given.items()])

    def end(self) -> None:
        """The end of the program: what is held goes out."""
        self._batch.end()

    def moves(self) -> Moves:
        """The moves since the last call, as arrays that are yours."""
        block, axes = self._batch.moves()
        return Moves(dict(axes), block)

    def events(self) -> list[Event]:
        """The events that are no moves since the last call: alarms, warnings, settings."""
        return [event_of_json(json.loads(line)) for line in self._batch.events()]

    @property
    def stopped(self) -> bool:
        """An alarm or the end of the program: what comes is ignored."""
        return self._batch.stopped

    @property
    def blocks(self) -> int:
        """Taken so far."""
        return self._batch.blocks

    @property
    def blocks_as_arrays(self) -> int:
        """How many of them many at a time; the others went one by one."""
        return self._batch.blocks_as_arrays
