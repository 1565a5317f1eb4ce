# SPDX-License-Identifier: Apache-2.0
"""Certification: a controller against the exact model."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field as _field
from typing import Any, Callable, Mapping, Sequence, Tuple, Union

from . import _core, corpus as _corpus
from .cases import Case
from .controllers import PythonController, bound
from .programs import ProgramLike, SetupLike, program_of

#: The fields of a function that does not announce its own.
DEFAULT_FIELDS = ("kind", "line", "axes")


@dataclass(frozen=True)
class Finding:
    """A difference between controller and model, with the smallest case found that shows it."""

    #: what differs: "coordinate", "missing event", "crash" …
    kind: str
    section: str
    #: id of the clause of the first divergence
    clause: str | None
    #: line of the program at which controller and model first differ
    line: int
    field: str
    expected: str
    actual: str
    deviation_um: float
    #: the difference in one or two sentences
    explanation: str
    #: the smallest case that shows it
    case: Case
    #: number of cases that failed in the same way
    occurrences: int
    #: traceback of an exception of a Python controller; of a command, the last lines of its standard error
    errors: str
    #: the finding as a file, for ``toolcomp replay``
    text: str = _field(repr=False)


@dataclass(frozen=True)
class Verdict:
    """The result of a certification."""

    #: "conforms in 1 of 13 sections, 11 not applicable", …
    text: str
    #: the exit status of the command: 0 conforms, 1 a finding, 3 could not be decided, 4 a self-check failed
    exit_status: int
    findings: Tuple[Finding, ...]
    #: hints: mistakes that would explain findings, in words
    causes: Tuple[str, ...]
    #: certificate.json as a whole: sections with their counts, clauses, what was not judged
    report: Mapping[str, Any] = _field(repr=False)
    _certificate: _core.Certificate = _field(repr=False, compare=False)

    @property
    def conforms(self) -> bool:
        """Whether everything that was asked for was judged and agrees."""
        return self.exit_status == 0

    def html(self) -> str:
        """The report as one page."""
        return self._certificate.html()

    def write(self, folder: str | os.PathLike[str]) -> None:
        """Writes the report: index.html, certificate.json, junit.xml, certificate.sarif, findings/."""
        self._certificate.write(os.fspath(folder))


def certify(
    controller: Union[PythonController, str],
    *,
    sections: Union[str, Sequence[str]] = (),
    cases: int | None = None,
    seed: int = 1,
    programs: Sequence[ProgramLike] = (),
    setup: SetupLike | None = None,
    samples: int | None = None,
    corpus: Union[bool, str, "os.PathLike[str]", None] = None,
    fields: Sequence[str] = DEFAULT_FIELDS,
    jobs: int = 1,
    timeout: float = 10.0,
    time_limit: float | None = None,
    settle: float = 30.0,
    accept_resolution: str = "",
    raise_errors: bool = False,
    report: str | os.PathLike[str] | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Verdict:
    """Judges a controller, as ``toolcomp certify`` does: golden corpus, generated cases, your programs.

    A controller in Python is called with the GIL held, and without a time limit. If it raises an Exception, this is a
    finding of kind "crash" with its traceback, and the next case follows. KeyboardInterrupt and other exceptions that
    are not an Exception end the certification and reach the caller. With `raise_errors` every exception does. With
    `report`, the findings so far are written first.

    :param controller: a function from a :class:`Case` to events; an object with ``hello`` and ``answer``; a command
        that speaks the protocol; the name of an adapter; or "fast" or "spec", an engine of toolcomp
    :param sections: sections of the corpus and of generated cases; all sections if empty
    :param cases: number of generated cases in each section; by default 1000, or 0 if programs are given
    :param seed: the same seed gives the same cases
    :param programs: your own programs, with `setup` and `samples` as for :func:`toolcomp.run`
    :param corpus: True, False or the folder of a golden corpus; by default True, unless programs are given
    :param fields: the event fields that a function gives
    :param jobs: number of controllers that run at the same time; a Python controller uses at most one processor
    :param timeout: seconds that a command has for one answer
    :param time_limit: seconds after which no further case is run; the verdict counts the cases that were not run
    :param settle: seconds for reproducing and shrinking one finding of each group
    :param accept_resolution: the resolution of a controller with coarse numbers (docs/protocol.md)
    :param report: the folder of the report
    :param progress: a function that is called with the number of cases done and of all cases
    :raises InputError: if a section is unknown, a case cannot be read, or a command cannot be run
    """
    wanted = [sections] if isinstance(sections, str) else list(sections)
    alone = bool(programs)
    if cases is None:
        cases = 0 if alone else 1000
    if corpus is None:
        corpus = not alone
    golden = "" if corpus is False else os.fspath(_corpus.folder() if corpus is True else corpus)
    if cases < 0 or seed < 0 or jobs < 1 or not timeout > 0 or settle < 0 or (time_limit is not None and not time_limit > 0):
        raise ValueError("cases, seed and settle must not be negative; jobs, timeout and time_limit must be positive")
    command, in_python = _subject(controller, wanted, fields, raise_errors)
    certificate = _core.certify(
        command=command,
        controller=in_python,
        sections=wanted,
        programs=[_own(program, setup, samples) for program in programs],
        corpus=golden,
        cases=cases,
        seed=seed,
        timeout=timeout,
        time_limit=time_limit or 0,
        settle=settle,
        accept_resolution=accept_resolution,
        jobs=jobs,
        report="" if report is None else os.fspath(report),
        progress=progress,
    )
    return _verdict(certificate)


def _subject(
    controller: Union[PythonController, str], sections: Sequence[str], fields: Sequence[str], raise_errors: bool
) -> Tuple[str, _core.PythonController | None]:
    if isinstance(controller, str):
        return controller, None
    if not callable(controller) and not hasattr(controller, "answer"):
        raise TypeError(
            f"{controller!r} is not a controller; expected a function, an object with hello and answer, or a command"
        )
    name = getattr(controller, "__name__", type(controller).__name__)
    module = getattr(controller, "__module__", "") or ""
    return f"python {module}.{name}", bound(controller, sections, fields, raise_errors)


def _own(program: ProgramLike, setup: SetupLike | None, samples: int | None) -> _core.Program:
    return program_of(program, None if isinstance(program, Case) else setup, samples)


def _finding(said: Mapping[str, Any], explanation: str, text: str) -> Finding:
    case = json.loads(text)["case"]
    return Finding(
        kind=said["kind"],
        section=said["section"],
        clause=said["clause"],
        line=said["line"],
        field=said["field"],
        expected=said["expected"],
        actual=said["actual"],
        deviation_um=said["deviation_um"],
        explanation=explanation,
        case=Case.from_json(json.dumps(case)),
        occurrences=said["occurrences"],
        errors=said.get("errors", ""),
        text=text,
    )


def _verdict(certificate: _core.Certificate) -> Verdict:
    report = json.loads(certificate.json())
    findings = map(_finding, report["findings"], certificate.explanations(), certificate.findings())
    return Verdict(
        text=report["verdict"],
        exit_status=report["exit_status"],
        findings=tuple(findings),
        causes=tuple(cause["cause"] for cause in report["causes"]),
        report=report,
        _certificate=certificate,
    )
