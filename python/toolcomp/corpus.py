# SPDX-License-Identifier: Apache-2.0
"""The golden corpus: vectors with setup, program and expected events."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Iterator

from . import _core
from .cases import Case
from .errors import InputError


def folder() -> Path:
    """The folder of the golden corpus: in share/toolcomp near this package, or in the source tree of the build.

    :raises InputError: if neither folder exists
    """
    for above in Path(__file__).absolute().parents:
        for below in ("share/toolcomp/corpus/golden", "corpus/golden"):
            if (above / below / "manifest.json").is_file():
                return above / below
    raise InputError("the golden corpus was not found; name its folder", "corpus")


def version(corpus: str | os.PathLike[str] | None = None) -> str:
    """The version of the corpus, MAJOR.MINOR.PATCH."""
    return _core.corpus_manifest(os.fspath(corpus or folder()))[0]


def sections(corpus: str | os.PathLike[str] | None = None) -> list[str]:
    """The sections that have golden vectors."""
    return list(dict.fromkeys(section for _, section in _core.corpus_manifest(os.fspath(corpus or folder()))[1]))


def vectors(section: str | None = None, *, corpus: str | os.PathLike[str] | None = None) -> Iterator[Case]:
    """The vectors of a section, or of all, one by one.

    :raises InputError: if the folder has no manifest, or there is no such section
    """
    place = Path(corpus or folder())
    files = [file for file, of in _core.corpus_manifest(str(place))[1] if section in (None, of)]
    if not files:
        raise InputError(f"no vectors of section {section}", str(place))
    return _read(place, files)


def _read(place: Path, files: list[str]) -> Iterator[Case]:
    for file in files:
        with open(place / file, encoding="utf-8") as lines:
            for line in lines:
                if line.strip():
                    yield Case.from_json(line)
