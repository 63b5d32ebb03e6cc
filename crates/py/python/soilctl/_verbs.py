"""What the command line does, as functions."""

from __future__ import annotations

import json
import operator
import os
from collections.abc import Iterable
from numbers import Real
from typing import TYPE_CHECKING, Any

from . import use_cases
from ._native import Certificate, Solution, answer_command
from ._progress import Progress, callback
from ._record import table
from ._run import run
from ._table import PathLike, Table
from .errors import InputError, InputTypeError

if TYPE_CHECKING:
    from typing_extensions import Unpack


class CommandAnswer(dict[str, Any]):
    """An answer of the command line: a dict that a notebook shows as a table, with links to the pages that were written."""

    def _repr_html_(self) -> str:
        return table(self)


def answer(*words: object, progress: Progress = None) -> dict[str, Any]:
    """The JSON answer of a command line, without a process of its own: ``answer("shear", "points.csv")``.

    Everything that the command ``soilctl`` can do can be had this way, and the answer is that of ``--format json``; its
    form is described by the JSON schema that its key ``schema`` names. Ctrl-C ends long work.

    Args:
        words: The words of the command line after ``soilctl``; numbers and paths are turned into text.
        progress: For ``simulate``, ``process``, ``table build`` and ``diagnose --self-test``: called with the number of strokes,
            logs, cells or campaigns that are done, and of all; or True for a bar of tqdm. If it raises, the work ends.

    Returns:
        The answer, with the key ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: Where the command would have exited with 2; the message is the same. Also for ``run``, ``console`` and
            ``completions``, which talk to their user or to a shell.
        FileError: If a file cannot be read or written.
    """
    line = ["soilctl", *(os.fspath(word) if isinstance(word, os.PathLike) else str(word) for word in words)]
    with callback(progress, "steps") as report:
        exit_code, text = answer_command(line, report)
    found: dict[str, Any] = json.loads(text) if text else {}
    return CommandAnswer(found, exit_code=exit_code)


def certify(solution: Solution | PathLike) -> Certificate:
    """Proves the bounds of a saved solution anew, with interval arithmetic and without the solver.

    Args:
        solution: A solution, or the path of one.

    Raises:
        FileError: If the file cannot be read.
        InputError: If it is no solution.
    """
    return (solution if isinstance(solution, Solution) else Solution.read(solution)).certify()


def shear(
    points: Table,
    *,
    soils: str | Iterable[str] = (),
    stress_pa: float | Iterable[float] = (),
    fit_limit_pa: float | None = None,
) -> use_cases.ShearAnswer:
    """The friction angle of direct-shear tests against normal stress: a power law, a slope on a floor, a constant.

    :func:`soilctl.use_cases.shear` takes raw records and strokes as well.

    Args:
        points: A CSV file, or columns (a dict of sequences of one length, or a DataFrame) with the names
            ``friction_angle_deg``, ``normal_stress_pa`` or ``normal_stress_psi`` and, if there are several, ``soil``.
        soils: Only this one, or these; all if there are none.
        stress_pa: Normal stress, or several, at which the angle is asked for.
        fit_limit_pa: The power law is fitted to the loads below; 17237 if not given.

    Raises:
        InputError: If the points make no sense, or columns differ in length.
        InputTypeError: If points are neither a path nor columns, or stresses no numbers.
        FileError: If the file cannot be read.
    """
    names = [soils] if isinstance(soils, str) else list(soils)
    return use_cases.shear(file=points, soil=names, stress_pa=_numbers("stress_pa", stress_pa), fit_limit_pa=fit_limit_pa)


def _numbers(name: str, value: float | Iterable[float]) -> list[float]:
    """One number or several."""
    if isinstance(value, (str, bytes)):
        raise InputTypeError(f"{name} is {value!r}; it must be a number or several")
    # An array without axes is one number, too.
    several: Any = [value] if isinstance(value, Real) or getattr(value, "ndim", 1) == 0 else value
    try:
        return [float(one) for one in several]
    except (TypeError, ValueError) as problem:
        raise InputTypeError(f"{name} is {value!r}; it must be a number or several") from problem


