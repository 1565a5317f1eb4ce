# SPDX-License-Identifier: Apache-2.0
"""Lines as arrays: the values by hand, the memory, and errors."""

from __future__ import annotations

import gc
import threading
import tracemalloc

import numpy as np
import pytest

import toolcomp

SETUP = 'control = "fanuc"\n[offsets.D]\n1 = "4.95"\n[offsets.H]\n1 = 20\n'


def test_length_offset() -> None:
    batch = toolcomp.Batch(SETUP)
    batch.run("G90 G01 F100\nG43 H1 Z0\n")
    batch.lines(X=np.array([1.0, 2.0, 3.0]), Z=np.array([5.0, 6.0, 7.0]))
    batch.end()
    moves = batch.moves()
    assert len(moves) == 4
    assert moves.block.tolist() == [2, 3, 4, 5]
    assert moves.block.dtype == np.uint64
    assert moves.axes["X"].tolist() == [0, 1, 2, 3]
    assert moves.axes["Z"].tolist() == [20, 25, 26, 27]
    assert list(moves.axes) == ["X", "Y", "Z"]
    assert (batch.blocks, batch.blocks_as_arrays) == (5, 3)
    assert len(batch.moves()) == 0


def test_it_is_the_fast_engine_bit_for_bit() -> None:
    turn = np.linspace(0, 6, 2000)
    x, y = np.round(300 * np.cos(turn), 3), np.round(300 * np.sin(turn), 3)
    head = "G90 G17 G01 F100\nG41 D1 X300. Y-10.\n"
    batch = toolcomp.Batch(SETUP)
    batch.run(head)
    batch.lines({"X": x, "Y": y})
    batch.run("G40 X0\n")
    batch.end()
    text = head + "".join(f"X{a:.3f} Y{b:.3f}\n" for a, b in zip(x, y)) + "G40 X0\n"
    expected = [e for e in toolcomp.run(text, setup=SETUP, engine="fast") if isinstance(e, toolcomp.Move)]
    moves = batch.moves()
    assert [move.line for move in expected] == moves.block.tolist()
    for axis in "XYZ":
        assert [move.axes[axis] for move in expected] == moves.axes[axis].tolist()


def test_decimals_round_to_even() -> None:
    batch = toolcomp.Batch(SETUP)
    batch.run("G90 G01 F100\n")
    batch.lines({"X": [0.125, 0.375, 1.2345]}, decimals={"X": 2})
    assert batch.moves().axes["X"].tolist() == [0.12, 0.38, 1.23]


def test_arrays_go_in_without_a_copy() -> None:
    x = np.zeros(1_000_000)
    batch = toolcomp.Batch(SETUP)
    batch.run("G90 G01 F100\n")
    tracemalloc.start()
    batch.lines(X=x)
    _, in_place = tracemalloc.get_traced_memory()
    tracemalloc.reset_peak()
    batch.lines(X=x.astype(np.float32)[::1])
    _, converted = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert in_place < x.nbytes / 100
    assert converted > x.nbytes / 2  # what a copy would look like


def test_arrays_come_out_without_a_copy_and_keep_their_memory() -> None:
    batch = toolcomp.Batch(SETUP)
    batch.run("G90 G01 F100\n")
    batch.lines(X=np.arange(1000.0))
    moves = batch.moves()
    x = moves.axes["X"]
    assert not x.flags.owndata and x.base is not None and x.flags.c_contiguous
    assert x.base is moves.axes["Y"].base is moves.block.base
    batch.lines(X=np.full(1000, 7.0))
    batch.end()
    del batch, moves
    gc.collect()
    assert x.tolist() == list(range(1000))


def test_klartext_vectors() -> None:
    setup = 'control = "heidenhain"\n[[tool]]\nnumber = 1\nR = 6\nR2 = 6\nDR = -1\nDR2 = -1\n'
    batch = toolcomp.Batch(setup)
    batch.run("TOOL CALL 1 Z S12000 F1000\nL X0 Y0 Z0 R0 F1000\n")
    n = [1.0, 1.0]
    zero = [0.0, 0.0]
    batch.lines({"X": [1.0, 2.0], "Y": zero, "Z": zero, "NX": n, "NY": zero, "NZ": zero}, decimals=5)
    batch.end()
    moves = batch.moves()
    # A ball of 5 in place of one of 6 that touches with its side: its centre is one nearer, as high as before, and its
    # tip 5 below that.
    assert moves.axes["X"].tolist() == [0, 0, 1]
    assert moves.axes["Z"].tolist() == [0, 1, 1]
    # No block names it.
    assert np.isnan(moves.axes["A"]).all()


def test_alarm() -> None:
    batch = toolcomp.Batch(SETUP)
    batch.run("G90 G01 F100\nG123 X1.\n")
    (event,) = batch.events()
    assert isinstance(event, toolcomp.Alarm) and event.number == "PS0010"
    assert batch.stopped
    batch.lines(X=[1.0])
    assert len(batch.moves()) == 0


@pytest.mark.parametrize(
    ("columns", "message"),
    [
        ({"X": [1.0], "Y": [1.0, 2.0]}, "Y: 2 values, and X has 1"),
        ({"Q": [1.0]}, "Q: not a word of a line"),
        ({"X": [1.0, np.nan]}, "X: value 1 is"),
        ({"X": [[1.0]]}, "X: not one-dimensional"),
    ],
)
def test_what_is_no_line(columns: dict[str, list[float]], message: str) -> None:
    batch = toolcomp.Batch(SETUP)
    with pytest.raises(ValueError, match=message):
        batch.lines(columns)
    assert batch.blocks == 0


def test_decimals_of_nothing() -> None:
    with pytest.raises(ValueError, match="decimals of Z"):
        toolcomp.Batch(SETUP).lines({"X": [1.0]}, decimals={"Z": 2})


def test_setup_errors_have_a_place() -> None:
    with pytest.raises(toolcomp.InputError) as raised:
        toolcomp.Batch('control = "fanuc"\naxes = ["X", "Q"]\n')
    assert (raised.value.file, raised.value.line) == ("setup", 2)


def test_threads_side_by_side() -> None:
    x = np.round(np.linspace(0, 100, 200_000), 3)
    results: list[float] = []

    def work() -> None:
        batch = toolcomp.Batch(SETUP)
        batch.run("G90 G01 F100\n")
        for _ in range(5):
            batch.lines(X=x, Y=x)
        results.append(float(batch.moves().axes["X"].sum()))

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(set(results)) == 1 and len(results) == 4
