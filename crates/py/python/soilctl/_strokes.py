"""What takes strokes as a table in memory: predictions, estimates and diagnoses of a DataFrame."""

from __future__ import annotations

import csv
import inspect
import os
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, Literal, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike

from . import _native, use_cases
from ._native import Estimate, Prediction
from ._table import PathLike, TableInMemory, columns, is_table, like, to_csv

_OrColumn = float | Literal["column"]
_Function = TypeVar("_Function", bound=Callable[..., Any])


def _documented(name: str) -> Callable[[_Function], _Function]:
    """Puts the documentation and the arguments of the function for arrays before those for tables."""
    of_arrays = getattr(_native, name)

    def document(function: _Function) -> _Function:
        function.__signature__ = inspect.signature(of_arrays)  # type: ignore[attr-defined]
        function.__doc__ = f"{inspect.getdoc(of_arrays)}\n\n{inspect.getdoc(function)}"
        return function

    return document


@overload
def predict(
    model: str = "chen",
    *,
    tool_angle_deg: ArrayLike,
    friction_angle_deg: ArrayLike,
    interface_friction_deg: ArrayLike,
    surface_slope_deg: ArrayLike | None = None,
    density_kg_m3: ArrayLike | None = None,
    depth_m: ArrayLike | None = None,
    width_m: ArrayLike | None = None,
    cohesion_pa: ArrayLike | None = None,
    adhesion_pa: ArrayLike | None = None,
    surcharge_pa: ArrayLike | None = None,
    gravity_m_s2: ArrayLike | None = None,
) -> Prediction: ...
@overload
def predict(
    strokes: TableInMemory,
    /,
    *,
    model: str | None = None,
    friction_angle_deg: float | None = None,
    interface_friction_deg: _OrColumn | None = None,
    surface_slope_deg: float | None = None,
    density_kg_m3: _OrColumn | None = None,
    cohesion_pa: float | None = None,
    adhesion_pa: float | None = None,
    surcharge_pa: float | None = None,
    gravity_m_s2: float | None = None,
    model_file: PathLike | None = None,
) -> Any: ...
@_documented("predict")
def predict(*arguments: Any, **options: Any) -> Any:
    """Of a table of strokes in memory, ``predict(strokes, friction_angle_deg=40, ...)``: a prediction for each of them.

    The table is a DataFrame of pandas or polars, or a dict of arrays, with the columns of a stroke table: ``alpha_deg``, ``depth_m``,
    ``width_m`` and ``force_n``. Arguments are single numbers; ``interface_friction_deg`` and ``density_kg_m3`` are by default the
    columns ``delta_set_deg`` and ``density_kg_m3``. With ``model_file``, a model file such as the patch of a diagnosis, all that is not
    given comes from there.

    Returns:
        A table of the same kind with the same index: ``k_net``, ``force_n``, ``measured_n`` and ``ratio``, the predicted force over
        the measured one. Without a density, forces and ratios are NaN.
    """
    if arguments and is_table(arguments[0]):
        return _predict_strokes(*arguments, **options)
    return _native.predict(*arguments, **options)


def _predict_strokes(
    strokes: TableInMemory,
    /,
    *,
    model: str | None = None,
    friction_angle_deg: float | None = None,
    interface_friction_deg: _OrColumn | None = None,
    surface_slope_deg: float | None = None,
    density_kg_m3: _OrColumn | None = None,
    model_file: PathLike | None = None,
    **loads: float | None,
) -> Any:
    if model_file is None:
        interface_friction_deg = "column" if interface_friction_deg is None else interface_friction_deg
        density_kg_m3 = "column" if density_kg_m3 is None and "density_kg_m3" in columns(strokes) else density_kg_m3
    given = {
        "model": model,
        "phi_deg": friction_angle_deg,
        "delta_deg": interface_friction_deg,
        "beta_deg": surface_slope_deg,
        "density_kg_m3": density_kg_m3,
        "model_file": model_file,
        **loads,
    }
    named: dict[str, Any] = {name: value for name, value in given.items() if value is not None}
    found = use_cases.predict(strokes=strokes, **named).strokes or []
    names = ("k_net", "force_n", "measured_n", "ratio")
    return like(strokes, {name: np.array([stroke[name] for stroke in found], dtype=float) for name in names})


