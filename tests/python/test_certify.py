# SPDX-License-Identifier: Apache-2.0
"""Controllers in Python, and as commands: what is found, and what their exceptions do."""

from __future__ import annotations

import signal
import sys
import threading
from dataclasses import replace
from pathlib import Path
from typing import Any, Iterator, Mapping

import pytest

import toolcomp

SECTION = "fanuc/tool-length-offset"
SETUP = {"control": "fanuc", "offsets": {"H": {"1": "20"}}}
PROGRAM = "G90 G43 Z100. H1\nG01 Z50. F100\nM02\n"


def right(case: toolcomp.Case) -> Iterator[toolcomp.Event]:
    """A control that does everything right: the fast engine."""
    return toolcomp.run(case, engine="fast")


def shifted(case: toolcomp.Case) -> Iterator[toolcomp.Event]:
    """The same, Z off by a hundredth where a length offset is on."""
    for event in toolcomp.run(case, engine="fast"):
        if isinstance(event, toolcomp.Move) and event.axes.get("Z") != event.programmed.get("Z"):
            yield replace(event, axes={**event.axes, "Z": float(event.axes["Z"]) + 0.01})
        else:
            yield event


def test_a_right_function_conforms() -> None:
    verdict = toolcomp.certify(right, sections=SECTION, cases=50)
    assert verdict.conforms and verdict.exit_status == 0
    assert verdict.text.startswith("conforms in 1 of 13 sections")
    assert verdict.findings == ()
    (section,) = [each for each in verdict.report["sections"] if each["section"] == SECTION]
    assert section["cases"]["generated"] == 50 and section["cases"]["golden"] > 100
    assert section["values"] > 1000
    assert verdict.report["controller"]["name"] == "right"
    assert verdict.report["identity"]["command"].endswith("right")


def test_a_wrong_function_is_found_and_shrunk(tmp_path: Path) -> None:
    verdict = toolcomp.certify(shifted, programs=[PROGRAM], setup=SETUP, report=tmp_path)
    assert verdict.exit_status == 1 and not verdict.conforms
    (finding,) = verdict.findings
    assert (finding.kind, finding.field) == ("coordinate", "axes.Z")
    assert finding.deviation_um == pytest.approx(10, rel=1e-6)
    assert len(finding.case.program.splitlines()) == 1
    assert finding.clause is not None and finding.clause.startswith("fanuc.")
    assert toolcomp.clause(finding.clause).text
    assert "axes.Z is" in finding.explanation
    assert (tmp_path / "index.html").read_text().startswith("<!DOCTYPE html>")
    assert len(list((tmp_path / "findings").iterdir())) == 1
    assert verdict.html().startswith("<!DOCTYPE html>")


def test_the_seed_repeats(tmp_path: Path) -> None:
    asked: list[str] = []

    def listening(case: toolcomp.Case) -> Iterator[toolcomp.Event]:
        asked.append(case.id)
        return right(case)

    runs = []
    for seed in (7, 7, 8):
        asked.clear()
        toolcomp.certify(listening, sections=SECTION, cases=10, corpus=False, seed=seed)
        runs.append(list(asked))
    assert len(runs[0]) == 10
    assert runs[0] == runs[1] != runs[2]


class Control:
    """One with capabilities of its own."""

    def hello(self) -> Mapping[str, Any]:
        return {"name": "ours", "version": "2", "sections": [SECTION], "fields": ["kind", "line", "axes", "point"]}

    def answer(self, case: toolcomp.Case) -> list[Mapping[str, Any]]:
        return [toolcomp.events.json_of_event(event) for event in right(case)]


def test_an_object_and_mappings() -> None:
    verdict = toolcomp.certify(Control(), cases=20, corpus=False, sections=[SECTION, "fanuc/tool-offset"])
    assert verdict.report["controller"]["version"] == "2"
    assert verdict.exit_status == 0
    assert verdict.text == "conforms in 1 of 13 sections, 1 not applicable, 11 not asked for"


class Remembering(Control):
    """Right but for the third answer since it began."""

    def __init__(self) -> None:
        self.asked = 0
        self.restarts = 0

    def restart(self) -> None:
        self.asked = 0
        self.restarts += 1

    def answer(self, case: toolcomp.Case) -> list[Mapping[str, Any]]:
        self.asked += 1
        return super().answer(case) if self.asked != 3 else []


def test_what_comes_only_behind_other_cases() -> None:
    control = Remembering()
    verdict = toolcomp.certify(control, programs=[PROGRAM] * 5, setup=SETUP)
    (finding,) = verdict.findings
    assert finding.kind == "missing event"
    assert verdict.report["findings"][0]["requests_before"] == 2
    assert control.restarts > 0


def test_an_exception_is_a_finding() -> None:
    def raising(case: toolcomp.Case) -> list[toolcomp.Event]:
        raise LookupError("no tool 7")

    verdict = toolcomp.certify(raising, programs=[PROGRAM], setup=SETUP)
    (finding,) = verdict.findings
    assert finding.kind == "crash"
    assert finding.actual.startswith("raised LookupError: no tool 7")
    assert "in raising" in finding.errors or "raising" in finding.errors


