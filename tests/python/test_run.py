# SPDX-License-Identifier: Apache-2.0
"""Runs: events, their types and their exact numbers. Expected values by hand."""

from __future__ import annotations

import pickle
from decimal import Decimal, localcontext
from fractions import Fraction
from pathlib import Path
from typing import Iterator

import pytest

import toolcomp

PLAIN = {"control": "fanuc", "offsets": {"H": {"1": "20"}, "D": {"1": "10"}}}

# Along a line at 45 degrees, and on: the vector at its begin is perpendicular, ten long.
SLOPE = "G90 G17 G01 F100 X0 Y0\nG41 D1 X10. Y10.\nX30. Y30.\nX50. Y50.\nG40 X60. Y50.\nM02\n"


def moves(events: Iterator[toolcomp.Event]) -> list[toolcomp.Move]:
    return [event for event in events if isinstance(event, toolcomp.Move)]


@pytest.mark.parametrize("engine", ["model", "fast", "spec"])
def test_length_offset(engine: toolcomp.running.Engine) -> None:
    if engine == "spec" and not toolcomp.has_specification:
        pytest.skip("built without the formal specification")
    (event,) = toolcomp.run("G43 Z100. H1\n", setup=PLAIN, engine=engine)
    assert isinstance(event, toolcomp.Move)
    assert (event.line, event.n, event.type, event.cause) == (1, None, "rapid", "programmed")
    assert {axis: float(value) for axis, value in event.axes.items()} == {"X": 0, "Y": 0, "Z": 120}
    assert isinstance(event.axes["Z"], float if engine == "fast" else Fraction)
    assert bool(event.clauses) == (engine == "model")


def test_rational_values_are_fractions() -> None:
    (event,) = moves(toolcomp.run("G01 Z0.001 F0.5\n", setup=PLAIN))
    assert event.axes["Z"] == Fraction(1, 1000)
    assert event.feed == Fraction(1, 2)


@pytest.mark.parametrize("digits", [5, 15, 40])
def test_other_values_are_decimals_with_a_radius(digits: int) -> None:
    with localcontext() as context:
        context.prec = 80
        expected = 30 - Decimal(50).sqrt()  # less ten times the sine of 45 degrees
    event = moves(toolcomp.run(SLOPE, setup=PLAIN, digits=digits))[2]
    x = event.point["X"]
    assert isinstance(x, toolcomp.Exact)
    assert x.contains(expected)
    assert x.radius == Decimal(5).scaleb(-digits - 1)
    assert x.upper - x.lower == 2 * Fraction(x.radius)
    assert not x.contains(Fraction(expected) + Fraction(1, 10**digits))
    assert float(x) == pytest.approx(30 - 50**0.5, abs=10.0**-digits)


def test_the_engines_agree_on_a_double() -> None:
    exact = moves(toolcomp.run(SLOPE, setup=PLAIN))[2].point["Y"]
    fast = moves(toolcomp.run(SLOPE, setup=PLAIN, engine="fast"))[2].point["Y"]
    assert isinstance(fast, float)
    assert float(exact) == pytest.approx(fast, abs=1e-14)


def test_arc_fields() -> None:
    events = moves(toolcomp.run("G90 G17 G01 F100 X10. Y0\nG03 X0 Y10. R10.\n", setup=PLAIN))
    arc = events[1]
    assert (arc.type, arc.plane, arc.direction) == ("arc", "XY", "ccw")
    assert arc.center == {"X": 0, "Y": 0}
    assert arc.sweep == 90


def test_events_are_shown_short_and_can_be_pickled() -> None:
    (event,) = toolcomp.run("G43 Z100. H1\n", setup=PLAIN, engine="fast")
    assert repr(event) == (
        "Move(line=1, type='rapid', cause='programmed', programmed={'X': 0.0, 'Y': 0.0, 'Z': 100.0}, "
        "point={'X': 0.0, 'Y': 0.0, 'Z': 100.0}, axes={'X': 0.0, 'Y': 0.0, 'Z': 120.0})"
    )
    assert pickle.loads(pickle.dumps(event)) == event


def test_alarm_ends_the_run() -> None:
    *_, last = toolcomp.run("G01 X1. F1\nG99999 X2.\nX3.\n", setup=PLAIN)
    assert isinstance(last, toolcomp.Alarm)
    assert (last.number, last.line) == ("PS0010", 2)


def test_setting_and_its_value() -> None:
    (event,) = [e for e in toolcomp.run("G90 G10 L11 P1 R3.5\n", setup=PLAIN) if isinstance(e, toolcomp.Setting)]
    assert (event.name, event.value) == ("H1", Fraction(7, 2))


