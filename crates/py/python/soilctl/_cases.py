"""The cases and sweeps of a problem file, each on any executor, in one store."""

from __future__ import annotations

import dataclasses
import itertools
import json
import os
import tempfile
from collections.abc import Mapping
from concurrent.futures import Executor
from pathlib import Path
from typing import Any, Literal

from . import use_cases
from ._native import VERSION
from ._problem import _plain
from ._progress import Progress
from ._sweep import SweepResult, sweep
from ._table import PathLike
from .errors import InputError, NoAnswerError

#: Under which results are stored.
NAME = "soilctl.solve_cases"
#: What a result has of the answer of a case.
KEPT = ("lower", "upper", "gap", "certified", "enough")


def solve_cases(
    problem: PathLike | Mapping[str, Any],
    *,
    store: str | os.PathLike[str],
    executor: Executor | None = None,
    max_gap: float = 0.01,
    max_elements: int = 20000,
    max_work: int | None = None,
    max_seconds: float | None = None,
    max_memory_mb: int | None = None,
    factorisation: Literal["auto", "qdldl", "faer"] = "auto",
    progress: Progress = None,
) -> SweepResult:
    """Proven bounds for each of the problems that a file describes by its cases and sweeps, shared out by an executor.

    It is :func:`sweep` with the cells of the file: what is in the store already is not solved again, results are the same
    whatever the executor, and a case without bounds is a failure, by name. Bounds are those that ``soilctl solve`` finds for the case.

    Args:
        problem: Path of a problem file (.toml or .json), or the description as a mapping, such as a :class:`soilctl.problem.Problem`. It has
            ``case`` or ``sweep``, or both.
        store: Folder for the results; made if it is not there.
        executor: As for :func:`sweep`; for a cluster, ``dask.distributed.Client(...).get_executor()``. Its workers need soilctl of this version.
        max_gap, max_elements, max_work, max_seconds, max_memory_mb, factorisation: As for ``solve``, for each problem by itself.
        progress: Called with the number of problems that are done and of all, after each; or True for a bar of tqdm.

    Returns:
        The results. A cell has ``case``, where the file names cases, and the swept parameters; a result ``lower`` and ``upper`` bound in the
        unit of the objective, ``gap``, ``certified`` and ``enough``, which is None where nothing is asked that bounds could be enough for.

    Raises:
        InputError: If the description has neither cases nor sweeps, or a sweep without values. What makes no sense otherwise is a failure
            of the cases of which that is true.
        FileError: If the file cannot be read, or the store cannot be written.
    """
    budget = {
        "max_gap": max_gap,
        "max_elements": max_elements,
        "max_work": max_work,
        "max_seconds": max_seconds,
        "max_memory_mb": max_memory_mb,
        "factorisation": factorisation,
    }
    given = {key: value for key, value in budget.items() if value is not None}
    described = _described(problem)
    shown, single = _problems(described)
    cells = [{"problem": one, **given} for one in single]
    done = sweep(_bounds, cells, store=store, executor=executor, name=NAME, version=VERSION, progress=progress)
    failures = [dataclasses.replace(failure, cell=shown[failure.index]) for failure in done.failures]
    return dataclasses.replace(done, cells=shown, failures=failures)


def _described(problem: PathLike | Mapping[str, Any]) -> dict[str, Any]:
    """What the file says."""
    if isinstance(problem, Mapping):
        return {key: _plain(value) for key, value in problem.items()}
    path = Path(problem)
    try:
        text = path.read_text(encoding="utf-8")
        if path.suffix == ".json":
            found: dict[str, Any] = json.loads(text)
            return found
        import tomllib

        return tomllib.loads(text)
    except (OSError, ValueError):
        # Says what is wrong, in the words of the command line.
        use_cases.solve_check(path)
        raise
    except ImportError as missing:
        raise InputError(f"{path}: reading TOML takes Python 3.11 or later; give the problem as .json, or as a mapping") from missing


def _values(sweep: dict[str, Any]) -> list[float]:
    """The values of a sweep: the same bits as those of the command line."""
    if "values" in sweep:
        return list(sweep["values"])
    try:
        start, end, count = float(sweep["from"]), float(sweep["to"]), int(sweep["count"])
    except KeyError as missing:
        raise InputError(f"sweep {sweep.get('parameter')!r}: give either values, or from, to and count") from missing
    if count < 2:
        raise InputError(f"sweep {sweep.get('parameter')!r}: count is {count}; it must be 2 or more")
    parts = [k / (count - 1) for k in range(count)]
    return [start * (1.0 - part) + end * part for part in parts]


def _problems(described: dict[str, Any]) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """The parameters of each problem, as they are shown, and a file for each, in the order of the command line."""
    cases, sweeps = described.get("case") or [], described.get("sweep") or []
    if not cases and not sweeps:
        raise InputError("the problem has neither case nor sweep, so it is one problem; solve it with soilctl.solve")
    plain = {key: value for key, value in described.items() if key not in ("case", "sweep")}
    shown, single = [], []
    # Each case goes with each value of each sweep, and the values of the last sweep change first.
    for case, *values in itertools.product(cases or [None], *map(_values, sweeps)):
        swept = {sweep["parameter"]: value for sweep, value in zip(sweeps, values)}
        shown.append({**({"case": case["name"]} if case else {}), **swept})
        alone = {**plain, **({"case": [case]} if case else {})}
        if swept:
            alone["sweep"] = [{"parameter": parameter, "values": [value]} for parameter, value in swept.items()]
        single.append(alone)
    return shown, single


def _bounds(problem: dict[str, Any], **budget: Any) -> dict[str, Any]:
    """The bounds of a problem that is one case; in the worker."""
    with _file(problem) as path:
        (case,) = use_cases.solve(path, **budget).cases
    if case.problem is not None:
        raise NoAnswerError(case.problem)
    return {key: getattr(case, key) for key in KEPT}


class _file:
    """A problem as a file, for as long as it is read."""

    def __init__(self, problem: Mapping[str, Any]) -> None:
        self._text = json.dumps(problem)

    def __enter__(self) -> Path:
        self._folder = tempfile.TemporaryDirectory(prefix="soilctl-")
        path = Path(self._folder.name) / "problem.json"
        path.write_text(self._text, encoding="utf-8")
        return path

    def __exit__(self, *_: object) -> None:
        self._folder.cleanup()
