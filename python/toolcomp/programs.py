# SPDX-License-Identifier: Apache-2.0
"""Programs and setups, in all forms in which they can be given."""

from __future__ import annotations

import json
import os
from fractions import Fraction
from decimal import Decimal
from pathlib import Path
from typing import Any, Mapping, Union

from . import _core
from .cases import Case
from .errors import InputError

#: A file (a str without line feed is its name; a program, or a case if it is JSON), text with line feeds, or a case.
ProgramLike = Union[str, "os.PathLike[str]", Case]
#: A file, TOML text (a str with ``=`` or a line feed), or a mapping as the setup in the JSON of a case.
SetupLike = Union[str, "os.PathLike[str]", Mapping[str, Any]]

#: The largest number of parts of a block.
MOST_SAMPLES = 1_000_000


def _plain(value: Any) -> Any:
    """A setup as JSON: keys are text, digits are kept."""
    if isinstance(value, Mapping):
        return {str(key): _plain(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(each) for each in value]
    if isinstance(value, bool) or value is None or isinstance(value, (str, int)):
        return value
    if isinstance(value, Decimal):
        return format(value, "f")
    if isinstance(value, Fraction):
        raise InputError(f"{value!r} is not a decimal number", "setup")
    # A double that a program would write with an exponent keeps its digits.
    return format(Decimal(repr(float(value))), "f") if hasattr(value, "__float__") else value


def setup_of(setup: SetupLike) -> _core.Setup:
    """Reads a setup.

    :raises InputError: if it is not a setup; the error names the place
    """
    if isinstance(setup, Mapping):
        try:
            return _core.setup_of_text(json.dumps(_plain(setup)), "setup", True)
        except InputError as error:
            # A dict has no lines.
            raise InputError(error.message, "setup") from None
    if isinstance(setup, str) and ("\n" in setup or "=" in setup):
        return _core.setup_of_text(setup, "setup", False)
    return _core.setup_of_file(os.fspath(setup))


def program_of(
    program: ProgramLike, setup: SetupLike | None = None, samples: int | None = None, name: str = "program"
) -> _core.Program:
    """Reads a program. Without `setup`, a program file takes the setup.toml in its folder.

    :raises InputError: if a file or case cannot be read
    """
    if samples is not None and not 0 <= samples <= MOST_SAMPLES:
        raise ValueError(f"samples must be 0 to {MOST_SAMPLES}, not {samples}")
    if isinstance(program, Case):
        if setup is not None:
            raise InputError("a case brings its own setup", program.id)
        return _core.program_of_case(program.json(), program.id or "case", samples)
    if isinstance(program, str) and "\n" in program:
        if program.lstrip().startswith("{"):
            return _core.program_of_case(program, "case", samples)
        if setup is None:
            raise InputError("a program given as text needs a setup", name)
        return _core.program_of_text(program, name, setup_of(setup), samples or 0)
    path = os.fspath(program)
    if isinstance(program, str) and not Path(path).exists():
        raise InputError("no such file; if this is the text of one block, end it with a line feed", path)
    if setup is None or (isinstance(setup, (str, os.PathLike)) and not _is_text(setup)):
        return _core.program_of_file(path, "" if setup is None else os.fspath(setup), samples)
    return _core.program_with_setup(path, setup_of(setup), samples or 0)


def _is_text(setup: object) -> bool:
    return isinstance(setup, str) and ("\n" in setup or "=" in setup)
