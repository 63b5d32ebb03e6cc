"""The answers of the command line, as dicts."""

from __future__ import annotations

import csv
import json
import operator
import os
import tempfile
from collections.abc import Iterable, Mapping
from html import escape
from numbers import Real
from pathlib import Path
from typing import Any

from ._native import Certificate, Solution, answer_command
from ._progress import Progress, told
from .errors import InputError, InputTypeError

_Path = str | os.PathLike[str]

#: Most characters of a value in a notebook.
_SHOWN = 200


class Answer(dict[str, Any]):
    """An answer of the command line: a dict that a notebook shows as a table, with links to the pages that were written."""

    def _repr_html_(self) -> str:
        rows = "".join(f"<tr><th>{escape(str(key))}</th><td>{_shown(value)}</td></tr>" for key, value in self.items())
        return f"<table>{rows}</table>"


def _shown(value: object) -> str:
    if isinstance(value, list) and value and all(isinstance(part, str) for part in value):
        return "<br>".join(map(_shown, value))
    if isinstance(value, str) and value.endswith(".html"):
        return f'<a href="{escape(value)}">{escape(value)}</a>'
    text = value if isinstance(value, str) else json.dumps(value, ensure_ascii=False, default=str)
    return escape(text if len(text) <= _SHOWN else text[:_SHOWN] + " ...")


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
    with told(progress, "steps") as tell:
        exit_code, text = answer_command(line, tell)
    found: dict[str, Any] = json.loads(text) if text else {}
    return Answer(found, exit_code=exit_code)


def certify(solution: Solution | _Path) -> Certificate:
    """Proves the bounds of a saved solution anew, with interval arithmetic and without the solver.

    Args:
        solution: A solution, or the path of one.

    Raises:
        FileError: If the file cannot be read.
        InputError: If it is no solution.
    """
    return (solution if isinstance(solution, Solution) else Solution.read(solution)).certify()


def diagnose(
    folder: _Path,
    *,
    model: str | None = None,
    model_file: _Path | None = None,
    traces: _Path | None = None,
    resimulate: _Path | None = None,
    out: _Path | None = None,
) -> dict[str, Any]:
    """Where model and measurement disagree, which effect is missing, and the gap after it is added.

    Args:
        folder: Holds ``strokes.csv`` and, beside it, ``campaign.json`` and ``traces.csv``.
        model: Force model without effects, one of ``soilctl.MODELS``; ``table`` by default.
        model_file: A model file instead of ``model``, such as the patch of an earlier diagnosis: its force model, and its effects
            as known ones, which are held as they are and not looked for.
        traces: Traces of the strokes; by default ``traces.csv`` in ``folder``, if it is there.
        resimulate: Folder with the campaign's logs: runs it again on the simulated arm, without and with what is found, and
            compares the traces. Takes some seconds a stroke.
        out: Folder for ``patch.json``, ``predictions.csv``, ``gap.csv``, ``next_experiment.csv`` and ``report.html``; by default
            ``diagnosis`` in ``folder``.

    Returns:
        The answer of ``soilctl diagnose``.

    Raises:
        InputError: If the table has errors; the message names file and line. Also if both a model and a model file are given.
        FileError: If a file cannot be read or written.
    """
    against = [*_option("--model", model), *_option("--model-file", model_file)]
    named = [*against, *_option("--traces", traces), *_option("--resimulate", resimulate), *_option("--out", out)]
    return answer("diagnose", folder, *named)


def shear(
    points: _Path | Mapping[str, Iterable[Any]],
    *,
    soils: str | Iterable[str] = (),
    stress_pa: float | Iterable[float] = (),
    fit_limit_pa: float | None = None,
) -> dict[str, Any]:
    """The friction angle of direct-shear tests against normal stress: a power law, a slope on a floor, a constant.

    Args:
        points: A CSV file, or columns (a dict of sequences of one length, or a ``pandas.DataFrame``) with the names
            ``friction_angle_deg``, ``normal_stress_pa`` or ``normal_stress_psi`` and, if there are several, ``soil``.
        soils: Only this one, or these; all if there are none.
        stress_pa: Normal stress, or several, at which the angle is asked for.
        fit_limit_pa: The power law is fitted to the loads below; 17237 if not given.

    Returns:
        The answer of ``soilctl shear``.

    Raises:
        InputError: If the points make no sense, or columns differ in length.
        InputTypeError: If points are neither a path nor columns, or stresses no numbers.
        FileError: If the file cannot be read.
    """
    words: list[object] = [*_option("--fit-limit", fit_limit_pa)]
    for soil in [soils] if isinstance(soils, str) else soils:
        words += ["--soil", soil]
    for stress in _numbers("stress_pa", stress_pa):
        words += ["--stress", stress]
    if isinstance(points, (str, os.PathLike)):
        return answer("shear", points, *words)
    if not isinstance(points, Mapping) and not hasattr(points, "columns"):
        raise InputTypeError(f"points is of type {type(points).__name__}; it must be a path or columns by name")
    columns = {str(name): list(points[name]) for name in points}
    lengths = {name: len(column) for name, column in columns.items()}
    if len(set(lengths.values())) > 1:
        raise InputError(f"columns differ in length: {lengths}")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "points.csv")
        with path.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(columns)
            writer.writerows(zip(*columns.values(), strict=True))
        return answer("shear", path, *words)


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
    plan: _Path,
    *,
    out: _Path,
    seed: int | None = None,
    threads: int | None = None,
    model_file: _Path | None = None,
    progress: Progress = None,
) -> dict[str, Any]:
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

    Returns:
        The answer of ``soilctl simulate``.

    Raises:
        InputError: If the plan makes no sense; the message says where.
        FileError: If a file cannot be read or written.
    """
    options = {"--out": out, "--seed": seed, "--threads": threads, "--model-file": model_file}
    return answer("simulate", plan, *_options(options), progress=progress)


def process(
    logs: _Path | Iterable[_Path],
    *,
    out: _Path | None = None,
    threads: int | None = None,
    shard: tuple[int, int] | None = None,
    report: _Path | None = None,
    options: Iterable[object] = (),
    progress: Progress = None,
) -> dict[str, Any]:
    """Failure forces of the strokes in logs, and what they say together.

    Args:
        logs: A log (.mcap), a folder with logs, or several.
        out: Stroke table to write (.csv or .parquet), with which the same call reads only what is new.
        threads: Logs that are read at a time; all cores if not given.
        shard: ``(i, n)``: reads only each n-th log, starting with the i-th, and writes no table. The shards may run at the same time
            in any executor or on other machines, if they see the same folder; the same call without ``shard`` then takes what they
            have read, and its files are the same bytes as without them.
        report: One HTML page to write.
        options: Further words of the command line, such as ``["--urdf", "arm.urdf", "--surface-z", -0.33]``.
        progress: Called with the number of logs that are done and of all, or True for a bar of tqdm.

    Returns:
        The answer of ``soilctl process``.

    Raises:
        InputError: If no log can be used, or an option makes no sense.
        InputTypeError: If ``shard`` is no pair of whole numbers.
        FileError: If a file cannot be read or written.
    """
    paths = [logs] if isinstance(logs, (str, os.PathLike)) else list(logs)
    named = {"--out": out, "--threads": threads, "--shard": _shard(shard), "--report": report}
    return answer("process", *paths, *_options(named), *options, progress=progress)


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


def _options(values: Mapping[str, object]) -> Iterable[object]:
    return (word for name, value in values.items() for word in _option(name, value))


def _option(name: str, value: object) -> tuple[object, ...]:
    return () if value is None else (name, value)
