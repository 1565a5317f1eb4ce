# SPDX-License-Identifier: Apache-2.0
"""Everything type-checks with mypy --strict, and the stub says what the extension has."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import toolcomp

MYPY = ["--config-file", "pyproject.toml", "--cache-dir", os.environ.get("MYPY_CACHE_DIR", os.devnull)]


def test_mypy(source: Path) -> None:
    checked = ["-p", "toolcomp"]
    run = subprocess.run(
        [sys.executable, "-m", "mypy", *MYPY, *checked],
        cwd=source,
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stdout + run.stderr


def test_mypy_of_users(source: Path) -> None:
    files = sorted(map(str, [*source.glob("examples/python/*.py"), *source.glob("tests/python/test_*.py")]))
    assert len(files) > 5
    run = subprocess.run(
        [sys.executable, "-m", "mypy", *MYPY, *files],
        cwd=source,
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stdout + run.stderr


def test_what_is_said_is_there() -> None:
    for name in toolcomp.__all__:
        assert getattr(toolcomp, name).__doc__ or name in ("Event", "Number")
    assert (Path(toolcomp.__file__).parent / "py.typed").exists()


def test_the_stub_has_the_names_of_the_extension(source: Path) -> None:
    import ast

    stub = ast.parse((source / "python/toolcomp/_core.pyi").read_text())
    said = {node.name for node in stub.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    said |= {node.target.id for node in stub.body if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name)}
    assert said == {name for name in dir(toolcomp._core) if not name.startswith("_")}
    for node in stub.body:
        if isinstance(node, ast.ClassDef):
            members = {each.name for each in node.body if isinstance(each, ast.FunctionDef)} - {"__init__"}
            kind = getattr(toolcomp._core, node.name)
            assert members == {name for name in vars(kind) if not name.startswith("_")}, node.name
