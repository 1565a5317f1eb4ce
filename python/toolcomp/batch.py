# SPDX-License-Identifier: Apache-2.0
"""Compensation of millions of lines: from arrays of words to arrays of axis positions.

No value is converted to a Python object."""

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
    """The moves of many blocks, as arrays of equal length.

    The arrays are views of the memory that the engine wrote to, and keep it alive.
    """

    #: by axis letter: the position that the axis is sent to, in workpiece coordinates, in the units of the setup or in
    #: degrees; nan if a move does not name the axis
    axes: Mapping[str, FloatArray]
    #: the block that each move belongs to, from 1
    block: npt.NDArray[np.uint64]

    def __len__(self) -> int:
        return len(self.block)


class Batch:
    """A program that is given to the fast engine in parts: blocks as text, and lines as arrays.

    The moves are bit for bit those of ``run(…, engine="fast")`` on the same blocks. The engine runs without the GIL.
    One thread at a time uses a batch; others wait.
    """

    def __init__(self, setup: SetupLike) -> None:
        """:raises InputError: if the setup cannot be read, or if no control could have it"""
        self._batch = _core.Batch(setup_of(setup))

    def run(self, text: str) -> None:
        """Runs blocks given as the text of a program: modes, offsets, start-up and cancel.

        :raises InputError: if the text cannot be the text of a program
        """
        self._batch.run(text)

    def lines(
        self,
        columns: Mapping[str, npt.ArrayLike] | None = None,
        *,
        decimals: Union[int, Mapping[str, int]] = 3,
        **words: npt.ArrayLike,
    ) -> None:
        """Runs one block for each index of the arrays. A block has all the words, and the modes in force.

        Contiguous arrays of float64 are used without a copy; other arrays are converted. Each word is the decimal
        nearest to the value with the given number of places, as a post processor prints it.

        :param columns: arrays by word: a letter, or NX NY NZ TX TY TZ for vectors of Klartext. Arrays may also be given
            by name, as in ``lines(X=x, Y=y)``
        :param decimals: number of decimals of all words, or by word (3 for a word without a number); at most 9
        :raises ValueError: if arrays have different lengths, if a line cannot have a word, or if a value is not a
            number. No block is run then
        """
        given = {**(columns or {}), **words}
        places = decimals if isinstance(decimals, Mapping) else dict.fromkeys(given, decimals)
        if unknown := [word for word in places if word not in given]:
            raise ValueError(f"decimals of {', '.join(unknown)}, given, and no values")
        self._batch.lines([(word, values, places.get(word, 3)) for word, values in given.items()])

    def end(self) -> None:
        """Ends the program: the engine gives the moves that it still holds."""
        self._batch.end()

    def moves(self) -> Moves:
        """The moves since the last call. The arrays belong to the caller."""
        block, axes = self._batch.moves()
        return Moves(dict(axes), block)

    def events(self) -> list[Event]:
        """The events other than moves since the last call: alarms, warnings, settings."""
        return [event_of_json(json.loads(line)) for line in self._batch.events()]

    @property
    def stopped(self) -> bool:
        """Whether the program has ended or raised an alarm. Later blocks are ignored."""
        return self._batch.stopped

    @property
    def blocks(self) -> int:
        """Number of blocks taken so far."""
        return self._batch.blocks

    @property
    def blocks_as_arrays(self) -> int:
        """How many of the blocks ran many at a time; the others ran one by one."""
        return self._batch.blocks_as_arrays
