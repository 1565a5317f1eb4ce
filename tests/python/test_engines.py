# SPDX-License-Identifier: Apache-2.0
"""diff, explain, clauses and the corpus. Expected values by hand."""

from __future__ import annotations

import signal
import threading
from fractions import Fraction
from pathlib import Path

import pytest

import toolcomp

SETUP = {"control": "fanuc", "offsets": {"H": {"1": "20"}, "D": {"1": "10"}}}
INNER = "G90 G17 G01 F100\nG41 D1 X10. Y0\nX50.\nY50.\nG40 X60.\nM02\n"


@pytest.mark.parametrize("engine", ["fast", "spec"])
def test_diff(engine: str) -> None:
    if engine == "spec" and not toolcomp.has_specification:
        pytest.skip("built without the formal specification")
    comparison = toolcomp.diff(INNER, setup=SETUP, engine=engine)  # type: ignore[arg-type]
    assert comparison.agrees and comparison.exit_status == 0
    assert comparison.difference is None
    assert comparison.values > 10


def test_diff_of_a_program_that_cannot_be_read(tmp_path: Path) -> None:
    program = tmp_path / "bad.nc"
    program.write_bytes(b"X1.\n\x01\n")
    with pytest.raises(toolcomp.InputError) as raised:
        toolcomp.diff(program, setup=SETUP)
    assert raised.value.line == 2


def test_ctrl_c_in_a_long_diff(tmp_path: Path) -> None:
    program = tmp_path / "long.nc"
    program.write_text("G90 G01 F100\n" + "".join(f"X{i % 1000}. Y{i % 7}.\n" for i in range(1_000_000)))
    timer = threading.Timer(0.3, signal.raise_signal, (signal.SIGINT,))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        toolcomp.diff(program, setup=SETUP)
    timer.join()


def test_explain_the_corner() -> None:
    (block,) = toolcomp.explain(INNER, setup=SETUP, block=3)
    assert (block.line, block.text) == (3, "X50.")
    # To the left of a line along X, then along Y: the corner of the offset lines is (40, 10).
    move = block.exact[0].event
    assert isinstance(move, toolcomp.Move)
    assert move.point == {"X": 40, "Y": 10, "Z": 0}
    assert "X40 Y10" in block.exact[0].corner
    fast = block.fast[0]
    assert isinstance(fast, toolcomp.Move) and fast.point["X"] == 40.0
    assert block.decisions
    for decision in block.decisions:
        sign = {"positive": 1, "negative": -1, "tie": 0}[decision.outcome]
        assert (float(decision.quantity) > 0) - (float(decision.quantity) < 0) == sign
        assert decision.clause.text
    assert len(toolcomp.explain(INNER, setup=SETUP)) == 6


def test_explain_no_such_block() -> None:
    with pytest.raises(toolcomp.InputError, match="no block"):
        toolcomp.explain(INNER, setup=SETUP, block=99)


def test_clause() -> None:
    (move,) = toolcomp.run("G43 Z100. H1\n", setup=SETUP)
    for id in move.clauses:
        assert toolcomp.clause(id).id == id
    with pytest.raises(KeyError):
        toolcomp.clause("fanuc.nothing")


def test_corpus() -> None:
    assert "fanuc/tool-length-offset" in toolcomp.corpus.sections()
    assert toolcomp.corpus.version().count(".") == 2
    vectors = list(toolcomp.corpus.vectors("fanuc/tool-length-offset"))
    assert len(vectors) > 100
    assert {vector.section for vector in vectors} == {"fanuc/tool-length-offset"}
    assert len({vector.id for vector in vectors}) == len(vectors)


def test_corpus_is_what_the_model_says() -> None:
    for section in toolcomp.corpus.sections():
        for vector, _ in zip(toolcomp.corpus.vectors(section), range(5)):
            events = list(toolcomp.run(vector))
            assert len(events) == len(vector.expect)
            for got, expected in zip(events, vector.expect):
                assert type(got) is type(expected) and got.line == expected.line
                if isinstance(got, toolcomp.Move) and isinstance(expected, toolcomp.Move):
                    assert got.axes == expected.axes
                    assert got.point == expected.point
                    assert got.tool_axis == expected.tool_axis


def test_corpus_is_lazy_and_says_what_it_has_not() -> None:
    assert next(toolcomp.corpus.vectors()).expect
    with pytest.raises(toolcomp.InputError, match="no vectors of section fanuc/nothing"):
        toolcomp.corpus.vectors("fanuc/nothing")
    with pytest.raises(toolcomp.InputError):
        toolcomp.corpus.vectors(corpus="/nowhere")


def test_numbers() -> None:
    from toolcomp.numbers import json_of_number

    assert json_of_number(Fraction(1, 8)) == "0.125"
    assert json_of_number(Fraction(1, 3)).startswith("0.333333333333333333333333333333")
    assert json_of_number(7) == "7"
    assert json_of_number(1e-7) == 1e-7
    assert json_of_number(float("nan")) == "nan"
    assert json_of_number("12.50") == "12.50"
    with pytest.raises(TypeError, match="None is not a number"):
        json_of_number(None)