def test_an_exception_passes_through_where_it_is_wanted(tmp_path: Path) -> None:
    def raising(case: toolcomp.Case) -> list[toolcomp.Event]:
        raise LookupError("no tool 7")

    with pytest.raises(LookupError, match="no tool 7"):
        toolcomp.certify(raising, programs=[PROGRAM], setup=SETUP, raise_errors=True, report=tmp_path)
    assert (tmp_path / "certificate.json").exists()


@pytest.mark.parametrize("jobs", [1, 2])
def test_keyboard_interrupt_of_a_controller_passes_through(jobs: int) -> None:
    def interrupted(case: toolcomp.Case) -> list[toolcomp.Event]:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        toolcomp.certify(interrupted, sections=SECTION, cases=20, corpus=False, jobs=jobs)


def test_ctrl_c_while_cases_are_chosen(tmp_path: Path) -> None:
    timer = threading.Timer(0.5, signal.raise_signal, (signal.SIGINT,))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        toolcomp.certify("fast", corpus=False, report=tmp_path)
    timer.join()
    assert "interrupted" in (tmp_path / "certificate.json").read_text()


def test_other_threads_run_meanwhile() -> None:
    counted = 0
    done = threading.Event()

    def count() -> None:
        nonlocal counted
        while not done.wait(0.001):
            counted += 1

    counter = threading.Thread(target=count)
    counter.start()
    toolcomp.certify("fast", sections=SECTION, cases=100, corpus=False)
    done.set()
    counter.join()
    assert counted > 10


def test_not_applicable() -> None:
    def refusing(case: toolcomp.Case) -> list[toolcomp.Event]:
        raise toolcomp.NotApplicable("no length offsets here")

    verdict = toolcomp.certify(refusing, programs=[PROGRAM], setup=SETUP)
    assert verdict.findings == ()
    assert verdict.report["sections"][0]["results"]["not applicable"] == 1


@pytest.mark.parametrize("answer", [None, 3, "events", [{"kind": "move"}], [{"line": 1}]])
def test_an_answer_that_is_none_is_a_malformed_reply(answer: Any) -> None:
    verdict = toolcomp.certify(lambda case: answer, programs=[PROGRAM], setup=SETUP)
    (finding,) = verdict.findings
    assert finding.kind == "malformed reply"


def test_a_field_that_is_announced_and_missing() -> None:
    verdict = toolcomp.certify(right, programs=[PROGRAM], setup=SETUP, fields=["kind", "line", "axes", "contact"])
    assert verdict.exit_status == 0  # it applies to no event here

    def bare(case: toolcomp.Case) -> Iterator[toolcomp.Event]:
        return (toolcomp.Move(line=e.line, axes=e.axes) for e in right(case) if isinstance(e, toolcomp.Move))

    verdict = toolcomp.certify(bare, programs=[PROGRAM], setup=SETUP, fields=["kind", "line", "axes", "point"])
    assert {finding.field for finding in verdict.findings} == {"point.X"}


def test_a_command(source: Path) -> None:
    command = f"{sys.executable} {source / 'adapters/examples/controller.py'}"
    verdict = toolcomp.certify(command, sections=SECTION, cases=20)
    assert verdict.exit_status == 0
    assert verdict.report["controller"]["name"] == "length offsets"


def test_our_own_engines() -> None:
    assert toolcomp.certify("fast", sections=SECTION, cases=20, corpus=False).conforms
    if toolcomp.has_specification:
        assert toolcomp.certify("spec", sections=SECTION, cases=20, corpus=False).conforms


def test_what_cannot_be() -> None:
    with pytest.raises(toolcomp.InputError, match="unknown section fanuc/nothing"):
        toolcomp.certify(right, sections="fanuc/nothing", corpus=False)
    with pytest.raises(toolcomp.InputError, match="cannot be run"):
        toolcomp.certify("/nowhere/control", sections=SECTION, cases=1, corpus=False)
    with pytest.raises(ValueError, match="jobs"):
        toolcomp.certify(right, jobs=0)
    with pytest.raises(TypeError, match="is not a controller"):
        toolcomp.certify(7)  # type: ignore[arg-type]


def test_progress_and_time_limit() -> None:
    seen: list[tuple[int, int]] = []
    told = lambda done, all: seen.append((done, all))  # noqa: E731
    toolcomp.certify(right, sections=SECTION, cases=10, corpus=False, progress=told)
    assert seen == [(k, 10) for k in range(1, 11)]
    verdict = toolcomp.certify("fast", corpus=False, time_limit=0.5)
    assert verdict.exit_status == 3 and verdict.text == "not decided: time limit"
    with pytest.raises(ZeroDivisionError):
        toolcomp.certify(right, sections=SECTION, cases=10, corpus=False, progress=lambda done, all: 1 // 0)
