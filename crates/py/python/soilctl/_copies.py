"""Copies of solutions for ``pickle``: the format is that of their files, so a copy goes through one."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

from ._native import Solution, _restore_solution

_Parts = tuple[bytes, tuple[float, float]]


def reduced(solution: Solution) -> tuple[Callable[..., Solution], _Parts]:
    """What ``Solution.__reduce__`` gives."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "solution.json")
        solution.write(path)
        return restored, (path.read_bytes(), solution.origin_m)


def restored(data: bytes, origin_m: tuple[float, float]) -> Solution:
    """The solution again."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "solution.json")
        path.write_bytes(data)
        return _restore_solution(path, origin_m)
