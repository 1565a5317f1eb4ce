# SPDX-License-Identifier: Apache-2.0
"""What goes wrong, as exceptions."""

from __future__ import annotations

from typing import Any


class Error(Exception):
    """The base of what toolcomp raises by itself."""


class InputError(Error, ValueError):
    """Input that nobody could read: bytes that are no text, malformed cases and setups, missing files.

    ``str()`` of it is ``FILE:LINE:COLUMN: message``, as the command prints it. What a control refuses is no error but
    an alarm among the events.

    :ivar message: what is wrong, and what was expected
    :ivar file: which file or argument; ``""`` where there is none
    :ivar line: from 1, or None
    :ivar column: from 1, or None
    """

    def __init__(self, message: str, file: str = "", line: int | None = None, column: int | None = None) -> None:
        super().__init__(message, file, line, column)
        self.message = message
        self.file = file
        self.line = line
        self.column = column

    def __str__(self) -> str:
        place = ":".join(str(part) for part in (self.file or None, self.line, self.column) if part is not None)
        return f"{place}: {self.message}" if place else self.message

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.message, self.file, self.line, self.column)


class UndecidedError(Error):
    """Digits of an exact value, or its sign, could not be certified."""


class NotApplicable(Error):
    """Raised by a controller: it does not have what the case needs. Counted, not judged."""