def simulate(
    plan: PathLike,
    *,
    out: PathLike,
    seed: int | None = None,
    threads: int | None = None,
    model_file: PathLike | None = None,
    progress: Progress = None,
) -> use_cases.SimulateAnswer:
    """Runs a campaign on the simulated arm and soil, a log for each batch.

    Batches that are there already are not run again, so that the same call goes on after Ctrl-C. The same plan and seed
    give the same bytes for any number of threads.

    Args:
        plan: A campaign plan (.toml).
        out: Folder for the logs; made if it is not there.
        seed: Of noise and scatter; that of the plan if not given.
        threads: Batches that run at a time; all cores if not given.
        model_file: Replaces soil, force model and effects of the plan.
        progress: Called with the number of strokes that are made and of all, or True for a bar of tqdm.

    Raises:
        InputError: If the plan makes no sense; the message says where.
        FileError: If a file cannot be read or written.
    """
    return use_cases.simulate(plan, out, seed=seed, threads=threads, model_file=model_file, progress=progress)


def replay(path: PathLike, *, from_keyframe: int = 0) -> use_cases.ReplayAnswer:
    """Runs the controller again on the inputs of a log, and compares every bit of every output. Ctrl-C ends it.

    Args:
        path: The log (.mcap).
        from_keyframe: Where to begin; 0 is the beginning, there is one every 500 steps.

    Raises:
        FileError: If it cannot be read.
        NoAnswerError: If it lacks what is needed, such as that key frame.
        InputError: If it was written by another program.
    """
    return use_cases.replay(path, from_keyframe=from_keyframe)


def process(
    logs: PathLike | Iterable[PathLike],
    *,
    out: PathLike | None = None,
    shard: tuple[int, int] | None = None,
    report: PathLike | None = None,
    progress: Progress = None,
    **request: Unpack[use_cases.ProcessArguments],
) -> use_cases.ProcessAnswer:
    """Failure forces of the strokes in logs, and what they say together.

    ``pandas.DataFrame(found.strokes)`` is the stroke table, which :func:`soilctl.estimate` takes.

    Args:
        logs: A log (.mcap, .db3, .bag, or the folder of a split bag), a folder with logs, or several.
        out: Stroke table to write (.csv or .parquet), with which the same call reads only what is new.
        shard: ``(i, n)``: reads only each n-th log, starting with the i-th, and writes no table. The shards may run at the same time
            in any executor or on other machines, if they see the same folder; the same call without ``shard`` then takes what they
            have read, and its files are the same bytes as without them.
        report: One HTML page to write.
        progress: Called with the number of logs that are done and of all, or True for a bar of tqdm.
        request: All other arguments of :func:`soilctl.use_cases.process`, such as ``threads``, and for bags of other programs
            ``urdf``, ``surface_z_m`` and ``width_m``; ``strokes``, the times of the pushes, may be columns ``start`` and ``end``.

    Raises:
        InputError: If no log can be used, or a value makes no sense.
        InputTypeError: If ``shard`` is no pair of whole numbers.
        FileError: If a file cannot be read or written.
    """
    paths = [logs] if isinstance(logs, (str, os.PathLike)) else list(logs)
    known = use_cases.process.__kwdefaults__ or {}
    for name in request:
        if name not in known:
            raise InputTypeError(f"{name} is unknown; known are {', '.join(known)}")
    arguments = {**request, "logs": paths, "out": out, "shard": _shard(shard), "progress": progress}
    return run("process", use_cases.process, arguments, use_cases.ProcessAnswer, tables=("strokes",), page=report)


def _shard(shard: tuple[int, int] | None) -> str | None:
    if shard is None:
        return None
    try:
        part, parts = (operator.index(number) for number in shard)
    except (TypeError, ValueError) as problem:
        raise InputTypeError(f"shard is {shard!r}; it must be (i, n), two whole numbers with 1 <= i <= n") from problem
    if not 1 <= part <= parts:
        raise InputError(f"shard is {shard!r}; it must be (i, n), two whole numbers with 1 <= i <= n")
    return f"{part}/{parts}"