@overload
def estimate(
    *,
    tool_angle_deg: ArrayLike,
    depth_m: ArrayLike,
    width_m: ArrayLike,
    force_n: ArrayLike,
    force_error_n: ArrayLike,
    interface_friction_deg: ArrayLike,
    surface_slope_deg: ArrayLike | None = None,
    density_kg_m3: ArrayLike | None = None,
    friction_search_deg: ArrayLike | None = None,
    model: str = "table",
    cohesion_pa: float = 0.0,
    adhesion_pa: float = 0.0,
    surcharge_pa: float = 0.0,
    gravity_m_s2: float = 9.80665,
) -> Estimate: ...
@overload
def estimate(
    strokes: TableInMemory,
    /,
    delta_deg: _OrColumn = "column",
    *,
    delta_tol_deg: float = 1.0,
    density_kg_m3: _OrColumn | None = None,
    density_tol: float = 0.04,
    model: str = "table",
    **options: Any,
) -> use_cases.EstimateAnswer: ...
@_documented("estimate")
def estimate(*arguments: Any, **options: Any) -> Any:
    """Of a table of strokes in memory, ``estimate(strokes, delta_deg=23, density_kg_m3=1600)``: as from its file.

    The table is a DataFrame of pandas or polars, or a dict of arrays, with the columns of a stroke table: ``alpha_deg``, ``depth_m``,
    ``width_m``, ``force_n``, for strokes that are not repeated ``force_sd_n``, and others of them. Strokes of one kind are taken
    together. Keywords are those of :func:`soilctl.use_cases.estimate`, which gives the answer; ``delta_deg``, which may be
    given by its place, is by default what the columns ``friction_angle_deg`` or ``delta_set_deg`` say.
    """
    if arguments and is_table(arguments[0]):
        strokes, *delta_deg = arguments
        return use_cases.estimate(strokes, *(delta_deg or [options.pop("delta_deg", "column")]), **options)
    return _native.estimate(*arguments, **options)


@dataclass(frozen=True, repr=False, eq=False)
class StrokesDiagnosis(use_cases.DiagnoseAnswer):
    """The diagnosis of a table in memory."""

    patch: str | None  # type: ignore[assignment]
    """The model file with the effects; None if no folder for it was given."""
    predictions: Any
    """A table of the same kind with the same index: the force of each stroke before and after what was found is added, in N."""


def diagnose(
    folder: PathLike | TableInMemory,
    *,
    model: str | None = None,
    model_file: PathLike | None = None,
    traces: PathLike | None = None,
    logs: PathLike | None = None,
    resimulate: bool = True,
    out: PathLike | None = None,
) -> use_cases.DiagnoseAnswer:
    """Where model and measurement disagree, which effect is missing, and the gap after it is added.

    Args:
        folder: A folder that holds ``strokes.csv`` and, beside it, ``campaign.json`` and ``traces.csv``; or the table itself, a
            DataFrame of pandas or polars or a dict of arrays.
        model: Force model without effects, one of ``soilctl.MODELS``; ``table`` by default.
        model_file: A model file instead of ``model``, such as the patch of an earlier diagnosis: its force model, and its effects
            as known ones, which are held as they are and not looked for.
        traces: Traces of the strokes; by default ``traces.csv`` in the folder, if it is there.
        logs: Folder with the campaign's logs, if they are soilctl's; by default the folder, if logs of its strokes are there. The same
            commands are run on the simulated arm, without and with what is found, and signals are compared. Takes some seconds a stroke.
        resimulate: False reads the table alone, also where logs are there.
        out: Folder for ``patch.json``, ``predictions.csv``, ``gap.csv``, ``next_experiment.csv`` and ``report.html``, and of
            logs ``twin.json``; by default ``diagnosis`` in the folder. Of a table in memory nothing is written by default.

    Returns:
        The answer. Of a table in memory it has ``predictions`` too, a table of the same kind with the same index: the force of each
        stroke before and after what was found is added, in N.

    Raises:
        InputError: If the table has errors; the message names file and line. Also if both a model and a model file are given.
        FileError: If a file cannot be read or written.
    """
    options: dict[str, Any] = {"model_file": model_file, "traces": traces, "logs": logs, "no_resimulate": not resimulate}
    if model is not None:
        options["model"] = model
    if isinstance(folder, (str, os.PathLike)):
        return use_cases.diagnose(folder, **options, out=out)
    # A diagnosis reads a folder.
    with tempfile.TemporaryDirectory() as place:
        Path(place, "strokes.csv").write_text(to_csv("strokes", folder), encoding="utf-8")
        written = Path(place, "diagnosis") if out is None else Path(out)
        answer = use_cases.diagnose(place, **options, out=written)
        with Path(written, "predictions.csv").open(newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    values: dict[str, Any] = {one.name: getattr(answer, one.name) for one in fields(answer)}
    if out is None:
        # They are gone.
        values.update(patch=None, report=None)
    names = ("force_before_n", "force_after_n")
    values["predictions"] = like(folder, {name: np.array([float(row[name]) for row in rows]) for name in names})
    return StrokesDiagnosis(**values)
