# SPDX-License-Identifier: Apache-2.0
"""The exceptions of toolcomp."""

from __future__ import annotations

from typing import Any


class Error(Exception):
    """The base class of the exceptions of toolcomp."""


class InputError(Error, ValueError):
    """Input that cannot be read: bytes that are not text, malformed cases and setups, missing files.

    Its ``str()`` is ``FILE:LINE:COLUMN: message``, as the command prints it. A program that a control refuses is not an
    error: the control raises an alarm, which is one of the events.

    :ivar message: what is wrong, and what was expected
    :ivar file: the file or the argument; ``""`` if there is none
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
    """The digits or the sign of an exact value could not be certified."""


class NotApplicable(Error):
    """A controller raises it if it does not have what the case needs. The case is counted, and not judged."""