def test_samples() -> None:
    setup = {
        "control": "fanuc",
        "axes": ["X", "Y", "Z", "B", "C"],
        "parameters": {"19680": 2, "19681": 5, "19682": 3, "19686": 4, "19687": 2},
        "offsets": {"H": {"1": 100}},
    }
    events = list(toolcomp.run("G90 G01 F1000\nG43.4 H1 Z0\nX10. B10.\n", setup=setup, samples=4))
    samples = [event for event in events if isinstance(event, toolcomp.Sample)]
    assert [sample.t for sample in samples] == [Fraction(k, 4) for k in (1, 2, 3)]
    # The tip runs straight, so a quarter of the way lies behind it.
    assert samples[0].point["X"] == Fraction(5, 2)
    assert samples[0].tool_axis is not None and len(samples[0].tool_axis) == 3


def test_klartext(source: Path) -> None:
    events = moves(toolcomp.run(source / "examples/heidenhain/reworked-ball-at-tip/reworked.h"))
    assert any(event.normal for event in events)
    assert all(set(event.shift) <= set("XYZ") for event in events)


def test_of_a_file_with_the_setup_beside_it(source: Path) -> None:
    path = source / "examples/fanuc/three-hole-boring/three-holes.nc"
    events = moves(toolcomp.run(path))
    # The manual's example: the tool is 4 mm shorter, so every Z is 4 mm deeper.
    assert events[1].axes["Z"] == -36
    assert list(toolcomp.run(str(path))) == list(toolcomp.run(path))
    assert moves(toolcomp.run(path, setup='control = "fanuc"\n[offsets.H]\n1 = 0\n'))[1].axes["Z"] == -32
    assert moves(toolcomp.run(path, setup=path.parent / "setup.toml"))[1].axes["Z"] == -36
    assert moves(toolcomp.run(path, setup={"control": "fanuc", "offsets": {"H": {1: -1.5}}}))[1].axes["Z"] == Fraction(
        -67, 2
    )


def test_it_is_lazy(tmp_path: Path) -> None:
    program = tmp_path / "long.nc"
    program.write_text("G90 G01 F100\n" + "".join(f"X{i}.\n" for i in range(200_000)))
    events = toolcomp.run(program, setup=PLAIN)
    first = [next(events) for _ in range(3)]
    assert [event.line for event in first] == [2, 3, 4]


def test_a_case_as_dict_of_json_or_object() -> None:
    case = toolcomp.Case(id="a", section="", dialect="fanuc", setup=PLAIN, program="G44 Z100. H1\n")
    (event,) = moves(toolcomp.run(case))
    assert event.axes["Z"] == 80
    (again,) = toolcomp.run(case.json() + "\n")
    assert again == event


class TestErrors:
    def test_place_in_a_setup(self) -> None:
        with pytest.raises(toolcomp.InputError) as raised:
            toolcomp.run("X1.\n", setup='control = "fanuc"\nwheels = 4\n')
        error = raised.value
        assert (error.file, error.line) == ("setup", 2)
        assert error.column is not None
        assert str(error).startswith("setup:2:") and "wheels" in error.message
        assert isinstance(error, ValueError)

    def test_no_such_file(self) -> None:
        with pytest.raises(toolcomp.InputError, match="nowhere.nc: no such file"):
            toolcomp.run("nowhere.nc")

    def test_text_without_setup(self) -> None:
        with pytest.raises(toolcomp.InputError, match="needs a setup"):
            toolcomp.run("X1.\n")

    def test_bytes_that_are_no_text_come_behind_the_events_before_them(self, tmp_path: Path) -> None:
        program = tmp_path / "bad.nc"
        program.write_bytes(b"G90 G01 F1\nX1.\nX2.\xff\n")
        events = toolcomp.run(program, setup=PLAIN)
        assert next(events).line == 2
        with pytest.raises(toolcomp.InputError) as raised:
            next(events)
        assert (raised.value.file, raised.value.line, raised.value.column) == (str(program), 3, 4)

    def test_engine_and_digits(self) -> None:
        with pytest.raises(ValueError, match="engine"):
            toolcomp.run("X1.\n", setup=PLAIN, engine="slow")  # type: ignore[arg-type]
        with pytest.raises(ValueError, match="digits"):
            toolcomp.run("X1.\n", setup=PLAIN, digits=0)

    def test_a_setup_as_dict_has_no_lines(self) -> None:
        with pytest.raises(toolcomp.InputError) as raised:
            toolcomp.run("X1.\n", setup={"control": "fanuc", "wheels": 4})
        assert (raised.value.line, raised.value.column) == (None, None)
        assert "wheels" in str(raised.value)

    def test_samples(self) -> None:
        with pytest.raises(ValueError, match="samples"):
            toolcomp.run("X1.\n", setup=PLAIN, samples=-1)

    def test_it_can_be_pickled(self) -> None:
        error = pickle.loads(pickle.dumps(toolcomp.InputError("bad", "f", 1, 2)))
        assert str(error) == "f:1:2: bad"
